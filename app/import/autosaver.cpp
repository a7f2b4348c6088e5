// SPDX-License-Identifier: Apache-2.0
#include "app/import/autosaver.h"

#include <chrono>
#include <utility>

#include "app/kit/written_file.h"
#include "app/style/library_text.h"

namespace hapticell::app {

namespace {
// ms between two recovery copies: at most so much work is lost. Half: twice the writing; twice: a minute is lost.
constexpr int kEveryMilliseconds = 30'000;
// s that a crash waits for a copy that is being written; where the writer itself broke it never ends. Half: a slow
// disk's copy is lost; twice: a crash takes longer.
constexpr std::chrono::seconds kLongestWait{1};
}  // namespace

Autosaver::Autosaver(DocumentModel& document, QObject* parent) : QObject(parent), document_(document) {
  writer_.setMaxThreadCount(1);
  timer_.start(kEveryMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &Autosaver::save);
  connect(&document_, &DocumentModel::changed, this, &Autosaver::note);
}

Autosaver::~Autosaver() {
  writer_.waitForDone();
}

Expected<std::filesystem::path> Autosaver::runFolder() {
  return run_.path();
}

/// Cheap, after every change: the entities are shared with the document.
void Autosaver::note() {
  const workcell::Document& document = document_.document();
  Unsaved fresh;
  if (document_.isDirty()) {
    if (unsaved_.number != 0 && noted_revision_ == document.revision() && unsaved_.document == document.path()) return;
    const auto run = run_.path();
    if (!run) {
      if (!std::exchange(told_, true)) emit failed(shownText(run.error()));
      return;
    }
    fresh = {document.state(), document.path(), *run, content_ ? content_() : std::string(), ++last_number_};
    noted_revision_ = document.revision();
  }
  const std::scoped_lock lock(unsaved_mutex_);
  std::swap(unsaved_, fresh);
}

void Autosaver::save() {
  note();
  if (unsaved_.number == 0) return;
  const QImage picture = picture_ ? picture_() : QImage();
  writer_.start([this, unsaved = unsaved_, picture] {
    const auto saved = write(unsaved);
    if (saved && !picture.isNull())
      (void)writePicture(picture, QString::fromStdString(workcell::pictureIn(unsaved.run).string()), 85);
    if (saved) return;
    const QString sentence = shownText(saved.error());
    QMetaObject::invokeMethod(
        this, [this, sentence] { emit failed(sentence); }, Qt::QueuedConnection);
  });
}

Expected<void> Autosaver::write(const Unsaved& unsaved) {
  // Where the writer itself broke, it never lets go.
  const std::unique_lock lock(write_mutex_, kLongestWait);
  if (unsaved.number == 0 || unsaved.number <= written_) return {};
  auto saved = workcell::autosave(unsaved.state, unsaved.document, unsaved.run, unsaved.content);
  if (saved) written_ = unsaved.number;
  return saved;
}

bool Autosaver::keepNow() {
  const std::unique_lock lock(unsaved_mutex_, kLongestWait);
  return lock.owns_lock() && write(unsaved_).has_value();
}

void Autosaver::adopt(const std::filesystem::path& left_run) {
  writer_.waitForDone();
  const auto adopted = run_.adopt(left_run);
  note();
  if (adopted)
    written_ = unsaved_.number;  // It is in the copy.
  else
    emit failed(shownText(adopted.error()));
}

void Autosaver::discard() {
  {
    Unsaved none;
    const std::scoped_lock lock(unsaved_mutex_);
    std::swap(unsaved_, none);
  }
  writer_.waitForDone();
  run_.discardCopy();
}

}  // namespace hapticell::app
