// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/arm_axes.h"

#include <algorithm>
#include <cmath>

namespace hapticell::kinematics {

ArmAxes armAxes(const Chain& chain) {
  ChainState state;
  chain.evaluate({}, state);
  const auto& elements = chain.elements();
  ArmAxes axes;
  axes.simple = elements.size() == chain.size();
  for (std::size_t i = 0; i < elements.size(); ++i) {
    axes.simple = axes.simple && elements[i].variable == static_cast<int>(i) && elements[i].factor == 1.0 &&
                  elements[i].offset == 0.0;
  }
  axes.reach = std::max(chain.scale(), 1e-6);
  axes.R_BT = state.R_BT;
  axes.p_BT = state.p_BT;
  if (!axes.simple) return axes;
  while (axes.rails < elements.size() && elements[axes.rails].prismatic) {
    axes.rail_B[axes.rails] = state.axis_B[axes.rails];
    ++axes.rails;
  }
  for (std::size_t i = axes.rails; i < elements.size(); ++i) {
    axes.axis_B[axes.count] = state.axis_B[i];
    axes.origin_B[axes.count] = state.origin_B[i];
    axes.prismatic[axes.count++] = elements[i].prismatic;
  }
  return axes;
}

double angleBetween(const ArmAxes& axes, std::size_t a, std::size_t b) {
  return std::atan2(glm::length(glm::cross(axes.axis_B[a], axes.axis_B[b])),
                    std::abs(glm::dot(axes.axis_B[a], axes.axis_B[b])));
}

double lineDistance(const ArmAxes& axes, std::size_t a, std::size_t b) {
  const dvec3 normal = glm::cross(axes.axis_B[a], axes.axis_B[b]);
  const dvec3 between = axes.origin_B[b] - axes.origin_B[a];
  const double length = glm::length(normal);
  if (length < 1e-9) return glm::length(glm::cross(between, axes.axis_B[a]));
  return std::abs(glm::dot(between, normal)) / length;
}

dvec3 nearestPoint(const ArmAxes& axes, std::size_t a, std::size_t b) {
  const dvec3 &o_a = axes.origin_B[a], &o_b = axes.origin_B[b], &z_a = axes.axis_B[a], &z_b = axes.axis_B[b];
  const dvec3 normal = glm::cross(z_a, z_b), between = o_b - o_a;
  const double squared = glm::dot(normal, normal);
  if (squared < 1e-18) return o_a + glm::dot(between, z_a) * z_a;
  const dvec3 on_a = o_a + glm::dot(glm::cross(between, z_b), normal) / squared * z_a;
  const dvec3 on_b = o_b + glm::dot(glm::cross(between, z_a), normal) / squared * z_b;
  return 0.5 * (on_a + on_b);
}

double distanceFromAxis(const ArmAxes& axes, const dvec3& p_B, std::size_t axis) {
  return glm::length(glm::cross(p_B - axes.origin_B[axis], axes.axis_B[axis]));
}

}  // namespace hapticell::kinematics
