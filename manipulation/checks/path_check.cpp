// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/path_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "kinematics/model/inverse_model.h"
#include "manipulation/checks/collision_track.h"
#include "manipulation/checks/joint_track.h"
#include "manipulation/checks/motion_replay.h"

namespace hapticell::manipulation {

namespace {

using trajectory::Trajectory;
using workcell::Entity;
using workcell::EntityKind;

/// Frames between two reports of progress: some tenths of a second. Half: more calls; twice: cancelling takes up to
/// twice as long.
constexpr std::size_t kFramesPerReport = 20;

Expected<void> checkArguments(const Entity* entity, const std::string& name, const Trajectory& trajectory) {
  if (entity == nullptr)
    return makeError({.found = Text("no entity is named '%1'", name), .expected = "an entity of the workcell"});
  if (trajectory.empty()) return makeError({.place = "frames", .found = "none", .expected = "a motion"});
  return {};
}

/// A mannequin's motion as a whole: each frame has its place and all its joints.
bool movesWhole(const Entity& entity, const MovedBy& moved_by, const Trajectory& trajectory) {
  return entity.figure() != nullptr && trajectory.has_poses &&
         (std::holds_alternative<by::Whole>(moved_by) || std::holds_alternative<by::Default>(moved_by));
}

/// The joints of an external axis that moves meanwhile, among those of the whole.
struct AxisTrack {
  std::shared_ptr<const Trajectory> motion;
  std::vector<std::size_t> columns;
};

/// One for each of the axes that the held robot stands on and that `options` has a motion of.
Expected<std::vector<AxisTrack>> axisTracks(const PreparedScene& scene, const HeldEntity& held,
                                            const PathCheckOptions& options) {
  std::vector<AxisTrack> tracks;
  std::size_t first = 0;
  for (const auto& [id, stands] : held.axes()) {
    const Entity& axis = *scene.find(id);
    const auto motion = std::find_if(options.axes.begin(), options.axes.end(),
                                     [&, &name = axis.name](const auto& one) { return one->entity == name; });
    if (motion != options.axes.end() && !(*motion)->empty()) {
      auto columns = jointColumns(axis, **motion);
      HAPTICELL_TRY(columns);
      for (std::size_t& column : *columns) column += first;
      tracks.push_back({*motion, std::move(*columns)});
    }
    first += stands.joints.size();
  }
  return tracks;
}

/// Walks through the frames and lets each kind of check look at every step.
class PathWalk {
 public:
  PathWalk(const Entity& entity, const HeldEntity& held, std::vector<AxisTrack> axes, const PathCheckOptions& options,
           bool moves_whole)
      : options_(options),
        moves_whole_(moves_whole),
        manipulator_(held.manipulator()),
        axes_(std::move(axes)),
        first_own_(held.accepted().joints.size() - held.standing().joints.size()),
        bodies_(held),
        collisions_(bodies_, manipulator_, options.look),
        before_(held.accepted()) {
    if (entity.kind() == EntityKind::kRobot && entity.robot() != nullptr) joints_.emplace(entity);
    if (!held.leftOutNote().empty()) result_.notes.push_back(english(held.leftOutNote()));
  }

  PathCheckResult run(const Trajectory& trajectory, const std::vector<std::size_t>& columns) {
    result_.least_clearance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < trajectory.size(); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(trajectory.size());
      if (options_.progress && i % kFramesPerReport == 0 && !options_.progress(share)) {
        result_.cancelled = true;
        break;
      }
      EntityConfiguration at = configurationAt(trajectory, columns, i);
      look(trajectory, i, at);
      before_ = std::move(at);
    }
    list_.endFrame(result_);
    collisions_.finish(result_);
    std::stable_sort(result_.findings.begin(), result_.findings.end(),
                     [](const PathFinding& a, const PathFinding& b) { return a.t_in < b.t_in; });
    return std::move(result_);
  }

 private:
  EntityConfiguration configurationAt(const Trajectory& trajectory, const std::vector<std::size_t>& columns,
                                      std::size_t i) const {
    if (columns.empty()) return manipulator_.propose(before_, trajectory[i].X_WT, kinematics::kUnboundedDuration);
    // What moves as a whole while its joints move: the frame says where it is, the joints how it stands.
    EntityConfiguration at =
        moves_whole_ ? manipulator_.propose(before_, trajectory[i].X_WT, kinematics::kUnboundedDuration) : before_;
    for (std::size_t j = 0; j < columns.size(); ++j) at.joints[first_own_ + columns[j]] = trajectory.joints(i)[j];
    for (const AxisTrack& axis : axes_) {
      const std::vector<double> joints = axis.motion->jointsAt(trajectory[i].t);
      for (std::size_t j = 0; j < axis.columns.size(); ++j) at.joints[axis.columns[j]] = joints[j];
    }
    return at;
  }

  /// Without the external axes' joints, which come first.
  EntityConfiguration ownOf(const EntityConfiguration& at) const {
    return {at.X_WE, {at.joints.begin() + static_cast<std::ptrdiff_t>(first_own_), at.joints.end()}};
  }

  void look(const Trajectory& trajectory, std::size_t i, const EntityConfiguration& at) {
    const double t = trajectory[i].t;
    const double t_before = i == 0 ? t : trajectory[i - 1].t;
    const auto off = trajectory::distanceBetween(manipulator_.movedFrame(at), trajectory[i].X_WT);
    const double worst = std::max(off.position, off.angle);
    if (worst > options_.pose_tolerance) list_.add(PathFinding::Kind::kOffPose, "", t, worst);
    if (joints_) {
      const EntityConfiguration before = ownOf(before_);
      joints_->look(ownOf(at), i == 0 ? nullptr : &before, t, t - t_before, list_);
    }
    if (i == 0) {
      collisions_.start(at, t, result_);
    } else {
      collisions_.step(before_, at, t_before, t, result_);
    }
    list_.endFrame(result_);
  }

  const PathCheckOptions& options_;
  const bool moves_whole_;
  const Manipulator& manipulator_;
  const std::vector<AxisTrack> axes_;
  const std::size_t first_own_;
  const MeetingBodies bodies_;
  CollisionTrack collisions_;
  FindingList list_;
  std::optional<JointTrack> joints_;
  EntityConfiguration before_;
  PathCheckResult result_;
};

}  // namespace

Expected<PathCheckResult> checkPath(std::shared_ptr<const PreparedScene> scene, const std::string& name,
                                    const Trajectory& trajectory, const PathCheckOptions& options,
                                    const config::Configuration& configuration) {
  const Entity* entity = scene->find(name);
  HAPTICELL_TRY(checkArguments(entity, name, trajectory));
  const auto columns = jointColumns(*entity, trajectory);
  HAPTICELL_TRY(columns);
  HoldOptions hold = options.hold;
  // A motion tells the robot's own joints; what it stands on moves only where a motion of that is there too.
  if (by::Tool* tool = toolOf(hold.moved_by)) tool->with_axes = !options.axes.empty() && !columns->empty();
  hold.joints_move = movesWhole(*entity, hold.moved_by, trajectory) && !columns->empty();
  const auto held = HeldEntity::take(scene, entity->id, {}, hold, configuration);
  HAPTICELL_TRY(held);
  auto axes = axisTracks(*scene, **held, options);
  HAPTICELL_TRY(axes);
  return PathWalk(*entity, **held, std::move(*axes), options, hold.joints_move).run(trajectory, *columns);
}

}  // namespace hapticell::manipulation
