// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/closures/loop_closure.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// A body with its shapes, and the pose of its frame in the model's frame M with all joints at 0.
struct GraphLink {
  Link link;
  Pose X_ML;
};

/// A joint between any two bodies: `joint.parent_link` and `joint.child_link` count the graph's links, `joint.mimic`
/// its joints; `joint.X_PJ` is not used. Type, axis (in the joint frame J) and limits are as in a RobotModel.
struct GraphJoint {
  Joint joint;
  Pose X_MJ;  ///< While all joints are at 0.
};

/// Bodies and joints that may close loops (SDF, mechanisms).
struct JointGraph {
  std::string name;
  std::vector<GraphLink> links;  ///< The first is the root, or `root` says which.
  std::vector<GraphJoint> joints;
  int root = 0;
};

/// The model of a graph: a spanning tree from the root, breadth first, and a LoopClosure where joints are left over.
///
/// Links keep their names and frames; a joint whose axis does not pass through the child's origin gets an empty link
/// "JOINT axis" between, a joint that closes a loop an empty link "JOINT closure". Joints that the tree walks backwards
/// keep their sign. The root's frame is the model's. Errors: a link that no joint connects to the root; see
/// LoopClosure::close().
Expected<RobotModel> modelOfGraph(const JointGraph& graph, const LoopOptions& options = {});

/// Three turning joints through one point in place of a ball joint, two in place of a universal one: adds empty links
/// between, named after `prototype.joint`, whose limits hold for each. `axes_J` are unit vectors in the joint frame.
void addCompoundJoint(JointGraph& graph, const GraphJoint& prototype, const std::vector<dvec3>& axes_J);

/// A turn and a slide that follows it by `pitch` (m a turn, right-handed) in place of a screw.
void addScrewJoint(JointGraph& graph, const GraphJoint& prototype, double pitch);

}  // namespace hapticell::kinematics
