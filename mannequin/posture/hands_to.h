// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "geometry/shapes/triangle_mesh.h"
#include "mannequin/posture/posture_solver.h"

namespace hapticell::mannequin {

/// The requested place of a hand on a part.
struct HandTarget {
  dvec3 p_W{0.0};               ///< On the surface; target of the centre of the grip.
  dvec3 into_W{1.0, 0.0, 0.0};  ///< Unit, into the part: the direction of the palm, if the arm allows it.
};

struct HandsReach {
  Posture posture;
  std::array<double, 2> short_m{};  ///< m from the centre of each grip to its target; 0 for a hand without target.
};

/// Moves hands (left, right) to targets, from `start`. The palms face the part if the limits allow it; otherwise the
/// wrists follow the arms. `task` gives the other conditions (locks, feet, balance); its hands are ignored. Out of
/// reach: the nearest posture, and the remaining distance. Takes up to half a second; any thread.
HandsReach handsTo(const Figure& figure, const Posture& start, const PostureTask& task,
                   const std::array<std::optional<HandTarget>, 2>& targets);

/// Two opposite sides of a part for two hands: the intersections of a line across it with its surface. `across_W` is
/// about the direction to the left hand; the line follows the part's own axis nearest to it, through the picked point
/// (`p_W`, with the surface's outward normal `nhat_W`) or, if it meets nothing there, through the centre of the part.
/// Left, right. A mesh without triangles gives an empty result.
std::optional<std::array<HandTarget, 2>> oppositeSides(const geometry::TriangleMesh& mesh, const Pose& X_WM,
                                                       const dvec3& p_W, const dvec3& nhat_W, const dvec3& across_W);

}  // namespace hapticell::mannequin
