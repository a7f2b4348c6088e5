// SPDX-License-Identifier: Apache-2.0
// Inverse kinematics of a URDF: all joint positions that bring the flange to a pose. usage: inverse_kinematics ARM.urdf
#include <kinematics/closed_form/inverse_factory.h>
#include <kinematics/model/robot_model.h>
#include <workcell/robots/robot_reader.h>

#include <cstdio>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <vector>

using hapticell::Pose;
namespace kinematics = hapticell::kinematics;

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: inverse_kinematics ARM.urdf\n");
    return 2;
  }
  // Errors are values: what was read, or a sentence that names the file, the line and what to do.
  hapticell::Diagnostics diagnostics;
  const auto robot = hapticell::workcell::readRobot(words[1], diagnostics);
  if (!robot) {
    std::fprintf(stderr, "%s\n", robot.error().message().c_str());
    return 1;
  }
  const kinematics::RobotModel& model = robot->model;

  // A closed form where the arm has one, else a numeric search: the same interface.
  const auto inverse = kinematics::createInverse(model, model.defaultTip());
  if (!inverse) {
    std::fprintf(stderr, "%s\n", inverse.error().message().c_str());
    return 1;
  }
  std::printf("%s: inverse model \"%s\"\n", model.name.c_str(), (*inverse)->name().c_str());

  // Reaching forward and down, at the flange's own orientation turned by 60 degrees.
  const Pose X_BT{{0.45, 0.2, 0.35}, glm::angleAxis(std::numbers::pi / 3.0, hapticell::dvec3(0.0, 1.0, 0.0))};
  const std::vector<double> rest = kinematics::restPositions(model);
  const kinematics::InverseSolution nearest = (*inverse)->solve(X_BT, rest);
  std::printf("nearest to rest: %s, off by %.6f mm\n", toString(nearest.status), 1e3 * nearest.position_error);
  for (const kinematics::AlternativeSolution& one : (*inverse)->solveAll(X_BT, rest)) {
    for (const double q : one.q) std::printf("%8.1f", q * 180.0 / std::numbers::pi);
    std::printf("   %s%s\n", one.configuration.c_str(), one.within_limits ? "" : " (beyond limits)");
  }

  // Forward again: where the tip stands with the answer.
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(model, nearest.q, X_BL);
  const Pose& tip = X_BL[static_cast<std::size_t>(model.defaultTip())];
  std::printf("the tip stands at %.4f %.4f %.4f m\n", tip.p.x, tip.p.y, tip.p.z);
  return 0;
}
