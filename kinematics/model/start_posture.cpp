// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/start_posture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kinematics/model/chain_report.h"

namespace hapticell::kinematics {

namespace {

constexpr std::array<double, 4> kBends{30.0 * kDegree, -30.0 * kDegree, 60.0 * kDegree, -60.0 * kDegree};
/// What the limits must leave of a bend; sine 20 degrees is 0.34, well out of the singular pose. Half: starts nearer to
/// singular; twice: robots with narrow joints start straight.
constexpr double kLeastBend = 20.0 * kDegree;

/// The variable bent by as much of `bend` as its limits let; false where that is little.
bool bend(const Chain& chain, std::size_t variable, double angle, ChainPositions& x) {
  const double bent = std::clamp(x[variable] + angle, chain.lower()[variable], chain.upper()[variable]);
  if (std::abs(bent - x[variable]) < kLeastBend) return false;
  x[variable] = bent;
  return true;
}

bool isRevolute(const RobotModel& model, int variable) {
  const int joint = model.moving[static_cast<std::size_t>(variable)];
  return model.joints[static_cast<std::size_t>(joint)].type != JointType::kPrismatic;
}

StartPosture postureOf(const RobotModel& model, const Chain& chain, const ChainPositions& x,
                       const std::vector<double>& rest) {
  StartPosture start{rest, {}};
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const auto variable = static_cast<std::size_t>(chain.variables()[k]);
    if (x[k] == rest[variable]) continue;
    start.q[variable] = x[k];
    start.bent_joints.push_back(model.joints[static_cast<std::size_t>(model.moving[variable])].name);
  }
  return start;
}

}  // namespace

std::optional<StartPosture> bentStart(const RobotModel& model, int tip_link) {
  if (model.closure || tip_link < 0) return std::nullopt;
  const Expected<Chain> chain = Chain::create(model, tip_link, Pose::identity());
  if (!chain) return std::nullopt;
  const std::vector<double> rest = restPositions(model);
  ChainPositions at_rest{};
  for (std::size_t k = 0; k < chain->size(); ++k) at_rest[k] = rest[static_cast<std::size_t>(chain->variables()[k])];
  if (!chainIsSingular(*chain, at_rest)) return std::nullopt;
  std::vector<std::size_t> hinges;
  for (std::size_t k = chain->size(); k > 0; --k)
    if (isRevolute(model, chain->variables()[k - 1])) hinges.push_back(k - 1);
  for (const bool in_pairs : {false, true}) {
    for (std::size_t i = 0; i < hinges.size(); ++i) {
      for (std::size_t j = in_pairs ? i + 1 : i; j < (in_pairs ? hinges.size() : i + 1); ++j) {
        for (const double angle : kBends) {
          ChainPositions x = at_rest;
          if (!bend(*chain, hinges[i], angle, x) || (in_pairs && !bend(*chain, hinges[j], angle, x))) continue;
          if (!chainIsSingular(*chain, x)) return postureOf(model, *chain, x, rest);
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace hapticell::kinematics
