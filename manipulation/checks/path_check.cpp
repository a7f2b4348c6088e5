// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/path_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "kinematics/model/inverse_model.h"
#include "kinematics/model/jacobian.h"
#include "manipulation/checks/motion_replay.h"
#include "manipulation/manipulators/arm_configuration.h"

namespace hapticell::manipulation {

namespace {

using trajectory::Trajectory;
using workcell::Entity;
using workcell::EntityKind;

/// m that a radian counts like, for the distance to singular positions: lever_m of the inverse models. Half: rotations
/// count half as much; twice: twice, so wrists are reported sooner.
constexpr double kLever = 0.25;
/// rad or m beyond a limit that are rounding of a file. Half: a file of six digits may have findings; twice: 2 um or 2
/// urad are let pass.
constexpr double kJointTolerance = 1e-6;
/// Frames between two reports of progress: some tenths of a second. Half: more calls; twice: cancelling takes up to
/// twice as long.
constexpr std::size_t kFramesPerReport = 20;

/// Everything that could meet, as the held entity knows it: its own parts, what hangs on it, and what stands. A motion
/// is looked at whole, so every pair blocks, those that the user passes through too.
struct Bodies {
  const HeldEntity& held;
  std::vector<MotionPair> pairs;

  explicit Bodies(const HeldEntity& of) : held(of), pairs(of.motion().pairs()) {
    for (MotionPair& pair : pairs) pair.blocks = true;
  }
  FreeMotion motionOf(std::vector<MotionPair> some) const {
    return {held.motion().parts(), held.motion().obstacles(), std::move(some)};
  }
  std::string first(std::uint32_t pair) const { return held.nameOf(*held.movedParts()[pairs[pair].part].part); }
  std::string second(std::uint32_t pair) const {
    const int other = pairs[pair].other_part;
    return held.nameOf(other < 0 ? *held.obstacleParts()[pairs[pair].obstacle]
                                 : *held.movedParts()[static_cast<std::size_t>(other)].part);
  }
};

/// Follows each pair through the motion and keeps an interval for each time that it meets.
class CollisionTrack {
 public:
  CollisionTrack(const Bodies& bodies, const Manipulator& manipulator, double look)
      : bodies_(bodies),
        manipulator_(manipulator),
        look_(look),
        motion_(bodies.motionOf(bodies.pairs)),
        open_(bodies.pairs.size()) {}

  void start(const EntityConfiguration& at, double t, PathCheckResult& result) {
    motion_.reset(manipulator_, at);
    for (std::uint32_t i = 0; i < open_.size(); ++i) {
      if (!motion_.isSoft(i)) continue;
      open_[i] = finding(i, t);
      at_start_.push_back(i);
    }
    look(t, result);
  }

  void step(const EntityConfiguration& from, const EntityConfiguration& to, double t0, double t1,
            PathCheckResult& result) {
    const MotionAnswer answer = motion_.advance(manipulator_, from, to);
    if (answer.blocked) {
      note(answer, answer.pair, t0, t1);
      noteOthers(from, to, answer.pair, t0, t1);
      motion_.reset(manipulator_, to);
    }
    for (std::uint32_t i = 0; i < open_.size(); ++i) {
      if (!open_[i]) continue;
      open_[i]->t_out = t1;
      if (!motion_.isSoft(i)) close(i, result);
    }
    look(t1, result);
  }

  void finish(PathCheckResult& result) {
    for (std::uint32_t i = 0; i < open_.size(); ++i) {
      if (open_[i]) close(i, result);
    }
  }

 private:
  PathFinding finding(std::uint32_t pair, double t) const {
    PathFinding found;
    found.t_in = found.t_out = t;
    found.first = bodies_.first(pair);
    found.second = bodies_.second(pair);
    return found;
  }

  void note(const MotionAnswer& answer, std::uint32_t pair, double t0, double t1) {
    if (open_[pair]) return;
    open_[pair] = finding(pair, t0 + answer.s * (t1 - t0));
    open_[pair]->p_W = 0.5 * (answer.contact.p_WA + answer.contact.p_WB);
  }

  /// A motion ends at the first pair that blocks; the others are tried without it.
  void noteOthers(const EntityConfiguration& from, const EntityConfiguration& to, std::uint32_t first, double t0,
                  double t1) {
    std::vector<std::uint32_t> left;
    for (std::uint32_t i = 0; i < open_.size(); ++i) {
      if (i != first && !open_[i]) left.push_back(i);
    }
    while (!left.empty()) {
      std::vector<MotionPair> pairs;
      for (const std::uint32_t i : left) pairs.push_back(bodies_.pairs[i]);
      FreeMotion others = bodies_.motionOf(std::move(pairs));
      others.reset(manipulator_, from);
      const MotionAnswer answer = others.advance(manipulator_, from, to);
      if (!answer.blocked) return;
      note(answer, left[answer.pair], t0, t1);
      left.erase(left.begin() + answer.pair);
    }
  }

  void close(std::uint32_t pair, PathCheckResult& result) {
    const auto first = std::find(at_start_.begin(), at_start_.end(), pair);
    if (first != at_start_.end()) {
      result.touching_at_start.push_back(*open_[pair]);
      at_start_.erase(first);
    } else {
      result.findings.push_back(*open_[pair]);
    }
    open_[pair].reset();
  }

  void look(double t, PathCheckResult& result) {
    motion_.distances(std::min(result.least_clearance, look_), near_);
    for (const auto& one : near_) {
      const bool own = bodies_.pairs[one.pair].other_part >= 0;  // Links of one arm are always near each other.
      if (own || open_[one.pair] || one.result.distance >= result.least_clearance) continue;
      result.least_clearance = one.result.distance;
      result.nearest_first = bodies_.first(one.pair);
      result.nearest_second = bodies_.second(one.pair);
      result.t_nearest = t;
    }
  }

  const Bodies& bodies_;
  const Manipulator& manipulator_;
  const double look_;
  FreeMotion motion_;
  std::vector<std::optional<PathFinding>> open_;
  std::vector<std::uint32_t> at_start_;
  std::vector<FreeMotion::PairDistance> near_;
};

/// Keeps one interval for each kind and name as long as it goes on from frame to frame.
class FindingList {
 public:
  void add(PathFinding::Kind kind, const std::string& name, double t, double worst) {
    auto& open = open_[{kind, name}];
    if (!open) {
      open = PathFinding{kind, t, t, name, {}, worst, {}};
    }
    open->t_out = t;
    open->worst = std::max(open->worst, worst);
    touched_.push_back({kind, name});
  }

  /// After each frame: what was not added again is over.
  void endFrame(PathCheckResult& result) {
    for (auto& [key, open] : open_) {
      if (!open || std::find(touched_.begin(), touched_.end(), key) != touched_.end()) continue;
      result.findings.push_back(*open);
      open.reset();
    }
    touched_.clear();
  }

 private:
  using Key = std::pair<PathFinding::Kind, std::string>;
  std::map<Key, std::optional<PathFinding>> open_;
  std::vector<Key> touched_;
};

/// Of a robot: joints against their ends and speeds, and how near the arm is to losing a direction.
class JointTrack {
 public:
  explicit JointTrack(const Entity& entity) : model_(*entity.robot()), arm_(sixAxisChain(entity)) {
    tip_ = model_.findLink(entity.jointed().tip_link);
    if (tip_ < 0) tip_ = model_.defaultTip();
    variables_ = tip_ >= 0 ? kinematics::variablesOfChain(model_, tip_) : std::vector<int>{};
  }

  void look(const EntityConfiguration& at, const EntityConfiguration* before, double t, double dt, FindingList& list) {
    const auto distances = kinematics::limitDistances(model_, at.joints);
    for (std::size_t v = 0; v < model_.dof(); ++v) {
      const kinematics::Joint& joint = model_.joints[static_cast<std::size_t>(model_.moving[v])];
      const double beyond = -std::min(distances[v].to_lower, distances[v].to_upper);
      if (beyond > kJointTolerance) list.add(PathFinding::Kind::kJointLimit, joint.name, t, beyond);
      if (before == nullptr || joint.velocity <= 0.0) continue;
      const double speed = std::abs(at.joints[v] - before->joints[v]) / dt;
      if (speed > joint.velocity * (1.0 + 1e-3)) {
        list.add(PathFinding::Kind::kJointSpeed, joint.name, t, speed - joint.velocity);
      }
    }
    lookAtConfiguration(at, t, list);
    if (tip_ < 0) return;
    kinematics::forwardKinematics(model_, at.joints, X_BL_);
    kinematics::geometricJacobian(model_, X_BL_, tip_, X_BL_[static_cast<std::size_t>(tip_)].p, jacobian_);
    // A robot with fewer than six joints lacks directions everywhere; that is no finding.
    if (variables_.size() >= 6 && kinematics::manipulability(jacobian_, kLever).smallest < 0.01) {
      list.add(PathFinding::Kind::kSingularity, "", t, 0.0);
    }
  }

 private:
  void lookAtConfiguration(const EntityConfiguration& at, double t, FindingList& list) {
    if (!arm_) return;
    const auto now = configurationNumber(*arm_, at.joints);
    if (now && configuration_ && *now != *configuration_) {
      list.add(PathFinding::Kind::kConfiguration, namesOfChange(*configuration_ ^ *now), t, 0.0);
    }
    if (now) configuration_ = now;
  }

  static std::string namesOfChange(int bits) {
    std::string names;
    for (const auto& [bit, name] : {std::pair(1, "front or back"), std::pair(2, "elbow"), std::pair(4, "wrist")}) {
      if ((bits & bit) != 0) names += (names.empty() ? "" : ", ") + std::string(name);
    }
    return names;
  }

  const kinematics::RobotModel& model_;
  std::optional<kinematics::Chain> arm_;
  std::optional<int> configuration_;
  int tip_ = -1;
  std::vector<int> variables_;
  std::vector<Pose> X_BL_;
  kinematics::Jacobian jacobian_;
};

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
  const Bodies bodies_;
  CollisionTrack collisions_;
  FindingList list_;
  std::optional<JointTrack> joints_;
  EntityConfiguration before_;
  PathCheckResult result_;
};

}  // namespace

const char* toString(PathFinding::Kind kind) {
  constexpr std::array<const char*, 6> kNames{"collision",   "joint_limit", "joint_speed",
                                              "singularity", "off_pose",    "configuration"};
  return kNames[static_cast<std::size_t>(kind)];
}

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
