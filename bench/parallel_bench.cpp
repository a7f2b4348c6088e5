// SPDX-License-Identifier: Apache-2.0
// How long the closed forms and Newton steps of parallel robots take; docs/dev/performance.md, "Parallel robots".
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <vector>

#include "kinematics/closures/delta.h"
#include "kinematics/closures/hexapod.h"

namespace {

using namespace hapticell;
using namespace hapticell::kinematics;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kPoses = 10000;
constexpr int kPasses = 15;

/// The best pass's mean of a call, ns; what it gives is summed up so that nothing is left out.
template <typename Call>
void measure(const char* what, const Call& call) {
  double best = 1e300, sum = 0.0;
  for (int pass = 0; pass < kPasses; ++pass) {
    const auto begin = Clock::now();
    for (std::size_t i = 0; i < kPoses; ++i) sum += call(i);
    best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - begin).count() / kPoses);
  }
  std::printf("%-46s %8.1f ns   (%s %g)\n", what, best, "sum", sum);
}

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

void delta() {
  const DeltaKinematics robot({0.140, 0.565, 1.260, 0.075, 0.1668, 0.0, false});
  std::mt19937_64 random(1);
  std::vector<dvec3> points;
  std::vector<std::array<double, 3>> angles;
  for (std::size_t i = 0; i < kPoses; ++i) {
    points.emplace_back(between(random, -0.4, 0.4), between(random, -0.4, 0.4), between(random, -1.3, -0.9));
    DeltaBranches branches{};
    robot.inverseAll(points.back(), branches);
    angles.push_back(branches[0]);
  }
  measure("Delta inverse, all 8 branches", [&](std::size_t i) {
    DeltaBranches branches{};
    robot.inverseAll(points[i], branches);
    return branches[5][1];
  });
  double worst = 0.0;
  measure("Delta forward", [&](std::size_t i) {
    dvec3 p(0.0);
    robot.forward(angles[i], p);
    worst = std::max(worst, glm::length(p - points[i]));
    return p.z;
  });
  std::printf("  worst error of forward after inverse: %.1e m\n", worst);
}

HexapodGeometry linuxCnc() {
  constexpr double kInch = 0.0254;
  HexapodGeometry g;
  g.p_BA = {dvec3(-22.95, 13.25, 0), {22.95, 13.25, 0}, {22.95, 13.25, 0},
            {0, -26.5, 0},           {0, -26.5, 0},     {-22.95, 13.25, 0}};
  g.p_PC = {dvec3(-1, 11.5, 0), {1, 11.5, 0},        {10.459, -4.884, 0},
            {9.459, -6.616, 0}, {-9.459, -6.616, 0}, {-10.459, -4.884, 0}};
  for (std::size_t i = 0; i < 6; ++i) {
    g.p_BA[i] *= kInch;
    g.p_PC[i] *= kInch;
  }
  return g;
}

void hexapod(double tilt_deg) {
  const HexapodKinematics robot(linuxCnc());
  const Pose home = Pose::translation({0, 0, 0.58});
  const double sign = robot.regularity(home);
  std::mt19937_64 random(2);
  std::vector<Pose> poses, near;
  std::vector<LegLengths> legs;
  while (poses.size() < kPoses) {
    const dvec3 axis = glm::normalize(dvec3(between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)));
    const Pose X{{between(random, -0.12, 0.12), between(random, -0.12, 0.12), between(random, 0.45, 0.72)},
                 glm::angleAxis(between(random, 0.0, tilt_deg * std::numbers::pi / 180.0), axis)};
    if (robot.regularity(X) * sign <= 0.0) continue;  // Another assembly.
    poses.push_back(X);
    near.push_back(displaced(X, {{2e-4, -1e-4, 1e-4}, {2e-4, 1e-4, -3e-4}}));
    legs.push_back(robot.lengths(X));
  }
  std::vector<dmat3> R;
  for (const Pose& X : poses) R.push_back(X.R());
  std::printf("tilt up to %.0f deg\n", tilt_deg);
  measure("hexapod lengths from a quaternion", [&](std::size_t i) { return robot.lengths(poses[i])[3]; });
  measure("hexapod lengths from a matrix", [&](std::size_t i) { return robot.lengths(R[i], poses[i].p)[3]; });
  std::size_t found = 0;
  measure("hexapod forward from home", [&](std::size_t i) {
    const HexapodForward forward = robot.forward(legs[i], home);
    found += forward.converged && glm::length(forward.X_BP.p - poses[i].p) < 1e-9 ? 1 : 0;
    return forward.X_BP.p.z;
  });
  std::printf("  found: %.3f %%\n", 100.0 * static_cast<double>(found) / (kPoses * kPasses));
  measure("hexapod forward, tracking (0.3 mm, 0.4 mrad)",
          [&](std::size_t i) { return robot.forward(legs[i], near[i]).X_BP.p.z; });
  std::size_t proved = 0;
  measure("hexapod certificate", [&](std::size_t i) {
    const bool holds = robot.certify(legs[i], poses[i]).holds;
    proved += holds ? 1 : 0;
    return 0.0;
  });
  std::printf("  proved: %.3f %%\n", 100.0 * static_cast<double>(proved) / (kPoses * kPasses));
}

}  // namespace

int main() {
  delta();
  hexapod(15.0);
  hexapod(35.0);
}
