// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/reach_envelope.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/system/assertion.h"

namespace hapticell::mannequin {

namespace {

// Of 0.6 of the stature: 8 mm for 1.755 m. Half: 0.13 m, steps are seen; twice: 60 um, twice the time.
constexpr int kHalvings = 7;

/// Distance from `from` along `direction` that the wrist gets to.
double reachAlong(const Figure& figure, const PostureTask& locks, Side side, const dvec3& from, const dvec3& direction,
                  Posture& posture) {
  const std::size_t i = static_cast<std::size_t>(side);
  PostureTask task = locks;
  task.orientation[i] = false;
  const PostureSolver solver(figure);
  double low = 0.0, high = 0.6 * figure.body[Dimension::kStature];
  // Halving: what can be met is met.
  for (int step = 0; step < kHalvings; ++step) {
    const double middle = 0.5 * (low + high);
    Pose target;
    target.p = from + middle * direction;
    task.hands[i] = target;
    const PostureResult result = solver.solve(task, posture);
    const bool met = result.status == PostureStatus::kSolved;
    (met ? low : high) = middle;
    if (met) posture = result.posture;
  }
  return low;
}

}  // namespace

geometry::TriangleMesh reachEnvelope(const Figure& figure, const Posture& posture, Side side,
                                     const ReachOptions& options) {
  HAPTICELL_DEMAND(options.meridians >= 6);
  const FigurePose pose = forwardKinematics(figure, posture);
  PostureTask locks;
  locks.trunk_locked = !options.with_trunk;
  locks.feet = {footPose(pose, Side::kLeft), footPose(pose, Side::kRight)};
  const dvec3 shoulder = pose[armSegment(side, Segment::kLeftUpperArm)].p_WS;
  const dmat3 heading = glm::mat3_cast(posture.X_WR.q);
  const int n = options.meridians, bands = std::max(4, n / 2);
  const double grip = glm::length(figure.p_HandGrip[static_cast<std::size_t>(side)]);
  geometry::TriangleMesh mesh;
  const auto add = [&](double azimuth, double elevation) {
    const dvec3 d = heading * dvec3(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                    std::sin(elevation));
    Posture start = posture;
    const double wrist = reachAlong(figure, locks, side, shoulder, d, start);
    mesh.vertices.push_back(shoulder + (wrist > 0.0 ? wrist + grip : 0.02) * d);
  };
  add(0.0, -0.5 * std::numbers::pi);
  for (int b = 1; b < bands; ++b) {
    for (int m = 0; m < n; ++m)
      add(2.0 * std::numbers::pi * m / n, -0.5 * std::numbers::pi + std::numbers::pi * b / bands);
  }
  add(0.0, 0.5 * std::numbers::pi);
  const auto at = [&](int band, int meridian) { return static_cast<std::uint32_t>(1 + (band - 1) * n + meridian % n); };
  const std::uint32_t top = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  for (int m = 0; m < n; ++m) {
    mesh.triangles.push_back({0, at(1, m + 1), at(1, m)});
    mesh.triangles.push_back({top, at(bands - 1, m), at(bands - 1, m + 1)});
    for (int b = 1; b + 1 < bands; ++b) {
      mesh.triangles.push_back({at(b, m), at(b, m + 1), at(b + 1, m + 1)});
      mesh.triangles.push_back({at(b, m), at(b + 1, m + 1), at(b + 1, m)});
    }
  }
  return mesh;
}

}  // namespace hapticell::mannequin
