// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/mechanism.h"

#include <cmath>
#include <map>

#include "kinematics/closures/joint_graph.h"

namespace hapticell::workcell {

namespace {

using kinematics::GraphJoint;
using kinematics::JointGraph;
using kinematics::JointType;

// rad, m: what a finite limit may be, against nonsense. Half, twice: no effect on machines.
constexpr double kLargest = 1e6;

Error refusal(Text place, Text found, Text expected, Text fix = {}) {
  return {.place = std::move(place), .found = std::move(found), .expected = std::move(expected), .fix = std::move(fix)};
}

int partNamed(const MechanismDefinition& definition, const std::string& name) {
  for (std::size_t k = 0; k < definition.parts.size(); ++k) {
    if (definition.parts[k].name == name) return static_cast<int>(k);
  }
  return -1;
}

const MechanismJoint* jointNamed(const MechanismDefinition& definition, const std::string& name) {
  for (const MechanismJoint& joint : definition.joints) {
    if (joint.name == name) return &joint;
  }
  return nullptr;
}

Expected<void> checkNames(const MechanismDefinition& definition) {
  std::map<std::string, int> parts, joints;
  for (const MechanismPart& part : definition.parts) {
    if (part.name.empty())
      return makeError(refusal(Text("a part"), Text("the name is missing"), Text("a unique name")));
    if (++parts[part.name] > 1)
      return makeError(refusal(Text("part '%1'", part.name), Text("its name is used twice"), Text("a unique name")));
    if (!part.X_MP.isValid()) return makeError(refusal(Text("part '%1'", part.name), Text("an invalid pose"), {}));
  }
  for (const MechanismJoint& joint : definition.joints) {
    if (joint.name.empty())
      return makeError(refusal(Text("a joint"), Text("the name is missing"), Text("a unique name")));
    if (++joints[joint.name] > 1)
      return makeError(refusal(Text("joint '%1'", joint.name), Text("its name is used twice"), Text("a unique name")));
  }
  return {};
}

Expected<void> checkLimits(const MechanismJoint& joint, const Text& place) {
  if (joint.type == MechanismJointType::kFixed) return {};
  const bool free = std::isinf(joint.lower) && std::isinf(joint.upper) && joint.lower < joint.upper;
  const bool finite = std::abs(joint.lower) <= kLargest && std::abs(joint.upper) <= kLargest;
  if (!free && !finite)
    return makeError(refusal(place, Text("limits that are not numbers"), Text("two numbers, or no limits")));
  if (joint.lower > joint.upper) {
    return makeError(refusal(place,
                             Text("its lower limit %1 is above its upper limit %2", std::to_string(joint.lower),
                                  std::to_string(joint.upper)),
                             "lower <= upper", Text("Swap the two limits.")));
  }
  if (free && joint.type == MechanismJointType::kPrismatic)
    return makeError(refusal(place, Text("a prismatic joint without limits"), Text("a lower and an upper limit")));
  return {};
}

Expected<void> checkJoint(const MechanismDefinition& definition, const MechanismJoint& joint) {
  const Text place("joint '%1'", joint.name);
  for (const std::string& part : {joint.parent, joint.child}) {
    if (partNamed(definition, part) < 0)
      return makeError(refusal(place, Text("no part is named '%1'", part), Text("a part of the mechanism")));
  }
  if (joint.parent == joint.child)
    return makeError(refusal(place, Text("it joins part '%1' to itself", joint.parent), Text("two different parts")));
  const double length = glm::length(joint.axis_M);
  if (!(length > 1e-9) || !std::isfinite(length) || !std::isfinite(glm::length(joint.p_MJ)))
    return makeError(refusal(place, Text("an axis of length zero"), Text("a direction, such as 0 0 1")));
  const bool positive =
      std::isfinite(joint.velocity) && joint.velocity > 0.0 && std::isfinite(joint.friction) && joint.friction >= 0.0;
  if (!positive)
    return makeError(
        refusal(place, Text("a speed or friction out of range"), Text("a speed above 0 and a friction of 0 or more")));
  if (joint.type == MechanismJointType::kScrew && !(std::abs(joint.pitch) > 1e-9 && std::isfinite(joint.pitch)))
    return makeError(refusal(place, Text("a screw joint without pitch"), Text("metres per turn, not 0")));
  return checkLimits(joint, place);
}

/// Follows couplings to the joint that moves by itself.
Expected<std::optional<JointCoupling>> resolveCoupling(const MechanismDefinition& definition,
                                                       const MechanismJoint& joint) {
  if (!joint.coupling) return std::optional<JointCoupling>{};
  JointCoupling resolved{joint.name, 1.0, 0.0};
  const MechanismJoint* at = &joint;
  for (std::size_t steps = 0; at->coupling; ++steps) {
    const Text place("joint '%1'", at->name);
    const JointCoupling& next = *at->coupling;
    if (!std::isfinite(next.ratio) || !std::isfinite(next.offset))
      return makeError(refusal(place, Text("a coupling without finite numbers"), Text("a ratio and an offset")));
    resolved.offset += resolved.ratio * next.offset;
    resolved.ratio *= next.ratio;
    resolved.joint = next.joint;
    at = jointNamed(definition, next.joint);
    if (!at)
      return makeError(
          refusal(place, Text("it is coupled to '%1', which does not exist", next.joint), Text("a joint")));
    if (at == &joint || steps > definition.joints.size())
      return makeError(
          refusal(Text("joint '%1'", joint.name), Text("its coupling leads back to itself"), Text("another joint")));
  }
  return std::optional<JointCoupling>(resolved);
}

Expected<void> addJoint(const MechanismDefinition& definition, const MechanismJoint& source,
                        std::map<std::string, int>& index_of, JointGraph& graph) {
  if (auto checked = checkJoint(definition, source); !checked) return checked;
  const auto coupling = resolveCoupling(definition, source);
  HAPTICELL_TRY(coupling);
  GraphJoint joint;
  joint.joint.name = source.name;
  joint.joint.parent_link = partNamed(definition, source.parent);
  joint.joint.child_link = partNamed(definition, source.child);
  joint.joint.axis_J = glm::normalize(source.axis_M);
  joint.joint.lower = source.lower;
  joint.joint.upper = source.upper;
  joint.joint.velocity = source.velocity;
  joint.X_MJ = Pose::translation(source.p_MJ);
  if (*coupling)
    joint.joint.mimic = kinematics::Mimic{index_of.at((*coupling)->joint), (*coupling)->ratio, (*coupling)->offset};
  switch (source.type) {
    case MechanismJointType::kFixed:
      joint.joint.type = JointType::kFixed;
      joint.joint.mimic.reset();
      break;
    case MechanismJointType::kPrismatic:
      joint.joint.type = JointType::kPrismatic;
      break;
    case MechanismJointType::kScrew:
    case MechanismJointType::kRevolute:
      joint.joint.type = std::isinf(source.lower) ? JointType::kContinuous : JointType::kRevolute;
      break;
  }
  if (source.type == MechanismJointType::kScrew) {
    kinematics::addScrewJoint(graph, joint, source.pitch);
  } else {
    graph.joints.push_back(std::move(joint));
  }
  return {};
}

}  // namespace

const char* wordOf(MechanismJointType type) {
  switch (type) {
    case MechanismJointType::kFixed:
      return "fixed";
    case MechanismJointType::kPrismatic:
      return "prismatic";
    case MechanismJointType::kScrew:
      return "screw";
    case MechanismJointType::kRevolute:
      break;
  }
  return "revolute";
}

Expected<kinematics::RobotModel> buildMechanism(const std::string& name, const MechanismDefinition& definition) {
  if (definition.parts.empty())
    return makeError(refusal(Text("mechanism '%1'", name), Text("the mechanism has no parts"), Text("at least one")));
  HAPTICELL_TRY(checkNames(definition));
  JointGraph graph;
  graph.name = name;
  for (const MechanismPart& part : definition.parts) {
    kinematics::GraphLink link;
    link.link.name = part.name;
    link.X_ML = part.X_MP;
    if (part.mesh) {
      const auto& c = part.color;
      link.link.visuals.push_back({part.mesh, Pose::identity(), {c[0], c[1], c[2], 1.0f}, part.source.path});
      link.link.collisions = link.link.visuals;
    }
    graph.links.push_back(std::move(link));
  }
  // Where each joint will stand in the graph: a screw takes two places, the first being its turn.
  std::map<std::string, int> index_of;
  int next = 0;
  for (const MechanismJoint& joint : definition.joints) {
    index_of[joint.name] = next;
    next += joint.type == MechanismJointType::kScrew ? 2 : 1;
  }
  for (const MechanismJoint& joint : definition.joints) {
    HAPTICELL_TRY(addJoint(definition, joint, index_of, graph));
  }
  auto model = kinematics::modelOfGraph(graph);
  if (!model) return model;
  int tip = model->defaultTip();
  for (std::size_t k = definition.parts.size(); k-- > 1;) {  // The last part that moves, not a frame between.
    const int link = model->findLink(definition.parts[k].name);
    if (!model->moving.empty()) tip = link;
    break;
  }
  model->tip = tip;
  return model;
}

std::vector<double> frictionOf(const MechanismDefinition& definition, const kinematics::RobotModel& model) {
  std::vector<double> friction(model.dof(), 0.0);
  for (const kinematics::Joint& joint : model.joints) {
    const MechanismJoint* stated = jointNamed(definition, joint.name);
    if (stated == nullptr) continue;
    const double share = joint.mimic ? std::abs(joint.mimic->multiplier) : 1.0;
    const kinematics::Joint& moved = joint.mimic ? model.joints[static_cast<std::size_t>(joint.mimic->joint)] : joint;
    if (moved.variable >= 0) friction[static_cast<std::size_t>(moved.variable)] += share * stated->friction;
  }
  return friction;
}

}  // namespace hapticell::workcell
