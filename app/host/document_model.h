// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "workcell/document/document.h"

namespace hapticell::app {

/// The open document with signals. Every change of it is made through this class. GUI thread.
class DocumentModel : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  const workcell::Document& document() const { return document_; }
  /// Counts the documents opened so far: background work that was started for one document must not change the next.
  int number() const { return number_; }
  /// Name for the window's title: the file's stem, "demo copy" for a sample that was not saved yet, or "New
  /// workcell".
  QString title() const;
  /// The file that it was read from: its own, or that of the sample that it is a copy of; empty for a new document.
  const std::filesystem::path& origin() const { return origin_; }

  /// Executes a command as one undo step; refused() reports refused commands.
  bool execute(const workcell::Command& command);
  /// Executes several commands as one undo step, with one changed(). If one is refused, none is executed.
  bool executeAll(const QString& text, const std::vector<workcell::Command>& commands);
  /// Executes several commands as part of the open step, with one changed(). If one is refused, the step keeps those
  /// before it and nothing is reported: a drag tries again at its next pose.
  bool executeWithin(const std::vector<workcell::Command>& commands);
  void undo();
  void redo();
  /// Undoes or redoes until `steps` steps are done: for a click into the history.
  void goTo(int steps);

  /// Makes all commands until endStep() one undo step with this text, for a drag. cancelStep() reverts them.
  void beginStep(const QString& text);
  void endStep();
  void cancelStep();

  /// Until endTrial(), moves are only tried, as in a trainee's run: the cell does not count as changed, and at the end
  /// everything returns to its placement without an undo step. Anything else that changes, saves or closes the cell
  /// ends the trial first.
  void beginTrial();
  void endTrial();
  bool inTrial() const { return trial_.has_value(); }
  /// Whether it differs from its file; moves of a trial do not count.
  bool isDirty() const { return trial_ ? trial_->dirty : document_.isDirty(); }

  /// Replaces the document by an empty one.
  void clear();
  /// Replaces the document by one that was read elsewhere (files are never read in this thread).
  void adopt(workcell::Document document);
  /// The same for a shipped sample: it has no file of its own until it is saved.
  void adoptCopy(workcell::Document document);
  Expected<void> save(const QString& path);
  /// Adds what an import made as one undo step, with the file's frame F at X_WF. Returns the new ids in tree order.
  Expected<std::vector<workcell::EntityId>> addImported(std::vector<workcell::Entity> entities, const Pose& X_WF = {});

 signals:
  void changed();  ///< The document changed, or its undo and redo did.
  void refused(const QString& sentence);
  /// Another document is about to replace this one. Everything that refers to this one (picked, measured, played,
  /// scored, drawn or chosen) must be dropped now, so that it does not show in the next: entity ids of this document
  /// mean nothing there.
  void closing();
  void trialEnded();  ///< Everything is back where it was before the trial.
  void opened();      ///< Another document has replaced it.
  /// Saving put recordings next to the document (old path to new path); emitted before changed().
  void recordingsMoved(const std::map<std::string, std::string>& places);

 private:
  using Entities = std::vector<std::shared_ptr<const workcell::Entity>>;
  struct Trial {
    bool dirty = false;            ///< The value before the trial.
    std::optional<Entities> step;  ///< All placements at the start of the open step.
  };
  /// Ends the trial if one of the commands is not a motion.
  void endTrialFor(const std::vector<workcell::Command>& commands);
  void goBackTo(const Entities& before);
  void replaceBy(workcell::Document document, std::filesystem::path origin);

  workcell::Document document_;
  std::filesystem::path origin_;
  int number_ = 0;
  std::optional<Trial> trial_;
  bool drop_step_ = false;  ///< The trial ended during a drag: the rest of the drag is dropped too.
};

}  // namespace hapticell::app
