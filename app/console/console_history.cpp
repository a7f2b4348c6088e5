// SPDX-License-Identifier: Apache-2.0
#include "app/console/console_history.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <string>
#include <utility>

#include "config/user_folders.h"
#include "geometry/system/atomic_file.h"

namespace hapticell::app {

ConsoleHistory::ConsoleHistory(QString file) : file_(std::move(file)) {
  read();
  at_ = static_cast<int>(entries_.size());
}

QString ConsoleHistory::usualFile() {
  const auto folder = config::userStateFolder();
  return folder ? QString::fromStdString((*folder / "python-history").string()) : QString();
}

void ConsoleHistory::add(const QString& text) {
  if (entries_.isEmpty() || entries_.back() != text) {
    entries_ << text;
    while (entries_.size() > kKept) entries_.removeFirst();
    write();
  }
  at_ = static_cast<int>(entries_.size());
  typed_.clear();
}

QString ConsoleHistory::before(const QString& text) {
  if (at_ == 0) return text;
  if (at_ == entries_.size()) typed_ = text;
  return entries_[--at_];
}

QString ConsoleHistory::after(const QString& text) {
  if (at_ >= entries_.size()) return text;
  ++at_;
  return at_ == entries_.size() ? typed_ : entries_[at_];
}

void ConsoleHistory::read() {
  constexpr qint64 kLargest = 1 << 22;  // Bytes: more than a thousand entries of any sense. Half, twice: as well.
  QFile file(file_);
  if (file_.isEmpty() || !QFileInfo(file_).isFile() || file.size() > kLargest || !file.open(QIODevice::ReadOnly)) return;
  while (!file.atEnd()) {
    const QJsonArray line = QJsonDocument::fromJson(file.readLine()).array();
    if (line.size() == 1 && line[0].isString()) entries_ << line[0].toString();
  }
  while (entries_.size() > kKept) entries_.removeFirst();
}

void ConsoleHistory::write() const {
  if (file_.isEmpty()) return;
  if (!config::makeOwnFolder(QFileInfo(file_).path().toStdString())) return;
  std::string text;
  for (const QString& entry : entries_)
    text += QJsonDocument(QJsonArray{entry}).toJson(QJsonDocument::Compact).toStdString() + '\n';
  (void)writeFileAtomically(file_.toStdString(), text);  // A history that is not kept stops nobody.
}

}  // namespace hapticell::app
