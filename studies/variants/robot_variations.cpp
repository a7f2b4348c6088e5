// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numbers>
#include <vector>

#include "geometry/system/listed.h"
#include "studies/document/study_section.h"
#include "studies/variants/variation_kinds.h"

namespace hapticell::studies {

namespace {

using workcell::Entity;
using workcell::EntityId;

/// Reads `entity`, which has joints.
Expected<const Entity*> readJointed(SectionReader& reader, const StudySection& section, const StudyInputs& inputs) {
  std::string name;
  reader.fields().require("entity");
  reader.fields().read("entity", name);
  HAPTICELL_TRY(reader.check());
  const auto entity = inputs.entityNamed(section, name);
  HAPTICELL_TRY(entity);
  if (!(*entity)->robot())
    return makeError(section.fault(Text("entity '%1' without joints", name), Text("a robot or a mechanism")));
  return *entity;
}

/// One joint of a robot, a positioner or a mechanism.
class JointPosition : public Variation {
 public:
  JointPosition(std::string name, ValueRange range, EntityId entity, std::string joint, bool turns)
      : Variation(std::move(name), std::move(range)), entity_(entity), joint_(std::move(joint)), turns_(turns) {}

  std::string unit() const override { return turns_ ? "deg" : "m"; }
  Expected<void> apply(const Value& value, VariantCell& cell) const override {
    const Entity& entity = *cell.document.find(entity_);
    const int joint = entity.robot()->findJoint(joint_);
    if (joint < 0 || entity.robot()->joints[static_cast<std::size_t>(joint)].variable < 0)
      return makeError({.place = Text("entity '%1'", entity.name),
                        .found = Text("no moving joint is named '%1'", joint_),
                        .expected = "a joint of this robot"});
    std::vector<double> joints = entity.joints();
    const auto variable = static_cast<std::size_t>(entity.robot()->joints[static_cast<std::size_t>(joint)].variable);
    joints[variable] = std::get<double>(value) * (turns_ ? std::numbers::pi / 180.0 : 1.0);
    HAPTICELL_TRY(cell.document.execute(workcell::SetJoints{entity_, std::move(joints)}));
    return {};
  }

 private:
  EntityId entity_;
  std::string joint_;
  bool turns_;
};

/// One of a robot's named tools.
class ToolChoice : public Variation {
 public:
  ToolChoice(std::string name, ValueRange range, EntityId robot)
      : Variation(std::move(name), std::move(range)), robot_(robot) {}

  Expected<void> apply(const Value& value, VariantCell& cell) const override {
    HAPTICELL_TRY(cell.document.execute(workcell::ChooseTool{robot_, std::get<std::string>(value)}));
    return {};
  }

 private:
  EntityId robot_;
};

/// The tool centre point moved along an axis of the tool.
class ToolOffset : public Variation {
 public:
  ToolOffset(std::string name, ValueRange range, EntityId robot, int axis)
      : Variation(std::move(name), std::move(range)), robot_(robot), axis_(axis) {}

  std::string unit() const override { return "m"; }
  Expected<void> apply(const Value& value, VariantCell& cell) const override {
    const Entity& robot = *cell.document.find(robot_);
    dvec3 way_T(0.0);
    way_T[axis_] = std::get<double>(value);
    const Pose X_LT = robot.jointed().X_LT * Pose::translation(way_T);
    HAPTICELL_TRY(cell.document.execute(workcell::SetTool{robot_, robot.jointed().tip_link, X_LT}));
    return {};
  }

 private:
  EntityId robot_;
  int axis_;
};

/// A motion out of several files, for questions that name it.
class MotionChoice : public Variation {
 public:
  MotionChoice(std::string name, ValueRange range, std::filesystem::path folder)
      : Variation(std::move(name), std::move(range)), folder_(std::move(folder)) {}

  Expected<void> apply(const Value& value, VariantCell& cell) const override {
    const auto file = (folder_ / std::get<std::string>(value)).lexically_normal();
    cell.motions[name()] = cell.inputs().motions.at(file.string());
    return {};
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace

MadeVariation makeJointPosition(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  const auto entity = readJointed(reader, section, inputs);
  HAPTICELL_TRY(entity);
  std::string joint;
  reader.fields().require("joint");
  reader.fields().read("joint", joint);
  auto range = ValueRange::numbers(reader);
  HAPTICELL_TRY(range);
  HAPTICELL_TRY(reader.end());
  const kinematics::RobotModel& model = *(*entity)->robot();
  const int found = model.findJoint(joint);
  if (found < 0 || model.joints[static_cast<std::size_t>(found)].variable < 0) {
    const std::string known =
        listed(model.moving, [&](int one) { return model.joints[static_cast<std::size_t>(one)].name; });
    return makeError(section.fault(Text("no moving joint is named '%1'", joint), Text("one of %1", known)));
  }
  const bool turns = model.joints[static_cast<std::size_t>(found)].type != kinematics::JointType::kPrismatic;
  return std::make_unique<JointPosition>(section.name, std::move(*range), (*entity)->id, joint, turns);
}

MadeVariation makeToolChoice(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  const auto robot = readJointed(reader, section, inputs);
  HAPTICELL_TRY(robot);
  auto range = ValueRange::words(reader);
  HAPTICELL_TRY(range);
  HAPTICELL_TRY(reader.end());
  for (std::size_t i = 0; i < range->count(); ++i) {
    const std::string& tool = std::get<std::string>(range->at(i));
    const auto& tools = (*robot)->jointed().tools;
    if (std::any_of(tools.begin(), tools.end(), [&](const auto& one) { return one.name == tool; })) continue;
    const std::string known = listed(tools, [](const auto& one) { return one.name; });
    return makeError(section.fault(Text("no tool of '%1' is named '%2'", (*robot)->name, tool),
                                   tools.empty() ? Text("a robot with named tools") : Text("one of %1", known)));
  }
  return std::make_unique<ToolChoice>(section.name, std::move(*range), (*robot)->id);
}

MadeVariation makeToolOffset(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  const auto robot = readJointed(reader, section, inputs);
  HAPTICELL_TRY(robot);
  int axis = 2;
  reader.fields().readWord("axis", {"x", "y", "z"}, axis);
  auto range = ValueRange::numbers(reader);
  HAPTICELL_TRY(range);
  HAPTICELL_TRY(reader.end());
  return std::make_unique<ToolOffset>(section.name, std::move(*range), (*robot)->id, axis);
}

MadeVariation makeMotionChoice(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  auto range = ValueRange::words(reader);
  HAPTICELL_TRY(range);
  HAPTICELL_TRY(reader.end());
  for (std::size_t i = 0; i < range->count(); ++i) {
    const auto motion = inputs.motionOf(section.fileNamed(std::get<std::string>(range->at(i))));
    HAPTICELL_TRY(motion);
  }
  return std::make_unique<MotionChoice>(section.name, std::move(*range), section.folder());
}

}  // namespace hapticell::studies
