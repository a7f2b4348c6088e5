// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/joint_centres.h"

#include <algorithm>
#include <cmath>

namespace hapticell::mannequin {

namespace {

/// Sines of a joint's flexion (20 and 7 deg): from the first on its plane is believed, below the second it is not. As
/// kBent of body_frame_finder.cpp. Half: noise turns straight limbs; twice: half-bent ones are guessed.
constexpr double kSureBend = 0.35, kSomeBend = 0.12;

}  // namespace

dvec3 hingeAxis(const dvec3& from, const dvec3& middle, const dvec3& to, double bends, const dvec3& otherwise) {
  const dvec3 bone = unitOf(middle - from);
  const dvec3 axis = bends * glm::cross(unitOf(to - middle), bone);
  const double sure = std::clamp((glm::length(axis) - kSomeBend) / (kSureBend - kSomeBend), 0.0, 1.0);
  const dvec3 plain = square(otherwise, bone);
  const dvec3 seen = unitOf(axis);
  return unitOf((1.0 - sure) * plain + (glm::dot(seen, plain) > 0.0 ? sure : 0.0) * seen);
}

dvec3 hingeOutward(const dvec3& from, const dvec3& marker, const dvec3& to, double offset, double turn) {
  const dvec3 along = unitOf(to - from);
  const dvec3 m = (marker - from) - glm::dot(marker - from, along) * along;
  const double h = glm::length(m);
  if (h < 1e-6) return square(dvec3(0, 1, 0), along);
  const dvec3 a = m / h, b = glm::cross(along, a);
  const double c = std::min(1.0, offset / h), s = std::sqrt(1.0 - c * c);
  const auto bends = [&](const dvec3& n) {
    const dvec3 centre = marker - offset * n;
    return turn * glm::dot(glm::cross(centre - from, to - centre), n);
  };
  const dvec3 one = c * a + s * b, other = c * a - s * b;
  return bends(one) >= bends(other) ? one : other;
}

dvec3 centreInside(const dvec3& above, const dvec3& marker, const dvec3& plane, double offset) {
  const dvec3 down = marker - above, along = unitOf(down);
  const double sine = std::min(0.9, offset / std::max(1e-6, glm::length(down)));
  const dvec3 out = square(plane - above, along);
  return marker - offset * (std::sqrt(1.0 - sine * sine) * out + sine * along);
}

}  // namespace hapticell::mannequin
