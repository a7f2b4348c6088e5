// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/methods/static_posture.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/system/text.h"
#include "mannequin/ergonomics/methods/view_planes.h"

namespace hapticell::ergonomics {
namespace {

// Parts and conditions, as reports name them.
constexpr std::string_view kTrunkForward = HAPTICELL_TRANSLATED("trunk forward");
constexpr std::string_view kUpperArm = HAPTICELL_TRANSLATED("upper arm");
constexpr std::string_view kLineOfSight = HAPTICELL_TRANSLATED("line of sight");
constexpr std::string_view kTrunkInclination = HAPTICELL_TRANSLATED("trunk inclination");
constexpr std::string_view kHeadInclination = HAPTICELL_TRANSLATED("head inclination");
constexpr std::string_view kUpperArmElevation = HAPTICELL_TRANSLATED("upper arm elevation");
constexpr std::string_view kTrunkSideBend = HAPTICELL_TRANSLATED("trunk side bend");
constexpr std::string_view kTrunkTwist = HAPTICELL_TRANSLATED("trunk twist");
constexpr std::string_view kTrunkSymmetry = HAPTICELL_TRANSLATED("trunk symmetry");
constexpr std::string_view kShoulder = HAPTICELL_TRANSLATED("shoulder");
constexpr std::string_view kFewMovements = HAPTICELL_TRANSLATED("fewer than 2 movements a minute");
constexpr std::string_view kFewMovementsNotHeld = HAPTICELL_TRANSLATED("fewer than 2 movements a minute, not held");

constexpr double kOften = 2.0;  ///< Movements a minute from which EN 1005-4 calls a movement frequent.

void add(PartVerdicts& verdicts, PartVerdict verdict) {
  verdicts.worst = std::max(verdicts.worst, verdict.zone);
  verdicts.parts.push_back(verdict);
}

/// Linear from `longest` at `from` to `shortest` at `to`.
double holdingTime(double angle, double from, double to, double longest, double shortest) {
  return longest + (shortest - longest) * (angle - from) / (to - from);
}

/// Next to acceptable, `degrees` beyond the limit.
PartVerdict beyond(PartVerdict verdict, double degrees, const PostureUse& use) {
  const bool is_near = use.measured && degrees <= kNearLimit;
  verdict.zone = is_near ? Zone::kConditional : Zone::kNotAcceptable;
  verdict.condition = is_near ? HAPTICELL_TRANSLATED("measured within 1.5 deg of the limit") : "";
  return verdict;
}

/// The same of a limit of 0, where what is measured counts as 0 within the neutral band.
PartVerdict below0(PartVerdict verdict, const PostureUse& use) {
  return beyond(verdict, -verdict.angle - kNeutralBand, use);
}

PartVerdict sidewaysTrunk(std::string_view part, double angle, const PostureUse& use) {
  const double size = std::abs(angle);
  if (size <= 10.0) return {part, angle, Zone::kAcceptable};
  if (use.movements_per_min < kOften) return {part, angle, Zone::kConditional, kFewMovements};
  return beyond({part, angle}, size - 10.0, use);
}

PartVerdict trunkForward(double angle, const PostureUse& use) {
  if (angle > 60.0) return {kTrunkForward, angle, Zone::kNotAcceptable};
  if (angle < 0.0 && !use.trunk_supported) return below0({kTrunkForward, angle}, use);
  if (angle <= 20.0) return {kTrunkForward, angle, Zone::kAcceptable};
  if (use.trunk_supported)
    return {kTrunkForward, angle, Zone::kConditional, HAPTICELL_TRANSLATED("full trunk support")};
  if (!use.is_static && use.movements_per_min < kOften) {
    return {kTrunkForward, angle, Zone::kConditional, kFewMovementsNotHeld};
  }
  return beyond({kTrunkForward, angle}, angle - 20.0, use);
}

/// An arm that is raised over 60 deg, or more than 20 deg behind the body; nothing where it is neither. `all_up_to_60`:
/// acceptable up to there. Behind, acceptable ends where the arm is raised by 20 deg, too.
std::optional<PartVerdict> armBeyond(PartVerdict arm, double flexion, bool all_up_to_60, const PostureUse& use) {
  const double raised = arm.angle - 60.0, behind = -20.0 - flexion;
  if (raised <= 0.0 && behind <= 0.0) return std::nullopt;
  if (raised > 0.0 && !all_up_to_60) return PartVerdict{arm.part, arm.angle, Zone::kNotAcceptable};
  return beyond(arm, std::max(raised, behind), use);
}

PartVerdict upperArm(double elevation, double flexion, const PostureUse& use) {
  const bool is_rare = use.movements_per_min < kOften && !use.is_static;
  if (const auto verdict = armBeyond({kUpperArm, elevation}, flexion, is_rare, use)) return *verdict;
  if (elevation <= 20.0 || is_rare) return {kUpperArm, elevation, Zone::kAcceptable};
  return {kUpperArm, elevation, Zone::kConditional,
          HAPTICELL_TRANSLATED("arm supported, or fewer than 10 movements a minute")};
}

PartVerdict lineOfSight(double below, const PostureUse& use) {
  if (below >= 0.0 && below <= 40.0) return {kLineOfSight, below, Zone::kAcceptable};
  if (below > 40.0 && !use.is_static && use.movements_per_min < kOften) {
    return {kLineOfSight, below, Zone::kConditional, kFewMovementsNotHeld};
  }
  return below < 0.0 ? below0({kLineOfSight, below}, use) : beyond({kLineOfSight, below}, below - 40.0, use);
}

/// Of the upper arm against its hanging position, whichever way it points.
double elevationOf(const MeasuredPosture& posture) {
  return posture.upper_arm_elevation ? *posture.upper_arm_elevation
                                     : armElevation(posture.upper_arm_flexion, posture.upper_arm_abduction);
}

}  // namespace

std::string_view nameOf(Zone zone) {
  switch (zone) {
    case Zone::kAcceptable:
      return HAPTICELL_TRANSLATED("acceptable");
    case Zone::kConditional:
      return HAPTICELL_TRANSLATED("conditionally acceptable");
    case Zone::kNotAcceptable:
      return HAPTICELL_TRANSLATED("not acceptable");
  }
  return "";
}

ZonePosture settledZones(ZonePosture posture) {
  for (double* angle : {&posture.measured.trunk_flexion, &posture.gaze_below_horizontal, &posture.head_inclination}) {
    if (*angle < 0.0 && *angle >= -kNeutralBand) *angle = 0.0;
  }
  posture.use.measured = true;
  return posture;
}

PartVerdicts en1005(const MeasuredPosture& posture, double gaze_below_horizontal, const PostureUse& use) {
  PartVerdicts verdicts;
  add(verdicts, trunkForward(posture.trunk_flexion, use));
  add(verdicts, sidewaysTrunk(kTrunkSideBend, posture.trunk_side_bend, use));
  add(verdicts, sidewaysTrunk(kTrunkTwist, posture.trunk_twist, use));
  add(verdicts, upperArm(elevationOf(posture), posture.upper_arm_flexion, use));
  add(verdicts, lineOfSight(gaze_below_horizontal, use));
  return verdicts;
}

namespace {

/// Acceptable up to `from`, then as long as the holding time allows, which is linear from there to `limit`.
PartVerdict heldAngle(PartVerdict verdict, double from, double limit, double longest, double shortest) {
  if (verdict.angle <= from) return verdict;
  verdict.zone = Zone::kConditional;
  verdict.condition = HAPTICELL_TRANSLATED("not held longer than the holding time");
  verdict.holding_time_min = holdingTime(verdict.angle, from, limit, longest, shortest);
  return verdict;
}

PartVerdict trunkInclination(double angle, const PostureUse& use) {
  const PartVerdict trunk{kTrunkInclination, angle};
  if (use.trunk_supported) return angle > 60.0 ? beyond(trunk, angle - 60.0, use) : trunk;
  if (angle < 0.0) return below0(trunk, use);
  if (angle > 60.0) return {kTrunkInclination, angle, Zone::kNotAcceptable};
  return heldAngle(trunk, 20.0, 60.0, 4.0, 1.0);
}

PartVerdict headInclination(double angle, const PostureUse& use) {
  if (angle < 0.0) return below0({kHeadInclination, angle}, use);
  if (angle > 85.0) return {kHeadInclination, angle, Zone::kNotAcceptable};
  return heldAngle({kHeadInclination, angle}, 25.0, 85.0, 8.0, 1.0);
}

PartVerdict armElevationHeld(const MeasuredPosture& posture, const PostureUse& use) {
  const PartVerdict arm{kUpperArmElevation, elevationOf(posture)};
  if (const auto verdict = armBeyond(arm, posture.upper_arm_flexion, use.arm_supported, use)) return *verdict;
  if (use.arm_supported) return arm;
  return heldAngle(arm, 20.0, 60.0, 3.0, 1.0);
}

/// Not acceptable from 10 deg on.
PartVerdict upTo10(std::string_view part, double angle, const PostureUse& use) {
  return angle >= 10.0 ? beyond({part, angle}, angle - 10.0, use) : PartVerdict{part, angle};
}

}  // namespace

PartVerdicts iso11226(const MeasuredPosture& posture, double head_inclination, const PostureUse& use) {
  PartVerdicts verdicts;
  const double turned = std::max(std::abs(posture.trunk_twist), std::abs(posture.trunk_side_bend));
  add(verdicts, upTo10(kTrunkSymmetry, turned, use));
  add(verdicts, trunkInclination(posture.trunk_flexion, use));
  add(verdicts, headInclination(head_inclination, use));
  add(verdicts, armElevationHeld(posture, use));
  add(verdicts, upTo10(kShoulder, posture.girdle_elevation, use));
  return verdicts;
}

}  // namespace hapticell::ergonomics
