/// What of the Python package `seiche` is compiled: the exact solutions with numpy arrays in and out, and the reader of
/// tables.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/exact/catalogue.hpp"
#include "seiche/io/text_table.hpp"
#include "seiche/require_that.hpp"

namespace py = pybind11;
using namespace seiche;

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A solution with its parameters fixed.
class Solution {
 public:
  Solution(const exact::ExactSolution& description, const std::map<std::string, double>& parameters)
      : description_(&description), evaluator_(description.evaluator(parameters)) {
    for (const auto& p : description.parameters) parameters_[p.name] = p.default_value;
    for (const auto& [name, value] : parameters) parameters_[name] = value;
  }

  /// Outputs at the broadcast coordinates.
  [[nodiscard]] py::dict at(const py::kwargs& coordinates) const {
    bool outside_is_nan = false;
    const std::vector<Array> inputs = broadcast(coordinates, outside_is_nan);
    if (evaluator_.curve) return curve(inputs);
    const auto count = inputs.empty() ? py::ssize_t{1} : inputs.front().size();
    const std::vector<py::ssize_t> shape =
        inputs.empty()
            ? std::vector<py::ssize_t>{}
            : std::vector<py::ssize_t>(inputs.front().shape(), inputs.front().shape() + inputs.front().ndim());
    std::vector<Array> outputs;
    for (std::size_t k = 0; k < description_->outputs.size(); ++k) outputs.emplace_back(shape);
    std::vector<const double*> from;
    std::vector<double*> to;
    for (const Array& input : inputs) from.push_back(input.data());
    for (Array& output : outputs) to.push_back(output.mutable_data());
    {
      const py::gil_scoped_release others_may_run;
      std::vector<double> point(inputs.size());
      for (py::ssize_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < from.size(); ++k) point[k] = from[k][i];
        std::vector<double> values;
        try {
          values = evaluator_.eval(point);
        } catch (const exact::OutsideFluid&) {
          if (!outside_is_nan) throw;
          values.assign(to.size(), std::numeric_limits<double>::quiet_NaN());
        }
        for (std::size_t k = 0; k < to.size(); ++k) to[k][i] = values[k];
      }
    }
    return named(outputs);
  }

  [[nodiscard]] py::dict scalars() const {
    const std::vector<double> values = evaluator_.scalars();
    py::dict result;
    for (std::size_t k = 0; k < values.size(); ++k) result[description_->scalars[k].name.c_str()] = values[k];
    return result;
  }

  [[nodiscard]] py::list self_test() const {
    py::list result;
    for (const exact::Identity& identity : evaluator_.self_test()) {
      py::dict entry;
      entry["name"] = identity.name;
      entry["defect"] = identity.defect;
      entry["accuracy"] = identity.accuracy;
      entry["reason"] = identity.reason;
      result.append(entry);
    }
    return result;
  }

  [[nodiscard]] double uncertainty() const { return evaluator_.uncertainty(); }
  [[nodiscard]] const std::map<std::string, double>& parameters() const { return parameters_; }
  [[nodiscard]] const exact::ExactSolution& description() const { return *description_; }

 private:
  [[nodiscard]] std::vector<Array> broadcast(const py::kwargs& coordinates, bool& outside_is_nan) const {
    std::vector<std::string> names;
    for (const auto& input : description_->inputs) names.push_back(input.name);
    for (const auto& [key, value] : coordinates) {
      const auto name = py::cast<std::string>(key);
      if (name == "outside") {
        const auto choice = py::cast<std::string>(value);
        require_that(choice == "nan" || choice == "error", "outside = {} is unknown: must be nan or error", choice);
        outside_is_nan = choice == "nan";
      } else if (std::find(names.begin(), names.end(), name) == names.end()) {
        throw std::invalid_argument(fmt::format("{} has no coordinate {}: it has {}", description_->name, name,
                                                names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
      }
    }
    if (names.empty()) return {};
    py::list given;
    for (const auto& input : description_->inputs) {
      given.append(coordinates.contains(input.name.c_str()) ? py::object(coordinates[input.name.c_str()])
                                                            : py::object(py::float_(input.default_value)));
    }
    const py::object arrays = py::module_::import("numpy").attr("broadcast_arrays")(*given);
    std::vector<Array> inputs;
    for (const py::handle array : arrays) inputs.push_back(Array::ensure(array));
    return inputs;
  }

  [[nodiscard]] py::dict curve(const std::vector<Array>& inputs) const {
    std::vector<double> point;
    for (const Array& input : inputs) {
      require_that(input.size() == 1, "{} is a curve: coordinates must be single numbers", description_->name);
      point.push_back(input.data()[0]);
    }
    const auto rows = evaluator_.curve(point);
    std::vector<Array> outputs;
    for (std::size_t k = 0; k < description_->outputs.size(); ++k) {
      outputs.emplace_back(static_cast<py::ssize_t>(rows.size()));
      for (std::size_t i = 0; i < rows.size(); ++i) outputs.back().mutable_data()[i] = rows[i][k];
    }
    return named(outputs);
  }

  [[nodiscard]] py::dict named(const std::vector<Array>& outputs) const {
    py::dict result;
    for (std::size_t k = 0; k < outputs.size(); ++k) result[description_->outputs[k].name.c_str()] = outputs[k];
    return result;
  }

  const exact::ExactSolution* description_;
  exact::Evaluator evaluator_;
  std::map<std::string, double> parameters_;
};

/// Numbers, and names of choices, from keyword arguments.
Solution make(const exact::ExactSolution& description, const py::kwargs& arguments) {
  std::map<std::string, double> parameters;
  for (const auto& [key, value] : arguments) {
    const auto name = py::cast<std::string>(key);
    if (!py::isinstance<py::str>(value)) {
      parameters[name] = py::cast<double>(value);
      continue;
    }
    const auto text = py::cast<std::string>(value);
    for (const auto& p : description.parameters) {
      if (p.name != name) continue;
      const auto choice = std::find(p.choices.begin(), p.choices.end(), text);
      require_that(choice != p.choices.end(), "{} = {} is unknown: must be one of {}", name, text,
                   fmt::join(p.choices, ", "));
      parameters[name] = static_cast<double>(choice - p.choices.begin());
    }
    require_that(parameters.count(name) != 0, "{} is not a parameter", name);
  }
  return {description, parameters};
}

std::string docstring(const exact::ExactSolution& s) {
  std::string text = fmt::format("{}.\n\n{}\n\n{}\n\nParameters:\n", s.title, s.formula, s.citation);
  for (const auto& p : s.parameters) {
    text += fmt::format("  {} [{}]: {}; {}\n", p.name, p.unit, p.meaning,
                        p.choices.empty()
                            ? fmt::format("default {:g}, in [{:g}, {:g}]", p.default_value, p.minimum, p.maximum)
                            : fmt::format("one of {}", fmt::join(p.choices, ", ")));
  }
  text += "Coordinates:\n";
  for (const auto& i : s.inputs) text += fmt::format("  {} [{}]: {}\n", i.name, i.unit, i.meaning);
  text += "Outputs:\n";
  for (const auto& o : s.outputs) text += fmt::format("  {} [{}]: {}\n", o.name, o.unit, o.meaning);
  text += "Scalars:\n";
  for (const auto& o : s.scalars) text += fmt::format("  {} [{}]: {}\n", o.name, o.unit, o.meaning);
  return text;
}

/// Docstring, and what every parameter is by default.
py::dict described(const exact::ExactSolution& s) {
  py::dict defaults;
  for (const auto& p : s.parameters) {
    defaults[p.name.c_str()] = p.choices.empty()
                                   ? py::object(py::float_(p.default_value))
                                   : py::object(py::str(p.choices.at(static_cast<std::size_t>(p.default_value))));
  }
  py::dict result;
  result["doc"] = docstring(s);
  result["defaults"] = defaults;
  return result;
}

py::dict read_table(const std::filesystem::path& path) {
  const io::Table table = io::read_table(path);
  py::dict columns;
  for (std::size_t k = 0; k < table.names.size(); ++k) {
    columns[table.names[k].c_str()] = Array(static_cast<py::ssize_t>(table.columns[k].size()), table.columns[k].data());
  }
  return columns;
}

}  // namespace

PYBIND11_MODULE(_seiche, m) {
  m.doc() = "Exact and semi-analytic solutions of free-surface flows, with numpy arrays in and out.";

  py::class_<Solution>(m, "Solution", "An exact solution with its parameters fixed; call it with coordinates.")
      .def("__call__", &Solution::at,
           "Outputs by name at the given coordinates, which broadcast like numpy's. Outside the fluid: ValueError, or "
           "NaN with outside='nan'.")
      .def("self_test", &Solution::self_test,
           "The solution's own identities, each with its defect, the accuracy that round-off or resolution explain, "
           "and why.")
      .def_property_readonly("scalars", &Solution::scalars, "Numbers that belong to the solution as a whole, by name.")
      .def_property_readonly("uncertainty", &Solution::uncertainty,
                             "Bound of the numerical error, relative to the solution's own scale.")
      .def_property_readonly("parameters", &Solution::parameters)
      .def_property_readonly("name", [](const Solution& s) { return s.description().name; })
      .def_property_readonly("citation", [](const Solution& s) { return s.description().citation; })
      .def(py::pickle([](const Solution& s) { return py::make_tuple(s.description().name, s.parameters()); },
                      [](const py::tuple& state) {
                        const auto parameters = state[1].cast<std::map<std::string, double>>();
                        return Solution(exact::find_solution(state[0].cast<std::string>()), parameters);
                      }))
      .def("__repr__", [](const Solution& s) {
        std::vector<std::string> words;
        for (const auto& [name, value] : s.parameters()) words.push_back(fmt::format("{}={:g}", name, value));
        return fmt::format("seiche.{}({})", s.description().name, fmt::join(words, ", "));
      });

  std::vector<std::string> names;
  for (const exact::ExactSolution& solution : exact::catalogue()) names.push_back(solution.name);
  m.attr("solutions") = names;
  m.attr("__version__") = SEICHE_VERSION;
  m.def("describe", [](const std::string& name) { return described(exact::find_solution(name)); });
  m.def("read_table", read_table);
  m.def("exact", [](const std::string& name, const py::kwargs& parameters) {
    return make(exact::find_solution(name), parameters);
  });
}
