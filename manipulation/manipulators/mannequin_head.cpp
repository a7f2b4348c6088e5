// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/mannequin_head.h"

#include <cmath>

#include "mannequin/posture/head_solver.h"

namespace hapticell::manipulation {
namespace {

/// Of the solver for one proposal; each turns joints by 1.8 deg at most: 22 deg. Half: the head lags behind a fast
/// hand; twice: dearer where it cannot arrive.
constexpr int kMostHeadTicks = 12;
/// m, the skin of a held part. Half: a tick more; twice: it stays behind by what is felt as 0.04 N.
constexpr double kHeadArrived = 2e-5;
/// m and rad of the difference that tells how parts follow; five times kHeadArrived, so 20 % at worst. Half: 40 %;
/// twice: more of the curvature is in it.
constexpr double kHeadStep = 1e-4;
/// Share of a probe that must be missing where a limit holds; a free axis misses little. Half: stiff postures count as
/// limits; twice: limits that give way a little are not felt.
constexpr double kBlocked = 0.4;

Pose displacedBy(const Pose& X_WM, std::size_t axis, double step) {
  dvec3 unit(0.0);
  unit[static_cast<int>(axis % 3)] = step;
  if (axis < 3) return {X_WM.p + unit, X_WM.q};
  return {X_WM.p, glm::normalize(quaternionFromRotationVector(unit) * X_WM.q)};
}

}  // namespace

Pose MannequinHead::movedFrame(const EntityConfiguration& configuration) const {
  return mannequin::eyesFrame(figure(), mannequin::forwardKinematics(figure(), postureOf(configuration)));
}

EntityConfiguration MannequinHead::propose(const EntityConfiguration& from, const Pose& X_WM, double) const {
  mannequin::Posture posture = postureOf(from);
  double before = 1e9;
  for (int i = 0; i < kMostHeadTicks; ++i) {
    const auto result = mannequin::followHead(figure(), posture, X_WM, trunk_locked_);
    posture = result.posture;
    const double error = std::hypot(result.position_error, 0.2 * result.orientation_error);
    if (error < kHeadArrived || error > 0.999 * before) break;
    before = error;
  }
  return configurationOf(posture);
}

std::vector<PartDifferential> MannequinHead::differentiate(const EntityConfiguration& configuration) const {
  const Pose X_WM = movedFrame(configuration);
  std::vector<Pose> here(parts().size()), there(parts().size());
  partPoses(configuration, here);
  std::vector<PartDifferential> result(parts().size());
  for (std::size_t k = 0; k < here.size(); ++k) result[k].p_WPo = here[k].p;
  for (std::size_t axis = 0; axis < 6; ++axis) {
    partPoses(propose(configuration, displacedBy(X_WM, axis, kHeadStep), 0.0), there);
    for (std::size_t k = 0; k < here.size(); ++k) {
      const Twist way = difference(there[k], here[k]);
      result[k].velocity[axis] = {way.linear / kHeadStep, way.angular / kHeadStep};
    }
  }
  return result;
}

std::vector<MotionLimit> MannequinHead::limits(const EntityConfiguration& configuration, double zone, double) const {
  const Pose X_WM = movedFrame(configuration);
  std::vector<MotionLimit> found;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const Pose wanted = displacedBy(X_WM, axis, sign * zone);
      const Pose reached = movedFrame(propose(configuration, wanted, 0.0));
      const double missing = glm::length(wanted.p - reached.p);
      if (missing < kBlocked * zone) continue;
      MotionLimit limit;
      limit.constraint_W.gap = std::max(0.0, zone - missing);
      limit.constraint_W.gradient[axis] = -sign;
      limit.constraint_W.id = 2 * axis + (sign > 0.0 ? 1 : 2);
      limit.kind = LimitKind::kReach;
      limit.text = Text("The head goes no further: neck and trunk are at their limits");
      found.push_back(std::move(limit));
    }
  }
  return found;
}

}  // namespace hapticell::manipulation
