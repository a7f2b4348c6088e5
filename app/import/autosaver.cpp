// SPDX-License-Identifier: Apache-2.0
#include "app/import/autosaver.h"

#include "workcell/autosave.h"

namespace hapticell::app {

namespace {
constexpr int kEveryMilliseconds = 60'000;
}

Autosaver::Autosaver(DocumentModel& document, QObject* parent) : QObject(parent), document_(document) {
  writer_.setMaxThreadCount(1);
  timer_.start(kEveryMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &Autosaver::save);
}

Autosaver::~Autosaver() {
  writer_.waitForDone();
}

void Autosaver::save() {
  const workcell::Document& document = document_.document();
  if (!document.isDirty() || (written_ && document.revision() == saved_revision_)) return;
  saved_revision_ = document.revision();
  path_ = document.path();
  written_ = true;
  writer_.start([this, state = document.state(), path = path_] {
    const auto saved = workcell::autosave(state, path);
    if (saved) return;
    const QString sentence = QString::fromStdString(saved.error().message());
    QMetaObject::invokeMethod(
        this, [this, sentence] { emit failed(sentence); }, Qt::QueuedConnection);
  });
}

void Autosaver::adopt(const std::filesystem::path& copy) {
  writer_.waitForDone();
  path_ = document_.document().path();
  saved_revision_ = document_.document().revision();
  std::error_code fault;
  std::filesystem::rename(copy, workcell::autosavePath(path_), fault);
  written_ = !fault;
}

void Autosaver::discard() {
  if (!written_) return;
  written_ = false;
  writer_.start([path = path_] { workcell::discardAutosave(path); });
}

}  // namespace hapticell::app
