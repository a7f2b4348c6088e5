// SPDX-License-Identifier: Apache-2.0
#include "python/engine/conversion.h"

#include <cmath>
#include <cstring>
#include <optional>

namespace hapticell::python {

namespace {

/// How far from 1 the length of a quaternion may be: numbers typed with three digits. Half: 0.707, 0.707 is refused;
/// twice: mistakes pass.
constexpr double kUnit = 1e-3;

std::string shapeText(const Doubles& array) {
  std::string text = "an array of shape (";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  return text + ")";
}

Pose poseOfSeven(const double* v) {
  const dquat q(v[3], v[4], v[5], v[6]);
  const double length = glm::length(q);
  const Pose pose{{v[0], v[1], v[2]}, q / length};
  if (std::abs(length - 1.0) < kUnit && pose.isValid()) return pose;
  raise({.place = "pose",
         .found = Text("x %1, y %2, z %3 and a quaternion of length %4", std::to_string(v[0]), std::to_string(v[1]),
                       std::to_string(v[2]), std::to_string(length)),
         .expected = "finite numbers x, y, z, qw, qx, qy, qz with a unit quaternion"});
}

Pose poseOfMatrix(const double* m) {
  dmat3 R;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) R[column][row] = m[4 * row + column];
  }
  const dmat3 off = glm::transpose(R) * R - dmat3(1.0);
  double worst = std::abs(glm::determinant(R) - 1.0);
  for (int i = 0; i < 9; ++i) worst = std::max(worst, std::abs(off[i / 3][i % 3]));
  const bool last_row = m[12] == 0.0 && m[13] == 0.0 && m[14] == 0.0 && m[15] == 1.0;
  const Pose pose{{m[3], m[7], m[11]}, glm::normalize(glm::quat_cast(R))};
  if (worst < kUnit && last_row && pose.isValid()) return pose;
  raise({.place = "pose",
         .found = "a matrix that is not a rigid pose",
         .expected = "a rotation and a translation, with 0, 0, 0, 1 in the last row"});
}

/// float64 or int64 numbers of a list, and the numbers of their rows.
class NumberTable {
 public:
  /// Empty unless all are numbers, or all are equally long lists of numbers.
  static std::optional<NumberTable> of(const nlohmann::ordered_json& list) {
    NumberTable table;
    for (const auto& row : list) {
      const bool is_row = row.is_array();
      if (!is_row && !row.is_number()) return std::nullopt;
      const long width = is_row ? static_cast<long>(row.size()) : -1;
      if (table.rows_ > 0 && width != table.width_) return std::nullopt;
      table.width_ = width;
      ++table.rows_;
      if (!is_row) {
        table.add(row);
        continue;
      }
      for (const auto& number : row) {
        if (!number.is_number()) return std::nullopt;
        table.add(number);
      }
    }
    if (table.numbers_.empty()) return std::nullopt;
    return table;
  }

  py::object array() const {
    std::vector<py::ssize_t> shape{rows_};
    if (width_ >= 0) shape.push_back(width_);
    if (!whole_) return py::array_t<double>(shape, numbers_.data());
    py::array_t<std::int64_t> integers(shape);
    std::transform(numbers_.begin(), numbers_.end(), integers.mutable_data(),
                   [](double number) { return static_cast<std::int64_t>(number); });
    return integers;
  }

 private:
  void add(const nlohmann::ordered_json& number) {
    // Beyond 2^53 a double does not hold each whole number.
    whole_ = whole_ && number.is_number_integer() && std::abs(number.get<double>()) < 9007199254740992.0;
    numbers_.push_back(number.get<double>());
  }

  std::vector<double> numbers_;
  py::ssize_t rows_ = 0;
  long width_ = -1;  ///< Of each row; -1: the list holds numbers.
  bool whole_ = true;
};

py::object listOf(const nlohmann::ordered_json& json) {
  if (const auto table = NumberTable::of(json)) return table->array();
  const bool records =
      !json.empty() && std::all_of(json.begin(), json.end(), [](const auto& one) { return one.is_object(); });
  py::list list;
  for (const auto& one : json) list.append(objectOf(one));
  return records ? py::module_::import("hapticell._results").attr("Records")(list) : py::object(list);
}

}  // namespace

void raise(const Error& error) {
  const py::object type = py::module_::import("hapticell._errors").attr("Error");
  const py::object raised = type(error.file, english(error.place), english(error.found), english(error.expected),
                                 english(error.fix), error.message());
  PyErr_SetObject(type.ptr(), raised.ptr());
  throw py::error_already_set();
}

void tellWarnings(const std::vector<Text>& warnings) {
  if (warnings.empty()) return;
  const py::object category = py::module_::import("hapticell._errors").attr("Notice");
  for (const Text& warning : warnings) {
    if (PyErr_WarnEx(category.ptr(), english(warning).c_str(), 1) != 0) throw py::error_already_set();
  }
}

void checkSignals() {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

Doubles doublesOf(py::handle given, const char* what) {
  Doubles array = Doubles::ensure(given);
  if (array) return array;
  PyErr_Clear();
  raise({.place = Text::plain(what),
         .found = Text::plain(py::str(py::type::of(given).attr("__name__"))),
         .expected = "numbers, or an array of them"});
}

Pose poseOf(py::handle given) {
  if (given.is_none()) return {};
  const Doubles array = doublesOf(given, "pose");
  if (array.ndim() == 1 && array.size() == 7) return poseOfSeven(array.data());
  if (array.ndim() == 2 && array.shape(0) == 4 && array.shape(1) == 4) return poseOfMatrix(array.data());
  raise({.place = "pose",
         .found = Text::plain(shapeText(array)),
         .expected = "x, y, z, qw, qx, qy, qz, or a 4 x 4 matrix"});
}

std::vector<Pose> posesOf(py::handle given) {
  const Doubles array = doublesOf(given, "poses");
  const bool sevens = array.ndim() == 2 && array.shape(1) == 7;
  const bool matrices = array.ndim() == 3 && array.shape(1) == 4 && array.shape(2) == 4;
  if (!sevens && !matrices) {
    raise({.place = "poses",
           .found = Text::plain(shapeText(array)),
           .expected = "an array of shape (n, 7) with x, y, z, qw, qx, qy, qz, or (n, 4, 4)"});
  }
  std::vector<Pose> poses(static_cast<std::size_t>(array.shape(0)));
  const double* at = array.data();
  for (Pose& pose : poses) {
    pose = sevens ? poseOfSeven(at) : poseOfMatrix(at);
    at += sevens ? 7 : 16;
  }
  return poses;
}

dvec3 pointOf(py::handle given, const char* what) {
  const std::vector<double> v = numbersOf(given, 3, what);
  return {v[0], v[1], v[2]};
}

std::vector<double> numbersOf(py::handle given, long count, const char* what) {
  const Doubles array = doublesOf(given, what);
  const bool fits = array.ndim() == 1 && (count < 0 || array.size() == count);
  bool finite = true;
  for (py::ssize_t i = 0; fits && i < array.size(); ++i) finite = finite && std::isfinite(array.data()[i]);
  if (fits && finite) return {array.data(), array.data() + array.size()};
  raise({.place = Text::plain(what),
         .found = finite ? Text::plain(shapeText(array)) : Text("a number that is not finite"),
         .expected = count < 0 ? Text("finite numbers") : Text("%1 finite numbers", count)});
}

std::string pathOf(py::handle given) {
  return py::str(py::module_::import("os").attr("fspath")(given));
}

py::array_t<double> arrayOf(const dvec3& v) {
  py::array_t<double> array(3);
  double* const to = array.mutable_data();
  to[0] = v.x, to[1] = v.y, to[2] = v.z;
  return array;
}

namespace {

void writePose(const Pose& X, double* to) {
  to[0] = X.p.x, to[1] = X.p.y, to[2] = X.p.z;
  to[3] = X.q.w, to[4] = X.q.x, to[5] = X.q.y, to[6] = X.q.z;
}

}  // namespace

py::array_t<double> arrayOf(const Pose& X) {
  py::array_t<double> array(7);
  writePose(X, array.mutable_data());
  return array;
}

py::array_t<double> arrayOf(const std::vector<Pose>& poses) {
  py::array_t<double> array({static_cast<py::ssize_t>(poses.size()), py::ssize_t{7}});
  double* to = array.mutable_data();
  for (const Pose& X : poses) {
    writePose(X, to);
    to += 7;
  }
  return array;
}

py::array_t<double> arrayOf(const std::vector<double>& numbers) {
  return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

py::array viewOf(py::dtype type, std::vector<py::ssize_t> shape, const void* values, py::handle owner) {
  py::array view(std::move(type), std::move(shape), values, owner);
  py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return view;
}

py::object objectOf(const nlohmann::ordered_json& json) {
  switch (json.type()) {
    case nlohmann::json::value_t::object: {
      py::object result = py::module_::import("hapticell._results").attr("Result")();
      for (const auto& [key, value] : json.items()) result[py::str(key)] = objectOf(value);
      return result;
    }
    case nlohmann::json::value_t::array:
      return listOf(json);
    case nlohmann::json::value_t::string:
      return py::reinterpret_steal<py::object>(
          PyUnicode_DecodeUTF8(json.get_ref<const std::string&>().c_str(),
                               static_cast<Py_ssize_t>(json.get_ref<const std::string&>().size()), "replace"));
    case nlohmann::json::value_t::boolean:
      return py::bool_(json.get<bool>());
    case nlohmann::json::value_t::number_integer:
      return py::int_(json.get<std::int64_t>());
    case nlohmann::json::value_t::number_unsigned:
      return py::int_(json.get<std::uint64_t>());
    case nlohmann::json::value_t::number_float:
      return py::float_(json.get<double>());
    default:
      return py::none();
  }
}

}  // namespace hapticell::python
