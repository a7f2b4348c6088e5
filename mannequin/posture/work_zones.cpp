// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/work_zones.h"

#include <array>
#include <cmath>
#include <numbers>

namespace hapticell::mannequin {
namespace {

// Cells of a fan or a cone, drawn only. Half: corners are seen; twice: twice the triangles.
constexpr int kSteps = 24;
/// 70 degrees to either side; our choice, as the zones' other bounds (work_zones.h). Half, twice: a narrower zone, or
/// one behind the back.
constexpr double kSide = 1.2217304763960306;
/// m: what is nearer is the body. Half: the zone reaches into the belly; twice: near places are left out.
constexpr double kInner = 0.10;

/// Closes a fan of cells: `rim[level][step]` with 2 levels and an inner and an outer radius.
geometry::TriangleMesh sector(const dvec3& middle, double heading, double radius, double low, double high) {
  geometry::TriangleMesh mesh;
  const auto at = [&](double angle, double r, double z) {
    return dvec3(middle.x + r * std::cos(heading + angle), middle.y + r * std::sin(heading + angle), z);
  };
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = -kSide + 2.0 * kSide * i / kSteps;
    for (const double z : {low, high}) {
      mesh.vertices.push_back(at(angle, kInner, z));
      mesh.vertices.push_back(at(angle, radius, z));
    }
  }
  const auto id = [](int step, int level, int outer) {
    return static_cast<std::uint32_t>(4 * step + 2 * level + outer);
  };
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (int i = 0; i < kSteps; ++i) {
    quad(id(i, 0, 1), id(i + 1, 0, 1), id(i + 1, 1, 1), id(i, 1, 1));
    quad(id(i + 1, 0, 0), id(i, 0, 0), id(i, 1, 0), id(i + 1, 1, 0));
    quad(id(i, 1, 0), id(i, 1, 1), id(i + 1, 1, 1), id(i + 1, 1, 0));
    quad(id(i, 0, 1), id(i, 0, 0), id(i + 1, 0, 0), id(i + 1, 0, 1));
  }
  quad(id(0, 0, 0), id(0, 0, 1), id(0, 1, 1), id(0, 1, 0));
  quad(id(kSteps, 0, 1), id(kSteps, 0, 0), id(kSteps, 1, 0), id(kSteps, 1, 1));
  return mesh;
}

/// Half angles: to the side, up, down (rad).
std::array<double, 3> anglesOf(VisionZone zone) {
  switch (zone) {
    case VisionZone::kPreferred:
      return {15 * kDegree, 15 * kDegree, 15 * kDegree};
    case VisionZone::kEyes:
      return {35 * kDegree, 20 * kDegree, 40 * kDegree};
    default:
      return {60 * kDegree, 60 * kDegree, 60 * kDegree};
  }
}

}  // namespace

geometry::TriangleMesh workZone(const Figure& figure, const Posture& posture, WorkZone zone) {
  const FigurePose pose = forwardKinematics(figure, posture);
  const dvec3 left = pose[Segment::kLeftUpperArm].p_WS, right = pose[Segment::kRightUpperArm].p_WS;
  const dvec3 middle = 0.5 * (left + right), ahead = posture.X_WR.rotate({1.0, 0.0, 0.0});
  const double shoulder = middle.z, elbow = shoulder - figure.upperArmLength();
  const double grip = glm::length(figure.p_HandGrip[0]);
  const double heading = std::atan2(ahead.y, ahead.x), half = 0.5 * glm::length(left - right);
  if (zone == WorkZone::kPreferred)
    return sector(middle, heading, half + figure.forearmLength() + grip - 0.08, elbow - 0.05, 0.5 * (elbow + shoulder));
  const double reach = 0.9 * (figure.upperArmLength() + figure.forearmLength() + grip);
  return sector(middle, heading, reach, elbow - 0.20, shoulder);
}

geometry::TriangleMesh visionVolume(const Figure& figure, const FigurePose& pose, const Gaze& gaze, VisionZone zone,
                                    double length) {
  const Pose eyes = eyePose(figure, pose, zone == VisionZone::kPreferred ? gaze : Gaze{});
  const auto [side, up, down] = anglesOf(zone);
  geometry::TriangleMesh mesh;
  mesh.vertices.push_back(eyes.p);
  for (int i = 0; i < kSteps; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kSteps, x = std::cos(turn), y = std::sin(turn);
    const double yaw = side * x, pitch = (y > 0.0 ? up : down) * y;
    const dvec3 d(std::cos(pitch) * std::sin(yaw), std::sin(pitch), -std::cos(pitch) * std::cos(yaw));
    mesh.vertices.push_back(eyes * (length * d));
  }
  mesh.vertices.push_back(eyes * dvec3(0.0, 0.0, -length));
  const auto last = static_cast<std::uint32_t>(kSteps + 1);
  for (int i = 0; i < kSteps; ++i) {
    const auto a = static_cast<std::uint32_t>(1 + i), b = static_cast<std::uint32_t>(1 + (i + 1) % kSteps);
    mesh.triangles.push_back({0, a, b});
    mesh.triangles.push_back({last, b, a});
  }
  return mesh;
}

}  // namespace hapticell::mannequin
