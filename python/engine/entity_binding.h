// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include "python/engine/workcell_binding.h"

namespace hapticell::python {

/// What Python sees of an entity: as it was when it was asked for.
struct EntityView {
  workcell::Entity entity;
};

/// The class Entity.
void bindEntity(pybind11::module_& module);
/// What places and changes the entities of a cell.
void bindPlacing(pybind11::class_<Workcell>& cell);

}  // namespace hapticell::python
