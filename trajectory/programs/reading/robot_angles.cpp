// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/reading/robot_angles.h"

#include <cmath>

namespace hapticell::trajectory {

namespace {

constexpr double kDegrees = 57.295779513082323;
/// Where the middle angle's cosine is below this, only the sum of the outer ones is known: they are off by 1e-16 over
/// it. Half: off by twice as much before; twice: the sum is used earlier; 1e-9 rad off at most.
constexpr double kDegenerate = 1e-9;

dquat turn(const dvec3& axis, double degrees) {
  return glm::angleAxis(degrees / kDegrees, axis);
}

constexpr dvec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

}  // namespace

dvec3 kukaAngles(const dquat& q) {
  const dmat3 R = glm::mat3_cast(q);  // R[column][row]
  const double cosine = std::hypot(R[0][0], R[0][1]);
  const double b = std::atan2(-R[0][2], cosine);
  if (cosine < kDegenerate) {
    return kDegrees * dvec3(std::atan2(-R[1][0], R[1][1]), b, 0.0);
  }
  return kDegrees * dvec3(std::atan2(R[0][1], R[0][0]), b, std::atan2(R[1][2], R[2][2]));
}

dquat fromKukaAngles(const dvec3& abc) {
  return turn(kZ, abc.x) * turn(kY, abc.y) * turn(kX, abc.z);
}

dvec3 fanucAngles(const dquat& q) {
  const dvec3 abc = kukaAngles(q);
  return {abc.z, abc.y, abc.x};
}

dquat fromFanucAngles(const dvec3& wpr) {
  return fromKukaAngles({wpr.z, wpr.y, wpr.x});
}

dvec3 staubliAngles(const dquat& q) {
  const dmat3 R = glm::mat3_cast(q);
  const double cosine = std::hypot(R[0][0], R[1][0]);
  const double ry = std::atan2(R[2][0], cosine);
  if (cosine < kDegenerate) {
    return kDegrees * dvec3(std::atan2(R[1][2], R[1][1]), ry, 0.0);
  }
  return kDegrees * dvec3(std::atan2(-R[2][1], R[2][2]), ry, std::atan2(-R[1][0], R[0][0]));
}

dquat fromStaubliAngles(const dvec3& angles) {
  return turn(kX, angles.x) * turn(kY, angles.y) * turn(kZ, angles.z);
}

}  // namespace hapticell::trajectory
