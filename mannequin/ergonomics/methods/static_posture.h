// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mannequin/ergonomics/methods/posture_angles.h"

namespace hapticell::ergonomics {

/// The result for one body part in a method that judges part by part.
enum class Zone { kAcceptable, kConditional, kNotAcceptable };

std::string_view nameOf(Zone zone);

struct PartVerdict {
  std::string_view part;  ///< "trunk forward", "upper arm", ...
  double angle = 0.0;     ///< Degrees.
  Zone zone = Zone::kAcceptable;
  std::string_view condition{};              ///< What makes a conditional zone acceptable; empty otherwise.
  std::optional<double> holding_time_min{};  ///< ISO 11226: the longest this may be held, minutes.
};

struct PartVerdicts {
  Zone worst = Zone::kAcceptable;
  std::vector<PartVerdict> parts{};
};

/// Support and pace of a working posture, which the zones depend on.
struct PostureUse {
  double movements_per_min = 0.0;
  bool is_static = false;  ///< Held for more than a few seconds.
  bool trunk_supported = false;
  bool arm_supported = false;
  bool measured = false;  ///< Measured on a figure or in a recording, not typed: see kNearLimit.
};

/// A measured angle that exceeds a limit by at most this many degrees is conditional if the standard has no class
/// between acceptable and not acceptable. No measurement is more accurate. Half: one degree decides (PostureSweep);
/// twice: 3 deg pass.
inline constexpr double kNearLimit = 1.5;

/// Inputs of EN 1005-4 and ISO 11226, degrees.
struct ZonePosture {
  MeasuredPosture measured;
  double gaze_below_horizontal = 0.0;  ///< EN 1005-4.
  double head_inclination = 0.0;       ///< ISO 11226.
  PostureUse use;
};

/// The same for measured angles: a trunk that leans back, a head or a gaze that points up within kNeutralBand counts as
/// level, because the standards' 0 has no width. Marked as measured.
ZonePosture settledZones(ZonePosture posture);

/// EN 1005-4:2005 (evaluation of working postures in relation to machinery), its zones for trunk, upper arm, head and
/// line of sight. `gaze_below_horizontal`: degrees, negative upwards.
PartVerdicts en1005(const MeasuredPosture& posture, double gaze_below_horizontal, const PostureUse& use);

/// ISO 11226:2000 (evaluation of static working postures): trunk, head, upper arm, shoulder, with the holding times,
/// linear between the corners of its figures. `head_inclination`: of the head against the vertical, degrees forward.
PartVerdicts iso11226(const MeasuredPosture& posture, double head_inclination, const PostureUse& use);

}  // namespace hapticell::ergonomics
