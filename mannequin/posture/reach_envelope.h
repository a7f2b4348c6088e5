// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/triangle_mesh.h"
#include "mannequin/posture/posture_solver.h"

namespace hapticell::mannequin {

struct ReachOptions {
  bool with_trunk = false;  ///< The trunk leans and turns, feet standing; else the shoulder alone.
  int meridians = 24;       ///< Directions around, half as many bands from bottom to top.
};

/// How far the grip of a hand gets in every direction from its shoulder, as a closed surface in the world. Each vertex
/// is where the posture solver stops on the way out of the reach, so limits of all joints and, with the trunk, balance
/// are in it. The hand may turn as it likes.
geometry::TriangleMesh reachEnvelope(const Figure& figure, const Posture& posture, Side side,
                                     const ReachOptions& options = {});

}  // namespace hapticell::mannequin
