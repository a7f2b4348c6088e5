// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/sdf_joints.h"

#include <algorithm>
#include <cmath>

namespace hapticell::workcell {

namespace {

using kinematics::GraphJoint;
using kinematics::JointType;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoLimit = 1e15;  // SDF's own words for none are -1e16 and 1e16.

}  // namespace

Error sdfRefusal(const std::filesystem::path& file, Text place, Text found, Text expected) {
  return {.file = file.string(), .place = std::move(place), .found = std::move(found), .expected = std::move(expected)};
}

Expected<void> SdfJointReader::add(const SdfJoint& source, GraphJoint& joint, const std::string& scope,
                                   const Pose& X_MN, const Text& place) {
  auto read = axesOf(source, scope, X_MN, place);
  HAPTICELL_TRY(read);
  std::vector<SdfAxis>& axes = *read;
  const auto take = [&](std::size_t count, bool slides) -> Expected<void> {
    if (axes.size() < count)
      return makeError(sdfRefusal(file_, place, Text("the axis is missing"), Text("<axis> with <xyz>")));
    axes.resize(count);
    addAxes(joint, axes, slides);
    return {};
  };
  switch (source.type) {
    case SdfJoint::Type::kFixed:
      joint.joint.type = JointType::kFixed;
      graph_.joints.push_back(joint);
      return {};
    case SdfJoint::Type::kContinuous:
      for (SdfAxis& axis : axes) {  // Which goes round for ever whatever limits stand there.
        axis.lower = -kInfinity;
        axis.upper = kInfinity;
      }
      return take(1, false);
    case SdfJoint::Type::kRevolute:
      return take(1, false);
    case SdfJoint::Type::kPrismatic:
      return take(1, true);
    case SdfJoint::Type::kUniversal:
    case SdfJoint::Type::kRevolute2:
      return take(2, false);
    case SdfJoint::Type::kBall:
      addAxes(joint, {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, false);
      return {};
    case SdfJoint::Type::kScrew:
      return addScrew(source, joint, axes, place);
    case SdfJoint::Type::kGearbox:
      diagnostics_.warn(Text("%1: %2 is a gearbox; it is left out", file_.string(), place));
      return {};
    case SdfJoint::Type::kInvalid:
      break;
  }
  return makeError(sdfRefusal(file_, place, Text("an unknown joint type"),
                              Text("revolute, continuous, prismatic, fixed, screw, universal, revolute2 or ball")));
}

void SdfJointReader::setMimics() {
  const auto find = [&](const std::pair<std::string, unsigned>& wanted) {
    for (std::size_t k = 0; k < graph_.joints.size(); ++k) {
      const std::string& name = graph_.joints[k].joint.name;
      if ((wanted.second == 0 && name == wanted.first) ||
          name == wanted.first + "_" + std::to_string(wanted.second + 1)) {
        return static_cast<int>(k);
      }
    }
    return -1;
  };
  for (const MimicOf& mimic : mimics_) {
    const int follower = find(mimic.follower), leader = find(mimic.leader);
    const bool chained = std::any_of(mimics_.begin(), mimics_.end(),
                                     [&](const MimicOf& other) { return find(other.follower) == leader; });
    if (follower < 0 || leader < 0 || chained) {
      const std::string file = file_.string();
      diagnostics_.warn(
          chained
              ? Text("%1: joint '%2' is read as an independent joint, because it follows '%3', which follows another "
                     "joint",
                     file, mimic.follower.first, mimic.leader.first)
              : Text("%1: joint '%2' is read as an independent joint, because it follows '%3', which does not exist",
                     file, mimic.follower.first, mimic.leader.first));
      continue;
    }
    graph_.joints[static_cast<std::size_t>(follower)].joint.mimic =
        kinematics::Mimic{leader, mimic.multiplier, mimic.offset};
  }
}

Expected<std::vector<SdfJointReader::SdfAxis>> SdfJointReader::axesOf(const SdfJoint& source, const std::string& scope,
                                                                      const Pose& X_MN, const Text& place) {
  std::vector<SdfAxis> axes;
  for (unsigned k = 0; k < source.axes.size(); ++k) {
    if (!source.axes[k]) continue;
    const SdfJointAxis& axis = *source.axes[k];
    if (!axis.fault.empty()) return makeError(sdfRefusal(file_, place, axis.fault, Text("an axis")));
    if (!(glm::length(axis.xyz_M) > 1e-9))
      return makeError(sdfRefusal(file_, place, Text("an axis of length zero"), Text("a direction")));
    SdfAxis made;
    made.axis_M = X_MN.rotate(glm::normalize(axis.xyz_M));
    made.lower = axis.lower < -kNoLimit ? -kInfinity : axis.lower;
    made.upper = axis.upper > kNoLimit ? kInfinity : axis.upper;
    made.velocity = axis.velocity > 0.0 && axis.velocity < kNoLimit ? axis.velocity : 0.0;
    if (std::isnan(made.lower) || made.lower > made.upper)
      return makeError(sdfRefusal(file_, place,
                                  Text("its lower limit %1 is above its upper limit %2", std::to_string(made.lower),
                                       std::to_string(made.upper)),
                                  "lower <= upper"));
    axes.push_back(made);
    noteMimic(axis, scope, scope + source.name, k);
  }
  return axes;
}

/// One joint for each axis, with its own limits.
void SdfJointReader::addAxes(const GraphJoint& prototype, const std::vector<SdfAxis>& axes, bool slides) {
  std::vector<dvec3> directions;
  for (const SdfAxis& axis : axes) directions.push_back(axis.axis_M);
  const std::size_t first = graph_.joints.size();
  kinematics::addCompoundJoint(graph_, prototype, directions);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    kinematics::Joint& joint = graph_.joints[first + k].joint;
    joint.lower = axes[k].lower;
    joint.upper = axes[k].upper;
    joint.velocity = axes[k].velocity;
    const bool endless = std::isinf(joint.lower) && std::isinf(joint.upper);
    joint.type = endless ? JointType::kContinuous : JointType::kRevolute;
    if (slides) joint.type = JointType::kPrismatic;
  }
}

Expected<void> SdfJointReader::addScrew(const SdfJoint& source, GraphJoint& joint, const std::vector<SdfAxis>& axes,
                                        const Text& place) {
  if (axes.empty()) return makeError(sdfRefusal(file_, place, Text("the axis is missing"), Text("<axis> with <xyz>")));
  joint.joint.axis_J = axes[0].axis_M;
  joint.joint.lower = axes[0].lower;
  joint.joint.upper = axes[0].upper;
  joint.joint.velocity = axes[0].velocity;
  const bool endless = std::isinf(joint.joint.lower) && std::isinf(joint.joint.upper);
  joint.joint.type = endless ? JointType::kContinuous : JointType::kRevolute;
  if (!(std::abs(source.pitch) > 1e-12 && std::abs(source.pitch) < 1e9))
    return makeError(sdfRefusal(file_, place, Text("a screw joint without pitch"), "<thread_pitch>"));
  kinematics::addScrewJoint(graph_, joint, source.pitch);
  return {};
}

/// SDF 1.11: position = multiplier (position of the other - reference) + offset.
void SdfJointReader::noteMimic(const SdfJointAxis& axis, const std::string& scope, const std::string& joint,
                               unsigned number) {
  if (!axis.mimic) return;
  MimicOf made;
  made.follower = {joint, number};
  made.leader = {scope + axis.mimic->joint, axis.mimic->second_axis ? 1u : 0u};
  made.multiplier = axis.mimic->multiplier;
  made.offset = axis.mimic->offset - made.multiplier * axis.mimic->reference;
  mimics_.push_back(made);
}

}  // namespace hapticell::workcell
