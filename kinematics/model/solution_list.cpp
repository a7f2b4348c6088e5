// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/solution_list.h"

#include <algorithm>
#include <cmath>

#include "geometry/system/assertion.h"
#include "kinematics/model/jog.h"
#include "kinematics/model/turns.h"

namespace hapticell::kinematics {

namespace {

// rad or m over a limit, as kLimitSlack of choose_lanes.h.
constexpr double kLimitSlack = 1e-9;
// rad or m: the solution is where the robot is; a thousand times the 1e-9 a pose is met to. Half, twice: no effect.
constexpr double kSameAsNow = 1e-6;

const Joint& jointOf(const RobotModel& model, int variable) {
  return model.joints[static_cast<std::size_t>(model.moving[static_cast<std::size_t>(variable)])];
}

// Which limit is passed furthest, and by how much.
void explain(const RobotModel& model, const std::vector<int>& variables, ListedSolution& listed) {
  double worst = kLimitSlack;
  bool upper = false;
  for (const int variable : variables) {
    const Joint& joint = jointOf(model, variable);
    const double q = listed.q[static_cast<std::size_t>(variable)];
    const double over = std::max(q - joint.upper, joint.lower - q);
    if (over <= worst) continue;
    worst = over;
    upper = q > joint.upper;
    listed.limiting_joint = model.moving[static_cast<std::size_t>(variable)];
  }
  if (listed.limiting_joint < 0) return;
  const Joint& joint = model.joints[static_cast<std::size_t>(listed.limiting_joint)];
  listed.reason = beyondLimitText(joint, worst, upper);
}

void measure(const RobotModel& model, const std::vector<int>& variables, const std::vector<double>& q_now,
             ListedSolution& listed) {
  for (const int variable : variables) {
    const Joint& joint = jointOf(model, variable);
    const auto i = static_cast<std::size_t>(variable);
    const double motion = std::abs(listed.q[i] - q_now[i]);
    listed.distance = std::max(listed.distance, motion);
    listed.time_s = std::max(listed.time_s, motion / greatestSpeed(joint));
  }
  listed.is_now = listed.distance < kSameAsNow;
}

// The six joints of the arm behind any slides, as the maker's flags want them.
std::array<double, 6> armJoints(const std::vector<int>& variables, const std::vector<double>& q) {
  std::array<double, 6> arm{};
  for (std::size_t i = 0; i < 6; ++i) arm[i] = q[static_cast<std::size_t>(variables[variables.size() - 6 + i])];
  return arm;
}

void name(const InverseModel& inverse, Maker maker, ListedSolution& listed) {
  const Chain* chain = inverse.chain();
  if (chain == nullptr) return;
  ChainPositions x{};
  for (std::size_t i = 0; i < chain->size(); ++i) x[i] = listed.q[static_cast<std::size_t>(chain->variables()[i])];
  const auto shape = armShape(*chain, x);
  if (!shape) return;
  if (listed.configuration.empty()) listed.configuration = toString(*shape);
  listed.maker_flags = makerFlags(maker, *shape, armJoints(inverse.variables(), listed.q));
}

// All ways to turn the joints of `base` by full turns within limits, itself left out.
std::vector<std::vector<double>> turnedCopies(const RobotModel& model, const InverseModel& inverse,
                                              const std::vector<double>& base, std::size_t most) {
  std::vector<std::vector<double>> copies{base};
  for (std::size_t k = 0; k < inverse.variables().size(); ++k) {
    const Joint& joint = jointOf(model, inverse.variables()[k]);
    const bool turns = inverse.chain() != nullptr && inverse.chain()->turns(k);
    if (!turns || !std::isfinite(joint.lower) || !std::isfinite(joint.upper)) continue;
    const auto i = static_cast<std::size_t>(inverse.variables()[k]);
    const std::size_t count = copies.size();
    for (double q = base[i] + kTurn * std::ceil((joint.lower - kLimitSlack - base[i]) / kTurn);
         q <= joint.upper + kLimitSlack && copies.size() < most; q += kTurn) {
      if (std::abs(q - base[i]) < 1.0) continue;
      for (std::size_t c = 0; c < count; ++c) {
        copies.push_back(copies[c]);
        copies.back()[i] = std::clamp(q, joint.lower, joint.upper);
      }
    }
  }
  copies.erase(copies.begin());
  return copies;
}

}  // namespace

std::vector<ListedSolution> listSolutions(const RobotModel& model, const InverseModel& inverse, const Pose& X_BT,
                                          const std::vector<double>& q_now, const SolutionListOptions& options) {
  HAPTICELL_DEMAND(q_now.size() == model.dof());
  const Maker maker = makerOf(model);
  std::vector<ListedSolution> list;
  const auto add = [&](std::vector<double> q, bool within_limits, const std::string& configuration) {
    ListedSolution listed;
    listed.q = std::move(q);
    listed.within_limits = within_limits;
    listed.configuration = configuration;
    if (!within_limits) explain(model, inverse.variables(), listed);
    measure(model, inverse.variables(), q_now, listed);
    name(inverse, maker, listed);
    list.push_back(std::move(listed));
  };
  const std::vector<AlternativeSolution> all = inverse.solveAll(X_BT, q_now);
  for (const AlternativeSolution& one : all) add(one.q, one.within_limits, one.configuration);
  if (options.with_turns) {
    std::size_t room = options.most_turns;
    for (const AlternativeSolution& one : all) {
      if (!one.within_limits) continue;
      for (std::vector<double>& q : turnedCopies(model, inverse, one.q, room + 1)) {
        add(std::move(q), true, one.configuration);
        --room;
      }
    }
  }
  std::stable_sort(list.begin(), list.end(), [](const ListedSolution& a, const ListedSolution& b) {
    return a.within_limits != b.within_limits ? a.within_limits : a.distance < b.distance;
  });
  return list;
}

}  // namespace hapticell::kinematics
