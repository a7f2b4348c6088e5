// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::python {

/// A field of a structured array: its name, numpy's word for its type ("f8", "?", "(3,)f8") and its place in the
/// struct.
struct ArrayField {
  const char* name;
  const char* type;
  std::size_t offset;
};

/// A vector into a field of three numbers.
inline void put(const dvec3& v, double (&to)[3]) {
  to[0] = v.x, to[1] = v.y, to[2] = v.z;
}

/// A turn into a field of four numbers, w first.
inline void put(const dquat& q, double (&to)[4]) {
  to[0] = q.w, to[1] = q.x, to[2] = q.y, to[3] = q.z;
}

/// A structured array of the rows, which it takes over without copying them. Row is a struct of plain numbers. Needs
/// the interpreter's lock.
template <typename Row>
pybind11::array structuredArray(std::vector<Row> rows, const std::vector<ArrayField>& fields) {
  namespace py = pybind11;
  py::list names, types, offsets;
  for (const ArrayField& field : fields) {
    names.append(field.name);
    types.append(field.type);
    offsets.append(field.offset);
  }
  const py::dtype type(names, types, offsets, static_cast<py::ssize_t>(sizeof(Row)));
  auto* const kept = new std::vector<Row>(std::move(rows));
  const py::capsule owner(kept, [](void* vector) { delete static_cast<std::vector<Row>*>(vector); });
  return py::array(type, {static_cast<py::ssize_t>(kept->size())}, {static_cast<py::ssize_t>(sizeof(Row))},
                   kept->data(), owner);
}

}  // namespace hapticell::python
