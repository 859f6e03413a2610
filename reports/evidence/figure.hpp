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
enum class Style { line, points, steps, fill, vertical, surface, plan };

struct Series {
  std::string label;
  Role role = Role::computed;
  Style style = Style::line;
  std::vector<double> x;        ///< one entry more than y for steps
  std::vector<double> y;        ///< empty for vertical lines
  std::vector<double> y_error;  ///< empty or as long as y
  std::vector<double> z;        ///< surface and plan only, as x and y then are: row by row
  std::size_t row_points = 0;   ///< points in a row of a surface or plan
};

/// Heights over a deformed lattice of columns x rows cells: point (i, j), 0 <= i <= columns, 0 <= j <= rows, stands at
/// [j (columns + 1) + i] of each span. A cell with a corner that is not finite is left open.
struct Lattice {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::span<const double> x, y, z;
};

/// From where a surface is seen, in degrees; what is not given is chosen by the drawing, and the vertical exaggeration
/// is printed beside the surface in any case.
struct View {
  std::optional<double> azimuth;    ///< of the eye, from the x axis towards the y axis
  std::optional<double> elevation;  ///< of the eye above the horizontal, (0, 90)
  std::optional<double> exaggeration;
};

struct Axes {
  std::string x;  ///< label with unit: "x [m]"
  std::string y;
  std::string z = {};  ///< heights of surfaces and plans
  std::string title;
  bool log_x = false;
  bool log_y = false;
  bool equal_aspect = false;
  std::optional<double> x_min, x_max, y_min, y_max, z_min, z_max;
  View view = {};
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
  /// Shaded perspective view; in its panel there are only surfaces, such as the water and its bed. All points are kept
  /// in the record, at most 200 x 200 cells are drawn.
  void surface(std::string label, const Lattice& lattice, Role role = Role::computed);
  /// The same from above: colours and contour lines of z, with a colour bar, at one scale of x and y. Lines and points
  /// of the panel lie over it.
  void plan(std::string label, const Lattice& lattice, Role role = Role::computed);

  [[nodiscard]] const Axes& axes() const { return axes_; }
  [[nodiscard]] const std::vector<Series>& series() const { return series_; }

 private:
  void add(Series series, std::size_t expected_x);
  void add(std::string label, const Lattice& lattice, Style style, Role role);

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
