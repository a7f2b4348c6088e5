// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>
#include <random>

#include "bench/kinematics_figures.h"
#include "kinematics/closed_form/analytic_inverse.h"
#include "kinematics/closed_form/opw_geometry.h"
#include "kinematics/model/turns.h"
#include "tests/kinematics/model/test_robots.h"

namespace hapticell::bench {

using namespace kinematics;

namespace {

double bestMean(int count, int passes, const std::function<void(int)>& call) {
  double best = 1e300;
  for (int pass = 0; pass < passes; ++pass) {
    const double begin = threadTime();
    for (int i = 0; i < count; ++i) call(i);
    best = std::min(best, (threadTime() - begin) / count);
  }
  return best;
}

/// One arm with its closed form, and poses as matrices.
struct Subject {
  std::unique_ptr<const ClosedForm> closed;
  kernels::JointBounds bounds{};
  std::vector<ReachedPose> poses;
  std::vector<dmat3> R;

  Subject(const RobotModel& model, int count) : poses(reachedPoses(model, count)) {
    const auto chain = Chain::create(model, model.defaultTip(), {});
    closed = makeClosedForm(classify(*chain).robot_class, armAxes(*chain));
    bounds.joints = static_cast<int>(chain->size());
    for (std::size_t i = 0; i < chain->size(); ++i) {
      bounds.lower[i] = chain->lower()[i];
      bounds.upper[i] = chain->upper()[i];
      bounds.turn[i] = chain->turns(i) ? 2.0 * std::numbers::pi : 0.0;
    }
    for (const ReachedPose& pose : poses) R.push_back(pose.X_BT.R());
  }
};

void sixJoints(const char* name, const RobotModel& model, int count) {
  const Subject arm(model, count);
  kernels::Solutions solutions;
  double sum = 0.0;
  const auto solve = [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    arm.closed->solve(arm.R[k], arm.poses[k].X_BT.p, 0.0, arm.poses[k == 0 ? 0 : k - 1].q.data(), solutions);
  };
  const double bare = bestMean(count, 100, [&](int i) {
    solve(i);
    sum += solutions.q[3][5];
  });
  const double full = bestMean(count, 100, [&](int i) {
    solve(i);
    const auto k = static_cast<std::size_t>(i == 0 ? 0 : i - 1);
    sum += kernels::table().choose(arm.bounds, arm.poses[k].q.data(), arm.closed->groups(), solutions).nearest;
  });
  std::printf("%-8s %-5s all solutions: bare %7.1f ns, with limits, turns, nearest %7.1f ns  (%g)\n", name,
              kernels::table().name, bare, full, sum > 0 ? 1.0 : 0.0);
}

void checkedOpw(const char* name, const RobotModel& model, int count) {
  const auto chain = Chain::create(model, model.defaultTip(), {});
  const OpwGeometry geometry(armAxes(*chain));
  const Subject arm(model, count);
  kernels::Solutions solutions;
  double worst = 0.0;
  const double checked = bestMean(count, 100, [&](int i) {
    const auto k = static_cast<std::size_t>(i), before = k == 0 ? 0 : k - 1;
    kernels::ArmPose pose;
    geometry.frames.map(arm.R[k], arm.poses[k].X_BT.p, pose);
    kernels::table().opw(geometry.arm, pose, arm.poses[before].q.data(), solutions);
    kernels::table().choose(arm.bounds, arm.poses[before].q.data(), 2, solutions);
    worst = std::max(worst, kernels::table().opwError(geometry.arm, pose, solutions));
  });
  std::printf("%-8s %-5s with the forward check of all eight %7.1f ns, worst %.1e\n", name, kernels::table().name,
              checked, worst);
}

void sevenJoints(const char* name, const RobotModel& model, int count) {
  const Subject arm(model, count);
  kernels::Solutions solutions;
  double sum = 0.0;
  const auto given = [&](std::size_t k, double redundant) {
    arm.closed->solve(arm.R[k], arm.poses[k].X_BT.p, redundant, arm.poses[k].q.data(), solutions);
    sum += solutions.q[3][5];
  };
  const double one = bestMean(count, 100, [&](int i) { given(static_cast<std::size_t>(i), 0.3); });
  const double ring = bestMean(count / 50, 5, [&](int i) {
    for (int k = 0; k < 64; ++k) given(static_cast<std::size_t>(i), (k - 31.5) * (std::numbers::pi / 32.0));
  });
  kernels::SwivelRing swivels;
  if (arm.closed->ring(arm.R[0], arm.poses[0].X_BT.p, 0.1, arm.poses[0].q.data(), swivels)) {
    const double at_once = bestMean(count / 10, 9, [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      arm.closed->ring(arm.R[k], arm.poses[k].X_BT.p, 0.1, arm.poses[k].q.data(), swivels);
      sum += swivels.theta[3][5];
    });
    const double all = bestMean(count / 10, 9, [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      arm.closed->ring(arm.R[k], arm.poses[k].X_BT.p, 0.1, arm.poses[k].q.data(), swivels);
      for (int entry = 0; entry < kernels::kRingSize; ++entry) {
        arm.closed->ofRing(swivels, entry, solutions);
        sum += solutions.q[3][5];
      }
    });
    std::printf("%-8s %-5s ring at once: 64 solutions %9.1f ns, all 512 %9.1f ns\n", name, kernels::table().name,
                at_once, all);
  }
  std::printf("%-8s %-5s redundancy given %7.1f ns, ring of 64 %9.1f ns  (%g)\n", name, kernels::table().name, one,
              ring, sum > 0 ? 1.0 : 0.0);
}

void everyArm(int poses) {
  sixJoints("KR 120", kinematics::test::kr120(), poses);
  checkedOpw("KR 120", kinematics::test::kr120(), poses);
  sixJoints("UR5e", kinematics::test::ur5e(), poses);
  sixJoints("wrist", kinematics::test::sphericalWrist(), poses);
  sixJoints("base", kinematics::test::sphericalBase(), poses);
  sixJoints("offset", kinematics::test::offsetWrist(), poses);
  sevenJoints("iiwa 14", kinematics::test::iiwa(), poses);
  sevenJoints("Panda", kinematics::test::panda(), poses);
}

void everySolution(const char* name, const RobotModel& model, int count) {
  const auto inverse = createInverse(model, model.defaultTip());
  const Chain& chain = *(*inverse)->chain();
  std::vector<double> ns;
  int own = 0, solved = 0;
  double solutions = 0.0;
  const std::vector<ReachedPose> poses = reachedPoses(model, count);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    std::vector<AlternativeSolution> all;
    ns.push_back(timed([&] { all = (*inverse)->solveAll(poses[k].X_BT, poses[k == 0 ? 0 : k - 1].q); }));
    ChainPositions x{}, y{};
    std::copy(poses[k].q.begin(), poses[k].q.end(), x.begin());
    bool found = false;
    for (const AlternativeSolution& one : all) {
      std::copy(one.q.begin(), one.q.end(), y.begin());
      found = found || sameButForTurns(chain, x, y, 1e-5);
    }
    own += found ? 1 : 0;
    solved += (*inverse)->solve(poses[k].X_BT, poses[k == 0 ? 0 : k - 1].q).status == InverseStatus::kSolved ? 1 : 0;
    solutions += static_cast<double>(all.size()) / count;
  }
  std::printf("%-8s %-22s own %.3f %%, solved %.3f %%, %.2f solutions;  ", name, (*inverse)->name().c_str(),
              100.0 * own / count, 100.0 * solved / count, solutions);
  print("", "all, as lists", ns);
}

/// Poses about the base, most of them out of reach or of limits: places in a cube of the arm's reach, any orientation.
std::vector<Pose> posesAbout(const Chain& chain, int count) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::normal_distribution<double> normal;
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i) {
    Pose X_BT;
    for (int k = 0; k < 3; ++k) X_BT.p[k] = chain.reach() * place(random);
    X_BT.q = glm::normalize(dquat(normal(random), normal(random), normal(random), normal(random)));
    poses.push_back(X_BT);
  }
  return poses;
}

/// How often solveAll() has no solution within limits where solve() has one, and what either costs.
void listsOfSeven(const char* name, const RobotModel& model, int count) {
  const auto inverse = createInverse(model, model.defaultTip());
  const std::vector<double> start = kinematics::restPositions(model);
  const auto measure = [&](const char* what, const std::vector<Pose>& poses) {
    std::vector<double> ns, ns_one;
    int reached = 0, listed = 0, only_listed = 0;
    for (const Pose& X_BT : poses) {
      std::vector<AlternativeSolution> all;
      InverseSolution one;
      ns.push_back(timed([&] { all = (*inverse)->solveAll(X_BT, start); }));
      ns_one.push_back(timed([&] { one = (*inverse)->solve(X_BT, start); }));
      const bool within = std::any_of(all.begin(), all.end(), [](const auto& listed_one) { return listed_one.within_limits; });
      reached += one.status == InverseStatus::kSolved ? 1 : 0;
      listed += within && one.status == InverseStatus::kSolved ? 1 : 0;
      only_listed += within && one.status != InverseStatus::kSolved ? 1 : 0;
    }
    std::printf("%-8s %s: %d of %zu solved, %d of these not listed, %d listed that are not solved\n", name, what, reached,
                poses.size(), reached - listed, only_listed);
    print(name, "solveAll", ns);
    print(name, "solve", ns_one);
  };
  std::vector<Pose> reachable;
  for (const ReachedPose& pose : reachedPoses(model, count)) reachable.push_back(pose.X_BT);
  measure("reachable poses", reachable);
  measure("poses anywhere", posesAbout(*(*inverse)->chain(), std::max(100, count / 20)));
}

}  // namespace

double clockCost() {
  static const double cost = [] {
    std::vector<double> ns;
    for (int i = 0; i < 1001; ++i) {
      const double begin = threadTime();
      ns.push_back(threadTime() - begin);
    }
    std::sort(ns.begin(), ns.end());
    return ns[500];
  }();
  return cost;
}

std::vector<ReachedPose> reachedPoses(const RobotModel& model, int count) {
  std::mt19937_64 random(11);
  std::vector<ReachedPose> poses;
  for (int i = 0; i < count; ++i) {
    std::vector<double> q = kinematics::test::randomJoints(model, random);
    const Pose X_BT = kinematics::test::tipPose(model, q, model.defaultTip());
    poses.push_back({std::move(q), X_BT});
  }
  return poses;
}

void print(const char* robot, const char* what, std::vector<double>& ns) {
  std::sort(ns.begin(), ns.end());
  double mean = 0.0;
  for (const double value : ns) mean += value / static_cast<double>(ns.size());
  std::printf("%-8s %-28s mean %7.2f us, median %7.2f us, p99 %7.2f us\n", robot, what, 1e-3 * mean,
              1e-3 * ns[ns.size() / 2], 1e-3 * ns[ns.size() * 99 / 100]);
}

void closedForms(int poses) {
  everyArm(poses);
  kernels::usePlain(true);
  everyArm(poses);
  kernels::usePlain(false);
}

void sevenAxisLists(int poses) {
  listsOfSeven("Panda", kinematics::test::panda(), poses);
  listsOfSeven("iiwa 14", kinematics::test::iiwa(), poses);
}

void allSolutions(int poses) {
  everySolution("KR 120", kinematics::test::kr120(), poses);
  everySolution("UR5e", kinematics::test::ur5e(), poses);
  everySolution("wrist", kinematics::test::sphericalWrist(), poses);
  everySolution("offset", kinematics::test::offsetWrist(), poses);
  everySolution("KR 120 c", kinematics::test::calibrated(kinematics::test::kr120()), poses);
  everySolution("UR5e c", kinematics::test::calibrated(kinematics::test::ur5e()), poses);
}

}  // namespace hapticell::bench
