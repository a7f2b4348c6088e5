// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/error.h"

namespace hapticell::python {

namespace py = pybind11;

// Between Python's objects and the engine's values. All of these need the interpreter's lock.

/// Raises hapticell.Error with the parts of `error`.
[[noreturn]] void raise(const Error& error);
/// The value, or raises its error.
template <typename T>
T valueOf(Expected<T> expected) {
  if (!expected) raise(expected.error());
  if constexpr (!std::is_void_v<T>) return std::move(*expected);
}
/// Each as a Python warning (hapticell.Notice).
void tellWarnings(const std::vector<Text>& warnings);
/// Raises what a signal handler raised (KeyboardInterrupt at Ctrl+C).
void checkSignals();

/// C-contiguous doubles; without a copy where `given` is that already. Raises Error, naming `what`, for other objects.
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
Doubles doublesOf(py::handle given, const char* what);

/// None (identity), seven numbers x, y, z, qw, qx, qy, qz (metres; a quaternion of length 1 within a thousandth), or a
/// 4 x 4 matrix. Raises Error for others and for numbers that are not finite.
Pose poseOf(py::handle given);
/// An array of shape (n, 7) or (n, 4, 4).
std::vector<Pose> posesOf(py::handle given);
/// Three finite numbers.
dvec3 pointOf(py::handle given, const char* what);
/// `count` finite numbers; any number of them if `count` is negative.
std::vector<double> numbersOf(py::handle given, long count, const char* what);
/// A name or path: a str, or what stands for a path in Python.
std::string pathOf(py::handle given);

py::array_t<double> arrayOf(const dvec3& v);
py::array_t<double> arrayOf(const Pose& X);
py::array_t<double> arrayOf(const std::vector<Pose>& poses);
py::array_t<double> arrayOf(const std::vector<double>& numbers);
/// An array that is a view of `values`, which `owner` keeps; it cannot be written to.
py::array viewOf(py::dtype type, std::vector<py::ssize_t> shape, const void* values, py::handle owner);

/// Objects, lists and numbers as dict (hapticell.Result), list (hapticell.Records where all are objects) and Python
/// numbers; a list of numbers, or of equally long lists of numbers, is an array of float64 or int64.
py::object objectOf(const nlohmann::ordered_json& json);

}  // namespace hapticell::python
