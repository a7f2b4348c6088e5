// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics::test {

inline double largestStep(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Appends a link carried by a joint to the link `parent` (by index); limits of +-2.5 unless changed afterwards.
inline Joint& addJoint(RobotModel& model, int parent, const std::string& name, JointType type, const dvec3& axis,
                       const Pose& X_PJ) {
  Joint joint;
  joint.name = name;
  joint.type = type;
  joint.parent_link = parent;
  joint.child_link = static_cast<int>(model.links.size());
  joint.X_PJ = X_PJ;
  joint.axis_J = glm::normalize(axis);
  joint.lower = type == JointType::kContinuous ? -std::numeric_limits<double>::infinity() : -2.5;
  joint.upper = -joint.lower;
  joint.velocity = 3.0;
  Link link;
  link.name = name + "_link";
  link.parent_joint = static_cast<int>(model.joints.size());
  if (type != JointType::kFixed) {
    joint.variable = static_cast<int>(model.moving.size());
    model.moving.push_back(link.parent_joint);
  }
  model.links.push_back(link);
  model.joints.push_back(joint);
  return model.joints.back();
}

inline std::string numbered(std::string word, std::size_t number) {
  return word.append(std::to_string(number));
}

inline RobotModel emptyModel() {
  RobotModel model;
  model.name = "test";
  model.links.resize(1);
  model.links[0].name = "base_link";
  return model;
}

/// One row of a standard Denavit-Hartenberg table: Rz(theta + q) Tz(d) Tx(a) Rx(alpha).
struct DhRow {
  double theta, d, a, alpha;
};

/// A serial arm from its published table: each joint turns about z of the frame before; the last link is "flange".
inline RobotModel fromDh(const std::vector<DhRow>& rows) {
  RobotModel model = emptyModel();
  Pose X_PJ;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Pose turned = X_PJ * Pose::rotation(glm::angleAxis(rows[i].theta, dvec3(0, 0, 1)));
    addJoint(model, static_cast<int>(i), numbered("j", i + 1), JointType::kRevolute, {0, 0, 1}, turned);
    X_PJ = Pose{{rows[i].a, 0.0, rows[i].d}, glm::angleAxis(rows[i].alpha, dvec3(1, 0, 0))};
  }
  addJoint(model, static_cast<int>(rows.size()), "to_flange", JointType::kFixed, {0, 0, 1}, X_PJ);
  model.links.back().name = "flange";
  return model;
}

/// UR5e, standard DH as the maker publishes it (metres).
inline RobotModel ur5e() {
  constexpr double kHalfPi = 0.5 * std::numbers::pi;
  RobotModel model = fromDh({{0, 0.1625, 0, kHalfPi},
                             {0, 0, -0.425, 0},
                             {0, 0, -0.3922, 0},
                             {0, 0.1333, 0, kHalfPi},
                             {0, 0.0997, 0, -kHalfPi},
                             {0, 0.0996, 0, 0}});
  for (Joint& joint : model.joints) {
    joint.lower = -2.0 * std::numbers::pi;
    joint.upper = 2.0 * std::numbers::pi;
  }
  model.joints[2].lower = -std::numbers::pi;
  model.joints[2].upper = std::numbers::pi;
  return model;
}

/// KUKA KR 120 R2500 pro from its data sheet: axes at 675, 350, 1150, -41, 1000, 215 mm, signs - + + - + -.
inline RobotModel kr120() {
  RobotModel model = emptyModel();
  const auto degrees = [](double deg) { return deg * 0.01745329251994329577; };
  struct Axis {
    dvec3 axis, offset;
    double lower, upper;
  };
  const std::vector<Axis> axes = {{{0, 0, -1}, {0, 0, 0.675}, -185, 185}, {{0, 1, 0}, {0.35, 0, 0}, -155, 35},
                                  {{0, 1, 0}, {1.15, 0, 0}, -130, 154},   {{-1, 0, 0}, {1.0, 0, -0.041}, -350, 350},
                                  {{0, 1, 0}, {0, 0, 0}, -130, 130},      {{-1, 0, 0}, {0, 0, 0}, -350, 350}};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Joint& joint = addJoint(model, static_cast<int>(i), numbered("a", i + 1), JointType::kRevolute, axes[i].axis,
                            Pose::translation(axes[i].offset));
    joint.lower = degrees(axes[i].lower);
    joint.upper = degrees(axes[i].upper);
  }
  addJoint(model, 6, "to_flange", JointType::kFixed, {0, 0, 1},
           {{0.215, 0, 0}, glm::angleAxis(0.5 * std::numbers::pi, dvec3(0, 1, 0))});
  model.links.back().name = "flange";
  return model;
}

/// Franka Panda (FER) from the maker's modified DH table (Craig), flange at 107 mm.
inline RobotModel panda() {
  constexpr double kHalfPi = 0.5 * std::numbers::pi;
  RobotModel model = emptyModel();
  struct Row {
    double a, d, alpha, lower, upper;
  };
  const std::vector<Row> rows = {{0, 0.333, 0, -2.8973, 2.8973},
                                 {0, 0, -kHalfPi, -1.7628, 1.7628},
                                 {0, 0.316, kHalfPi, -2.8973, 2.8973},
                                 {0.0825, 0, kHalfPi, -3.0718, -0.0698},
                                 {-0.0825, 0.384, -kHalfPi, -2.8973, 2.8973},
                                 {0, 0, kHalfPi, -0.0175, 3.7525},
                                 {0.088, 0, kHalfPi, -2.8973, 2.8973}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Pose X_PJ =
        Pose{{rows[i].a, 0, 0}, glm::angleAxis(rows[i].alpha, dvec3(1, 0, 0))} * Pose::translation({0, 0, rows[i].d});
    Joint& joint = addJoint(model, static_cast<int>(i), numbered("j", i + 1), JointType::kRevolute, {0, 0, 1}, X_PJ);
    joint.lower = rows[i].lower;
    joint.upper = rows[i].upper;
  }
  addJoint(model, 7, "to_flange", JointType::kFixed, {0, 0, 1}, Pose::translation({0, 0, 0.107}));
  model.links.back().name = "flange";
  return model;
}

/// A SCARA (R-R-P-R) in the measures of DENSO's HSR065: arms of 375 and 275 mm.
inline RobotModel scara() {
  RobotModel model = emptyModel();
  addJoint(model, 0, "j1", JointType::kRevolute, {0, 0, 1}, {});
  addJoint(model, 1, "j2", JointType::kRevolute, {0, 0, 1}, Pose::translation({0.375, 0, 0}));
  Joint& lift = addJoint(model, 2, "j3", JointType::kPrismatic, {0, 0, 1}, Pose::translation({0.275, 0, 0}));
  lift.lower = -0.1;
  lift.upper = 0.22;
  addJoint(model, 3, "j4", JointType::kContinuous, {0, 0, 1}, {});
  return model;
}

/// An S-R-S arm in the measures of KUKA's LBR iiwa 14: 360, 420, 400, 126 mm.
inline RobotModel iiwa() {
  constexpr double kHalfPi = 0.5 * std::numbers::pi;
  RobotModel model = fromDh({{0, 0.36, 0, -kHalfPi},
                             {0, 0, 0, kHalfPi},
                             {0, 0.42, 0, kHalfPi},
                             {0, 0, 0, -kHalfPi},
                             {0, 0.4, 0, -kHalfPi},
                             {0, 0, 0, kHalfPi},
                             {0, 0.126, 0, 0}});
  const double limits[] = {2.967, 2.094, 2.967, 2.094, 2.967, 2.094, 3.054};
  for (std::size_t i = 0; i < 7; ++i) {
    model.joints[i].lower = -limits[i];
    model.joints[i].upper = limits[i];
  }
  return model;
}

/// Six axes (point, direction) at zero with the flange at `flange`: any arm, all limits +-2.8 rad.
inline RobotModel fromAxes(const std::vector<std::pair<dvec3, dvec3>>& axes, const dvec3& flange) {
  RobotModel model = emptyModel();
  dvec3 before(0.0);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Joint& joint = addJoint(model, static_cast<int>(i), numbered("j", i + 1), JointType::kRevolute, axes[i].second,
                            Pose::translation(axes[i].first - before));
    joint.lower = -2.8;
    joint.upper = 2.8;
    before = axes[i].first;
  }
  addJoint(model, static_cast<int>(axes.size()), "to_flange", JointType::kFixed, {0, 0, 1},
           {flange - before, glm::angleAxis(0.7, dvec3(0, 0.6, 0.8))});
  model.links.back().name = "flange";
  return model;
}

/// A cobot whose axis 6 passes the wrist at 80 mm, in the measures of ABB's CRB 15000-5.
inline RobotModel offsetWrist() {
  return fromAxes({{{0, 0, 0.265}, {0, 0, 1}},
                   {{0, 0, 0.265}, {0, 1, 0}},
                   {{0, 0, 0.709}, {0, 1, 0}},
                   {{0, 0, 0.819}, {1, 0, 0}},
                   {{0.47, 0, 0.819}, {0, 1, 0}},
                   {{0.47, 0, 0.899}, {1, 0, 0}}},
                  {0.571, 0, 0.899});
}

/// Axis 6 beside the wrist along axis 5, as FANUC's CRX cobots have it (710, 540, 150, 160 mm).
inline RobotModel offsetWristAlongAxisFive() {
  return fromAxes({{{0, 0, 0}, {0, 0, 1}},
                   {{0, 0, 0}, {0, 1, 0}},
                   {{0, 0, 0.71}, {0, -1, 0}},
                   {{0, 0, 0.71}, {-1, 0, 0}},
                   {{0.54, 0, 0.71}, {0, 1, 0}},
                   {{0.54, 0.15, 0.71}, {-1, 0, 0}}},
                  {0.7, 0.15, 0.71});
}

/// The same with a shoulder offset and axis 6 aslant: nothing of its reach is a plain cosine any more.
inline RobotModel offsetWristWithShoulder() {
  return fromAxes({{{0, 0, 0}, {0, 0, 1}},
                   {{0.15, 0, 0.4}, {0, 1, 0}},
                   {{0.15, 0, 1.0}, {0, 1, 0}},
                   {{0.15, 0.05, 1.1}, {1, 0, 0}},
                   {{0.75, 0.05, 1.1}, {0, 1, 0}},
                   {{0.75, 0.05, 1.18}, {0.9, 0.3, 0.2}}},
                  {0.95, 0.1, 1.2});
}

/// Axes 4 to 6 in a point, nothing parallel or square.
inline RobotModel sphericalWrist() {
  return fromAxes({{{0, 0, 0}, {0, 0, 1}},
                   {{0.2, 0.05, 0.4}, {0.1, 0.9, 0.3}},
                   {{0.25, 0, 0.9}, {-0.2, 0.8, 0.1}},
                   {{0.7, 0.1, 1.0}, {1, 0.1, 0.2}},
                   {{0.7, 0.1, 1.0}, {0, 1, 0.2}},
                   {{0.7, 0.1, 1.0}, {0.9, -0.2, 0.1}}},
                  {0.9, 0.1, 1.05});
}

/// Axes 1 to 3 in a point instead, the wrist spread out.
inline RobotModel sphericalBase() {
  return fromAxes({{{0, 0, 0.5}, {0, 0, 1}},
                   {{0, 0, 0.5}, {0.1, 1, 0}},
                   {{0, 0, 0.5}, {1, 0, 0.1}},
                   {{0.5, 0.1, 0.6}, {0, 1, 0}},
                   {{0.9, 0.1, 0.5}, {0.2, 0.1, 1}},
                   {{1.0, 0.2, 0.5}, {1, 0, 0.3}}},
                  {1.1, 0.2, 0.4});
}

/// The arm on slides along x, y and z (the first `count` of them), 2 m either way.
inline RobotModel onSlides(const RobotModel& arm, int count) {
  RobotModel model = emptyModel();
  const dvec3 directions[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < count; ++i) {
    Joint& slide = addJoint(model, i, numbered("slide", static_cast<std::size_t>(i + 1)), JointType::kPrismatic,
                            directions[i], Pose::translation({0.1, 0.2, 0.3}));
    slide.lower = -2.0;
    slide.upper = 2.0;
    slide.velocity = 1.0;
  }
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& from = arm.joints[i];
    Joint& joint = addJoint(model, count + static_cast<int>(i), from.name, from.type, from.axis_J, from.X_PJ);
    joint.lower = from.lower;
    joint.upper = from.upper;
  }
  model.links.back().name = "flange";
  return model;
}

/// The arm as a calibration finds it: axes turned by up to 0.8 mrad, moved by up to 0.5 mm.
inline RobotModel calibrated(RobotModel model) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&](double size) {
    return size / std::sqrt(3.0) * dvec3(unit(random), unit(random), unit(random));
  };
  for (Joint& joint : model.joints) {
    joint.X_PJ.q = glm::normalize(joint.X_PJ.q * quaternionFromRotationVector(vector(0.8e-3)));
    joint.X_PJ.p += vector(0.5e-3);
  }
  return model;
}

/// Uniform joint positions within the limits (continuous joints within +-3 rad).
inline std::vector<double> randomJoints(const RobotModel& model, std::mt19937_64& random) {
  std::vector<double> q;
  for (const int index : model.moving) {
    const Joint& joint = model.joints[static_cast<std::size_t>(index)];
    const bool endless = joint.type == JointType::kContinuous;
    q.push_back(
        std::uniform_real_distribution<double>(endless ? -3.0 : joint.lower, endless ? 3.0 : joint.upper)(random));
  }
  return q;
}

inline Pose tipPose(const RobotModel& model, const std::vector<double>& q, int tip) {
  std::vector<Pose> X_BL;
  forwardKinematics(model, q, X_BL);
  return X_BL[static_cast<std::size_t>(tip)];
}

}  // namespace hapticell::kinematics::test
