// SPDX-License-Identifier: Apache-2.0
#include "app/robot/mechanism_samples.h"

#include <limits>

#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {

using workcell::MechanismJoint;
using workcell::MechanismJointType;

constexpr std::array<float, 3> kSteel{0.72f, 0.74f, 0.76f}, kDark{0.30f, 0.33f, 0.37f}, kBlue{0.50f, 0.58f, 0.66f};

/// Collects the parts; names are made free when the sample is placed.
class Kit {
 public:
  Kit(const Pose& X_WB, const workcell::Document& document) : X_WB_(X_WB), document_(document) {}

  /// A built-in shape whose own origin stands at p_B.
  std::string add(const std::string& name, const std::string& shape, const dvec3& p_B,
                  const std::array<float, 3>& color) {
    Diagnostics diagnostics;
    auto entity = workcell::EntityLoader({}).load(shape, 1.0, diagnostics);
    if (!entity) {
      fault_ = entity.error();
      return name;
    }
    entity->name = document_.uniqueName(name);
    entity->X_WE = X_WB_ * Pose::translation(p_B);
    entity->color = color;
    made_.parts.push_back(std::move(*entity));
    return made_.parts.back().name;
  }

  MechanismJoint& join(MechanismJointType type, const std::string& parent, const std::string& child) {
    MechanismJoint joint;
    joint.name = "J" + std::to_string(made_.joints.size() + 1);
    joint.type = type;
    joint.parent = parent;
    joint.child = child;
    joint.p_MJ = X_WB_.p;
    made_.joints.push_back(joint);
    return made_.joints.back();
  }

  void axis(MechanismJoint& joint, const dvec3& p_B, const dvec3& axis_B) const {
    joint.p_MJ = X_WB_ * p_B;
    joint.axis_M = X_WB_.rotate(axis_B);
  }

  Expected<SampleParts> finish(const std::string& name) {
    if (fault_) return makeError(*fault_);
    made_.name = document_.uniqueName(name);
    return std::move(made_);
  }

 private:
  Pose X_WB_;
  const workcell::Document& document_;
  SampleParts made_;
  std::optional<Error> fault_;
};

Expected<SampleParts> door(Kit kit) {
  const std::string frame = kit.add("Door post", "box:0.08,0.10,2.10", {0, 0, 1.05}, kDark);
  const std::string other = kit.add("Door post, lock side", "box:0.08,0.10,2.10", {1.0, 0, 1.05}, kDark);
  const std::string lintel = kit.add("Lintel", "box:1.08,0.10,0.08", {0.5, 0, 2.14}, kDark);
  const std::string leaf = kit.add("Door leaf", "box:0.90,0.04,2.04", {0.50, -0.02, 1.05}, kSteel);
  const std::string handle = kit.add("Handle", "box:0.14,0.05,0.02", {0.86, -0.08, 1.05}, kBlue);
  for (const std::string& fixed : {other, lintel}) kit.join(MechanismJointType::kFixed, frame, fixed);
  MechanismJoint& hinge = kit.join(MechanismJointType::kRevolute, frame, leaf);
  hinge.name = "hinge";
  hinge.lower = 0.0;
  hinge.upper = 110.0 * kDegree;
  hinge.friction = 0.8;
  kit.axis(hinge, {0.05, -0.04, 0}, {0, 0, -1});
  kit.join(MechanismJointType::kFixed, leaf, handle);
  return kit.finish("Door");
}

Expected<SampleParts> gripper(Kit kit) {
  const std::string body = kit.add("Gripper body", "box:0.12,0.08,0.07", {0, 0, 0.035}, kDark);
  const std::string left = kit.add("Finger, left", "box:0.02,0.03,0.09", {-0.012, 0, 0.116}, kSteel);
  const std::string right = kit.add("Finger, right", "box:0.02,0.03,0.09", {0.012, 0, 0.116}, kSteel);
  for (const bool mirrored : {false, true}) {
    MechanismJoint& slide = kit.join(MechanismJointType::kPrismatic, body, mirrored ? right : left);
    slide.name = mirrored ? "jaw_right" : "jaw";
    slide.upper = 0.035;
    slide.velocity = 0.1;
    slide.friction = 5.0;
    if (mirrored) slide.coupling = workcell::JointCoupling{"jaw", 1.0, 0.0};
    kit.axis(slide, {0, 0, 0.09}, {mirrored ? 1.0 : -1.0, 0, 0});
  }
  return kit.finish("Gripper");
}

Expected<SampleParts> turntable(Kit kit) {
  const std::string base = kit.add("Turntable base", "cylinder:0.22,0.60", {0, 0, 0.30}, kDark);
  const std::string table = kit.add("Turntable top", "cylinder:0.50,0.04", {0, 0, 0.622}, kSteel);
  const std::string stop = kit.add("Turntable stop", "box:0.30,0.04,0.06", {0.20, 0.15, 0.672}, kBlue);
  MechanismJoint& turn = kit.join(MechanismJointType::kRevolute, base, table);
  turn.name = "turn";
  turn.lower = -std::numeric_limits<double>::infinity();
  turn.upper = std::numeric_limits<double>::infinity();
  turn.friction = 2.0;
  kit.axis(turn, {0, 0, 0.6}, {0, 0, 1});
  kit.join(MechanismJointType::kFixed, table, stop);
  return kit.finish("Turntable");
}

}  // namespace

const char* nameOf(MechanismSample sample) {
  constexpr const char* kNames[]{"Door", "Gripper", "Turntable"};
  return kNames[static_cast<int>(sample)];
}

Expected<SampleParts> sampleParts(MechanismSample sample, const Pose& X_WB, const workcell::Document& document) {
  switch (sample) {
    case MechanismSample::kDoor:
      return door(Kit(X_WB, document));
    case MechanismSample::kGripper:
      return gripper(Kit(X_WB, document));
    case MechanismSample::kTurntable:
      break;
  }
  return turntable(Kit(X_WB, document));
}

}  // namespace hapticell::app
