// SPDX-License-Identifier: Apache-2.0
#include "app/ros2/ros2_process.h"

#include <QCoreApplication>
#include <QDir>
#include <QJsonDocument>

#include "app/style/library_text.h"
#include "app/style/plain_lines.h"
#include "geometry/system/packed_text.h"

namespace hapticell::app {

Ros2Process::Ros2Process(QObject* parent) : QObject(parent) {
  connect(&process_, &QProcess::readyReadStandardOutput, this, &Ros2Process::readLines);
  connect(&process_, &QProcess::finished, this, &Ros2Process::finish);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart)
      emit ended({}, tr("The link to ROS 2 could not be started: %1 was not found or cannot be run.").arg(process_.program()));
  });
}

Ros2Process::~Ros2Process() {
  process_.disconnect(this);
  if (!isRunning()) return;
  process_.terminate();
  if (!process_.waitForFinished(6000)) process_.kill();
  process_.waitForFinished(1000);
}

void Ros2Process::start(const QJsonObject& job) {
  if (isRunning()) return;
  last_ = {};
  failure_.clear();
  process_.start(QDir(QCoreApplication::applicationDirPath()).filePath("hapticell-ros2"),
                 {QString::fromUtf8(QJsonDocument(job).toJson(QJsonDocument::Compact))});
}

void Ros2Process::write(const QJsonObject& line) {
  // A job that does not read would let the lines pile up. Half and twice of this: sooner or later.
  constexpr qint64 kMostUnread = 65536;
  if (!isRunning() || process_.bytesToWrite() > kMostUnread) return;
  process_.write(QJsonDocument(line).toJson(QJsonDocument::Compact) + '\n');
}

void Ros2Process::stop() {
  if (isRunning()) process_.terminate();
}

void Ros2Process::readLines() {
  while (process_.canReadLine()) {
    const QJsonDocument line = QJsonDocument::fromJson(process_.readLine());
    if (!line.isObject()) continue;
    last_ = line.object();
    if (last_.contains("failure")) {
      auto error = unpackedError(last_.value("failure").toString().toStdString());
      if (error) {
        error->file = last_.value("file").toString().toStdString();
        failure_ = shownText(*error);
      }
      continue;
    }
    emit said(last_);
  }
}

void Ros2Process::finish() {
  readLines();
  const bool is_done = process_.exitStatus() == QProcess::NormalExit && process_.exitCode() == 0;
  QString sentence = plainLines(QString::fromUtf8(process_.readAllStandardError()).trimmed());
  if (sentence.startsWith("hapticell-cli: ")) sentence.remove(0, 15);
  if (!failure_.isEmpty()) sentence = failure_;
  if (!is_done && sentence.isEmpty()) sentence = tr("The link to ROS 2 stopped unexpectedly. Start it again.");
  emit ended(is_done ? last_ : QJsonObject(), sentence);
}

}  // namespace hapticell::app
