// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/sitting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "mannequin/posture/posture_solver.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::mannequin {
namespace {

// m; the pelvis is where it was put. Half: feet hang for what the solver leaves; twice: it may float by 4 mm.
constexpr double kOnSeat = 2e-3;

/// Lowest point of the pelvis' flesh.
double underside(const Figure& figure, const kinematics::RobotModel& model, const Posture& posture) {
  const auto stands = toModel(figure, posture);
  std::vector<Pose> X_EL;
  kinematics::forwardKinematics(model, stands.joints, X_EL);
  double lowest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (bodyOfLink(model, static_cast<int>(i)) != static_cast<int>(indexOf(Segment::kPelvis))) continue;
    for (const auto& shape : model.links[i].visuals)
      for (const dvec3& vertex : shape.mesh->vertices)
        lowest = std::min(lowest, (stands.X_WE * X_EL[i] * shape.X_LS * vertex).z);
  }
  return lowest;
}

double soleOf(const Figure& figure, const FigurePose& pose, Side side) {
  return footPose(pose, side).p.z + figure.sole.z;
}

}  // namespace

Sitting sitOn(const Figure& figure, const kinematics::RobotModel& model, const dvec3& p_WSeat, double heading) {
  Posture posture = *libraryPosture(figure, "seated");
  posture.X_WR.q = glm::normalize(quaternionFromRotationVector({0.0, 0.0, heading}) * posture.X_WR.q);
  const dvec3 pelvis = forwardKinematics(figure, posture)[Segment::kPelvis].p_WS;
  posture.X_WR.p += dvec3(p_WSeat.x - pelvis.x, p_WSeat.y - pelvis.y, p_WSeat.z - underside(figure, model, posture));
  PostureTask task;
  task.pelvis_locked = true;
  task.balance = false;
  const FigurePose pose = forwardKinematics(figure, posture);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    Pose foot = footPose(pose, side);
    foot.p.z = -figure.sole.z;
    task.feet[static_cast<std::size_t>(side)] = foot;
  }
  Sitting sitting{PostureSolver(figure).solve(task, posture).posture, 0.0};
  const FigurePose seated = forwardKinematics(figure, sitting.posture);
  // Feet go before the pelvis: where they cannot be met it leaves the seat, and they hang instead.
  if (glm::length(seated[Segment::kPelvis].p_WS - pose[Segment::kPelvis].p_WS) > kOnSeat) {
    sitting.posture = posture;
    sitting.feet_above_floor_m = std::max(soleOf(figure, pose, Side::kLeft), soleOf(figure, pose, Side::kRight));
  }
  return sitting;
}

}  // namespace hapticell::mannequin
