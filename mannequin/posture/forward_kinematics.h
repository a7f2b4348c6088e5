// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mannequin/body/figure.h"
#include "mannequin/posture/posture.h"

namespace hapticell::mannequin {

/// The frame S of a segment in the world. A matrix, not a Pose: this is the inner loop of the solver, and products of a
/// few rotations stay orthonormal to rounding.
struct SegmentPlace {
  dmat3 R_WS{1.0};
  dvec3 p_WS{0.0};

  dvec3 point(const dvec3& p_SQ) const { return p_WS + R_WS * p_SQ; }
  Pose pose() const { return {p_WS, glm::normalize(glm::quat_cast(R_WS))}; }
};

/// The frames of all segments.
struct FigurePose {
  std::array<SegmentPlace, kSegmentCount> segments{};

  const SegmentPlace& operator[](Segment segment) const { return segments[indexOf(segment)]; }
  SegmentPlace& operator[](Segment segment) { return segments[indexOf(segment)]; }
};

/// Sines and cosines by one polynomial for all 56 angles (within 1e-15 of the true ones for |angle| <= 8 rad): the same
/// bits on every machine. No allocation.
void forwardKinematics(const Figure& figure, const Posture& posture, FigurePose& pose);
FigurePose forwardKinematics(const Figure& figure, const Posture& posture);

/// R = Ry(y) Rx(x) Rz(z) and its inverse. Of the two equivalent triples, the one with the smaller sum of absolute
/// values; if y and z are the same rotation (x = +-90 deg), z is 0.
dmat3 rotationYXZ(const dvec3& angles_xyz);
dvec3 anglesYXZ(const dmat3& R);

/// Midway between the hip joints, in the world.
dvec3 middleOfHips(const FigurePose& pose);

/// A load in a hand, kg, with its centre in the hand's frame.
struct HandLoad {
  double mass = 0.0;
  dvec3 p_HC{0.0};
};

/// Centre of mass of the body and of the loads in its hands (left, right).
dvec3 centerOfMass(const Figure& figure, const FigurePose& pose, const std::array<HandLoad, 2>& loads = {});

/// Pose of a hand (its segment's frame H: origin at the wrist, fingers along -Z, back of the left hand +Y).
Pose handPose(const FigurePose& pose, Side side);
Pose footPose(const FigurePose& pose, Side side);

}  // namespace hapticell::mannequin
