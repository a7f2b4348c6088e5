// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "manipulation/checks/motion_replay.h"
#include "manipulation/checks/path_check.h"
#include "studies/document/study_section.h"
#include "studies/questions/cycle_route.h"
#include "studies/questions/question_kinds.h"
#include "studies/questions/robot_targets.h"
#include "trajectory/timing/retiming.h"

namespace hapticell::studies {

namespace {

using manipulation::PathFinding;
using trajectory::Trajectory;
using workcell::Entity;

/// s in which a joint reaches its greatest speed where nobody says so; kTimeToSpeed of cli/trajectory. Half: cycles up
/// to a third shorter; twice: sluggish.
constexpr double kTimeToSpeed = 0.25;
constexpr double kLongestDwell = 3600.0;  ///< s; half and twice: only what is refused as a slip.

std::int64_t countOf(const std::vector<PathFinding>& findings, std::initializer_list<PathFinding::Kind> kinds) {
  return std::count_if(findings.begin(), findings.end(), [&](const PathFinding& one) {
    return std::find(kinds.begin(), kinds.end(), one.kind) != kinds.end();
  });
}

/// The least time through all targets, resting at each, by the best choice of configurations.
class CycleTime : public Question {
 public:
  struct Settings {
    double dwell = 0.0;  ///< s at each target.
    double time_to_speed = kTimeToSpeed;
    bool returns = true;
    bool check_motions = false;
  };
  CycleTime(std::string name, TargetList list, Settings settings)
      : Question(std::move(name)), list_(std::move(list)), settings_(settings) {}

  std::vector<Column> columns() const override {
    std::vector<Column> columns{{"time", Column::Kind::kNumber, "s"}, {"changes", Column::Kind::kWhole, ""}};
    if (settings_.check_motions) columns.push_back({"collisions", Column::Kind::kWhole, ""});
    return columns;
  }

  Expected<std::vector<Answer>> answer(VariantCell& cell) const override {
    const auto solved = solvedTargets(cell, list_);
    HAPTICELL_TRY(solved);
    const Entity& robot = *cell.document.find((*solved)->robot);
    const JointRates rates = jointRates(*robot.robot(), settings_.time_to_speed);
    const CycleRoute route = fastestRoute(rates, robot.joints(), (*solved)->targets, settings_.returns);
    if (route.stops.empty()) return std::vector<Answer>(columns().size());
    const double time = route.time_s + settings_.dwell * static_cast<double>(route.stops.size());
    std::vector<Answer> answers{time, static_cast<std::int64_t>(route.changes)};
    if (settings_.check_motions) {
      const auto check = manipulation::checkPath(cell.scene(), robot.name, motionOf(robot, rates, route), {},
                                                 cell.inputs().configuration);
      HAPTICELL_TRY(check);
      answers.emplace_back(countOf(check->findings, {PathFinding::Kind::kCollision}));
    }
    return answers;
  }

 private:
  /// The straight joint motions of the route, a frame a stop.
  Trajectory motionOf(const Entity& robot, const JointRates& rates, const CycleRoute& route) const {
    Trajectory motion;
    motion.entity = robot.name;
    motion.moved = "tcp";
    motion.has_poses = false;
    for (const int joint : robot.robot()->moving)
      motion.joint_names.push_back(robot.robot()->joints[static_cast<std::size_t>(joint)].name);
    double t = 0.0;
    std::vector<double> last = robot.joints();
    motion.addFrame({t, {}}, last);
    const auto go = [&](const std::vector<double>& to) {
      const double time = straightTime(rates, last, to);
      if (time <= 0.0) return;
      motion.addFrame({t += time, {}}, to);
      last = to;
    };
    for (const auto* stop : route.stops) go(stop->joints);
    if (settings_.returns) go(robot.joints());
    return motion;
  }

  TargetList list_;
  Settings settings_;
};

/// A given motion of an entity through the cell: collisions, limits, clearance and its least time.
class MotionQuestion : public Question {
 public:
  MotionQuestion(std::string name, std::string entity, std::string motion, std::filesystem::path file,
                 double time_to_speed)
      : Question(std::move(name)),
        entity_(std::move(entity)),
        motion_(std::move(motion)),
        file_(std::move(file)),
        time_to_speed_(time_to_speed) {}

  std::vector<Column> columns() const override {
    return {{"collisions", Column::Kind::kWhole, ""},    {"limits", Column::Kind::kWhole, ""},
            {"singularities", Column::Kind::kWhole, ""}, {"clearance", Column::Kind::kNumber, "m"},
            {"duration", Column::Kind::kNumber, "s"},    {"least_time", Column::Kind::kNumber, "s"}};
  }

  Expected<std::vector<Answer>> answer(VariantCell& cell) const override {
    const auto motion = motionIn(cell);
    HAPTICELL_TRY(motion);
    manipulation::PathCheckOptions options;
    if (!(*motion)->moved.empty()) {
      auto moved_by = manipulation::parseMovedBy((*motion)->moved);
      HAPTICELL_TRY(moved_by);
      options.hold.moved_by = std::move(*moved_by);
    }
    const auto check =
        manipulation::checkPath(cell.scene(), entity_, **motion, options, cell.inputs().configuration);
    HAPTICELL_TRY(check);
    std::vector<Answer> answers{
        countOf(check->findings, {PathFinding::Kind::kCollision}),
        countOf(check->findings,
                {PathFinding::Kind::kJointLimit, PathFinding::Kind::kJointSpeed, PathFinding::Kind::kOffPose}),
        countOf(check->findings, {PathFinding::Kind::kSingularity}),
        Answer(),
        (*motion)->duration(),
        leastTime(cell, *motion)};
    if (std::isfinite(check->least_clearance)) answers[3] = check->least_clearance;
    return answers;
  }

 private:
  Expected<std::shared_ptr<const Trajectory>> motionIn(const VariantCell& cell) const {
    const auto chosen = cell.motions.find(motion_);
    if (chosen != cell.motions.end()) return chosen->second;
    return cell.inputs().motions.at(file_.string());
  }

  /// Empty where the motion cannot be timed (a solid, frames that do not move).
  Answer leastTime(const VariantCell& cell, const std::shared_ptr<const Trajectory>& motion) const {
    const Entity& entity = *cell.document.findByName(entity_);
    if (!entity.robot()) return {};
    const auto replay = manipulation::MotionReplay::create(cell.document.state().entities, entity_, motion);
    if (!replay) return {};
    const Trajectory joints = replay->withJoints();
    const JointRates rates = jointRates(*entity.robot(), time_to_speed_);
    trajectory::RetimingOptions options;
    for (const std::string& name : joints.joint_names) {
      const int joint = entity.robot()->findJoint(name);
      if (joint < 0 || entity.robot()->joints[static_cast<std::size_t>(joint)].variable < 0) return {};
      const auto variable = static_cast<std::size_t>(entity.robot()->joints[static_cast<std::size_t>(joint)].variable);
      options.limits.velocity.push_back(rates.speed[variable]);
      options.limits.acceleration.push_back(rates.acceleration[variable]);
    }
    const auto timed = trajectory::retimed(joints, options);
    return timed ? Answer(timed->report.duration_after) : Answer();
  }

  std::string entity_, motion_;
  std::filesystem::path file_;
  double time_to_speed_;
};

void readTimeToSpeed(SectionReader& reader, double& seconds) {
  reader.fields().read("time_to_speed", seconds, 1.0, 0.001, 100.0);
}

}  // namespace

MadeQuestion makeCycleTime(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  auto list = readTargetList(reader, section, inputs);
  HAPTICELL_TRY(list);
  CycleTime::Settings settings;
  reader.fields().read("dwell", settings.dwell, 1.0, 0.0, kLongestDwell);
  readTimeToSpeed(reader, settings.time_to_speed);
  reader.fields().read("returns", settings.returns);
  reader.fields().read("check_motions", settings.check_motions);
  HAPTICELL_TRY(reader.end());
  return std::make_unique<CycleTime>(section.name, std::move(*list), settings);
}

MadeQuestion makeMotion(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  std::string entity, motion;
  double time_to_speed = kTimeToSpeed;
  reader.fields().require("entity");
  reader.fields().read("entity", entity);
  reader.fields().require("motion");
  reader.fields().read("motion", motion);
  readTimeToSpeed(reader, time_to_speed);
  HAPTICELL_TRY(reader.end());
  HAPTICELL_TRY(inputs.entityNamed(section, entity));
  // The name of a variation, of a trajectory of the cell, or a file, in this order.
  const auto& variations = inputs.document.variations;
  const bool varies = std::any_of(variations.begin(), variations.end(), [&](const StudySection& one) {
    return one.kind == "motion" && one.name == motion;
  });
  const workcell::TrajectoryReference* own = inputs.cell.state().findTrajectory(motion);
  const std::filesystem::path file = own != nullptr ? std::filesystem::path(own->path) : section.fileNamed(motion);
  if (!varies) {
    HAPTICELL_TRY(inputs.motionOf(file));
  }
  return std::make_unique<MotionQuestion>(section.name, entity, motion, file, time_to_speed);
}

}  // namespace hapticell::studies
