// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/motion_replay.h"

#include <algorithm>
#include <optional>

#include "geometry/system/overloaded.h"
#include "kinematics/closed_form/inverse_factory.h"
#include "manipulation/manipulators/moved_by.h"
#include "manipulation/manipulators/robot_manipulator.h"

namespace hapticell::manipulation {

namespace {

using trajectory::Trajectory;
using workcell::Entity;

Error replayRefusal(Text place, Text found, Text expected) {
  return {.place = std::move(place), .found = std::move(found), .expected = std::move(expected)};
}

/// Where a frame of the cell is in the entity.
Expected<std::optional<Pose>> namedFrame(const std::vector<std::shared_ptr<const Entity>>& entities,
                                         const Entity& entity, const std::string& name) {
  for (const auto& other : entities) {
    const Pose X_EO = entity.X_WE.inverse() * other->X_WE;
    if (other->name == name) return std::optional<Pose>(X_EO);
    for (const workcell::Frame& frame : other->frames) {
      if (frame.name == name) return std::optional<Pose>(X_EO * frame.X_EF);
    }
  }
  return makeError(
      replayRefusal(std::string("moved"), Text("no frame is named '%1'", name), Text("a frame of an entity")));
}

/// Where the moved frame is fixed in the entity; nothing where its joints move it.
Expected<std::optional<Pose>> fixedFrame(const std::vector<std::shared_ptr<const Entity>>& entities,
                                         const Entity& entity, const MovedBy& moved_by) {
  using Fixed = Expected<std::optional<Pose>>;
  const auto fixed = [](const Pose& X_EM) { return Fixed(std::optional<Pose>(X_EM)); };
  const auto by_joints = [] { return Fixed(std::optional<Pose>()); };
  const auto of_a_body = [](const auto&) -> Fixed {
    return makeError(replayRefusal(std::string("moved"), Text("a motion of one hand only"),
                                   Text("a mannequin's whole posture (moved: whole)")));
  };
  return std::visit(
      Overloaded{
          [&](const by::Default&) {
            const bool is_robot = workcell::isMachine(entity);
            return is_robot ? by_joints() : fixed(Pose::identity());
          },
          [&](const by::Tool&) { return by_joints(); },
          [&](const by::Base&) { return fixed(Pose::identity()); },
          [&](const by::Origin&) { return fixed(Pose::identity()); },
          [&](const by::Center&) {
            return fixed(entity.mesh() ? Pose::translation(entity.mesh()->bounds().center()) : Pose::identity());
          },
          [&](const by::Frame& frame) {
            if (entity.robot() && entity.robot()->findLink(frame.name) >= 0) return by_joints();
            return namedFrame(entities, entity, frame.name);
          },
          [&](const by::Whole&) { return fixed(Pose::identity()); },
          [&](const by::Hand& way) { return of_a_body(way); },
          [&](const by::BothHands& way) { return of_a_body(way); },
          [&](const by::Head& way) { return of_a_body(way); },
      },
      moved_by);
}

}  // namespace

namespace {

/// A robot drawn by its tool centre point, without parts.
Expected<std::unique_ptr<RobotManipulator>> armOf(const Entity& entity) {
  int tip = entity.robot()->findLink(entity.jointed().tip_link);
  if (tip < 0) tip = entity.robot()->defaultTip();
  if (tip < 0)
    return makeError(replayRefusal("'" + entity.name + "'", Text("the robot has no tip"), Text("a tip that moves")));
  auto inverse = kinematics::createInverse(*entity.robot(), tip, entity.jointed().X_LT);
  HAPTICELL_TRY(inverse);
  return std::make_unique<RobotManipulator>(entity.robot(), RobotManipulator::Tool{tip, entity.jointed().X_LT},
                                            std::move(*inverse), std::vector<RobotManipulator::Part>{});
}

/// A robot's motion by its tool: what joints and poses say of each other.
bool isByTool(const Entity& entity, const Trajectory& trajectory) {
  const bool robot = workcell::isMachine(entity);
  return robot && trajectory.hasJoints() && (trajectory.moved.empty() || trajectory.moved == "tcp");
}

/// m, rad between a frame's pose and its joints': far below any tolerance, above rounding. Half and twice as well.
constexpr double kSamePose = 1e-6;

/// Each frame with its configuration changed by `change`; marked where its joints do not bring the tool to its pose.
template <class Change>
Expected<Trajectory> reconciled(const Entity& entity, const Trajectory& trajectory, Change change) {
  if (!isByTool(entity, trajectory)) return trajectory;
  const auto columns = jointColumns(entity, trajectory);
  HAPTICELL_TRY(columns);
  const auto arm = armOf(entity);
  HAPTICELL_TRY(arm);
  Trajectory result = trajectory.emptyCopy();
  result.has_poses = true;
  result.reserve(trajectory.size());
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    EntityConfiguration at{entity.X_WE, entity.joints()};
    const auto joints = trajectory.joints(i);
    for (std::size_t j = 0; j < joints.size(); ++j) at.joints[(*columns)[j]] = joints[j];
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): one `change` sets it.
    Trajectory::Frame frame = trajectory[i];
    change(**arm, at, frame);
    const auto off = trajectory::distanceBetween((*arm)->movedFrame(at), frame.X_WT);
    frame.is_pose_apart = off.position > kSamePose || off.angle > kSamePose;
    std::vector<double> changed;
    for (const std::size_t column : *columns) changed.push_back(at.joints[column]);
    result.addFrame(frame, changed);
  }
  return result;
}

}  // namespace

Expected<Trajectory> jointsFromPoses(const Entity& entity, const Trajectory& trajectory) {
  if (!trajectory.has_poses) return posesFromJoints(entity, trajectory);
  return reconciled(entity, trajectory,
                    [](const RobotManipulator& arm, EntityConfiguration& at, const Trajectory::Frame& frame) {
                      at = arm.propose(at, frame.X_WT, kinematics::kUnboundedDuration);
                    });
}

Expected<Trajectory> posesFromJoints(const Entity& entity, const Trajectory& trajectory) {
  return reconciled(entity, trajectory,
                    [](const RobotManipulator& arm, const EntityConfiguration& at, Trajectory::Frame& frame) {
                      frame.X_WT = arm.movedFrame(at);
                    });
}

Expected<std::vector<std::size_t>> jointColumns(const Entity& entity, const Trajectory& trajectory) {
  std::vector<std::size_t> columns;
  if (entity.robot() == nullptr) return columns;
  for (std::size_t j = 0; j < trajectory.joint_names.size(); ++j) {
    const std::string& name = trajectory.joint_names[j];
    const int joint = entity.robot()->findJoint(name);
    const int variable = joint < 0 ? -1 : entity.robot()->joints[static_cast<std::size_t>(joint)].variable;
    // CSV twins name their columns q1, q2, ... from base to tip.
    const bool is_counted = joint < 0 && name == "q" + std::to_string(j + 1) && j < entity.robot()->dof();
    if (variable < 0 && !is_counted) {
      return makeError(replayRefusal(Text("joint '%1'", name), Text("'%1' has no such joint", entity.name),
                                     Text("names of the robot's joints, or q1, q2, ...")));
    }
    columns.push_back(is_counted ? j : static_cast<std::size_t>(variable));
  }
  return columns;
}

Expected<MotionReplay> MotionReplay::create(const std::vector<std::shared_ptr<const Entity>>& entities,
                                            const std::string& name, std::shared_ptr<const Trajectory> trajectory,
                                            const std::vector<double>& start) {
  const auto found = std::find_if(entities.begin(), entities.end(), [&](const auto& e) { return e->name == name; });
  if (found == entities.end())
    return makeError(
        replayRefusal(Text("entity"), Text("'%1' does not exist", name), Text("one that exists in the cell")));
  if (trajectory->empty()) return makeError(replayRefusal(Text("frames"), Text("none"), Text("a motion")));
  auto columns = jointColumns(**found, *trajectory);
  HAPTICELL_TRY(columns);
  MovedBy moved_by;
  if (!trajectory->moved.empty()) {
    auto parsed = parseMovedBy(trajectory->moved);
    HAPTICELL_TRY(parsed);
    moved_by = std::move(*parsed);
  }
  const auto X_EM = fixedFrame(entities, **found, moved_by);
  HAPTICELL_TRY(X_EM);

  MotionReplay replay;
  replay.entity_ = *found;
  replay.trajectory_ = std::move(trajectory);
  replay.columns_ = std::move(*columns);
  replay.moves_root_ = X_EM->has_value();
  if (replay.moves_root_) replay.X_EM_ = **X_EM;
  if (!replay.moves_root_ && replay.columns_.empty()) {
    HAPTICELL_TRY(replay.follow(start));
  }
  return replay;
}

Expected<void> MotionReplay::follow(const std::vector<double>& start) {
  const auto arm = armOf(*entity_);
  HAPTICELL_TRY(arm);
  EntityConfiguration at{entity_->X_WE, start.size() == entity_->robot()->dof() ? start : entity_->joints()};
  followed_.reserve(trajectory_->size());
  for (const Trajectory::Frame& frame : trajectory_->frames()) {
    at = (*arm)->propose(at, frame.X_WT, kinematics::kUnboundedDuration);
    const auto off = trajectory::distanceBetween((*arm)->movedFrame(at), frame.X_WT);
    off_pose_ = {std::max(off_pose_.position, off.position), std::max(off_pose_.angle, off.angle)};
    followed_.push_back(at.joints);
  }
  return {};
}

EntityConfiguration MotionReplay::at(double t) const {
  EntityConfiguration at{entity_->X_WE, entity_->joints()};
  if (moves_root_) at.X_WE = trajectory_->poseAt(t) * X_EM_.inverse();
  if (!columns_.empty()) {
    const std::vector<double> joints = trajectory_->jointsAt(t);
    for (std::size_t j = 0; j < columns_.size(); ++j) at.joints[columns_[j]] = joints[j];
  } else if (!followed_.empty()) {
    const auto frames = trajectory_->frames();
    const auto after =
        std::upper_bound(frames.begin(), frames.end(), t, [](double time, const auto& f) { return time < f.t; });
    const auto next = std::min<std::size_t>(static_cast<std::size_t>(after - frames.begin()), frames.size() - 1);
    const std::size_t before = after == frames.begin() ? 0 : static_cast<std::size_t>(after - frames.begin()) - 1;
    const double span = frames[next].t - frames[before].t;
    const double share = span > 0.0 ? std::clamp((t - frames[before].t) / span, 0.0, 1.0) : 0.0;
    at.joints = followed_[before];
    for (std::size_t j = 0; j < at.joints.size(); ++j) at.joints[j] += share * (followed_[next][j] - at.joints[j]);
  }
  return at;
}

Pose MotionReplay::movedFrame(const EntityConfiguration& at) const {
  if (moves_root_ || !entity_->robot()) return at.X_WE * X_EM_;
  int tip = entity_->robot()->findLink(entity_->jointed().tip_link);
  if (tip < 0) tip = entity_->robot()->defaultTip();
  if (tip < 0) return at.X_WE;
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*entity_->robot(), at.joints, X_BL);
  return at.X_WE * X_BL[static_cast<std::size_t>(tip)] * entity_->jointed().X_LT;
}

Trajectory MotionReplay::withJoints() const {
  if (followed_.empty()) return *trajectory_;
  Trajectory result = trajectory_->emptyCopy();
  for (const int joint : entity_->robot()->moving) {
    result.joint_names.push_back(entity_->robot()->joints[static_cast<std::size_t>(joint)].name);
  }
  result.reserve(trajectory_->size());
  for (std::size_t i = 0; i < trajectory_->size(); ++i) result.addFrame((*trajectory_)[i], followed_[i]);
  return result;
}

}  // namespace hapticell::manipulation
