// SPDX-License-Identifier: Apache-2.0
#include "studies/questions/robot_targets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/document/study_section.h"
#include "studies/variants/value_range.h"
#include "trajectory/files/pose_csv.h"

namespace hapticell::studies {

namespace {

/// Of one target: as many as the finest spin that matters (15 deg). Half: coarser; twice: twice the time.
constexpr double kMostTurns = 24;
/// m; a robot that keeps more passes nothing. Half and twice: only what is refused as a slip.
constexpr double kMostClearance = 1.0;

/// Adds what another turn of the tool gives.
void join(manipulation::FreeAnswer more, manipulation::FreeAnswer& answer) {
  answer.checked += more.checked;
  // kSolved is the least of the states, kUnreachable the greatest.
  answer.status = std::min(answer.status, more.status);
  std::move(more.free.begin(), more.free.end(), std::back_inserter(answer.free));
}

}  // namespace

std::string TargetList::key() const {
  return "targets|" + robot + "|" + file.string() + "|" + frame + "|" + std::to_string(turns) + "|" +
         textOf(clearance);
}

Expected<TargetList> readTargetList(SectionReader& reader, const StudySection& section, StudyInputs& inputs) {
  TargetList list;
  std::string targets;
  double turns = 1.0;
  reader.fields().require("entity");
  reader.fields().read("entity", list.robot);
  reader.fields().require("targets");
  reader.fields().read("targets", targets);
  reader.fields().read("frame", list.frame);
  reader.fields().read("turns", turns, 1.0, 1.0, kMostTurns);
  reader.fields().read("clearance", list.clearance, 1.0, 0.0, kMostClearance);
  if (std::floor(turns) != turns) reader.fields().failKey("turns", Text("turns is not a whole number"), Text("a whole number"));
  HAPTICELL_TRY(reader.check());
  list.turns = static_cast<int>(turns);
  const auto robot = inputs.entityNamed(section, list.robot);
  HAPTICELL_TRY(robot);
  if (!(*robot)->robot())
    return makeError(section.fault(Text("entity '%1' without joints", list.robot), Text("a robot or a mechanism")));
  if (!list.frame.empty() && inputs.cell.findByName(list.frame) == nullptr) {
    const auto missing = inputs.entityNamed(section, list.frame);
    HAPTICELL_TRY(missing);
  }
  list.file = section.fileNamed(targets);
  auto poses = trajectory::readPoseCsv(list.file);
  HAPTICELL_TRY(poses);
  if (poses->empty())
    return makeError({.file = list.file.string(), .found = "a header without rows", .expected = "at least one pose"});
  list.X_FT = std::move(*poses);
  if (std::find(inputs.files.begin(), inputs.files.end(), list.file) == inputs.files.end())
    inputs.files.push_back(list.file);
  return list;
}

bool RobotTargets::allReached() const {
  return reached() == targets.size();
}

std::size_t RobotTargets::reached() const {
  return static_cast<std::size_t>(std::count_if(targets.begin(), targets.end(), [](const auto& t) { return t.isFree(); }));
}

Expected<std::shared_ptr<RobotTargets>> solvedTargets(VariantCell& cell, const TargetList& list) {
  std::any& kept = cell.kept(list.key());
  if (kept.has_value()) return std::any_cast<std::shared_ptr<RobotTargets>>(kept);
  const workcell::Entity& robot = *cell.document.findByName(list.robot);
  const auto inverse = manipulation::inverseToTool(robot);
  HAPTICELL_TRY(inverse);
  auto check = manipulation::JointCheck::create(cell.scene(), robot.id, cell.inputs().configuration);
  HAPTICELL_TRY(check);
  const int tip = robot.jointed().tip_link.empty() ? robot.robot()->defaultTip() : robot.robot()->findLink(robot.jointed().tip_link);
  auto solved = std::make_shared<RobotTargets>(RobotTargets{robot.id, tip, std::move(*check), {}});
  const Pose X_BF = robot.X_WE.inverse() * (list.frame.empty() ? Pose() : cell.document.findByName(list.frame)->X_WE);
  for (const Pose& X_FT : list.X_FT) {
    manipulation::FreeAnswer answer;
    for (int turn = 0; turn < list.turns; ++turn) {
      const double angle = 2.0 * std::numbers::pi * turn / list.turns;
      const Pose X_BT = X_BF * X_FT * Pose::rotation(glm::angleAxis(angle, dvec3(0.0, 0.0, 1.0)));
      join(manipulation::freeSolutions(**inverse, solved->check, X_BT, robot.joints(), list.clearance), answer);
    }
    solved->targets.push_back(std::move(answer));
  }
  kept = solved;
  return solved;
}

}  // namespace hapticell::studies
