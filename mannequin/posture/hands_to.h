// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "geometry/shapes/triangle_mesh.h"
#include "mannequin/posture/posture_solver.h"

namespace hapticell::mannequin {

/// Where a hand is wanted on a part.
struct HandTarget {
  dvec3 p_W{0.0};               ///< On the surface; there the centre of the grip goes.
  dvec3 into_W{1.0, 0.0, 0.0};  ///< Unit, into the part: the direction of the palm, if the arm allows it.
};

struct HandsReach {
  Posture posture;
  std::array<double, 2> short_m{};  ///< m from each grip's centre to its target; 0 for a hand that is not sent.
};

/// Sends hands (left, right) to targets, from `start`. The palms face the part if the limits allow it; else the wrists
/// follow the arms. `task` says what else holds (locks, feet, balance); its hands are not minded. Out of reach: the
/// nearest posture, and by how much it is short. Takes up to half a second; any thread.
HandsReach handsTo(const Figure& figure, const Posture& start, const PostureTask& task,
                   const std::array<std::optional<HandTarget>, 2>& targets);

/// Two opposite sides of a part for two hands: where a line across it leaves its surface. `across_W` is about where the
/// left hand is; the line follows the part's own axis that is nearest to it, through the picked point (`p_W`, with the
/// surface's outward normal `nhat_W`), or where it meets nothing there, through the part's middle. Left, right. A mesh
/// without triangles gives nothing.
std::optional<std::array<HandTarget, 2>> oppositeSides(const geometry::TriangleMesh& mesh, const Pose& X_WM,
                                                       const dvec3& p_W, const dvec3& nhat_W, const dvec3& across_W);

}  // namespace hapticell::mannequin
