// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/body/figure.h"
#include "mannequin/posture/forward_kinematics.h"

namespace hapticell::mannequin {

/// A leg in closed form: hip as a rotation of the thigh in the pelvis, the rest as angles (rad).
struct LegAngles {
  dmat3 R_PelvisThigh{1.0};
  double knee = 0.0;
  double plantar_flexion = 0.0;
  double inversion = 0.0;
  double violation = 0.0;  ///< Sum of the excess over hard limits, rad; 0 if all hold.
  /// m by which the leg is too short or too long for the distance; the knee is then at its limit.
  double missing = 0.0;
};

/// The leg posture that puts the foot at X_WF under a pelvis at `pelvis`.
LegAngles legInverse(const Figure& figure, Side side, const SegmentPlace& pelvis, const SegmentPlace& foot);

/// An arm in closed form.
struct ArmAngles {
  dmat3 R_ClavicleUpperArm{1.0};
  double elbow = 0.0;
  double pronation = 0.0;
  double wrist_flexion = 0.0;
  double wrist_ulnar = 0.0;
  double swivel = 0.0;
  double violation = 0.0;
  double missing = 0.0;  ///< m by which the wrist misses its target (too far or too near).
};

/// Data of the arm's inverse that does not depend on the swivel. Tolani, Goswami and Badler, Graphical Models 62
/// (2000).
///
/// The swivel is the angle of the elbow about the line from shoulder to wrist: 0 if the elbow hangs along the trunk's
/// down, positive outward.
class ArmProblem {
 public:
  ArmProblem(const Figure& figure, Side side, const SegmentPlace& thorax, const SegmentPlace& clavicle,
             const SegmentPlace& hand);

  ArmAngles at(double swivel) const;
  /// The same without checking limits (`violation` stays 0).
  ArmAngles anglesAt(double swivel) const;
  /// The swivel of an elbow seen at p_WE (projected onto the circle).
  double swivelOf(const dvec3& p_WE) const;
  /// Distance shoulder to wrist over the arm's length.
  double stretch() const { return distance_ / (upper_ + forearm_); }

  /// Discomfort of a swivel, lower is better: pronation, wrist, humeral twist and a raised elbow, with round weights
  /// chosen on recorded motion (docs/dev/mannequin.md). Takes the arm already solved at that swivel.
  double discomfort(const ArmAngles& arm) const;
  /// The most comfortable swivel: `samples` of the circle and a parabola through the best.
  double preferredSwivel(int samples = 24) const;
  /// The same, near a known swivel: five values within `span`.
  double preferredSwivelNear(double swivel, double span) const;

 private:
  double refined(double best, double step) const;

  Side side_;
  double upper_, forearm_;
  dmat3 R_WC_, R_WH_, R_WThorax_, R_Elbow_;
  dvec3 p_WShoulder_;
  dvec3 along_, down_, outward_;  ///< Unit: to the wrist, and across it.
  double distance_ = 0.0, elbow_ = 0.0, centre_ = 0.0, radius_ = 0.0, missing_ = 0.0;
};

}  // namespace hapticell::mannequin
