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
  std::optional<double> off_seat;  ///< Degrees that a standing figure lacks to be seated: REBA's legs go up with it.
};

/// A posture as the observation methods ask for it: one side's arm, and the body. Angles in degrees, as a person with
/// a worksheet reads them; what nobody observed is empty and never scored as zero.
///
/// Flexion is positive forwards (wrist: either way), extension negative; the elbow and the knee are 0 when straight;
/// the upper arm and the neck are measured against the trunk, the trunk against the vertical.
struct PostureAngles : ObservedArm, ObservedTrunk, ObservedLegs {
  /// By an instrument or on a figure, not by eye: then kNeutralBand counts, and RULA's neck leads up to its extension
  /// class by class. Not given: by eye, and the methods' text is followed to the letter.
  std::optional<bool> measured;
};

/// A measured angle of trunk, neck or wrist within so many degrees of 0 is neutral: the methods name no width, and
/// noise of 0.1 deg would decide. Half: noise of marker sets does; twice: all of RULA's first class.
inline constexpr double kNeutralBand = 5.0;
/// RULA's neck behind the band, measured: up to so many degrees of extension it is class 2, then 3, beyond 4.
/// Chosen so that one degree changes the class by one (PostureSweep). Half or less than 1 apart: it does by two; twice:
/// 16 deg of extension is not 4 yet.
inline constexpr double kNeckSecond = 6.5, kNeckThird = 8.0;

/// Degrees within which legs that are nearly seated go from REBA's class of the seated to their own, three classes 1.5
/// apart, so that one degree changes one (PostureSweep). Half: it does by two; twice: half squats count as seated.
inline constexpr double kOffSeat = 4.5;

/// The angle as it is classed: 0 where it is measured and neutral.
double neutralSettled(const PostureAngles& angles, double degrees);

/// One side's arm in MeasuredPosture.
struct MeasuredArm {
  double upper_arm_flexion = 0.0;
  double upper_arm_abduction = 0.0;
  std::optional<double> upper_arm_elevation;  ///< Against hanging, whichever way; not given: out of the two before it.
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
  double off_seat = 180.0;  ///< Degrees that it lacks to be seated; 0 or less where it is.
};

/// PostureAngles measured on a figure, where twist, side bend and the rest are angles too. Each is of its own plane
/// (see view_planes.h): a bend to the side has no flexion, a turn has neither.
struct MeasuredPosture : MeasuredArm, MeasuredTrunk, MeasuredLegs {};

/// From which angles on a figure counts as twisted, abducted and so on, degrees. The methods' texts name none: 10 deg
/// is "clearly visible" in EN 1005-4, the others are this project's choice, printed in each report.
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

/// Marked as measured. `arm_supported` and `trunk_supported` are left empty: no figure shows them.
PostureAngles postureAngles(const MeasuredPosture& measured, const PostureThresholds& thresholds = {});

}  // namespace hapticell::ergonomics
