// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace hapticell::mannequin {

/// Into how many groups (colours) a skin is cut at most.
inline constexpr std::size_t kMostGroups = 8;

/// How far (m) a vertex is from each group's bodies; large where a group is not there.
using GroupDistances = std::array<double, kMostGroups>;

/// Cuts a mesh into a mesh for each group, where two of them are equally near: along clean lines through the triangles,
/// sharing vertices within a group, without a gap between groups. `distances`: one for each vertex.
std::vector<geometry::TriangleMesh> cutByGroups(const geometry::TriangleMesh& mesh,
                                                const std::vector<GroupDistances>& distances);

}  // namespace hapticell::mannequin
