// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/robot_model.h"

#include <algorithm>
#include <numeric>

#include "geometry/system/assertion.h"
#include "geometry/system/text_case.h"
#include "kinematics/model/link_pose.h"

namespace hapticell::kinematics {

namespace {

/// Two counts that say how deep a link sits: first what moves it, then how many joints in all.
struct Depth {
  int moving = 0;
  int joints = 0;
  friend auto operator<=>(const Depth&,
                          const Depth&) = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0 here.
};

Depth depthOf(const RobotModel& model, int link) {
  Depth depth;
  for (int joint = model.links[static_cast<std::size_t>(link)].parent_joint; joint >= 0;) {
    const Joint& j = model.joints[static_cast<std::size_t>(joint)];
    depth.moving += j.type != JointType::kFixed ? 1 : 0;
    depth.joints += 1;
    joint = model.links[static_cast<std::size_t>(j.parent_link)].parent_joint;
  }
  return depth;
}

bool namedAsTool(const std::string& name) {
  const std::string lower = lowerCase(name);
  const auto matches = [&](const std::string& word) {
    return lower == word ||
           (lower.size() > word.size() && lower.ends_with(word) && lower[lower.size() - word.size() - 1] == '_');
  };
  return matches("tcp") || matches("tool0") || matches("tool") || matches("flange");
}

Pose jointMotion(const Joint& joint, double position) {
  switch (joint.type) {
    case JointType::kFixed:
      return {};
    case JointType::kPrismatic:
      return Pose::translation(joint.axis_J * position);
    case JointType::kRevolute:
    case JointType::kContinuous:
      break;
  }
  return {dvec3(0.0), glm::angleAxis(position, joint.axis_J)};
}

}  // namespace

int RobotModel::findLink(const std::string& link_name) const {
  const auto found = std::find_if(links.begin(), links.end(), [&](const Link& link) { return link.name == link_name; });
  return found == links.end() ? -1 : static_cast<int>(found - links.begin());
}

int RobotModel::findJoint(const std::string& joint_name) const {
  const auto found =
      std::find_if(joints.begin(), joints.end(), [&](const Joint& joint) { return joint.name == joint_name; });
  return found == joints.end() ? -1 : static_cast<int>(found - joints.begin());
}

int RobotModel::defaultTip() const {
  if (tip >= 0) return tip;
  int best = -1, best_tool = -1;
  Depth deepest, deepest_tool;
  for (int link = 0; link < static_cast<int>(links.size()); ++link) {
    const Depth depth = depthOf(*this, link);
    if (best < 0 || depth > deepest) {
      best = link;
      deepest = depth;
    }
    if (depth.moving > 0 && namedAsTool(links[static_cast<std::size_t>(link)].name) &&
        (best_tool < 0 || depth > deepest_tool)) {
      best_tool = link;
      deepest_tool = depth;
    }
  }
  return best_tool >= 0 ? best_tool : best;
}

double jointPosition(const RobotModel& model, const std::vector<double>& q, const Joint& joint) {
  if (joint.variable >= 0) return q[static_cast<std::size_t>(joint.variable)];
  if (!joint.mimic) return 0.0;
  const Joint& followed = model.joints[static_cast<std::size_t>(joint.mimic->joint)];
  const double position = followed.variable >= 0 ? q[static_cast<std::size_t>(followed.variable)] : 0.0;
  return joint.mimic->multiplier * position + joint.mimic->offset;
}

double greatestSpeed(const Joint& joint) {
  if (joint.velocity > 0.0) return joint.velocity;
  return joint.type == JointType::kPrismatic ? 1.0 : std::numbers::pi;
}

std::vector<double> restPositions(const RobotModel& model) {
  if (model.home.size() == model.dof()) return model.home;
  std::vector<double> q;
  q.reserve(model.dof());
  for (const int index : model.moving) {
    const Joint& joint = model.joints[static_cast<std::size_t>(index)];
    q.push_back(std::min(std::max(0.0, joint.lower), joint.upper));
  }
  return q;
}

std::vector<int> rigidBodies(const RobotModel& model) {
  std::vector<int> body(model.links.size());
  std::iota(body.begin(), body.end(), 0);
  if (model.closure) return body;
  for (const Joint& joint : model.joints) {
    if (joint.type != JointType::kFixed) continue;
    body[static_cast<std::size_t>(joint.child_link)] = body[static_cast<std::size_t>(joint.parent_link)];
  }
  return body;
}

void forwardKinematics(const RobotModel& model, const std::vector<double>& q, std::vector<Pose>& X_BL) {
  HAPTICELL_DEMAND(q.size() == model.dof());
  X_BL.resize(model.links.size());
  if (X_BL.empty()) return;
  if (model.closure) {
    model.closure->pose(q, X_BL);
    return;
  }
  X_BL[0] = Pose::identity();
  for (const Joint& joint : model.joints) {
    const Pose X_PL = joint.X_PJ * jointMotion(joint, jointPosition(model, q, joint));
    X_BL[static_cast<std::size_t>(joint.child_link)] = X_BL[static_cast<std::size_t>(joint.parent_link)] * X_PL;
  }
}

Pose linkPose(const RobotModel& model, const std::vector<double>& q, int link) {
  HAPTICELL_DEMAND(q.size() == model.dof() && link >= 0 && static_cast<std::size_t>(link) < model.links.size());
  if (model.closure) {
    std::vector<Pose> X_BL;
    forwardKinematics(model, q, X_BL);
    return X_BL[static_cast<std::size_t>(link)];
  }
  Pose X_PL = Pose::identity();  // Of the link in the one that is gone through.
  for (int at = model.links[static_cast<std::size_t>(link)].parent_joint; at >= 0;) {
    const Joint& joint = model.joints[static_cast<std::size_t>(at)];
    X_PL = joint.X_PJ * jointMotion(joint, jointPosition(model, q, joint)) * X_PL;
    at = model.links[static_cast<std::size_t>(joint.parent_link)].parent_joint;
  }
  return X_PL;
}

}  // namespace hapticell::kinematics
