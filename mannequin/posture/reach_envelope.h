// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/triangle_mesh.h"
#include "mannequin/posture/posture_solver.h"

namespace hapticell::mannequin {

struct ReachOptions {
  bool with_trunk = false;  ///< The trunk leans and turns, with the feet fixed; otherwise only the shoulder moves.
  int meridians = 24;       ///< Directions around, half as many bands from bottom to top.
};

/// The reach of the grip of a hand in every direction from its shoulder, as a closed surface in the world. Each vertex
/// is the farthest point that the posture solver reaches, so limits of all joints and, with the trunk, balance are
/// included. The orientation of the hand is free.
geometry::TriangleMesh reachEnvelope(const Figure& figure, const Posture& posture, Side side,
                                     const ReachOptions& options = {});

}  // namespace hapticell::mannequin
