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

/// Keeps a copy of the unsaved document against a crash (workcell/files/autosave.h): twice a minute where something
/// changed, written by another thread, and at once where the program breaks. GUI thread, but for keepNow().
class Autosaver : public QObject {
  Q_OBJECT
 public:
  explicit Autosaver(DocumentModel& document, QObject* parent = nullptr);
  ~Autosaver() override;
  void setInterval(int milliseconds) { timer_.setInterval(milliseconds); }
  /// Where it is asked what the document's file held when it was read or last saved (contentName()).
  void setContent(std::function<std::string()> content) { content_ = std::move(content); }
  /// Where the picture beside the copy comes from; null images are left out.
  void setPicture(std::function<QImage()> picture) { picture_ = std::move(picture); }
  /// Writes the copy now, where there is something unsaved.
  void save();
  /// The program breaks: writes the newest unsaved state, as of the last edit, if it is not in the copy already. False:
  /// it could not. Any thread, while the window's stands still; does not wait longer than a second for the writer.
  bool keepNow();
  /// The folder of this run, where the crash note goes. Error: it cannot be made.
  Expected<std::filesystem::path> runFolder();
  /// The open document is what this run left: its copy is this one's from here on.
  void adopt(const std::filesystem::path& left_run);
  /// The document was saved, closed or replaced in an orderly way: no copy is needed.
  void discard();

 signals:
  void failed(const QString& sentence);

 private:
  struct Unsaved {
    workcell::DocumentState state;
    std::filesystem::path document, run;
    std::string content;       ///< Of the document's file, that this differs from.
    std::uint64_t number = 0;  ///< Grows with each; 0: nothing is unsaved.
  };
  void note();
  Expected<void> write(const Unsaved& unsaved);

  DocumentModel& document_;
  workcell::RunFolder run_;
  std::function<QImage()> picture_;
  std::function<std::string()> content_;
  std::uint64_t noted_revision_ = 0, last_number_ = 0;
  bool told_ = false;  ///< That there is no folder for copies.
  QTimer timer_;
  std::timed_mutex unsaved_mutex_, write_mutex_;
  Unsaved unsaved_;            ///< The newest state, for keepNow(); behind unsaved_mutex_.
  std::uint64_t written_ = 0;  ///< Its number in the copy; behind write_mutex_.
  QThreadPool writer_;
};

}  // namespace hapticell::app
