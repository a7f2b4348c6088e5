// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <limits>
#include <memory>
#include <string>

#include "collision/queries/distance_result.h"
#include "collision/trees/mesh_collider.h"

namespace hapticell::python {

/// What Python sees as hapticell.Mesh: a mesh with its tree, shared and immutable.
struct Mesh {
  std::shared_ptr<const collision::MeshCollider> collider;
  std::string name;
};

/// No limit to a distance that is asked for, metres.
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// What Python sees as hapticell.Distance.
using Distance = collision::DistanceResult;

}  // namespace hapticell::python
