// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"
#include "kinematics/model/closure.h"

namespace hapticell::kinematics {

enum class JointType { kFixed, kRevolute, kContinuous, kPrismatic };

/// A joint that follows another: position = multiplier * position(joint) + offset. The followed joint moves or is fixed
/// (position 0); it is never a mimic joint itself: readers ensure this.
struct Mimic {
  int joint = -1;
  double multiplier = 1.0;
  double offset = 0.0;
};

/// A shape on a link, in the link's frame L.
struct LinkShape {
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  Pose X_LS;
  std::array<float, 4> color{0.7f, 0.7f, 0.7f, 1.0f};
  std::string source;  ///< The file it came from, or "box", "cylinder", "sphere".
};

struct Link {
  std::string name;
  int parent_joint = -1;  ///< Index of the joint that carries it; -1 for the root.
  std::vector<LinkShape> visuals;
  std::vector<LinkShape> collisions;  ///< Shapes for collision checks; equal to the visuals if the file gives none.
  /// Shapes that the file names but that could not be read (a missing or broken mesh). If `collisions` is empty then,
  /// the link is not checked although it has a shape: users see "no shape".
  int lost_shapes = 0;

  bool isUnchecked() const { return lost_shapes > 0 && collisions.empty(); }
};

struct Joint {
  std::string name;
  JointType type = JointType::kFixed;
  int parent_link = -1;
  int child_link = -1;
  Pose X_PJ;                    ///< Joint frame in the parent link's frame, at position 0.
  dvec3 axis_J{0.0, 0.0, 1.0};  ///< Unit, in the joint frame.
  double lower = 0.0;           ///< rad or m; -inf for continuous.
  double upper = 0.0;
  double velocity = 0.0;  ///< rad/s or m/s; 0 if the file gives none.
  std::optional<Mimic> mimic;
  int variable = -1;  ///< Index among the moving joints (what users set); -1 for fixed and mimic joints.
};

/// Two links that are never checked against each other, and the reason ("Adjacent", "Never").
struct DisabledPair {
  int first = -1;
  int second = -1;
  std::string reason;
};

/// A named set of joints or links (SRDF), e.g. "arm", "gripper".
struct JointGroup {
  std::string name;
  std::vector<int> joints;  ///< Indices into RobotModel::joints.
  std::string base_link, tip_link;
};

/// Named positions, e.g. "home": one number per variable.
struct NamedPose {
  std::string name;
  std::vector<double> q;
};

/// A tree of links and joints, root first: joints are ordered so that each parent link comes before its children. If a
/// closure is set, the joints hold the variables and their limits, and the closure alone determines the poses of the
/// links.
struct RobotModel {
  std::string name;
  std::vector<Link> links;    ///< links[0] is the root.
  std::vector<Joint> joints;  ///< Topological order.
  std::vector<int> moving;    ///< Joint indices of the variables, in order; size() is the number of degrees of freedom.
  std::shared_ptr<const Closure> closure;    ///< Null for a tree.
  std::vector<DisabledPair> disabled_pairs;  ///< From an SRDF beside the file, or from the builder of the closure.
  std::vector<JointGroup> groups;
  std::vector<NamedPose> named_poses;
  int tip = -1;              ///< The link of defaultTip() if the file names it; -1: chosen by its rule.
  std::vector<double> home;  ///< One per variable, or empty: all zero, moved into their limits.

  std::size_t dof() const { return moving.size(); }
  int findLink(const std::string& link_name) const;    ///< Index or -1.
  int findJoint(const std::string& joint_name) const;  ///< Index or -1.
  /// The tip that a user most likely means: the link moved by most joints, deepest among equals. A link named tcp,
  /// tool0, tool or flange (or with a name that ends in "_" and one of these) has priority; `tip` comes before these.
  /// -1 without links.
  int defaultTip() const;
};

/// The position of one joint (rad or m) at the variables `q`: its own, or that of the joint it mimics; 0 if fixed.
double jointPosition(const RobotModel& model, const std::vector<double>& q, const Joint& joint);

/// The greatest speed of the joint; if the file gives none, 1 m/s or pi rad/s.
double greatestSpeed(const Joint& joint);

/// Default joint positions: the robot's home, or else zero, moved into the limits.
std::vector<double> restPositions(const RobotModel& model);

/// For each link the first link of its rigid body: links connected by fixed joints form one body. With a closure each
/// link is a body of its own, because the tree does not show what moves.
std::vector<int> rigidBodies(const RobotModel& model);

/// Poses X_BL of all links in the root link's frame B for joint positions `q` (one per variable), into `X_BL`
/// (resized). With a closure: in the assembly of the home position; if the loops cannot be closed, the nearest poses
/// found.
void forwardKinematics(const RobotModel& model, const std::vector<double>& q, std::vector<Pose>& X_BL);

}  // namespace hapticell::kinematics
