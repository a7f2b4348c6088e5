// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/methods/posture_angles.h"

#include <algorithm>
#include <cmath>

namespace hapticell::ergonomics {

double neutralSettled(const PostureAngles& angles, double degrees) {
  return angles.measured.value_or(false) && std::abs(degrees) <= kNeutralBand ? 0.0 : degrees;
}

PostureAngles postureAngles(const MeasuredPosture& measured, const PostureThresholds& thresholds) {
  const auto reaches = [](double angle, double threshold) { return std::abs(angle) >= threshold; };
  const auto settled = [](double angle, double tolerance) { return std::abs(angle) <= tolerance ? 0.0 : angle; };
  PostureAngles angles;
  angles.upper_arm_flexion = measured.upper_arm_flexion;
  angles.lower_arm_flexion = measured.lower_arm_flexion;
  angles.wrist_flexion = settled(measured.wrist_flexion, thresholds.neutral_wrist);
  angles.neck_flexion = settled(measured.neck_flexion, thresholds.neutral_neck);
  angles.trunk_flexion = settled(measured.trunk_flexion, thresholds.upright);
  angles.knee_flexion = measured.knee_flexion;
  angles.upper_arm_abducted = reaches(measured.upper_arm_abduction, thresholds.abduction);
  angles.upper_arm_rotated = reaches(measured.upper_arm_rotation, thresholds.rotation);
  angles.shoulder_raised = measured.girdle_elevation >= thresholds.girdle_elevation;
  angles.lower_arm_across_midline =
      measured.wrist_past_midline || measured.lower_arm_outwards > thresholds.lower_arm_outwards;
  angles.wrist_deviated = reaches(measured.wrist_deviation, thresholds.wrist_deviation);
  angles.wrist_twist_at_end = measured.wrist_twist_share > thresholds.wrist_twist_share;
  angles.neck_twisted = reaches(measured.neck_twist, thresholds.twist);
  angles.neck_side_bent = reaches(measured.neck_side_bend, thresholds.side_bend);
  angles.trunk_twisted = reaches(measured.trunk_twist, thresholds.twist);
  angles.trunk_side_bent = reaches(measured.trunk_side_bend, thresholds.side_bend);
  angles.legs_supported = measured.seated || measured.share_on_heavier_foot <= thresholds.one_leg_share;
  angles.legs_bilateral = angles.legs_supported;
  angles.seated = measured.seated;
  angles.measured = true;
  if (!measured.seated && measured.off_seat < kOffSeat) angles.off_seat = std::max(0.0, measured.off_seat);
  return angles;
}

}  // namespace hapticell::ergonomics
