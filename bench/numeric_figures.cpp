// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "bench/kinematics_figures.h"
#include "kinematics/closed_form/inverse_factory.h"
#include "kinematics/numeric/numeric_inverse.h"
#include "tests/kinematics/model/test_robots.h"
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

/// The same path as a whole: the clock's own noise is out of the mean.
void trackWhole(const char* robot, const char* what, const RobotModel& model, const InverseModel& inverse, int paths) {
  constexpr int kSamples = 1000;
  const int tip = model.defaultTip();
  std::mt19937_64 random(1);
  std::vector<double> means;
  InverseSolution solution;
  std::vector<Pose> wanted(kSamples);
  for (int path = 0; path < paths; ++path) {
    solution.q = kinematics::test::randomJoints(model, random);
    const Pose X_0 = kinematics::test::tipPose(model, solution.q, tip);
    for (int i = 0; i < kSamples; ++i) {
      const double s = 1e-2 * std::sin(2e-3 * std::numbers::pi * i);
      wanted[static_cast<std::size_t>(i)] = displaced(X_0, {s * dvec3(0.8, 0.5, 0.3), s * dvec3(1.0, 1.5, 0.8)});
    }
    std::vector<double> q = solution.q;
    means.push_back(timed([&] {
                      for (const Pose& X_BT : wanted) {
                        inverse.solveNearest(X_BT, q, 1e-3, solution);
                        q.swap(solution.q);
                      }
                    }) /
                    kSamples);
  }
  std::sort(means.begin(), means.end());
  std::printf("%-8s %-28s mean of a path of 1000: median of the paths %6.3f us, least %6.3f us\n", robot, what,
              1e-3 * means[means.size() / 2], 1e-3 * means.front());
}

/// The tool is turned at 0.2 and 0.5 Hz so that the wrist passes its singularity a little beside it.
void throughTheWrist(const char* robot, const RobotModel& model, std::vector<double> q_start) {
  const auto inverse = createInverse(model, model.defaultTip()).value();
  const Pose X_0 = kinematics::test::tipPose(model, q_start, model.defaultTip());
  std::vector<double> ns, before;
  InverseSolution solution;
  solution.q = std::move(q_start);
  double off = 0.0, tilt = 0.0, hurry = 0.0;
  int exact = 0;
  constexpr int kSamples = 10000;
  for (int i = 0; i < kSamples; ++i) {
    const double t = 1e-3 * i;
    const Pose X_BT =
        displaced(X_0, {dvec3(0.0),
                        {0.25 * std::sin(0.4 * std::numbers::pi * t), 0.25 * std::sin(1.0 * std::numbers::pi * t),
                         0.05 * std::sin(0.4 * std::numbers::pi * t)}});
    before = solution.q;
    ns.push_back(timed([&] { inverse->solveNearest(X_BT, before, 1e-3, solution); }));
    off = std::max(off, solution.position_error);
    tilt = std::max(tilt, solution.orientation_error);
    exact += solution.status == InverseStatus::kSolved ? 1 : 0;
    for (std::size_t k = 0; k < before.size(); ++k) {
      const Joint& joint = model.joints[static_cast<std::size_t>(model.moving[k])];
      hurry = std::max(hurry, std::abs(solution.q[k] - before[k]) / (1e-3 * greatestSpeed(joint)));
    }
  }
  std::printf(
      "%-8s through the wrist: largest step %.6f of v_max dt, position off by %.4f mm, tilt %.3f rad, exact %.1f %%\n",
      robot, hurry, 1e3 * off, tilt, 100.0 * exact / kSamples);
  print(robot, "through the wrist", ns);
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
    trackWhole(name, (*best)->name().c_str(), model, **best, std::max(1, paths / 2));
    track(name, "numeric, inside", model, **numeric, 0.0, paths);
    track(name, "numeric, 1 m beyond", model, **numeric, 1.0, paths);
  }
  throughTheWrist("KR 120", kinematics::test::kr120(), {0.1, -1.3, 1.4, 0.3, 0.0, 0.2});
  throughTheWrist("UR5e", kinematics::test::ur5e(), {0.1, -1.3, 1.4, -0.3, 0.0, 0.2});
}

}  // namespace hapticell::bench
