// SPDX-License-Identifier: Apache-2.0
#include "app/import/document_guard.h"

#include "app/host/document_model.h"
#include "geometry/system/atomic_file.h"
#include "workcell/files/content_name.h"
#include "workcell/format/document_io.h"

namespace hapticell::app {

namespace {

QString sentenceAbout(const workcell::DocumentOwner& owner) {
  const auto named = [](const std::string& name) { return QString::fromStdString(name).simplified().left(64); };
  if (owner.user.empty()) return DocumentGuard::tr("Another program has it open.");
  return DocumentGuard::tr("%1 on %2 has had it open since %3.")
      .arg(named(owner.user), named(owner.host), named(owner.since));
}

}  // namespace

DocumentGuard::DocumentGuard(DocumentModel& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document, &DocumentModel::opened, this, [this] {
    path_.clear();  // The same file once more: whoever had it may be gone.
    lock_ = {};
    follow();
  });
  connect(&document, &DocumentModel::changed, this, &DocumentGuard::follow);
}

void DocumentGuard::follow() {
  const std::filesystem::path& path = document_.document().path();
  if (path == path_) return;
  path_ = path;
  lock_ = {};
  if (!path_.empty()) {
    removeUnfinished(path_.parent_path());
    lock_ = workcell::DocumentLock::take(path_);
  }
  emit changed();
}

void DocumentGuard::setContent(std::filesystem::path document, std::string content) {
  content_path_ = std::move(document);
  content_ = std::move(content);
}

std::string DocumentGuard::content() const {
  return document_.document().path() == content_path_ ? content_ : std::string();
}

QString DocumentGuard::ownerSentence() const {
  return lock_.owner() ? sentenceAbout(*lock_.owner()) : QString();
}

QString DocumentGuard::doubtAbout(const QString& path) {
  const std::filesystem::path place = std::filesystem::absolute(path.toStdString()).lexically_normal();
  if (place != path_) {
    const auto there = workcell::DocumentLock::take(place);
    return there.owner() ? sentenceAbout(*there.owner()) : QString();
  }
  const bool was_read_only = isReadOnly();
  if (lock_.tryAgain() && was_read_only) emit changed();
  if (lock_.owner()) return sentenceAbout(*lock_.owner());
  return workcell::changedOnDisk(place, content())
             ? tr("Another program changed this file after it was opened here. If you save, those changes are lost.")
             : QString();
}

void DocumentGuard::noteSaved() {
  follow();
  const auto& document = document_.document();
  setContent(document.path(),
             workcell::contentName(workcell::documentText(document.state(), document.path().parent_path())));
  const bool was_read_only = isReadOnly();
  lock_.takeOver();
  if (was_read_only && !isReadOnly()) emit changed();
}

}  // namespace hapticell::app
