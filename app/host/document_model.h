// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <vector>

#include "workcell/document.h"

namespace hapticell::app {

/// The open document with signals. Everything that changes it goes through here. GUI thread.
class DocumentModel : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  const workcell::Document& document() const { return document_; }
  /// Name for the window's title: the file's stem, or "New workcell".
  QString title() const;

  /// Does a command as one step of undo; what was refused is told by refused().
  bool execute(const workcell::Command& command);
  /// Several commands as one step of undo, and one changed(); where one is refused, none is done.
  bool executeAll(const QString& text, const std::vector<workcell::Command>& commands);
  /// Several commands as part of the step that is open, and one changed(); where one is refused the step holds those
  /// before it, and nothing is told: a drag asks again at the next place.
  bool executeWithin(const std::vector<workcell::Command>& commands);
  void undo();
  void redo();
  /// Undoes or does again until `steps` steps are done: what a click into the history asks for.
  void goTo(int steps);

  /// From here to endStep() all commands are one step of undo with this text: a drag. cancelStep() takes them back.
  void beginStep(const QString& text);
  void endStep();
  void cancelStep();

  /// An empty document in place of this one.
  void clear();
  /// A document that was read elsewhere (files are never read in this thread) in place of this one.
  void adopt(workcell::Document document);
  Expected<void> save(const QString& path);
  /// What an import made, as one step of undo, its file's frame F at X_WF. Gives the new ids in tree order.
  Expected<std::vector<workcell::EntityId>> addImported(std::vector<workcell::Entity> entities, const Pose& X_WF = {});

 signals:
  void changed();  ///< The document differs from before; undo and redo included.
  void refused(const QString& sentence);
  void opened();  ///< Another document stands in its place.

 private:
  workcell::Document document_;
};

}  // namespace hapticell::app
