// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <filesystem>

#include "app/host/document_model.h"

namespace hapticell::app {

/// Keeps a copy of the unsaved document against a crash (workcell/autosave.h): once a minute where something changed,
/// written by another thread. GUI thread.
class Autosaver : public QObject {
  Q_OBJECT
 public:
  explicit Autosaver(DocumentModel& document, QObject* parent = nullptr);
  ~Autosaver() override;
  void setInterval(int milliseconds) { timer_.setInterval(milliseconds); }
  /// Writes the copy now, where there is something unsaved.
  void save();
  /// The open document is what this copy holds: from here on the copy is as if save() had written it.
  void adopt(const std::filesystem::path& copy);
  /// The document was saved, closed or replaced in an orderly way: no copy is needed.
  void discard();

 signals:
  void failed(const QString& sentence);

 private:
  DocumentModel& document_;
  std::filesystem::path path_;  ///< Of the document that the copy belongs to.
  std::uint64_t saved_revision_ = 0;
  bool written_ = false;
  QTimer timer_;
  QThreadPool writer_;
};

}  // namespace hapticell::app
