// SPDX-License-Identifier: Apache-2.0
#include "studies/questions/robot_targets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "studies/document/study_section.h"
#include "studies/variants/value_range.h"
#include "trajectory/files/pose_csv.h"

namespace hapticell::studies {

namespace {

/// Of one target: as many as the finest spin that matters (15 deg). Half: coarser; twice: twice the time.
constexpr double kMostTurns = 24;
/// m; a robot that keeps more passes nothing. Half and twice: only what is refused as a slip.
constexpr double kMostClearance = 1.0;

/// Where a frame of that name is: a frame of the cell, an entity, or "ENTITY/FRAME".
std::optional<Pose> frameNamed(const workcell::DocumentState& state, const std::string& name) {
  if (const workcell::Entity* entity = state.findByName(name)) return entity->X_WE;
  const std::size_t cut = name.rfind('/');
  const workcell::Entity* owner = cut != std::string::npos ? state.findByName(name.substr(0, cut)) : nullptr;
  if (owner == nullptr) return std::nullopt;
  for (const workcell::Frame& frame : owner->frames) {
    if (frame.name == name.substr(cut + 1)) return owner->X_WE * frame.X_EF;
  }
  return std::nullopt;
}

/// The targets of a list in the cell of a variant.
Expected<std::vector<Pose>> targetsIn(const workcell::DocumentState& state, const TargetList& list) {
  std::vector<Pose> X_WT;
  for (const std::string& one : list.frames) {
    const auto X_WF = frameNamed(state, one);
    if (!X_WF) return makeError({.found = Text("no frame is called '%1' in this variant", one)});
    X_WT.push_back(*X_WF);
  }
  const Pose X_WF = list.frame.empty() ? Pose() : state.findByName(list.frame)->X_WE;
  for (const Pose& X_FT : list.X_FT) X_WT.push_back(X_WF * X_FT);
  return X_WT;
}

/// Adds what another turn of the tool gives.
void join(manipulation::FreeAnswer more, manipulation::FreeAnswer& answer) {
  answer.checked += more.checked;
  // kSolved is the least of the states, kUnreachable the greatest.
  answer.status = std::min(answer.status, more.status);
  std::move(more.free.begin(), more.free.end(), std::back_inserter(answer.free));
}

}  // namespace

std::string TargetList::key() const {
  std::string named;
  for (const std::string& one : frames) named += one + "\n";
  return "targets|" + robot + "|" + file.string() + "|" + named + "|" + frame + "|" + std::to_string(turns) + "|" +
         textOf(clearance);
}

Expected<TargetList> readTargetList(SectionReader& reader, const StudySection& section, StudyInputs& inputs) {
  TargetList list;
  std::string targets;
  double turns = 1.0;
  reader.fields().require("entity");
  reader.fields().read("entity", list.robot);
  reader.fields().read("targets", targets);
  reader.fields().readList("frames", list.frames);
  reader.fields().read("frame", list.frame);
  reader.fields().read("turns", turns, 1.0, 1.0, kMostTurns);
  reader.fields().read("clearance", list.clearance, 1.0, 0.0, kMostClearance);
  if (std::floor(turns) != turns) reader.fields().failKey("turns", Text("turns is not a whole number"), Text("a whole number"));
  HAPTICELL_TRY(reader.check());
  if (targets.empty() == list.frames.empty())
    reader.fields().fail(nullptr, Text("no single list of targets"),
                         Text("either targets = \"poses.csv\" or frames = [...]"));
  if (!list.frames.empty() && !list.frame.empty())
    reader.fields().failKey("frame", Text("frame with frames, which have their own places"), Text("one of them"));
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
  for (const std::string& one : list.frames) {
    if (frameNamed(inputs.cell.state(), one)) continue;
    return makeError(section.fault(Text("no frame is called '%1'", one),
                                   Text("a frame of the cell, an entity, or ENTITY/FRAME for a frame of an entity")));
  }
  if (!list.frames.empty()) return list;
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
  const Pose X_BW = robot.X_WE.inverse();
  const auto targets = targetsIn(cell.document.state(), list);
  HAPTICELL_TRY(targets);
  for (const Pose& X_WT : *targets) {
    manipulation::FreeAnswer answer;
    for (int turn = 0; turn < list.turns; ++turn) {
      const double angle = 2.0 * std::numbers::pi * turn / list.turns;
      const Pose X_BT = X_BW * X_WT * Pose::rotation(glm::angleAxis(angle, dvec3(0.0, 0.0, 1.0)));
      join(manipulation::freeSolutions(**inverse, solved->check, X_BT, robot.joints(), list.clearance), answer);
    }
    solved->targets.push_back(std::move(answer));
  }
  kept = solved;
  return solved;
}

}  // namespace hapticell::studies
