/// Figures as data: what is drawn, not how. reports/render draws them from the arrays alone.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace seiche::evidence {

/// What a series is, which decides its colour: the truth, what is judged, what it is compared with, measured data,
/// a helping line such as a theoretical slope, or a piece of the scene.
enum class Role { exact, computed, peer, data, guide, bed, water };
enum class Style { line, points, steps, fill, vertical };

struct Series {
  std::string label;
  Role role = Role::computed;
  Style style = Style::line;
  std::vector<double> x;        ///< one entry more than y for steps
  std::vector<double> y;        ///< empty for vertical lines
  std::vector<double> y_error;  ///< empty or as long as y
};

struct Axes {
  std::string x;  ///< label with unit: "x [m]"
  std::string y;
  std::string title;
  bool log_x = false;
  bool log_y = false;
  bool equal_aspect = false;
  std::optional<double> x_min, x_max, y_min, y_max;
};

class Panel {
 public:
  explicit Panel(Axes axes) : axes_(std::move(axes)) {}

  /// Each throws std::invalid_argument when the lengths do not fit.
  void line(std::string label, std::span<const double> x, std::span<const double> y, Role role = Role::computed);
  void points(std::string label, std::span<const double> x, std::span<const double> y, Role role = Role::computed,
              std::span<const double> y_error = {});
  /// Piecewise constant: edges has one entry more than values.
  void steps(std::string label, std::span<const double> edges, std::span<const double> values,
             Role role = Role::computed);
  /// Area below y.
  void fill(std::string label, std::span<const double> x, std::span<const double> y, Role role = Role::water);
  void vertical(std::string label, std::span<const double> x, Role role = Role::guide);

  [[nodiscard]] const Axes& axes() const { return axes_; }
  [[nodiscard]] const std::vector<Series>& series() const { return series_; }

 private:
  void add(Series series, std::size_t expected_x);

  Axes axes_;
  std::vector<Series> series_;
};

class Figure {
 public:
  std::string id;
  std::string title;
  std::string caption;
  std::vector<std::string> atlas;  ///< tiles of the atlas that this figure fills
  std::string drawing = "panels";  ///< name of the function in reports/render that draws it

  Figure(std::string figure_id, std::string figure_title, std::string figure_caption, std::vector<std::string> tiles)
      : id(std::move(figure_id)),
        title(std::move(figure_title)),
        caption(std::move(figure_caption)),
        atlas(std::move(tiles)) {}

  /// Adds a panel; the reference stays valid for the figure's life.
  Panel& panel(Axes axes) { return panels_.emplace_back(std::move(axes)); }
  [[nodiscard]] const std::deque<Panel>& panels() const { return panels_; }

 private:
  std::deque<Panel> panels_;
};

}  // namespace seiche::evidence
