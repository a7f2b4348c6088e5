// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/head_solver.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "mannequin/body/rotations.h"
#include "mannequin/posture/forward_kinematics.h"

namespace hapticell::mannequin {
namespace {

constexpr int kTurns = 18;  // Spine and neck: the first 18 of Dof.
constexpr int kFirstNeck = 9;
// Of an iteration; three make a tick, as kTickTurn of posture_solver.cpp. Half: the head follows half as fast; twice:
// it jumps.
constexpr double kMostHeadTurn = 0.6 * kDegree;
// m that a radian counts like, as kLever of body_solver.h. Half: place goes first; twice: direction of the eyes does.
constexpr double kHeadLever = 0.2;
// The neck moves more readily; our choice. Half: the trunk leans for a look; twice: the neck bends to its limits first.
constexpr double kSpineWeight = 3.0;
// m^2: keeps steps finite where joints are at their limits. Half, twice: a little faster or slower near them.
constexpr double kDamping = 1e-4;

using HeadRows = Eigen::Matrix<double, 6, 1>;
using Jacobian = Eigen::Matrix<double, 6, kTurns>;

struct HeadWish {
  const Figure& figure;
  Pose X_WEyes;
};

HeadRows errorOf(const HeadWish& wish, const FigurePose& pose) {
  const Pose eyes = eyesFrame(wish.figure, pose);
  const dvec3 way = wish.X_WEyes.p - eyes.p;
  const dvec3 turn = rotationVector(glm::normalize(wish.X_WEyes.q * glm::conjugate(eyes.q)));
  HeadRows error;
  for (int k = 0; k < 3; ++k) {
    error[k] = way[k];
    error[k + 3] = kHeadLever * turn[k];
  }
  return error;
}

/// Axis of a turn in the world: R = Ry Rx Rz, each about the frame that those before it have turned.
dvec3 axisOf(const Posture& posture, const FigurePose& pose, const DofInfo& info) {
  const SegmentPlace& parent = pose[*segmentInfo(info.segment).parent];
  dvec3 axis(0.0);
  axis[info.axis] = info.sign;
  double y = 0.0, x = 0.0;
  for (int k = 0; k < kTurns; ++k) {
    const DofInfo& other = dofInfo(static_cast<Dof>(k));
    if (other.segment != info.segment) continue;
    const double angle = other.sign * posture.angles[static_cast<std::size_t>(k)];
    if (other.axis == 1) y = angle;
    if (other.axis == 0) x = angle;
  }
  if (info.axis == 1) return parent.R_WS * axis;
  if (info.axis == 0) return parent.R_WS * aboutY(y) * axis;
  return parent.R_WS * aboutY(y) * aboutX(x) * axis;
}

Jacobian jacobianOf(const HeadWish& wish, const Posture& posture, const FigurePose& pose) {
  Jacobian J;
  const dvec3 eyes = eyesFrame(wish.figure, pose).p;
  for (int i = 0; i < kTurns; ++i) {
    const DofInfo& info = dofInfo(static_cast<Dof>(i));
    const dvec3 axis = axisOf(posture, pose, info);
    const dvec3 way = glm::cross(axis, eyes - pose[info.segment].p_WS);
    for (int k = 0; k < 3; ++k) {
      J(k, i) = way[k];
      J(k + 3, i) = kHeadLever * axis[k];
    }
  }
  return J;
}

/// One step; a joint at its limit that is pushed outwards is left out and the others are asked again.
Posture stepped(const HeadWish& wish, const Posture& posture, const FigurePose& pose, double most, bool trunk_locked) {
  const HeadRows error = errorOf(wish, pose);
  const Jacobian J = jacobianOf(wish, posture, pose);
  std::array<double, kTurns> weight{};
  weight.fill(1.0);
  std::fill_n(weight.begin(), kFirstNeck, trunk_locked ? 0.0 : 1.0 / kSpineWeight);
  Posture result = posture;
  for (int pass = 0; pass < 4; ++pass) {
    Jacobian JW = J;
    for (int i = 0; i < kTurns; ++i) JW.col(i) *= weight[static_cast<std::size_t>(i)];
    const Eigen::Matrix<double, 6, 6> A = JW * J.transpose() + kDamping * Eigen::Matrix<double, 6, 6>::Identity();
    const Eigen::Matrix<double, kTurns, 1> dq = JW.transpose() * A.ldlt().solve(error);
    // All together: joints cut one by one would turn the step away from its direction, and the head would not move.
    const double largest = dq.cwiseAbs().maxCoeff();
    const double share = largest > most ? most / largest : 1.0;
    bool again = false;
    for (int i = 0; i < kTurns; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const DofInfo& info = dofInfo(static_cast<Dof>(i));
      const double wanted = posture.angles[k] + share * dq[i];
      result.angles[k] = std::clamp(wanted, info.lower, info.upper);
      const bool pushes =
          weight[k] > 0.0 && result.angles[k] != wanted && std::abs(result.angles[k] - posture.angles[k]) < 1e-12;
      if (pushes) {
        weight[k] = 0.0;
        again = true;
      }
    }
    if (!again) break;
  }
  return result;
}

}  // namespace

Pose eyesFrame(const Figure& figure, const FigurePose& pose) {
  const Pose head = pose[Segment::kHead].pose();
  return {head * figure.p_HeadEyes, head.q};
}

HeadResult followHead(const Figure& figure, const Posture& from, const Pose& X_WEyes, bool trunk_locked) {
  const HeadWish wish{figure, X_WEyes};
  Posture best = from;
  FigurePose pose;
  forwardKinematics(figure, best, pose);
  double least = errorOf(wish, pose).squaredNorm();
  double most = kMostHeadTurn;
  for (int i = 0; i < 3; ++i) {
    const Posture next = stepped(wish, best, pose, most, trunk_locked);
    FigurePose there;
    forwardKinematics(figure, next, there);
    const double error = errorOf(wish, there).squaredNorm();
    if (error > least) {
      most *= 0.4;
      continue;
    }
    best = next;
    pose = there;
    least = error;
  }
  const HeadRows error = errorOf(wish, pose);
  HeadResult result{best, 0.0, 0.0};
  result.position_error = error.head<3>().norm();
  result.orientation_error = error.tail<3>().norm() / kHeadLever;
  return result;
}

}  // namespace hapticell::mannequin
