// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/methods/view_planes.h"

#include <algorithm>
#include <cmath>

namespace hapticell::ergonomics {
namespace {

constexpr double kDegreesInRadian = 57.295779513082323;
/// Of a line seen from the side: shorter ones have no sure direction there. PostureSweep tests it. Half: side views of
/// arms at the side swing; twice: flexion fades earlier.
constexpr double kShortView = 0.2;
/// Degrees over which a raised arm goes over from its side view to its elevation. PostureSweep tests it. Half: twice as
/// fast, one degree moves flexion more; twice: raised arms count as lower.
constexpr double kOverLevel = 15.0;

/// A rounding error counts as 0: 1e-15 deg behind it would be another class.
double cleanedAngle(double degrees) {
  // Degrees: what rounding leaves, under any limit's last digit. Half, twice: no effect.
  constexpr double kLeft = 1e-6;
  return std::abs(degrees) < kLeft ? 0.0 : degrees;
}

double sidewaysOf(double outward) {
  return cleanedAngle(kDegreesInRadian * std::asin(std::clamp(outward, -1.0, 1.0)));
}

}  // namespace

PlaneAngles trunkAngles(const ViewPlanes& planes, const dvec3& line) {
  const dvec3 d = glm::normalize(line);
  const double ahead = glm::dot(d, planes.forward), out = glm::dot(d, planes.outward), up = glm::dot(d, planes.up);
  const double seen = std::min(1.0, std::hypot(ahead, up) / kShortView);
  return {cleanedAngle(seen * kDegreesInRadian * std::atan2(ahead, up)), sidewaysOf(out),
          cleanedAngle(kDegreesInRadian * std::atan2(std::hypot(ahead, out), up))};
}

PlaneAngles upperArmAngles(const ViewPlanes& planes, const dvec3& line) {
  const dvec3 d = glm::normalize(line);
  const double ahead = glm::dot(d, planes.forward), out = glm::dot(d, planes.outward), down = -glm::dot(d, planes.up);
  PlaneAngles angles;
  angles.sideways = sidewaysOf(out);
  angles.elevation = cleanedAngle(kDegreesInRadian * std::atan2(std::hypot(ahead, out), down));
  const double side_view = kDegreesInRadian * std::atan2(ahead, std::max(down, kShortView * std::abs(out)));
  const double above = std::max(0.0, angles.elevation - 90.0);
  const double of_side_view = std::max(0.0, 1.0 - above / kOverLevel);
  angles.flexion = cleanedAngle(above > 0.0 ? angles.elevation - (90.0 - side_view) * of_side_view : side_view);
  return angles;
}

double armElevation(double flexion, double sideways) {
  const double cosine = std::cos(flexion / kDegreesInRadian) * std::cos(sideways / kDegreesInRadian);
  constexpr double kFine = 1e9;  // 20 deg forward alone are 20 deg, not 2e-15 more: a class ends there.
  return std::round(kFine * kDegreesInRadian * std::acos(std::clamp(cosine, -1.0, 1.0))) / kFine;
}

}  // namespace hapticell::ergonomics
