// SPDX-License-Identifier: Apache-2.0
#include "agents/body/follow.h"

#include <Eigen/Dense>
#include <algorithm>

namespace hapticell::agents {

namespace {

/// m that a radian counts like. Half: directions go before places; twice: the other way round.
constexpr double kTurnLever = 0.25;
/// Lets no joint race near a singular place: damping of singular values, m. Half: faster there; twice: the arm follows
/// less closely everywhere.
constexpr double kDamping = 0.04;
/// rad or m before a limit at which a variable stops. Half, twice: far below what is seen.
constexpr double kAtLimit = 1e-4;
/// m, as the lever of the checks of motions (manipulation/checks/path_check.cpp), for the singular values.
constexpr double kSingularLever = 0.5;

using Rows = Eigen::Matrix<double, 6, Eigen::Dynamic>;

Rows jacobianOf(const MovedBody& body, int link, const dvec3& p_WQ, double lever) {
  Rows J = Rows::Zero(6, static_cast<Eigen::Index>(body.size()));
  const auto screws = body.screws();
  for (std::size_t v = 0; v < body.size(); ++v) {
    if (!body.carries(v, link)) continue;
    const dvec3 way = screws[v].at(p_WQ), turn = screws[v].turn();
    for (int k = 0; k < 3; ++k) {
      J(k, static_cast<Eigen::Index>(v)) = way[k];
      J(k + 3, static_cast<Eigen::Index>(v)) = lever * turn[k];
    }
  }
  return J;
}

}  // namespace

std::vector<double> follow(const MovedBody& body, const PointWish& wish, std::span<const double> readiness) {
  Rows J = jacobianOf(body, wish.link, wish.p_WQ, kTurnLever);
  Eigen::Matrix<double, 6, 1> wanted;
  for (int k = 0; k < 3; ++k) {
    wanted[k] = wish.velocity.linear[k];
    wanted[k + 3] = wish.with_turn ? kTurnLever * wish.velocity.angular[k] : 0.0;
  }
  if (!wish.with_turn) J.bottomRows<3>().setZero();
  std::vector<double> weight(readiness.begin(), readiness.end());
  std::vector<double> v(body.size(), 0.0);
  for (int pass = 0; pass < 4; ++pass) {
    Rows JW = J;
    for (std::size_t i = 0; i < v.size(); ++i) JW.col(static_cast<Eigen::Index>(i)) *= weight[i];
    const Eigen::Matrix<double, 6, 6> A =
        JW * J.transpose() + kDamping * kDamping * Eigen::Matrix<double, 6, 6>::Identity();
    const Eigen::VectorXd found = JW.transpose() * A.ldlt().solve(wanted);
    bool again = false;
    for (std::size_t i = 0; i < v.size(); ++i) {
      v[i] = found[static_cast<Eigen::Index>(i)];
      const Room room = body.room(i);
      const bool pushes = (v[i] < 0.0 && room.down < kAtLimit) || (v[i] > 0.0 && room.up < kAtLimit);
      if (!pushes || weight[i] == 0.0) continue;
      weight[i] = 0.0;
      again = true;
    }
    if (!again) break;
  }
  return v;
}

std::vector<double> follow(const MovedBody& body, const PointWish& wish) {
  std::vector<double> readiness(body.size());
  for (std::size_t v = 0; v < readiness.size(); ++v) readiness[v] = body.readiness(v);
  return follow(body, wish, readiness);
}

dvec3 velocityOf(const MovedBody& body, int link, const dvec3& p_WQ, std::span<const double> v) {
  dvec3 velocity(0.0);
  const auto screws = body.screws();
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (v[i] != 0.0 && body.carries(i, link)) velocity += v[i] * screws[i].at(p_WQ);
  }
  return velocity;
}

double leastSingularValue(const MovedBody& body) {
  Rows J = jacobianOf(body, body.handleLink(), body.handle().p, 1.0);
  J.topRows<3>() /= kSingularLever;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J);
  return svd.singularValues()[std::min<Eigen::Index>(6, J.cols()) - 1];
}

}  // namespace hapticell::agents
