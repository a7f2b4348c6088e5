// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/static_posture.h"

#include <algorithm>
#include <cmath>

#include "mannequin/ergonomics/view_planes.h"

namespace hapticell::ergonomics {
namespace {

constexpr double kOften = 2.0;  ///< Movements a minute from which EN 1005-4 calls a movement frequent.

void add(PartVerdicts& verdicts, PartVerdict verdict) {
  verdicts.worst = std::max(verdicts.worst, verdict.zone);
  verdicts.parts.push_back(verdict);
}

/// Linear from `longest` at `from` to `shortest` at `to`.
double holdingTime(double angle, double from, double to, double longest, double shortest) {
  return longest + (shortest - longest) * (angle - from) / (to - from);
}

PartVerdict sidewaysTrunk(std::string_view part, double angle, double per_minute) {
  const double size = std::abs(angle);
  if (size <= 10.0) return {part, angle, Zone::kAcceptable};
  if (per_minute < kOften) return {part, angle, Zone::kConditional, "fewer than 2 movements a minute"};
  return {part, angle, Zone::kNotAcceptable};
}

PartVerdict trunkForward(double angle, const PostureUse& use) {
  if (angle > 60.0 || (angle < 0.0 && !use.trunk_supported)) return {"trunk forward", angle, Zone::kNotAcceptable};
  if (angle <= 20.0) return {"trunk forward", angle, Zone::kAcceptable};
  if (use.trunk_supported) return {"trunk forward", angle, Zone::kConditional, "full trunk support"};
  if (!use.is_static && use.movements_per_min < kOften) {
    return {"trunk forward", angle, Zone::kConditional, "fewer than 2 movements a minute, not held"};
  }
  return {"trunk forward", angle, Zone::kNotAcceptable};
}

PartVerdict upperArm(double elevation, bool is_behind, const PostureUse& use) {
  if (elevation > 60.0 || is_behind) return {"upper arm", elevation, Zone::kNotAcceptable};
  if (elevation <= 20.0) return {"upper arm", elevation, Zone::kAcceptable};
  if (use.movements_per_min < kOften && !use.is_static) return {"upper arm", elevation, Zone::kAcceptable};
  return {"upper arm", elevation, Zone::kConditional, "arm supported, or fewer than 10 movements a minute"};
}

PartVerdict lineOfSight(double below, const PostureUse& use) {
  if (below >= 0.0 && below <= 40.0) return {"line of sight", below, Zone::kAcceptable};
  if (below > 40.0 && !use.is_static && use.movements_per_min < kOften) {
    return {"line of sight", below, Zone::kConditional, "fewer than 2 movements a minute, not held"};
  }
  return {"line of sight", below, Zone::kNotAcceptable};
}

/// Of the upper arm against its hanging position, whichever way it points.
double elevationOf(const MeasuredPosture& posture) {
  return posture.upper_arm_elevation ? *posture.upper_arm_elevation
                                     : armElevation(posture.upper_arm_flexion, posture.upper_arm_abduction);
}

bool isBehind(const MeasuredPosture& posture) {
  return posture.upper_arm_flexion < -20.0;
}

}  // namespace

std::string_view nameOf(Zone zone) {
  switch (zone) {
    case Zone::kAcceptable:
      return "acceptable";
    case Zone::kConditional:
      return "conditionally acceptable";
    case Zone::kNotAcceptable:
      return "not acceptable";
  }
  return "";
}

ZonePosture settledZones(ZonePosture posture) {
  for (double* angle : {&posture.measured.trunk_flexion, &posture.gaze_below_horizontal, &posture.head_inclination}) {
    if (*angle < 0.0 && *angle >= -kNeutralBand) *angle = 0.0;
  }
  return posture;
}

PartVerdicts en1005(const MeasuredPosture& posture, double gaze_below_horizontal, const PostureUse& use) {
  PartVerdicts verdicts;
  add(verdicts, trunkForward(posture.trunk_flexion, use));
  add(verdicts, sidewaysTrunk("trunk side bend", posture.trunk_side_bend, use.movements_per_min));
  add(verdicts, sidewaysTrunk("trunk twist", posture.trunk_twist, use.movements_per_min));
  add(verdicts, upperArm(elevationOf(posture), isBehind(posture), use));
  add(verdicts, lineOfSight(gaze_below_horizontal, use));
  return verdicts;
}

PartVerdicts iso11226(const MeasuredPosture& posture, double head_inclination, const PostureUse& use) {
  PartVerdicts verdicts;
  const bool is_turned = std::abs(posture.trunk_twist) >= 10.0 || std::abs(posture.trunk_side_bend) >= 10.0;
  add(verdicts, {"trunk symmetry", std::max(std::abs(posture.trunk_twist), std::abs(posture.trunk_side_bend)),
                 is_turned ? Zone::kNotAcceptable : Zone::kAcceptable});

  PartVerdict trunk{"trunk inclination", posture.trunk_flexion};
  if (trunk.angle > 60.0 || (trunk.angle < 0.0 && !use.trunk_supported)) {
    trunk.zone = Zone::kNotAcceptable;
  } else if (trunk.angle > 20.0 && !use.trunk_supported) {
    trunk.zone = Zone::kConditional;
    trunk.condition = "not held longer than the holding time";
    trunk.holding_time_min = holdingTime(trunk.angle, 20.0, 60.0, 4.0, 1.0);
  }
  add(verdicts, trunk);

  PartVerdict head{"head inclination", head_inclination};
  if (head.angle > 85.0 || head.angle < 0.0) {
    head.zone = Zone::kNotAcceptable;
  } else if (head.angle > 25.0) {
    head.zone = Zone::kConditional;
    head.condition = "not held longer than the holding time";
    head.holding_time_min = holdingTime(head.angle, 25.0, 85.0, 8.0, 1.0);
  }
  add(verdicts, head);

  PartVerdict arm{"upper arm elevation", elevationOf(posture)};
  if (arm.angle > 60.0 || isBehind(posture)) {
    arm.zone = Zone::kNotAcceptable;
  } else if (arm.angle > 20.0 && !use.arm_supported) {
    arm.zone = Zone::kConditional;
    arm.condition = "not held longer than the holding time";
    arm.holding_time_min = holdingTime(arm.angle, 20.0, 60.0, 3.0, 1.0);
  }
  add(verdicts, arm);

  add(verdicts, {"shoulder", posture.girdle_elevation,
                 posture.girdle_elevation >= 10.0 ? Zone::kNotAcceptable : Zone::kAcceptable});
  return verdicts;
}

}  // namespace hapticell::ergonomics
