// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/mounted_robot.h"

#include <algorithm>
#include <set>

#include "geometry/system/assertion.h"

namespace hapticell::kinematics {

namespace {

Expected<void> checkTree(const RobotModel& model, int link) {
  if (model.closure) {
    return makeError(
        {.place = Text("'%1'", model.name), .found = "it has closed loops", .expected = "an open chain of joints"});
  }
  if (link < 0 || static_cast<std::size_t>(link) >= model.links.size()) {
    return makeError({.place = Text("'%1'", model.name),
                      .found = "the link does not exist",
                      .expected = "the name of a link of the robot"});
  }
  return {};
}

/// Gives names of `carrier` that `robot` has too its own name in front.
template <typename Named>
void keepApart(std::vector<Named>& carriers, const std::vector<Named>& robots, const std::string& carrier) {
  std::set<std::string> taken;
  for (const Named& named : robots) taken.insert(named.name);
  for (Named& named : carriers) {
    if (taken.count(named.name)) named.name = carrier + "/" + named.name;
  }
}

void append(RobotModel& model, const RobotModel& robot, int first_link) {
  const int first_joint = static_cast<int>(model.joints.size()), first_variable = static_cast<int>(model.dof());
  for (Link link : robot.links) {
    link.parent_joint = link.parent_joint < 0 ? first_joint - 1 : link.parent_joint + first_joint;
    model.links.push_back(std::move(link));
  }
  for (Joint joint : robot.joints) {
    joint.parent_link += first_link;
    joint.child_link += first_link;
    if (joint.variable >= 0) joint.variable += first_variable;
    if (joint.mimic) joint.mimic->joint += first_joint;
    model.joints.push_back(std::move(joint));
  }
  for (const int joint : robot.moving) model.moving.push_back(joint + first_joint);
  for (DisabledPair pair : robot.disabled_pairs) {
    pair.first += first_link;
    pair.second += first_link;
    model.disabled_pairs.push_back(std::move(pair));
  }
}

/// Builds a tree again, joint by joint from another root.
class Rerooting {
 public:
  Rerooting(const RobotModel& from, int root) : from_(from), new_link_(from.links.size(), -1) {
    to_.name = from.name;
    to_.home = from.home;
    new_joint_.assign(from.joints.size(), -1);
    place(root, -1);
    walk(root, -1);
  }

  RobotModel finish() {
    to_.moving.assign(from_.moving.size(), -1);
    for (std::size_t v = 0; v < from_.moving.size(); ++v) {
      to_.moving[v] = new_joint_[static_cast<std::size_t>(from_.moving[v])];
    }
    for (Joint& joint : to_.joints) {
      if (joint.mimic) joint.mimic->joint = new_joint_[static_cast<std::size_t>(joint.mimic->joint)];
    }
    for (DisabledPair pair : from_.disabled_pairs) {
      pair.first = new_link_[static_cast<std::size_t>(pair.first)];
      pair.second = new_link_[static_cast<std::size_t>(pair.second)];
      to_.disabled_pairs.push_back(std::move(pair));
    }
    return std::move(to_);
  }

 private:
  void place(int link, int parent_joint) {
    Link placed = from_.links[static_cast<std::size_t>(link)];
    placed.parent_joint = parent_joint;
    new_link_[static_cast<std::size_t>(link)] = static_cast<int>(to_.links.size());
    to_.links.push_back(std::move(placed));
  }

  void walk(int link, int came_by) {
    for (int j = 0; j < static_cast<int>(from_.joints.size()); ++j) {
      const Joint& joint = from_.joints[static_cast<std::size_t>(j)];
      if (j == came_by) continue;
      if (joint.parent_link == link) {
        addForward(j);
        walk(joint.child_link, j);
      } else if (joint.child_link == link) {
        addBack(j);
        walk(joint.parent_link, j);
      }
    }
  }

  void addForward(int j) {
    Joint joint = from_.joints[static_cast<std::size_t>(j)];
    joint.parent_link = new_link_[static_cast<std::size_t>(joint.parent_link)];
    place(joint.child_link, static_cast<int>(to_.joints.size()));
    joint.child_link = static_cast<int>(to_.links.size()) - 1;
    new_joint_[static_cast<std::size_t>(j)] = static_cast<int>(to_.joints.size());
    to_.joints.push_back(std::move(joint));
  }

  // The child is where the parent sees it at X_PJ M(q): the parent is at M(q)^-1 X_PJ^-1 of the child, and M(q)^-1 is
  // the same motion about the axis the other way.
  void addBack(int j) {
    const Joint& old = from_.joints[static_cast<std::size_t>(j)];
    Joint joint = old;
    joint.X_PJ = Pose::identity();
    joint.axis_J = -old.axis_J;
    joint.parent_link = new_link_[static_cast<std::size_t>(old.child_link)];
    joint.child_link = static_cast<int>(to_.links.size());
    Link between;
    between.name = old.name + " seen back";
    between.parent_joint = static_cast<int>(to_.joints.size());
    to_.links.push_back(std::move(between));
    new_joint_[static_cast<std::size_t>(j)] = static_cast<int>(to_.joints.size());
    to_.joints.push_back(std::move(joint));
    Joint frame;
    frame.name = old.name + " frame";
    frame.parent_link = static_cast<int>(to_.links.size()) - 1;
    frame.X_PJ = old.X_PJ.inverse();
    place(old.parent_link, static_cast<int>(to_.joints.size()));
    frame.child_link = static_cast<int>(to_.links.size()) - 1;
    to_.joints.push_back(std::move(frame));
  }

  const RobotModel& from_;
  RobotModel to_;
  std::vector<int> new_link_, new_joint_;
};

}  // namespace

Expected<RobotModel> mountRobot(const RobotModel& carrier, int link, const Pose& X_LB, const RobotModel& robot) {
  HAPTICELL_TRY(checkTree(carrier, link));
  HAPTICELL_TRY(checkTree(robot, 0));
  RobotModel model = carrier;
  keepApart(model.links, robot.links, carrier.name);
  keepApart(model.joints, robot.joints, carrier.name);
  model.name = robot.name;
  model.groups.clear();
  model.named_poses.clear();
  model.home = restPositions(carrier);
  const std::vector<double> home = restPositions(robot);
  model.home.insert(model.home.end(), home.begin(), home.end());
  const int first_link = static_cast<int>(carrier.links.size());
  Joint foot;
  foot.name = robot.name + " stands on " + carrier.name;
  foot.parent_link = link;
  foot.child_link = first_link;
  foot.X_PJ = X_LB;
  model.joints.push_back(std::move(foot));
  append(model, robot, first_link);
  model.tip = robot.defaultTip() + first_link;
  return model;
}

Expected<RobotModel> seenFrom(const RobotModel& model, int link) {
  HAPTICELL_TRY(checkTree(model, link));
  return Rerooting(model, link).finish();
}

bool isMoved(const RobotModel& model, int link) {
  HAPTICELL_DEMAND(link >= 0 && static_cast<std::size_t>(link) < model.links.size());
  for (int at = model.links[static_cast<std::size_t>(link)].parent_joint; at >= 0;) {
    const Joint& joint = model.joints[static_cast<std::size_t>(at)];
    if (joint.type != JointType::kFixed) return true;
    at = model.links[static_cast<std::size_t>(joint.parent_link)].parent_joint;
  }
  return false;
}

}  // namespace hapticell::kinematics
