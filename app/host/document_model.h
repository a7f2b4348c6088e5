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

/// The open document with signals. Everything that changes it goes through here. GUI thread.
class DocumentModel : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  const workcell::Document& document() const { return document_; }
  /// Counts the documents that stood here: what was begun beside the window for one is not for the next.
  int number() const { return number_; }
  /// Name for the window's title: the file's stem, "demo copy" for a sample that has no file of its own yet, or "New
  /// workcell".
  QString title() const;
  /// Where it was read from: its own path, or that of the sample that it is a copy of; empty for a new one.
  const std::filesystem::path& origin() const { return origin_; }

  /// Does a command as one step of undo; refused() reports refused commands.
  bool execute(const workcell::Command& command);
  /// Several commands as one step of undo, and one changed(); where one is refused, none is done.
  bool executeAll(const QString& text, const std::vector<workcell::Command>& commands);
  /// Several commands as part of the step that is open, and one changed(); where one is refused the step holds those
  /// before it, and nothing is reported: a drag asks again at the next place.
  bool executeWithin(const std::vector<workcell::Command>& commands);
  void undo();
  void redo();
  /// Undoes or does again until `steps` steps are done: what a click into the history asks for.
  void goTo(int steps);

  /// From here to endStep() all commands are one step of undo with this text: a drag. cancelStep() takes them back.
  void beginStep(const QString& text);
  void endStep();
  void cancelStep();

  /// From here to endTrial() what is moved is only tried: a trainee's run. The cell does not count as changed; at the
  /// end everything returns to its place, without an undo step. Whatever else changes the cell, saves it or closes it
  /// ends the trial first.
  void beginTrial();
  void endTrial();
  bool inTrial() const { return trial_.has_value(); }
  /// Whether it differs from its file; what is only tried is no difference.
  bool isDirty() const { return trial_ ? trial_->dirty : document_.isDirty(); }

  /// An empty document in place of this one.
  void clear();
  /// A document that was read elsewhere (files are never read in this thread) in place of this one.
  void adopt(workcell::Document document);
  /// The same, of a shipped sample: it has no file of its own until it is saved.
  void adoptCopy(workcell::Document document);
  Expected<void> save(const QString& path);
  /// What an import made, as one step of undo, its file's frame F at X_WF. Gives the new ids in tree order.
  Expected<std::vector<workcell::EntityId>> addImported(std::vector<workcell::Entity> entities, const Pose& X_WF = {});

 signals:
  void changed();  ///< The document differs from before; undo and redo included.
  void refused(const QString& sentence);
  /// Another document will replace this one. Whoever keeps something of this one (what was picked, measured, played,
  /// scored, drawn, chosen of it) drops it now, so that nothing of it is in the next; ids of its entities mean nothing
  /// there.
  void closing();
  void trialEnded();  ///< Everything is back at its place before the trial.
  void opened();      ///< Another document has replaced it.
  /// Saving put recordings beside the document (old to new path); before changed().
  void recordingsMoved(const std::map<std::string, std::string>& places);

 private:
  using Entities = std::vector<std::shared_ptr<const workcell::Entity>>;
  struct Trial {
    bool dirty = false;            ///< Before it.
    std::optional<Entities> step;  ///< Where all stood when the step that is open began.
  };
  /// Commands that are not motions end the trial.
  void endTrialFor(const std::vector<workcell::Command>& commands);
  void goBackTo(const Entities& before);
  void replaceBy(workcell::Document document, std::filesystem::path origin);

  workcell::Document document_;
  std::filesystem::path origin_;
  int number_ = 0;
  std::optional<Trial> trial_;
  bool drop_step_ = false;  ///< The trial ended in the middle of a drag: the rest of it is not kept either.
};

}  // namespace hapticell::app
