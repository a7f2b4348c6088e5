// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "bench/kinematics_figures.h"
#include "kinematics/inverse_factory.h"
#include "kinematics/numeric_inverse.h"
#include "tests/kinematics/test_robots.h"
#ifdef HAPTICELL_HAS_KDL
#include "bench/kdl_peer.h"
#endif

namespace hapticell::bench {

using namespace kinematics;

namespace {

/// Paths of 300 samples at 1 kHz from random poses, 0.2 m/s and 0.4 rad/s, `offset_m` further out than the arm's pose.
void track(const char* robot, const char* what, const RobotModel& model, const InverseModel& inverse, double offset_m,
           int paths) {
  const int tip = model.defaultTip();
  std::mt19937_64 random(1);
  std::vector<double> ns;
  InverseSolution solution;
  for (int path = 0; path < paths; ++path) {
    solution.q = kinematics::test::randomJoints(model, random);
    Pose X_0 = kinematics::test::tipPose(model, solution.q, tip);
    X_0.p += offset_m * glm::normalize(X_0.p);
    std::vector<double> q;
    for (int i = 0; i < 300; ++i) {
      const double t = i * 1e-3;
      const Pose X_BT = displaced(X_0, {t * dvec3(0.16, 0.1, 0.06), t * dvec3(0.2, 0.3, 0.17)});
      q = solution.q;
      const double one = timed([&] { inverse.solveNearest(X_BT, q, 1e-3, solution); });
      if (i >= 200) ns.push_back(one);
    }
  }
  print(robot, what, ns);
}

void coldStart(const char* robot, const RobotModel& model, int count) {
  const auto numeric = NumericInverse::create(model, model.defaultTip());
  const std::vector<ReachedPose> poses = reachedPoses(model, count);
  std::vector<double> ns;
  std::mt19937_64 random(2);
  int solved = 0;
  for (const ReachedPose& pose : poses) {
    const std::vector<double> q_start = kinematics::test::randomJoints(model, random);
    InverseSolution solution;
    ns.push_back(timed([&] { solution = (*numeric)->solveAny(pose.X_BT, q_start); }));
    solved += solution.status == InverseStatus::kSolved ? 1 : 0;
  }
  std::printf("%-8s numeric, any solution: %.3f %% within limits;  ", robot, 100.0 * solved / count);
  print("", "", ns);
}

const std::pair<const char*, RobotModel (*)()> kArms[] = {{"KR 120", kinematics::test::kr120},
                                                          {"UR5e", kinematics::test::ur5e},
                                                          {"offset", kinematics::test::offsetWrist},
                                                          {"Panda", kinematics::test::panda},
                                                          {"iiwa 14", kinematics::test::iiwa}};

}  // namespace

void numericInverse(int poses) {
  for (const auto& [name, make] : kArms) {
    coldStart(name, make(), poses);
#ifdef HAPTICELL_HAS_KDL
    kdlFromMiddle(name, make(), poses / 5);
#endif
  }
}

void paths(int poses) {
  const int paths = std::max(1, poses / 100);
  for (const auto& [name, make] : kArms) {
    const RobotModel model = make();
    const auto numeric = NumericInverse::create(model, model.defaultTip());
    const auto best = createInverse(model, model.defaultTip());
    track(name, ((*best)->name() + ", inside").c_str(), model, **best, 0.0, paths);
    track(name, "numeric, inside", model, **numeric, 0.0, paths);
    track(name, "numeric, 1 m beyond", model, **numeric, 1.0, paths);
  }
}

}  // namespace hapticell::bench
