// SPDX-License-Identifier: Apache-2.0
#include "app/robot/mechanism_draft.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hapticell::app {
namespace {

using workcell::MechanismJoint;
using workcell::MechanismJointType;
constexpr int kArcPoints = 33;

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

dvec3 squareTo(const dvec3& axis) {
  const dvec3 other = std::abs(axis.x) < 0.7 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  return glm::normalize(glm::cross(axis, other));
}

}  // namespace

MechanismDraft draftOf(const workcell::Entity& mechanism) {
  MechanismDraft draft{mechanism.id, mechanism.name, {}};
  if (mechanism.mechanism()) draft.joints = mechanism.mechanism()->joints;
  for (MechanismJoint& joint : draft.joints) {
    joint.p_MJ = mechanism.X_WE * joint.p_MJ;
    joint.axis_M = mechanism.X_WE.rotate(joint.axis_M);
  }
  return draft;
}

std::vector<std::string> partsOf(const MechanismDraft& draft) {
  std::vector<std::string> children, parts;
  for (const MechanismJoint& joint : draft.joints) children.push_back(joint.child);
  for (const MechanismJoint& joint : draft.joints)
    if (!joint.parent.empty() && !has(children, joint.parent) && !has(parts, joint.parent))
      parts.push_back(joint.parent);
  for (const MechanismJoint& joint : draft.joints)
    for (const std::string& name : {joint.parent, joint.child})
      if (!name.empty() && !has(parts, name)) parts.push_back(name);
  return parts;
}

Expected<workcell::Command> commandOf(const MechanismDraft& draft, const workcell::DocumentState& state) {
  if (draft.joints.empty()) return makeError({.found = "the mechanism has no joint", .fix = "Add a joint."});
  for (const MechanismJoint& joint : draft.joints)
    if (joint.parent.empty() || joint.child.empty())
      return makeError({.place = Text("joint '%1'", joint.name),
                        .found = "a moving part or a carrying part is not set",
                        .fix = "Pick the moving part and the part that carries it in the scene."});
  if (draft.edited != 0) {
    const workcell::Entity* mechanism = state.find(draft.edited);
    if (!mechanism) return makeError({.found = "the mechanism is no longer in the cell"});
    workcell::EditMechanism edit{draft.edited, draft.joints};
    const Pose X_MW = mechanism->X_WE.inverse();
    for (MechanismJoint& joint : edit.joints) {
      joint.p_MJ = X_MW * joint.p_MJ;
      joint.axis_M = X_MW.rotate(joint.axis_M);
    }
    return workcell::Command(edit);
  }
  workcell::MakeMechanism make{draft.name, {}, draft.joints};
  for (const std::string& name : partsOf(draft)) {
    const workcell::Entity* part = state.findByName(name);
    if (!part || !part->mesh())
      return makeError({.found = Text("'%1' is not a solid of the cell", name), .fix = "Pick another part."});
    if (part->locked)
      return makeError(
          {.found = Text("'%1' is locked in place", name), .fix = "Unlock it in the tree or in its properties."});
    make.parts.push_back(part->id);
  }
  return workcell::Command(make);
}

std::optional<Error> faultOf(const MechanismDraft& draft, const workcell::DocumentState& state) {
  const auto command = commandOf(draft, state);
  if (!command) return command.error();
  workcell::DocumentState trial = state;
  const auto done = workcell::apply(*command, trial, std::numeric_limits<workcell::EntityId>::max());
  return done ? std::nullopt : std::optional<Error>(done.error());
}

void layAxis(MechanismJoint& joint, const PickedFeature& feature) {
  const Pose X_WF = featureFrame_W(feature);
  joint.p_MJ = X_WF.p;
  joint.axis_M = glm::normalize(X_WF.rotate(dvec3(0, 0, 1)));
}

void flipAxis(MechanismJoint& joint) {
  joint.axis_M = -joint.axis_M;
  std::swap(joint.lower, joint.upper);
  joint.lower = -joint.lower;
  joint.upper = -joint.upper;
}

void suitLimits(MechanismJoint& joint) {
  joint.pitch = joint.type == MechanismJointType::kScrew ? 0.010 : 0.0;
  joint.velocity = joint.type == MechanismJointType::kPrismatic ? 0.25 : 1.0;
  joint.lower = joint.upper = 0.0;
  if (joint.type == MechanismJointType::kRevolute) joint.upper = 0.5 * std::numbers::pi;
  if (joint.type == MechanismJointType::kPrismatic) joint.upper = 0.1;
  if (joint.type == MechanismJointType::kScrew) joint.upper = 20.0 * std::numbers::pi;
}

MechanismJoint newJoint(const MechanismDraft& draft, MechanismJointType type) {
  const auto taken = [&](const std::string& name) {
    return std::any_of(draft.joints.begin(), draft.joints.end(), [&](const auto& joint) { return joint.name == name; });
  };
  MechanismJoint joint;
  int number = static_cast<int>(draft.joints.size()) + 1;
  while (taken("J" + std::to_string(number))) ++number;
  joint.name = "J" + std::to_string(number);
  joint.type = type;
  if (!draft.joints.empty()) joint.parent = partsOf(draft).empty() ? std::string() : partsOf(draft).front();
  suitLimits(joint);
  return joint;
}

std::vector<SceneCurve> axisCurves(const MechanismJoint& joint, double length) {
  const double size = glm::length(joint.axis_M);
  if (!(size > 0.0) || joint.type == MechanismJointType::kFixed) return {};
  const dvec3 z = joint.axis_M / size;
  const dvec3 x = squareTo(z), y = glm::cross(z, x);
  const dvec3 from = joint.p_MJ - 0.5 * length * z, to = joint.p_MJ + 0.5 * length * z;
  const double head = 0.06 * length;
  std::vector<SceneCurve> curves;
  curves.push_back({{from, to}, SceneCurve::Role::kGuide, SceneCurve::Style::kDashDot, 1.6, joint.name});
  curves.push_back({{to - 2.0 * head * z + head * x, to, to - 2.0 * head * z - head * x},
                    SceneCurve::Role::kGuide,
                    SceneCurve::Style::kSolid,
                    1.6});
  const double turn = joint.upper - joint.lower;
  if (joint.type == MechanismJointType::kRevolute && std::isfinite(turn)) {
    SceneCurve arc{{}, SceneCurve::Role::kGuide, SceneCurve::Style::kSolid, 1.6};
    for (int i = 0; i < kArcPoints; ++i) {
      const double angle = joint.lower + std::min(turn, 2.0 * std::numbers::pi) * i / (kArcPoints - 1);
      arc.points_W.push_back(joint.p_MJ + 0.25 * length * (std::cos(angle) * x + std::sin(angle) * y));
    }
    curves.push_back(std::move(arc));
  }
  if (joint.type == MechanismJointType::kPrismatic && std::isfinite(turn))
    for (const double end : {joint.lower, joint.upper}) {
      const dvec3 at = joint.p_MJ + end * z;
      curves.push_back({{at - head * x, at + head * x}, SceneCurve::Role::kLimit, SceneCurve::Style::kSolid, 2.0});
    }
  return curves;
}

double shownUnit(const workcell::MechanismJoint& joint) {
  return joint.type == workcell::MechanismJointType::kPrismatic ? 0.001 : kDegree;
}

}  // namespace hapticell::app
