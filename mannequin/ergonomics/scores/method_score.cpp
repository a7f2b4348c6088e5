// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/scores/method_score.h"

namespace hapticell::ergonomics {

using mannequin::Side;

std::string_view nameOf(PostureMethod method) {
  constexpr std::array<std::string_view, kPostureMethods.size()> kNames{"RULA",      "REBA",      "OWAS",
                                                                        "EN 1005-4", "ISO 11226", "EAWS"};
  return kNames[static_cast<std::size_t>(method)];
}

int leastLevel(PostureMethod method) {
  return method == PostureMethod::kReba ? 0 : 1;
}

int levelOf(Zone zone) {
  return 1 + static_cast<int>(zone);
}

Zone zoneOfLevel(double level) {
  if (level <= 1.0) return Zone::kAcceptable;
  return level <= 2.0 ? Zone::kConditional : Zone::kNotAcceptable;
}

MethodScore scoreBy(const PostureScores& scores, PostureMethod method, Side side) {
  const SideScores& one = scores.sides[static_cast<std::size_t>(side)];
  const auto zone = [](const PartVerdicts& verdicts) {
    const int level = levelOf(verdicts.worst);
    return MethodScore{static_cast<double>(level), level};
  };
  switch (method) {
    case PostureMethod::kRula:
      return {static_cast<double>(one.rula_score), one.rula_level};
    case PostureMethod::kReba:
      return {static_cast<double>(one.reba_score), one.reba_level};
    case PostureMethod::kOwas:
      return {static_cast<double>(scores.owas_category), scores.owas_category};
    case PostureMethod::kEn1005:
      return zone(one.en1005);
    case PostureMethod::kIso11226:
      return zone(one.iso11226);
    case PostureMethod::kEaws:
      return {scores.eaws_points, eawsLevel(scores.eaws_points)};
  }
  return {};
}

Side worseSide(const PostureScores& scores, PostureMethod method) {
  const double left = scoreBy(scores, method, Side::kLeft).score;
  const double right = scoreBy(scores, method, Side::kRight).score;
  if (left == right) return scores.worseSide();
  return left > right ? Side::kLeft : Side::kRight;
}

MethodScore scoreBy(const PostureScores& scores, PostureMethod method) {
  return scoreBy(scores, method, worseSide(scores, method));
}

}  // namespace hapticell::ergonomics
