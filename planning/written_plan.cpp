// SPDX-License-Identifier: Apache-2.0
#include "planning/written_plan.h"

#include <algorithm>
#include <cmath>

#include "manipulation/checks/joint_check.h"
#include "manipulation/checks/motion_replay.h"
#include "manipulation/checks/path_check.h"
#include "manipulation/holding/held_model.h"
#include "planning/axis_motions.h"
#include "planning/written_leaving.h"
#include "planning/written_poses.h"
#include "trajectory/files/trajectory_io.h"
#include "trajectory/motion/number_text.h"

namespace hapticell::planning {

namespace {

using trajectory::Trajectory;

/// m and rad between two places that are measured. Half: twice the time; twice: a corner may hide 1 mm.
constexpr double kFinePosition = 2e-3, kFineTurn = 4e-3;
/// m: clearances are measured up to here; half: larger ones are not told apart; twice: some ms more.
constexpr double kLook = 1.0;
/// m: gaps of pairs that are left or reached are measured up to here. Half: a pair may count as clear too early; twice:
/// more pairs are measured at each place.
constexpr double kLeavingLook = 0.05;
/// m, rad: ends are met so well: a hundred times the rounding of the timing's curves. Half: passes as well; twice: 2e-5
/// off passes.
constexpr double kEnds = 1e-5;
/// rad, m beyond a limit: rounding of the curves. Half: passes as well; twice: 4e-5 beyond passes.
constexpr double kBeyondLimit = 2e-5;
/// Share of a greatest speed: what remains of the times' rounding. Half, twice: as well.
constexpr double kSpeedRounding = 1e-6;

/// The same motion with places between its frames.
Trajectory refined(const Trajectory& given) {
  Trajectory fine = given.emptyCopy();
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (i > 0) {
      const auto apart = trajectory::distanceBetween(given[i - 1].X_WT, given[i].X_WT);
      double turn = apart.angle;
      for (std::size_t j = 0; j < given.joint_names.size(); ++j) {
        turn = std::max(turn, std::abs(given.joints(i)[j] - given.joints(i - 1)[j]));
      }
      const int pieces = static_cast<int>(std::ceil(std::max(apart.position / kFinePosition, turn / kFineTurn)));
      for (int k = 1; k < pieces; ++k) {
        Trajectory::Frame frame;
        frame.t = given[i - 1].t + (given[i].t - given[i - 1].t) * k / pieces;
        frame.X_WT = given.poseAt(frame.t);
        fine.addFrame(frame, given.jointsAt(frame.t));
      }
    }
    fine.addFrame(given[i], given.joints(i));
  }
  return fine;
}

double differenceOf(const Trajectory& motion, std::size_t frame, const EntityConfiguration& wanted,
                    const std::vector<std::size_t>& columns) {
  if (columns.empty()) {
    const auto apart = trajectory::distanceBetween(motion[frame].X_WT, wanted.X_WE);
    return std::max(apart.position, apart.angle);
  }
  double worst = 0.0;
  if (motion.moved == "whole") {
    const auto apart = trajectory::distanceBetween(motion[frame].X_WT, wanted.X_WE);
    worst = std::max(apart.position, apart.angle);
  }
  for (std::size_t j = 0; j < columns.size(); ++j) {
    worst = std::max(worst, std::abs(motion.joints(frame)[j] - wanted.joints[columns[j]]));
  }
  return worst;
}

struct Clearance {
  double least = kLook, t = 0.0;
};

/// Of a robot: what no joint moves (a base on its table) is left out.
Expected<Clearance> clearanceOfJoints(const Trajectory& fine, const std::vector<std::size_t>& columns,
                                      const std::shared_ptr<const manipulation::PreparedScene>& scene,
                                      const workcell::Entity& entity, const LeavingLook& wanted,
                                      const config::Configuration& configuration) {
  auto check = manipulation::JointCheck::create(scene, entity.id, configuration,
                                                manipulation::RestContacts::kLeaveOutLasting, wanted.with_axes);
  HAPTICELL_TRY(check);
  Clearance clearance{wanted.look, 0.0};
  std::vector<double> joints = check->entity().joints();
  for (std::size_t i = 0; i < fine.size(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) joints[columns[j]] = fine.joints(i)[j];
    const double distance = check->clearance(joints, clearance.least);
    if (distance < clearance.least) clearance = {distance, fine[i].t};
  }
  return clearance;
}

/// What the files say together.
struct ReadMotions {
  workcell::Entity entity;                         ///< With its external axes, if they move: all as one robot.
  Trajectory own;                                  ///< Of the entity.
  std::vector<std::shared_ptr<const Trajectory>> axes;
  Trajectory all;                                  ///< With the joints of the axes.
  std::vector<std::size_t> columns;                ///< Of `all` in `entity`.
  std::size_t axis_joints = 0;                     ///< The first of them.
};

Error otherEntity(const std::filesystem::path& file, const Trajectory& motion) {
  return {.file = file.string(),
          .found = Text("a motion of '%1'", motion.entity),
          .expected = "a motion of the entity that was planned for"};
}

Expected<ReadMotions> readMotions(const WrittenFiles& written,
                                  const std::shared_ptr<const manipulation::PreparedScene>& scene,
                                  const workcell::Entity* entity) {
  auto own = trajectory::readTrajectory(written.motion);
  HAPTICELL_TRY(own);
  const bool is_other = entity == nullptr || (!own->entity.empty() && own->entity != entity->name);
  if (is_other || own->empty()) return makeError(otherEntity(written.motion, *own));
  ReadMotions read{*entity, *own, {}, *own, {}, 0};
  if (!written.axes.empty()) {
    std::vector<Text> notes;
    workcell::Entity free = *entity;
    free.locked = false;
    const manipulation::HeldModel model(scene, free, {}, true, notes);
    const auto members = model.members();
    std::vector<Trajectory> axes;
    for (std::size_t k = 0; k < written.axes.size(); ++k) {
      auto axis = trajectory::readTrajectory(written.axes[k]);
      HAPTICELL_TRY(axis);
      const bool is_complete = written.axes.size() + 1 == members.size();
      if (is_complete && axis->entity.empty()) axis->entity = members[k]->name;  // Tables do not name it.
      if (!is_complete || axis->entity != members[k]->name) return makeError(otherEntity(written.axes[k], *axis));
      read.axes.push_back(std::make_shared<const Trajectory>(*axis));
      read.axis_joints += axis->joint_names.size();
      axes.push_back(std::move(*axis));
    }
    read.entity = model.form();
    auto all = motionOfAll(*own, axes, read.entity);
    HAPTICELL_TRY(all);
    read.all = std::move(*all);
  }
  auto columns = manipulation::jointColumns(read.entity, read.all);
  HAPTICELL_TRY(columns);
  read.columns = std::move(*columns);
  return read;
}

/// The worst joint of the external axes.
struct AxisLimits {
  double beyond = 0.0;  ///< rad, m
  Text where_beyond;
  double speed = 0.0;   ///< Share of the greatest.
  Text where_speed;
};

AxisLimits axisLimits(const ReadMotions& read) {
  AxisLimits worst;
  if (read.axis_joints == 0) return worst;
  const kinematics::RobotModel& robot = *read.entity.robot();
  for (std::size_t j = 0; j < read.axis_joints; ++j) {
    const kinematics::Joint& joint = robot.joints[static_cast<std::size_t>(robot.moving[read.columns[j]])];
    for (std::size_t i = 0; i < read.all.size(); ++i) {
      const double q = read.all.joints(i)[j];
      const double beyond = std::max(q - joint.upper, joint.lower - q);
      if (beyond > worst.beyond) {
        worst.beyond = beyond;
        worst.where_beyond = Text("joint '%1'", joint.name);
      }
      if (i == 0) continue;
      const double way = std::abs(q - read.all.joints(i - 1)[j]);
      const double speed = way / (read.all[i].t - read.all[i - 1].t) / kinematics::greatestSpeed(joint);
      if (speed <= worst.speed) continue;
      worst.speed = speed;
      worst.where_speed = Text("joint '%1'", joint.name);
    }
  }
  return worst;
}

Text timeText(double t) {
  return Text("at %1 s", trajectory::shortestText(std::round(1e4 * t) / 1e4));
}

/// A contact of a pair that is left or reached just then, or of a foot that stands.
bool isAllowed(const manipulation::PathFinding& finding, const Leaving& leaving) {
  const auto& still = leaving.still;
  if (std::find(still.begin(), still.end(), finding.first) != still.end()) return true;
  const std::vector<TightPair>& tight = leaving.tight;
  return std::any_of(tight.begin(), tight.end(), [&](const TightPair& one) {
    if (one.moved != finding.first || one.met != finding.second) return false;
    return one.is_reached ? finding.t_in >= one.t : finding.t_out <= one.t;
  });
}

void addLeaving(const Leaving& leaving, Promises& promises) {
  if (leaving.tight.empty()) return;
  // Half the exactness to which the planner halves depths; half: it may refuse what the planner has just allowed.
  constexpr double kDepthRounding = 2e-5;
  promises.list.push_back(
      {"depth", LeavingRule::kDeepest, leaving.deepest, "m", leaving.where_deepest, false, kDepthRounding});
  promises.list.push_back({"closing", LeavingRule::kMayClose, leaving.closing, "m", leaving.where_closing, false, 1e-6});
}

}  // namespace

Text TightPair::text() const {
  const std::string when = trajectory::shortestText(std::round(100.0 * t) / 100.0);
  if (is_reached)
    return gap > 0.0 ? Text("%1 is %2 from %3 at the goal, and clear of it until %4 s", moved, Text::Length{gap}, met, when)
                     : Text("%1 touches %2 at the goal, and is clear of it until %3 s", moved, met, when);
  return gap > 0.0 ? Text("%1 is %2 from %3 at the start, and clear of it from %4 s on", moved, Text::Length{gap}, met, when)
                   : Text("%1 touches %2 at the start, and is clear of it from %3 s on", moved, met, when);
}

Expected<Promises> writtenPlanPromises(const WrittenFiles& written, const Plan& plan, double clearance,
                                       const std::shared_ptr<const manipulation::PreparedScene>& scene,
                                       workcell::EntityId id, const config::Configuration& configuration) {
  auto check = checkWrittenPlan(written, plan, clearance, scene, id, configuration);
  HAPTICELL_TRY(check);
  return std::move(check->promises);
}

Expected<WrittenPlan> checkWrittenPlan(const WrittenFiles& written, const Plan& plan, double clearance,
                                       const std::shared_ptr<const manipulation::PreparedScene>& scene,
                                       workcell::EntityId id, const config::Configuration& configuration) {
  const workcell::Entity* entity = scene->find(id);
  const auto read = readMotions(written, scene, entity);
  HAPTICELL_TRY(read);
  const std::vector<std::size_t>& columns = read->columns;
  const Trajectory fine = refined(read->all);
  manipulation::PathCheckOptions options;
  options.look = std::max(kLook, 2.0 * clearance);
  options.axes = read->axes;
  const bool has_axes = !read->axes.empty();
  const auto check = manipulation::checkPath(scene, entity->name, has_axes ? refined(read->own) : fine, options,
                                             configuration);
  HAPTICELL_TRY(check);

  const bool is_figure = entity->figure() != nullptr;
  Clearance least{std::min(options.look, check->least_clearance), check->t_nearest};
  const LeavingLook near{clearance, std::max(kLeavingLook, 2.0 * clearance), has_axes};
  const LeavingLook far{clearance, options.look, has_axes};
  if (!columns.empty() && !is_figure) {
    auto of_joints = clearanceOfJoints(fine, columns, scene, *entity, far, configuration);
    HAPTICELL_TRY(of_joints);
    least = *of_joints;
  }
  Leaving leaving;
  if (plan.leaves_contact || is_figure) {
    auto measured = measuredLeaving(fine, columns, scene, *entity, near, configuration);
    HAPTICELL_TRY(measured);
    leaving = std::move(*measured);
    if (!leaving.tight.empty() || is_figure) least = {leaving.least, leaving.t_least};
    if (!plan.leaves_contact) {
      for (const TightPair& one : leaving.tight) least = {std::max(0.0, std::min(least.least, one.gap)), one.t};
      leaving.tight.clear();
    }
  }
  double contacts = 0.0, beyond = 0.0;
  Text where_contact, where_beyond;
  for (const manipulation::PathFinding& finding : check->findings) {
    if (finding.kind == manipulation::PathFinding::Kind::kCollision) {
      if (isAllowed(finding, leaving)) continue;
      contacts += 1.0;
      where_contact = Text("%1 touches %2", finding.first, finding.second);
    }
    if (finding.kind == manipulation::PathFinding::Kind::kJointLimit && finding.worst > beyond) {
      beyond = finding.worst;
      where_beyond = Text("joint '%1'", finding.first);
    }
  }
  if (contacts > 0.0) least.least = 0.0;
  WrittenPlan result;
  Promises& promises = result.promises;
  // A millionth of a metre: distances of the file's numbers, written to the last bit, differ by far less.
  promises.list.push_back({"clearance", clearance, least.least, "m", timeText(least.t), true, 1e-6});
  promises.list.push_back({"contacts", 0.0, contacts, "", {}, false, 0.0, where_contact, Text("no contact on the way")});
  if (is_figure) {
    for (Promise& one : figurePromises(fine, columns, *entity)) promises.list.push_back(std::move(one));
  } else {
    const AxisLimits axes = axisLimits(*read);
    const bool is_axis = axes.beyond > beyond;
    promises.list.push_back({"limits", 0.0, is_axis ? axes.beyond : beyond, "rad",
                             is_axis ? axes.where_beyond : where_beyond, false, kBeyondLimit});
    if (has_axes) promises.list.push_back({"axis_speed", 1.0, axes.speed, "", axes.where_speed, false, kSpeedRounding});
  }
  const std::vector<Pose> X_WT = writtenPoses(fine, columns, read->entity, plan.hand);
  for (Promise& one : posePromises(fine, X_WT, plan)) promises.list.push_back(std::move(one));
  const char* const unit = columns.empty() ? "m" : "rad";
  promises.list.push_back(
      {"start", kEnds, differenceOf(read->all, 0, plan.waypoints.front(), columns), unit, {}, false, 0.0});
  promises.list.push_back(
      {"goal", kEnds, differenceOf(read->all, read->all.size() - 1, plan.waypoints.back(), columns), unit, {}, false, 0.0});
  promises.help = "Ask for a larger clearance, or for another seed.";
  promises.can_be_forced = false;
  addLeaving(leaving, promises);
  result.tight = std::move(leaving.tight);
  return result;
}

}  // namespace hapticell::planning
