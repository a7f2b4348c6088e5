// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/singularity_wall.h"

#include <algorithm>
#include <cmath>

#include "geometry/system/assertion.h"
#include "kinematics/model/jacobian.h"

namespace hapticell::manipulation {

namespace {

/// rad or m: error (1e-10) and rounding (1e-11) of a first difference. Half and twice as well.
constexpr double kWallDifference = 1e-5;
/// rad or m: half of kWall, so that a wall is not jumped over between two looks. Half: twice the looks; twice: one may
/// be.
constexpr double kPiece = 0.01;
/// Looks of one step, 2 rad; a longer one is looked at more coarsely. Half: 1 rad; twice: twice the time of a leap.
constexpr int kMostPieces = 200;
/// To 1e-8 rad. Half: 1e-5, a step that is felt; twice: below rounding.
constexpr int kWallBisections = 20;

std::vector<double> mix(const std::vector<double>& from, const std::vector<double>& to, double s) {
  std::vector<double> q = from;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] += s * (to[i] - from[i]);
  return q;
}

}  // namespace

SingularityWall::SingularityWall(const kinematics::RobotModel& model, int tip_link, const Pose& X_LT, double lever_m)
    : model_(model), tip_link_(tip_link), X_LT_(X_LT), lever_m_(lever_m) {
  HAPTICELL_DEMAND(!model.closure && lever_m > 0.0);
}

double SingularityWall::measure(const std::vector<double>& q) const {
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(model_, q, X_BL);
  kinematics::Jacobian J;
  kinematics::geometricJacobian(model_, X_BL, tip_link_, X_BL[static_cast<std::size_t>(tip_link_)] * X_LT_.p, J);
  return kinematics::manipulability(J, lever_m_).smallest;
}

std::vector<double> SingularityWall::gradient(const std::vector<double>& q) const {
  std::vector<double> result(q.size()), moved = q;
  for (std::size_t i = 0; i < q.size(); ++i) {
    moved[i] = q[i] + kWallDifference;
    const double ahead = measure(moved);
    moved[i] = q[i] - kWallDifference;
    result[i] = (ahead - measure(moved)) / (2.0 * kWallDifference);
    moved[i] = q[i];
  }
  return result;
}

double SingularityWall::freeShare(const std::vector<double>& from, const std::vector<double>& to) const {
  double furthest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) furthest = std::max(furthest, std::abs(to[i] - from[i]));
  if (furthest == 0.0) return 1.0;
  const double least = std::min(kWall, measure(from) * (1.0 - 1e-9));
  const int pieces = static_cast<int>(std::clamp(std::ceil(furthest / kPiece), 1.0, static_cast<double>(kMostPieces)));
  double free = 0.0;
  for (int piece = 1; piece <= pieces; ++piece) {
    double next = static_cast<double>(piece) / pieces;
    if (measure(mix(from, to, next)) >= least) {
      free = next;
      continue;
    }
    for (int i = 0; i < kWallBisections; ++i) {
      const double middle = 0.5 * (free + next);
      (measure(mix(from, to, middle)) >= least ? free : next) = middle;
    }
    return free;
  }
  return 1.0;
}

}  // namespace hapticell::manipulation
