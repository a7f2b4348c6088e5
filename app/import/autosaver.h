// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <mutex>

#include "app/host/document_model.h"
#include "workcell/files/autosave.h"

namespace hapticell::app {

/// Keeps a recovery copy of the unsaved document (workcell/files/autosave.h): twice a minute if something changed,
/// written by another thread, and at once if the program crashes. GUI thread, except for keepNow().
class Autosaver : public QObject {
  Q_OBJECT
 public:
  explicit Autosaver(DocumentModel& document, QObject* parent = nullptr);
  ~Autosaver() override;
  void setInterval(int milliseconds) { timer_.setInterval(milliseconds); }
  /// Sets the function that gives what the document's file held when it was read or last saved (contentName()).
  void setContent(std::function<std::string()> content) { content_ = std::move(content); }
  /// Sets the function that gives the picture for the copy; null images are left out.
  void setPicture(std::function<QImage()> picture) { picture_ = std::move(picture); }
  /// Writes the copy now, if there are unsaved changes.
  void save();
  /// For a crash: writes the newest unsaved state, as of the last edit, if it is not in the copy already. False: it
  /// could not. Any thread, while the window's thread is stopped; waits at most a second for the writer.
  bool keepNow();
  /// The folder of this run, which also holds the crash note. Error: it cannot be made.
  Expected<std::filesystem::path> runFolder();
  /// Takes over the copy of an earlier run, because the open document was restored from it.
  void adopt(const std::filesystem::path& left_run);
  /// Removes the copy, because the document was saved, closed or replaced properly.
  void discard();

 signals:
  void failed(const QString& sentence);

 private:
  struct Unsaved {
    workcell::DocumentState state;
    std::filesystem::path document, run;
    std::string content;       ///< Content name of the document's file that this state differs from.
    std::uint64_t number = 0;  ///< Increases with each state; 0: nothing is unsaved.
  };
  void note();
  Expected<void> write(const Unsaved& unsaved);

  DocumentModel& document_;
  workcell::RunFolder run_;
  std::function<QImage()> picture_;
  std::function<std::string()> content_;
  std::uint64_t noted_revision_ = 0, last_number_ = 0;
  bool told_ = false;  ///< The missing folder for copies was reported.
  QTimer timer_;
  std::timed_mutex unsaved_mutex_, write_mutex_;
  Unsaved unsaved_;            ///< The newest state, for keepNow(); guarded by unsaved_mutex_.
  std::uint64_t written_ = 0;  ///< Number of the state in the copy; guarded by write_mutex_.
  QThreadPool writer_;
};

}  // namespace hapticell::app
