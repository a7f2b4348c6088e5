// SPDX-License-Identifier: Apache-2.0
#include "studies/runner/study.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/system/listed.h"
#include "geometry/system/text_case.h"
#include "manipulation/scene/rest_pairs.h"
#include "manipulation/scene/scene_service.h"
#include "studies/document/study_section.h"
#include "workcell/files/content_name.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"

namespace hapticell::studies {

namespace fs = std::filesystem;

namespace {

/// Missing answers count as a requirement that is missed by this much. Half and twice: any such variant is infeasible.
constexpr double kUnanswered = 1.0;
/// Columns of every row; see ResultStore.
constexpr const char* kReserved[] = {"number", "feasible", "violation", "objective", "note", "seed", "version"};

bool isFinite(const Answer& answer) {
  const auto* number = std::get_if<double>(&answer);
  return number == nullptr || std::isfinite(*number);
}

/// Number of an answer; empty for texts and where there is none.
std::optional<double> numberOf(const Answer& answer) {
  if (const auto* number = std::get_if<double>(&answer)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&answer)) return static_cast<double>(*whole);
  return std::nullopt;
}

void addNote(const std::string& text, std::string& note) {
  if (!note.empty()) note += "; ";
  note += text;
}

}  // namespace

Expected<std::unique_ptr<const Study>> Study::load(const fs::path& file, std::string version) {
  std::unique_ptr<Study> study(new Study());
  auto document = StudyDocument::read(file);
  HAPTICELL_TRY(document);
  study->inputs_.document = std::move(*document);
  HAPTICELL_TRY(study->readCell());
  manipulation::SceneService scenes;
  HAPTICELL_TRY(study->prepare(std::move(version), scenes));
  return study;
}

Expected<std::unique_ptr<const Study>> Study::load(std::string text, const fs::path& file, std::string version) {
  std::unique_ptr<Study> study(new Study());
  auto document = StudyDocument::parse(std::move(text), file);
  HAPTICELL_TRY(document);
  study->inputs_.document = std::move(*document);
  HAPTICELL_TRY(study->readCell());
  manipulation::SceneService scenes;
  HAPTICELL_TRY(study->prepare(std::move(version), scenes));
  return study;
}

Expected<std::unique_ptr<const Study>> Study::load(std::string text, const fs::path& file, CellInMemory cell,
                                                   std::string version) {
  std::unique_ptr<Study> study(new Study());
  auto document = StudyDocument::parse(std::move(text), file);
  HAPTICELL_TRY(document);
  study->inputs_.document = std::move(*document);
  study->cell_text_ = workcell::documentText(cell.document.state(), study->inputs_.document.cell.parent_path());
  study->inputs_.cell = std::move(cell.document);
  manipulation::SceneService own;
  HAPTICELL_TRY(study->prepare(std::move(version), cell.scenes != nullptr ? *cell.scenes : own));
  return study;
}

Expected<void> Study::readCell() {
  Diagnostics diagnostics;
  auto cell = workcell::loadDocument(inputs_.document.cell, diagnostics);
  HAPTICELL_TRY(cell);
  inputs_.cell = std::move(*cell);
  inputs_.notes = std::move(diagnostics.warnings);
  inputs_.files.push_back(inputs_.document.cell);
  return {};
}

Expected<void> Study::prepare(std::string version, manipulation::SceneService& scenes) {
  HAPTICELL_TRY(makeParts());
  auto space = VariantSpace::create(inputs_.document, variations_);
  HAPTICELL_TRY(space);
  space_ = std::move(*space);
  HAPTICELL_TRY(makeHead(std::move(version)));
  HAPTICELL_TRY(checkNames());
  return prepareScene(scenes);
}

Expected<void> Study::makeParts() {
  for (const StudySection& section : inputs_.document.variations) {
    auto variation = makeVariation(section, inputs_);
    HAPTICELL_TRY(variation);
    variations_.push_back(std::move(*variation));
  }
  for (const StudySection& section : inputs_.document.questions) {
    auto question = makeQuestion(section, inputs_);
    HAPTICELL_TRY(question);
    questions_.push_back(std::move(*question));
  }
  return {};
}

/// All meshes of the cell and of what may stand in it; then what touches in the given cell is left out from all checks.
Expected<void> Study::prepareScene(manipulation::SceneService& scenes) {
  const workcell::PairDefaults defaults = manipulation::pairDefaults(inputs_.configuration);
  manipulation::SceneSource source = manipulation::sourceOf(inputs_.cell, defaults);
  const std::size_t own = source.entities.size();
  workcell::EntityId id = 0;
  for (const workcell::Entity& entity : source.entities) id = std::max(id, entity.id);
  for (const auto& shape : inputs_.shapes) {
    workcell::Entity entity = shape.second;
    entity.id = ++id;
    entity.name = "study " + shape.first;
    entity.checked = false;
    if (entity.joints().empty()) entity.setJoints(kinematics::restPositions(*entity.robot()));
    source.entities.push_back(std::move(entity));
  }
  source.revision = 0;
  inputs_.scene = scenes.prepare(std::move(source));
  manipulation::SceneSource as_given = manipulation::sourceOf(inputs_.cell, defaults);
  as_given.revision = 0;  // Of this study's own document: the service may know another one of that number.
  const auto given = scenes.prepare(std::move(as_given));
  if (own == 0 || !inputs_.scene || !given)
    return makeError({.file = inputs_.document.cell.string(), .found = "an empty cell", .expected = "a cell with parts"});
  auto rules = manipulation::touchingAtRest(*given);
  const auto words = [](const workcell::PairRule& rule) { return "'" + rule.first + "' with '" + rule.second + "'"; };
  const auto deep = manipulation::takeDeepOverlaps(*given, rules);
  if (!deep.empty()) {
    const std::string pairs = listed(deep, [](const auto& one) {
      const auto side = [](const std::string& entity, const std::string& part) {
        return "'" + entity + (part.empty() ? "'" : "/" + part + "'");
      };
      return side(one.rule.first, one.rule.first_part) + " with " + side(one.rule.second, one.rule.second_part);
    });
    inputs_.notes.push_back(
        Text("Pairs that overlap in the given cell, by up to %1, are checked: %2. If the overlap is intended, exclude "
             "them in the cell.",
             Text::Length{deep.front().depth}, pairs));
  }
  if (rules.empty()) return {};
  const std::string pairs = listed(rules, words);
  inputs_.notes.push_back(Text("Pairs that touch in the given cell are not checked: %1", pairs));
  HAPTICELL_TRY(inputs_.cell.execute(workcell::SetPairRules{std::move(rules)}));
  return {};
}

Expected<void> Study::makeHead(std::string version) {
  const StudyDocument& document = inputs_.document;
  head_.name = document.name;
  head_.study = document.text;
  head_.file = document.file.string();
  head_.version = std::move(version);
  head_.seed = document.seed;
  head_.variants = static_cast<std::int64_t>(space_.count());
  head_.units = static_cast<std::int64_t>(space_.units());
  head_.per_unit = static_cast<std::int64_t>(space_.variantsPerUnit());
  for (const auto& variation : variations_) {
    const bool words = variation->range().isWords();
    head_.values.push_back(
        {variation->name(), words ? Column::Kind::kText : Column::Kind::kNumber, words ? "" : variation->unit()});
  }
  for (const auto& question : questions_) {
    for (Column column : question->columns()) {
      column.name = question->name() + "." + column.name;
      head_.answers.push_back(std::move(column));
    }
  }
  // By content, not by place: the same files on another machine are the same study.
  std::string contents = workcell::contentName(document.text);
  if (!cell_text_.empty()) contents += workcell::contentName(cell_text_);
  for (const auto& entity : inputs_.cell.state().entities) {
    const std::string& source = entity->source.path;
    if (!source.empty() && !workcell::isBuiltIn(source)) inputs_.files.emplace_back(source);
  }
  for (const fs::path& file : inputs_.files) contents += workcell::contentNameOf(file);
  head_.digest = workcell::contentName(contents);
  return {};
}

Expected<void> Study::checkNames() const {
  std::set<std::string> names;
  for (const char* reserved : kReserved) names.insert(reserved);
  for (const Column& column : head_.values) {
    if (names.insert(lowerCase(column.name)).second) continue;
    return makeError({.file = inputs_.document.file.string(),
                      .place = Text("vary '%1'", column.name),
                      .found = "a name that is taken",
                      .expected = Text("another name than %1", listed(kReserved))});
  }
  const auto check = [&](const std::string& value) -> Expected<void> {
    if (answerNamed(value) < head_.answers.size()) return {};
    return makeError({.file = inputs_.document.file.string(),
                      .found = Text("no result is called '%1'", value),
                      .expected = Text("one of %1", listed(head_.answers, &Column::name))});
  };
  for (const Requirement& one : inputs_.document.requirements) {
    HAPTICELL_TRY(check(one.value));
  }
  for (const Objective& one : inputs_.document.objectives) {
    HAPTICELL_TRY(check(one.value));
  }
  return {};
}

std::size_t Study::answerNamed(const std::string& name) const {
  const auto found =
      std::find_if(head_.answers.begin(), head_.answers.end(), [&](const Column& one) { return one.name == name; });
  return static_cast<std::size_t>(found - head_.answers.begin());
}

Expected<void> Study::change(const std::vector<Value>& values, VariantCell& cell) const {
  // What stands in the cell before what moves it: another robot or another size is put where the cell has the old one.
  for (const bool shapes : {true, false}) {
    for (std::size_t i = 0; i < variations_.size(); ++i) {
      if (variations_[i]->changesShape() != shapes) continue;
      const auto done = variations_[i]->apply(values[i], cell);
      if (!done) {
        Error error = done.error();
        if (error.file.empty()) error.file = variations_[i]->name() + " = " + textOf(values[i]);
        return makeError(std::move(error));
      }
    }
  }
  return {};
}

ResultRow Study::evaluate(std::int64_t number, const std::vector<Value>& values) const {
  ResultRow row;
  row.number = number;
  row.values = values;
  VariantCell cell(inputs_);
  const auto changed = change(values, cell);
  if (!changed) addNote(changed.error().message(), row.note);
  for (const auto& question : questions_) {
    const std::size_t count = question->columns().size();
    std::vector<Answer> answers(count);
    if (changed) {
      auto answered = question->answer(cell);
      if (answered) {
        answers = std::move(*answered);
      } else {
        addNote(question->name() + ": " + answered.error().message(), row.note);
      }
    }
    for (Answer& answer : answers) row.answers.push_back(isFinite(answer) ? std::move(answer) : Answer());
  }
  judge(row);
  return row;
}

void Study::judge(ResultRow& row) const {
  for (const Requirement& one : inputs_.document.requirements) {
    const auto value = numberOf(row.answers[answerNamed(one.value)]);
    if (!value) {
      row.violation += kUnanswered;
      continue;
    }
    if (one.at_least) row.violation += std::max(0.0, *one.at_least - *value);
    if (one.at_most) row.violation += std::max(0.0, *value - *one.at_most);
  }
  row.feasible = row.violation == 0.0;
  double sum = 0.0;
  bool complete = !inputs_.document.objectives.empty();
  for (const Objective& one : inputs_.document.objectives) {
    const auto value = numberOf(row.answers[answerNamed(one.value)]);
    complete = complete && value.has_value();
    if (value) sum += one.weight * (one.is_greatest ? -*value : *value);
  }
  if (complete) row.objective = sum;
}

std::vector<ResultRow> Study::runUnit(std::size_t unit, const std::atomic<bool>& cancelled) const {
  if (space_.isSearch()) return search(unit, cancelled);
  std::vector<ResultRow> rows;
  rows.push_back(evaluate(static_cast<std::int64_t>(unit), space_.values(unit)));
  return rows;
}

Expected<workcell::Document> Study::cellOf(const std::vector<Value>& values) const {
  VariantCell cell(inputs_);
  HAPTICELL_TRY(change(values, cell));
  return std::move(cell.document);
}

}  // namespace hapticell::studies
