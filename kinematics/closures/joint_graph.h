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

/// A joint between any two bodies. `joint.parent_link` and `joint.child_link` are indices of the graph's links,
/// `joint.mimic` of its joints; `joint.X_PJ` is not used. Type, axis (in the joint frame J) and limits are as in a
/// RobotModel.
struct GraphJoint {
  Joint joint;
  Pose X_MJ;  ///< With all joints at 0.
};

/// Bodies and joints that may form closed loops (SDF, mechanisms).
struct JointGraph {
  std::string name;
  std::vector<GraphLink> links;  ///< The first is the root, unless `root` names another.
  std::vector<GraphJoint> joints;
  int root = 0;
};

/// The model of a graph: a spanning tree from the root, breadth first, and a LoopClosure for the remaining joints.
///
/// Links keep their names and frames. A joint whose axis does not pass through the child's origin gets an empty link
/// "JOINT axis" between; a joint that closes a loop gets an empty link "JOINT closure". Joints that the tree passes in
/// reverse keep their sign. The root's frame is the model's. Errors: a link without a connection to the root; see
/// LoopClosure::close().
Expected<RobotModel> modelOfGraph(const JointGraph& graph, const LoopOptions& options = {});

/// Replaces a ball joint by three turning joints through one point, and a universal joint by two: adds empty links
/// between, named after `prototype.joint`, whose limits hold for each. `axes_J` are unit vectors in the joint frame.
void addCompoundJoint(JointGraph& graph, const GraphJoint& prototype, const std::vector<dvec3>& axes_J);

/// Replaces a screw by a turning joint and a slide that follows it by `pitch` (m per turn, right-handed).
void addScrewJoint(JointGraph& graph, const GraphJoint& prototype, double pitch);

}  // namespace hapticell::kinematics
