// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace hapticell::ergonomics {

/// One side's arm in PostureAngles.
struct ObservedArm {
  std::optional<double> upper_arm_flexion;
  std::optional<double> lower_arm_flexion;
  std::optional<double> wrist_flexion;
  std::optional<bool> upper_arm_abducted;
  std::optional<bool> upper_arm_rotated;  ///< REBA only.
  std::optional<bool> shoulder_raised;
  std::optional<bool> arm_supported;
  std::optional<bool> lower_arm_across_midline;  ///< Or out to the side.
  std::optional<bool> wrist_deviated;            ///< REBA: or twisted.
  std::optional<bool> wrist_twist_at_end;        ///< Near the end of pronation or supination; else in its middle.
};

/// Neck and trunk in PostureAngles.
struct ObservedTrunk {
  std::optional<double> neck_flexion;
  std::optional<double> trunk_flexion;
  std::optional<bool> neck_twisted;
  std::optional<bool> neck_side_bent;
  std::optional<bool> trunk_twisted;
  std::optional<bool> trunk_side_bent;
  std::optional<bool> trunk_supported;  ///< Seated and well supported; not given: no.
};

/// Legs in PostureAngles.
struct ObservedLegs {
  std::optional<double> knee_flexion;
  std::optional<bool> legs_supported;  ///< RULA: feet supported and evenly balanced.
  std::optional<bool> legs_bilateral;  ///< REBA: weight on both legs, or walking.
  std::optional<bool> seated;
  /// Degrees by which a standing figure differs from seated: REBA's score of the legs increases with it.
  std::optional<double> off_seat;
};

/// A posture in the terms of the observation methods: the arm of one side, and the body. Angles in degrees, as a person
/// with a worksheet reads them; values that nobody observed are empty and never scored as zero.
///
/// Flexion is positive forwards (wrist: both directions), extension negative; the elbow and the knee are 0 when
/// straight; the upper arm and the neck are measured against the trunk, the trunk against the vertical.
struct PostureAngles : ObservedArm, ObservedTrunk, ObservedLegs {
  /// Measured by an instrument or on a figure, not observed: kNeutralBand is then applied, and RULA's neck classes grow
  /// step by step up to extension. Not given: observed, and the text of the method is applied literally.
  std::optional<bool> measured;
};

/// A measured angle of trunk, neck or wrist within this many degrees of 0 counts as neutral: the methods give no width,
/// and noise of 0.1 deg would decide. Half: noise of marker sets decides; twice: all of RULA's first class.
inline constexpr double kNeutralBand = 5.0;
/// RULA's neck beyond the band, measured: up to this many degrees of extension it is class 2, then 3, then 4. Chosen so
/// that one degree changes the class by one (PostureSweep). Half or less than 1 apart: by two; twice: 16 deg of
/// extension is not yet class 4.
inline constexpr double kNeckSecond = 6.5, kNeckThird = 8.0;

/// The range, in degrees, over which nearly seated legs change from REBA's class of the seated to their own, in three
/// classes 1.5 apart, so that one degree changes one class (PostureSweep). Half: two classes; twice: half squats count
/// as seated.
inline constexpr double kOffSeat = 4.5;

/// The angle for classification: 0 if it is measured and neutral.
double neutralSettled(const PostureAngles& angles, double degrees);

/// One side's arm in MeasuredPosture.
struct MeasuredArm {
  double upper_arm_flexion = 0.0;
  double upper_arm_abduction = 0.0;
  /// Angle from hanging, in any direction; not given: computed from the two before it.
  std::optional<double> upper_arm_elevation;
  double upper_arm_rotation = 0.0;
  double girdle_elevation = 0.0;
  double lower_arm_flexion = 0.0;
  double lower_arm_outwards = 0.0;  ///< Of the forearm out of the sagittal plane, degrees; inwards negative.
  bool wrist_past_midline = false;
  double wrist_flexion = 0.0;
  double wrist_deviation = 0.0;
  double wrist_twist_share = 0.0;  ///< |pronation or supination| over its range to that side.
};

/// Neck and trunk in MeasuredPosture.
struct MeasuredTrunk {
  double neck_flexion = 0.0;
  double neck_twist = 0.0;
  double neck_side_bend = 0.0;
  double trunk_flexion = 0.0;
  double trunk_twist = 0.0;
  double trunk_side_bend = 0.0;
};

/// Legs in MeasuredPosture.
struct MeasuredLegs {
  double knee_flexion = 0.0;           ///< The more bent one.
  double share_on_heavier_foot = 0.5;  ///< Of the weight, 0.5 to 1.
  bool seated = false;
  double off_seat = 180.0;  ///< Degrees missing to a seated posture; 0 or less if seated.
};

/// PostureAngles measured on a figure, with twist, side bend and the like also as angles. Each is in its own plane (see
/// view_planes.h): a side bend has no flexion, a twist has neither.
struct MeasuredPosture : MeasuredArm, MeasuredTrunk, MeasuredLegs {};

/// The angles from which a figure counts as twisted, abducted and so on, degrees. The texts of the methods give none:
/// 10 deg is "clearly visible" in EN 1005-4, the others are this project's choice, printed in each report.
struct PostureThresholds {
  double twist = 10.0;
  double side_bend = 10.0;
  double abduction = 45.0;
  double rotation = 45.0;
  double girdle_elevation = 10.0;
  double lower_arm_outwards = 45.0;
  double wrist_deviation = 10.0;
  double wrist_twist_share = 0.75;
  double one_leg_share = 0.9;
  double upright = kNeutralBand;  ///< Trunk within this of the vertical is upright.
  double neutral_neck = kNeutralBand;
  double neutral_wrist = kNeutralBand;
};

/// Marked as measured. `arm_supported` and `trunk_supported` are left empty, because a figure does not show them.
PostureAngles postureAngles(const MeasuredPosture& measured, const PostureThresholds& thresholds = {});

}  // namespace hapticell::ergonomics
