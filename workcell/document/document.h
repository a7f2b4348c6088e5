// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "workcell/document/command.h"
#include "workcell/document/document_state.h"

namespace hapticell::workcell {

/// The workcell: entities, pair sets, view. Changed only by commands, each of which can be undone.
///
/// Belongs to one thread (the window's, or a command's). Other threads get values: snapshotEntities(), or a copy of
/// state().
class Document {
 public:
  Document() = default;
  /// A document as read: nothing to undo, not dirty. Ids are assigned again, in order.
  explicit Document(DocumentState state);

  /// For documents that follow each other: continues ids and revision from the previous document, so that none is used
  /// in both. Call it before the first command.
  void continueAfter(const Document& before);

  const DocumentState& state() const { return state_; }
  const Entity* find(EntityId id) const { return state_.find(id); }
  const Entity* findByName(std::string_view name) const { return state_.findByName(name); }
  /// Copies of all entities; meshes and robot models are shared.
  std::vector<Entity> snapshotEntities() const;
  /// `wanted`, or "wanted 2", "wanted 3" ... if that name is taken.
  std::string uniqueName(std::string_view wanted) const;

  /// Executes the command as one undo step (or as part of the open compound); undone steps can then no longer be
  /// redone. On error nothing has changed. Returns the id of the entity concerned; 0 for commands without one.
  Expected<EntityId> execute(const Command& command);

  /// Makes all commands until endCompound() one undo step with this text: for a drag, an import. Compounds may be
  /// nested; the outermost one counts. A compound that changed nothing leaves no step.
  void beginCompound(std::string text);
  void endCompound();
  /// Ends all open compounds and reverts what was done in them (Escape during a drag).
  void cancelCompound();
  bool inCompound() const { return compound_depth_ > 0; }

  /// Returns false and does nothing if there is nothing to undo or a compound is open.
  bool undo();
  bool redo();
  bool canUndo() const { return !inCompound() && !undo_.empty(); }
  bool canRedo() const { return !inCompound() && !redo_.empty(); }
  /// Name of the undo step; empty if there is no step.
  std::string undoText() const { return undo_.empty() ? "" : undo_.back().text; }
  std::string redoText() const { return redo_.empty() ? "" : redo_.back().text; }

  /// Texts of the steps that can be undone, oldest first, and of those that can be redone, next first: the history.
  std::vector<std::string> undoTexts() const;
  std::vector<std::string> redoTexts() const;

  /// Grows with every change, including undo and redo: data for drawing or checking are outdated if it differs.
  std::uint64_t revision() const { return revision_; }
  /// True if the state differs from the one last saved or read; undoing back to that makes it false.
  bool isDirty() const { return state_id_ != saved_state_id_; }
  void markSaved() { saved_state_id_ = state_id_; }
  /// Makes it dirty, whatever is undone: for a document restored from a recovery copy, which is in no file.
  void markUnsaved() { saved_state_id_ = ~std::uint64_t{0}; }

  /// Files of trajectories have moved (old to new path): changes all states of the undo history. No change in itself.
  void moveTrajectories(const std::map<std::string, std::string>& places);

  /// The file that it was read from or last saved to; empty for a new document.
  const std::filesystem::path& path() const { return path_; }
  void setPath(std::filesystem::path path) { path_ = std::move(path); }

 private:
  struct Step {
    std::string text;
    DocumentState state;  // The state to go to.
    std::uint64_t state_id = 0;
  };

  void number();
  void moveStep(std::vector<Step>& from, std::vector<Step>& to);

  DocumentState state_;
  EntityId next_id_ = 1;
  std::vector<Step> undo_;
  std::vector<Step> redo_;
  Step compound_;  // The state before the open compound.
  int compound_depth_ = 0;
  std::uint64_t revision_ = 0;
  std::uint64_t state_id_ = 0;  // Identifies the state; never used twice.
  std::uint64_t last_state_id_ = 0;
  std::uint64_t saved_state_id_ = 0;
  std::filesystem::path path_;
};

}  // namespace hapticell::workcell
