// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/guide.h"

#include <algorithm>
#include <cmath>

namespace hapticell::workcell {

namespace {

// m, rad: a limit against typing errors, half of a cell's (command_checks.h). Half, twice: other errors are refused.
constexpr double kFarthest = 1000.0;

Error refusal(const Guide& guide, Text found, Text expected) {
  return {.place = Text("guide '%1'", guide.name), .found = std::move(found), .expected = std::move(expected)};
}

bool within(double value, double low, double high) {
  return std::isfinite(value) && value >= low && value <= high;
}

bool isInReach(const dvec3& p) {
  return within(p.x, -kFarthest, kFarthest) && within(p.y, -kFarthest, kFarthest) && within(p.z, -kFarthest, kFarthest);
}

Expected<void> checkPath(const Guide& guide) {
  if (guide.kind != GuideKind::kTube) return {};
  if (guide.path.size() < 2)
    return makeError(refusal(guide, Text("a path of fewer than two points"), Text("two or more")));
  if (!std::all_of(guide.path.begin(), guide.path.end(), isInReach)) {
    return makeError(refusal(guide, Text("a point of the path that is not finite"), Text("metres in the cell")));
  }
  return {};
}

Expected<void> checkStops(const Guide& guide) {
  for (const auto& stop : {guide.lower, guide.upper}) {
    if (stop && !within(*stop, -kFarthest, kFarthest)) {
      return makeError(refusal(guide, Text("a stop out of range"), Text("metres or radians")));
    }
  }
  if (guide.lower && guide.upper && *guide.lower > *guide.upper) {
    return makeError(refusal(guide, Text("a lower stop above the upper stop"), Text("the lower stop first")));
  }
  for (const double detent : guide.detents) {
    if (!within(detent, -kFarthest, kFarthest))
      return makeError(refusal(guide, Text("a detent out of range"), Text("a number")));
  }
  return {};
}

}  // namespace

Expected<void> checkGuide(const Guide& guide) {
  if (!guide.X_WG.isValid())
    return makeError(refusal(guide, Text("an invalid placement"), Text("a valid pose and status")));
  if (guide.entity.empty())
    return makeError(refusal(guide, Text("the entity is missing"), Text("the name of the guided entity")));
  struct Range {
    const char* what;
    double value, low, high;
  };
  for (const Range& range :
       {Range{"radius", guide.radius, 1e-6, kFarthest}, Range{"pitch", guide.pitch, -kFarthest, kFarthest},
        Range{"offset", guide.offset, 0.0, kFarthest}, Range{"friction", guide.friction, 0.0, 3.0},
        Range{"detent_width", guide.detent_width, 1e-4, kFarthest},
        Range{"detent_stiffness", guide.detent_stiffness, 0.0, 500.0}, Range{"help", guide.help, 0.0, 500.0},
        Range{"lead", guide.lead, 0.0, 1.0}}) {
    if (!within(range.value, range.low, range.high)) {
      return makeError(refusal(guide, std::string(range.what) + " " + std::to_string(range.value),
                               Text("%1 to %2", std::to_string(range.low), std::to_string(range.high))));
    }
  }
  if (guide.kind == GuideKind::kSurface && guide.surface.empty()) {
    return makeError(
        refusal(guide, Text("the surface is missing"), Text("the name of the entity whose surface the guide follows")));
  }
  if (auto path = checkPath(guide); !path) return path;
  return checkStops(guide);
}

}  // namespace hapticell::workcell
