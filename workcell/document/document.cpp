// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/document.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/system/assertion.h"
#include "workcell/document/command_checks.h"

namespace hapticell::workcell {

namespace {

/// The next push_back allocates nothing.
template <typename T>
void makeRoom(std::vector<T>& list) {
  if (list.size() == list.capacity()) list.reserve(2 * list.size() + 8);
}

/// What a user may not do, though a file that was written so is still read.
Expected<void> checkReachOf(const Command& command, const DocumentState& state) {
  const auto placed = [&state](EntityId id, const Pose& X_WE) -> Expected<void> {
    const Entity* entity = state.find(id);
    return entity ? checkReach(entity->name, X_WE.p) : Expected<void>{};
  };
  if (const auto* add = std::get_if<AddEntity>(&command)) return checkReach(add->entity);
  if (const auto* fresh = std::get_if<ReplaceShape>(&command)) return checkReach(fresh->fresh);
  if (const auto* place = std::get_if<SetPlacement>(&command)) return placed(place->id, place->X_WE);
  if (const auto* at = std::get_if<SetConfiguration>(&command)) return placed(at->id, at->X_WE);
  return {};
}

}  // namespace

Document::Document(DocumentState state) : state_(std::move(state)) {
  number();
}

void Document::continueAfter(const Document& before) {
  HAPTICELL_DEMAND(undo_.empty() && redo_.empty() && !inCompound());
  next_id_ = before.next_id_;
  revision_ = before.revision_ + 1;
  number();
}

void Document::number() {
  for (auto& entity : state_.entities) {
    auto numbered = std::make_shared<Entity>(*entity);
    numbered->id = next_id_++;
    entity = std::move(numbered);
  }
}

std::vector<Entity> Document::snapshotEntities() const {
  std::vector<Entity> entities;
  entities.reserve(state_.entities.size());
  for (const auto& entity : state_.entities) entities.push_back(*entity);
  return entities;
}

std::string Document::uniqueName(std::string_view wanted) const {
  std::string name(wanted);
  for (int number = 2; findByName(name) != nullptr; ++number) name = std::string(wanted) + " " + std::to_string(number);
  return name;
}

Expected<EntityId> Document::execute(const Command& command) {
  HAPTICELL_TRY(checkReachOf(command, state_));
  // Where the memory ends, the state of before stands: nothing below the last allocation throws.
  Expected<EntityId> done = EntityId{0};
  if (inCompound()) {
    // In place: copies for each of an import's thousands of parts would take seconds.
    try {
      done = apply(command, state_, next_id_);
    } catch (...) {
      cancelCompound();
      throw;
    }
    if (!done) return done;
  } else {
    DocumentState next = state_;
    Step before{commandText(command, state_), {}, state_id_};
    done = apply(command, next, next_id_);
    if (!done) return done;
    makeRoom(undo_);
    before.state = std::exchange(state_, std::move(next));
    undo_.push_back(std::move(before));
    redo_.clear();
  }
  for (const auto& entity : state_.entities) next_id_ = std::max(next_id_, entity->id + 1);
  state_id_ = ++last_state_id_;
  ++revision_;
  return done;
}

void Document::beginCompound(std::string text) {
  if (compound_depth_ == 0) compound_ = {std::move(text), state_, state_id_};
  ++compound_depth_;  // Last: it is open only when what it goes back to is kept.
}

void Document::endCompound() {
  HAPTICELL_DEMAND(compound_depth_ > 0);
  if (compound_depth_ == 1) makeRoom(undo_);
  if (--compound_depth_ > 0) return;
  if (compound_.state_id != state_id_) {
    undo_.push_back(std::move(compound_));
    redo_.clear();
  }
  compound_ = {};
}

void Document::cancelCompound() {
  if (compound_depth_ == 0) return;
  compound_depth_ = 0;
  if (compound_.state_id != state_id_) {
    state_ = std::move(compound_.state);
    state_id_ = compound_.state_id;
    ++revision_;
  }
  compound_ = {};
}

void Document::moveStep(std::vector<Step>& from, std::vector<Step>& to) {
  makeRoom(to);
  std::string text = from.back().text;
  Step step = std::move(from.back());
  from.pop_back();
  to.push_back({std::move(text), std::move(state_), state_id_});
  state_ = std::move(step.state);
  state_id_ = step.state_id;
  ++revision_;
}

void Document::moveTrajectories(const std::map<std::string, std::string>& places) {
  if (places.empty()) return;
  const auto move = [&places](DocumentState& state) {
    for (TrajectoryReference& reference : state.trajectories)
      if (const auto place = places.find(reference.path); place != places.end()) reference.path = place->second;
  };
  move(state_);
  for (Step& step : undo_) move(step.state);
  for (Step& step : redo_) move(step.state);
}

std::vector<std::string> Document::undoTexts() const {
  std::vector<std::string> texts;
  for (const Step& step : undo_) texts.push_back(step.text);
  return texts;
}

std::vector<std::string> Document::redoTexts() const {
  std::vector<std::string> texts;
  for (auto step = redo_.rbegin(); step != redo_.rend(); ++step) texts.push_back(step->text);
  return texts;
}

bool Document::undo() {
  if (!canUndo()) return false;
  moveStep(undo_, redo_);
  return true;
}

bool Document::redo() {
  if (!canRedo()) return false;
  moveStep(redo_, undo_);
  return true;
}

}  // namespace hapticell::workcell
