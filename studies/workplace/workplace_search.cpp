// SPDX-License-Identifier: Apache-2.0
#include "studies/workplace/workplace_search.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/posture/posture_file.h"
#include "mannequin/shape/figure_model.h"
#include "studies/runner/study_run.h"
#include "studies/workplace/workplace_text.h"

namespace hapticell::studies {
namespace {

using workcell::Entity;
using workcell::EntityId;

/// Placements of one search, each with up to four bodies: it bounds the time. Half: some grids must be coarser; twice:
/// up to twice as long without an answer.
constexpr std::size_t kMostCells = 10000;
/// What the cell is called that is in no file.
constexpr const char* kCellInMemory = "memory.hcell";

Error refusal(Text place, Text found, Text expected) {
  return {.place = std::move(place), .found = std::move(found), .expected = std::move(expected)};
}

std::vector<double> gridOf(double from, double to, double step) {
  std::vector<double> values;
  if (!(step > 0.0)) return values;
  for (int i = 0; from + i * step <= to + 1e-9 && i < static_cast<int>(kMostCells); ++i)
    values.push_back(from + i * step);
  return values;
}

const Entity* find(const WorkplaceQuestion& question, EntityId id) {
  const auto found = std::find_if(question.entities.begin(), question.entities.end(),
                                  [id](const Entity& entity) { return entity.id == id; });
  return found == question.entities.end() ? nullptr : &*found;
}

Expected<void> check(const WorkplaceQuestion& question) {
  const Entity* shown = find(question, question.mannequin);
  if (shown == nullptr || !shown->figure())
    return makeError(
        refusal(Text("mannequin"), Text("the mannequin does not exist"), Text("one that exists in the cell")));
  if (question.station.empty())
    return makeError(
        refusal(Text("station"), Text("no parts to move"), Text("at least one part, such as a table or a fixture")));
  for (const EntityId id : question.station) {
    if (find(question, id) == nullptr || id == question.mannequin)
      return makeError(refusal(Text("station"), Text("the part does not exist"),
                               Text("parts of the cell, not the mannequin itself")));
  }
  return {};
}

/// All placements, not evaluated yet.
Expected<WorkplaceMap> emptyMap(const WorkplaceQuestion& question) {
  HAPTICELL_TRY(check(question));
  WorkplaceMap map;
  map.rises = gridOf(question.rise_from, question.rise_to, question.rise_step);
  map.aways = gridOf(question.away_from, question.away_to, question.away_step);
  const std::size_t stances = (question.may_stand ? 1u : 0u) + (question.may_sit ? 1u : 0u);
  const std::size_t count = map.rises.size() * map.aways.size() * stances;
  if (count == 0 || count > kMostCells)
    return makeError(refusal(Text("grid"), Text("%1 placements", count), Text("1 to 10000 placements")));
  for (const bool seated : {false, true}) {
    if (!(seated ? question.may_sit : question.may_stand)) continue;
    for (const double rise : map.rises) {
      for (const double away : map.aways) map.cells.push_back({rise, away, seated, 0, {}, {}, {}});
    }
  }
  return map;
}

WorkplaceTables tablesOf(const WorkplaceQuestion& question, const WorkplaceMap& map) {
  const Entity& shown = *find(question, question.mannequin);
  const auto posture = mannequin::toPosture(*shown.figure(), {shown.X_WE, shown.joints()});
  const dvec3 ahead = posture.X_WR.rotate({1.0, 0.0, 0.0});
  WorkplaceTables tables;
  tables.mannequin = shown.name;
  for (const EntityId id : question.station) tables.station.push_back(find(question, id)->name);
  tables.ahead_W = glm::normalize(dvec3(ahead.x, ahead.y, 0.0));
  tables.height = {{"values", map.rises}};
  tables.distance = {{"values", map.aways}};
  tables.may_stand = question.may_stand;
  tables.may_sit = question.may_sit;
  const bool empty_task = question.task == ergonomics::WorkTask{};
  tables.task = empty_task ? std::string() : question.task.name;
  tables.each_body = tables.all_pairs = true;
  return tables;
}

Expected<std::string> textOf(const WorkplaceTables& tables, const std::string& cell) {
  StudyText text;
  HAPTICELL_TRY(text.set({}, "cell", cell));
  HAPTICELL_TRY(addWorkplaceTables(text, tables, {}));
  return text.text();
}

/// The cell as a document. Hidden parts are not in the way, and locks are for hands.
workcell::Document documentOf(const WorkplaceQuestion& question) {
  workcell::DocumentState state;
  for (Entity entity : question.entities) {
    entity.locked = false;
    entity.checked = entity.checked && entity.visible;
    state.entities.push_back(std::make_shared<const Entity>(std::move(entity)));
  }
  state.work_tasks.push_back(question.task);
  return workcell::Document(std::move(state));
}

/// The answers of a row by their names.
class Answers {
 public:
  Answers(const ResultHead& head, const ResultRow& row) : head_(head), row_(row) {}

  double number(const std::string& name) const {
    const Answer& answer = find(name);
    if (const auto* whole = std::get_if<std::int64_t>(&answer)) return static_cast<double>(*whole);
    const auto* number = std::get_if<double>(&answer);
    return number != nullptr ? *number : 0.0;
  }
  std::string word(const std::string& name) const {
    const auto* word = std::get_if<std::string>(&find(name));
    return word != nullptr ? *word : std::string();
  }

 private:
  const Answer& find(const std::string& name) const {
    static const Answer kNone;
    for (std::size_t i = 0; i < row_.answers.size(); ++i)
      if (head_.answers[i].name == name) return row_.answers[i];
    return kNone;
  }

  const ResultHead& head_;
  const ResultRow& row_;
};

/// Why this body cannot do the task; empty: it can.
std::string whyNot(const Answers& answers, const std::string& body, const std::string& ending) {
  if (answers.number("posture.solved" + ending) == 0.0) {
    char text[120];
    std::snprintf(text, sizeof text, "%s is %.0f mm short", body.c_str(),
                  1000.0 * answers.number("posture.short" + ending));
    return text;
  }
  const std::string touched = answers.word("posture.touched" + ending);
  return touched.empty() ? std::string() : body + " would touch " + touched;
}

/// A placement as the study's row says it.
Expected<void> take(const ResultHead& head, const ResultRow& row, WorkplaceCell& cell) {
  const Answers answers(head, row);
  const auto bodies = mannequin::boundaryFigures();
  cell.why = row.note;
  for (std::size_t i = 0; i < bodies.size() && cell.why.empty(); ++i) {
    std::string ending = "_" + workplaceBodies()[i];
    std::replace(ending.begin(), ending.end(), ':', '_');
    cell.why = whyNot(answers, bodies[i].name, ending);
    if (!cell.why.empty()) break;
    auto posture = mannequin::parsePosture(answers.word("posture.posture" + ending), bodies[i].name);
    HAPTICELL_TRY(posture);
    cell.postures.push_back(std::move(*posture));
    cell.rula[i] = static_cast<int>(std::lround(answers.number("posture.rula" + ending)));
    cell.worst = std::max(cell.worst, cell.rula[i]);
  }
  if (cell.why.empty()) return {};
  cell.worst = 0;  // One that cannot is enough.
  cell.postures.clear();
  return {};
}

int bestOf(const std::vector<WorkplaceCell>& cells) {
  int best = -1;
  const auto key = [](const WorkplaceCell& cell) {
    int sum = 0;
    for (const int rula : cell.rula) sum += rula;
    return std::tuple(cell.worst, sum, std::abs(cell.rise) + std::abs(cell.away));
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].worst == 0) continue;
    if (best < 0 || key(cells[i]) < key(cells[static_cast<std::size_t>(best)])) best = static_cast<int>(i);
  }
  return best;
}

}  // namespace

std::vector<EntityId> movedWith(const WorkplaceQuestion& question) {
  const auto& all = question.entities;
  std::vector<bool> moves(all.size(), false);
  for (std::size_t i = 0; i < all.size(); ++i)
    moves[i] = std::find(question.station.begin(), question.station.end(), all[i].id) != question.station.end();
  const auto carried = [&](const Entity& entity) {
    for (std::size_t i = 0; i < all.size(); ++i)
      if (moves[i] && (all[i].name == entity.attachment.to || all[i].name == entity.parent)) return true;
    return false;
  };
  for (bool found = true; found;) {
    found = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool hangs = !all[i].attachment.to.empty() || !all[i].parent.empty();
      if (moves[i] || !hangs || all[i].id == question.mannequin || !carried(all[i])) continue;
      moves[i] = found = true;
    }
  }
  std::vector<EntityId> ids;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (moves[i]) ids.push_back(all[i].id);
  return ids;
}

Expected<std::string> workplaceStudy(const WorkplaceQuestion& question, const std::string& cell) {
  const auto map = emptyMap(question);
  HAPTICELL_TRY(map);
  return textOf(tablesOf(question, *map), cell);
}

Expected<WorkplaceMap> searchWorkplace(const WorkplaceQuestion& question, manipulation::SceneService& scenes,
                                       const std::function<void(double)>& progress, const std::atomic<bool>& cancel) {
  auto map = emptyMap(question);
  HAPTICELL_TRY(map);
  WorkplaceTables tables = tablesOf(question, *map);
  tables.postures = true;
  auto text = textOf(tables, kCellInMemory);
  HAPTICELL_TRY(text);
  const auto study = Study::load(std::move(*text), "memory.hstudy", {documentOf(question), &scenes}, {});
  HAPTICELL_TRY(study);
  auto store = ResultStore::inMemory((*study)->head());
  HAPTICELL_TRY(store);
  RunOptions options;
  options.cancelled = &cancel;
  if (progress)
    options.progress = [&progress](const RunProgress& now) {
      progress(static_cast<double>(now.done) / static_cast<double>(now.total));
    };
  const auto run = runStudy(**study, *store, options);
  HAPTICELL_TRY(run);
  map->is_complete = run->complete;
  HAPTICELL_TRY(store->forEachRow([&](const ResultRow& row) {
    return take(store->head(), row, map->cells[static_cast<std::size_t>(row.number)]);
  }));
  map->best = bestOf(map->cells);
  return map;
}

}  // namespace hapticell::studies
