// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/system/listed.h"
#include "studies/document/study_section.h"
#include "studies/variants/placed_entities.h"
#include "studies/variants/variation_kinds.h"
#include "workcell/document/part_resize.h"
#include "workcell/entity/built_in_parts.h"
#include "workcell/import/entity_source.h"
#include "workcell/robots/robot_library.h"

namespace hapticell::studies {

namespace {

using workcell::Entity;
using workcell::EntityId;
using workcell::EntityKind;

/// Reads `entity` and demands its kind.
Expected<const Entity*> readEntityOfKind(SectionReader& reader, const StudySection& section, const StudyInputs& inputs,
                                         EntityKind kind, Text expected) {
  std::string name;
  reader.fields().require("entity");
  reader.fields().read("entity", name);
  HAPTICELL_TRY(reader.check());
  const auto entity = inputs.entityNamed(section, name);
  HAPTICELL_TRY(entity);
  if ((*entity)->kind() != kind)
    return makeError(section.fault(Text("entity '%1' of another kind", name), std::move(expected)));
  return *entity;
}

/// Puts what hangs on the robot where the robot's link is now: the same link, or the tip where the robot has none of
/// that name.
Expected<void> hangAgain(workcell::Document& document, EntityId robot) {
  const Entity now = *document.find(robot);
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*now.robot(), now.joints(), X_BL);
  for (const auto& entity : workcell::DocumentState(document.state()).entities) {
    if (entity->attachment.to != now.name) continue;
    int link = now.robot()->findLink(entity->attachment.link);
    if (link < 0) link = now.robot()->findLink(now.jointed().tip_link);
    if (link < 0) link = 0;
    const Pose X_WE = now.X_WE * X_BL[static_cast<std::size_t>(link)] * entity->attachment.X_LE;
    HAPTICELL_TRY(document.execute(workcell::Detach{entity->id}));
    HAPTICELL_TRY(place(document, entity->id, X_WE));
    HAPTICELL_TRY(document.execute(
        workcell::Attach{entity->id, robot, now.robot()->links[static_cast<std::size_t>(link)].name}));
  }
  return {};
}

/// Rules about the base of the robot before hold for the base of the one that stands there now.
Expected<void> renameBaseRules(workcell::Document& document, const std::string& robot, const std::string& before,
                               const std::string& now) {
  if (before == now) return {};
  std::vector<workcell::PairRule> rules;
  for (workcell::PairRule rule : document.state().pair_rules) {
    const bool first = rule.first == robot && rule.first_part == before;
    const bool second = rule.second == robot && rule.second_part == before;
    if (!first && !second) continue;
    (first ? rule.first_part : rule.second_part) = now;
    rules.push_back(std::move(rule));
  }
  if (rules.empty()) return {};
  HAPTICELL_TRY(document.execute(workcell::SetPairRules{std::move(rules)}));
  return {};
}

class RobotChoice : public Variation {
 public:
  RobotChoice(std::string name, ValueRange range, EntityId robot)
      : Variation(std::move(name), std::move(range)), robot_(robot) {}

  bool changesShape() const override { return true; }
  Expected<void> apply(const Value& value, VariantCell& cell) const override {
    const Entity before = *cell.document.find(robot_);
    const Entity& fresh = cell.inputs().shapes.at(std::get<std::string>(value));
    if (before.source.path == fresh.source.path) return {};
    HAPTICELL_TRY(cell.document.execute(workcell::ReplaceShape{robot_, fresh}));
    const Entity* changed = cell.document.find(robot_);
    HAPTICELL_TRY(renameBaseRules(cell.document, before.name, before.robot()->links[0].name,
                                  changed->robot()->links[0].name));
    return hangAgain(cell.document, robot_);
  }

 private:
  EntityId robot_;
};

/// Another body at the same place: its feet where the one of the cell stands.
class BodyChoice : public Variation {
 public:
  BodyChoice(std::string name, ValueRange range, EntityId body)
      : Variation(std::move(name), std::move(range)), body_(body) {}

  bool changesShape() const override { return true; }
  Expected<void> apply(const Value& value, VariantCell& cell) const override {
    return replaceBody(cell.document, body_, cell.inputs().shapes.at("mannequin:" + std::get<std::string>(value)));
  }

 private:
  EntityId body_;
};

/// A size of a built-in part.
class PartSizeChoice : public Variation {
 public:
  PartSizeChoice(std::string name, ValueRange range, EntityId part, std::size_t size)
      : Variation(std::move(name), std::move(range)), part_(part), size_(size) {}

  std::string unit() const override { return "m"; }
  bool changesShape() const override { return true; }
  Expected<void> apply(const Value& value, VariantCell& cell) const override {
    std::vector<double> sizes = workcell::partSizes(cell.document.find(part_)->source);
    sizes[size_] = std::get<double>(value);
    const auto commands = workcell::resizePart(cell.document.state(), part_, sizes);
    HAPTICELL_TRY(commands);
    for (const workcell::Command& command : *commands) {
      HAPTICELL_TRY(cell.document.execute(command));
    }
    return {};
  }

 private:
  EntityId part_;
  std::size_t size_;
};

/// The names of the library's robots that are arms: a chain with a tool centre point.
Expected<std::vector<std::string>> libraryWords(StudyInputs& inputs) {
  Diagnostics diagnostics;
  std::vector<std::string> words;
  for (const workcell::LibraryRobot& robot : workcell::listLibraryRobots(diagnostics))
    words.push_back("library:" + robot.name);
  inputs.notes.insert(inputs.notes.end(), diagnostics.warnings.begin(), diagnostics.warnings.end());
  return words;
}

}  // namespace

MadeVariation makeRobotChoice(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  const auto robot =
      readEntityOfKind(reader, section, inputs, EntityKind::kRobot, Text("a robot"));
  HAPTICELL_TRY(robot);
  bool library = false;
  reader.fields().read("library", library);
  if (library && reader.fields().has("values"))
    reader.fields().failKey("library", Text("both library and values"), Text("one of them"));
  HAPTICELL_TRY(reader.check());
  ValueRange range;
  if (library) {
    auto words = libraryWords(inputs);
    HAPTICELL_TRY(words);
    range = ValueRange::ofWords(std::move(*words));
  } else {
    auto words = ValueRange::words(reader);
    HAPTICELL_TRY(words);
    range = std::move(*words);
  }
  HAPTICELL_TRY(reader.end());
  for (std::size_t i = 0; i < range.count(); ++i) {
    const auto shape = inputs.shapeOf(std::get<std::string>(range.at(i)));
    HAPTICELL_TRY(shape);
    if ((*shape)->kind() != EntityKind::kRobot)
      return makeError(section.fault(Text("'%1', which is no robot", textOf(range.at(i))), Text("robots")));
  }
  return std::make_unique<RobotChoice>(section.name, std::move(range), (*robot)->id);
}

MadeVariation makeBodyChoice(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  const auto body = readEntityOfKind(reader, section, inputs, EntityKind::kMannequin, Text("a mannequin"));
  HAPTICELL_TRY(body);
  auto range = ValueRange::words(reader);
  HAPTICELL_TRY(range);
  HAPTICELL_TRY(reader.end());
  for (std::size_t i = 0; i < range->count(); ++i) {
    const auto shape = inputs.shapeOf("mannequin:" + std::get<std::string>(range->at(i)));
    if (!shape)
      return makeError(section.fault(shape.error().text(), Text("bodies such as \"female:5\" or \"male:1750mm\"")));
  }
  return std::make_unique<BodyChoice>(section.name, std::move(*range), (*body)->id);
}

MadeVariation makePartSize(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  const auto part = readEntityOfKind(reader, section, inputs, EntityKind::kSolid, Text("a built-in part"));
  HAPTICELL_TRY(part);
  const std::string& source = (*part)->source.path;
  const workcell::BuiltInPart* known = workcell::findBuiltInPart(source.substr(0, source.find(':')));
  if (known == nullptr)
    return makeError(section.fault(Text("'%1' is not a built-in part", (*part)->name),
                                   Text("a built-in part, such as a box, a table or a bench")));
  std::vector<std::string> names;
  for (const workcell::PartSize& size : known->sizes) names.emplace_back(size.name);
  int size = 0;
  reader.fields().require("size");
  reader.fields().readWord("size", names, size);
  auto range = ValueRange::numbers(reader);
  HAPTICELL_TRY(range);
  HAPTICELL_TRY(reader.end());
  return std::make_unique<PartSizeChoice>(section.name, std::move(*range), (*part)->id,
                                          static_cast<std::size_t>(size));
}

}  // namespace hapticell::studies
