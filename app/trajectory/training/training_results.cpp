// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/training/training_results.h"

#include <QDir>
#include <QFileInfo>
#include <QObject>
#include <QRegularExpression>
#include <QStandardPaths>

#include "trajectory/files/trajectory_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::app {

QString TrainingResults::file() const {
  if (!path_.isEmpty()) return path_;
  static const QRegularExpression kOdd(QStringLiteral("[^\\w.-]+"));
  const QString folder =
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/training");
  const QString name = trainee_.isEmpty() ? QObject::tr("trainee") : trainee_;
  const QString exercise = QString::fromStdString(exercise_);
  return QDir(folder).filePath(QString(name + '-' + exercise).replace(kOdd, QStringLiteral("-")) +
                               QStringLiteral(".htrain"));
}

Expected<void> TrainingResults::load(const QString& trainee, const std::string& exercise) {
  trainee_ = trainee;
  exercise_ = exercise;
  session_ = {trainee.toStdString(), exercise, {}};
  if (exercise.empty() || !QFileInfo::exists(file())) return {};
  auto kept = trajectory::readTraining(file().toStdString());
  HAPTICELL_TRY(kept);
  session_ = std::move(*kept);
  return {};
}

Expected<void> TrainingResults::keep() const {
  const QString path = file();
  QDir().mkpath(QFileInfo(path).path());
  return workcell::writeFileAtomically(path.toStdString(), trajectory::toJsonText(session_));
}

Expected<std::string> TrainingResults::keepRun(const trajectory::Trajectory& run) const {
  const QFileInfo results(file());
  const QString folder = results.completeBaseName() + QStringLiteral("-runs");
  QDir().mkpath(results.dir().filePath(folder));
  QString name;
  for (std::size_t k = session_.attempts.size() + 1; name.isEmpty() || QFileInfo::exists(results.dir().filePath(name));
       ++k)
    name = QStringLiteral("%1/%2.htraj").arg(folder).arg(k);
  HAPTICELL_TRY(workcell::writeFileAtomically(results.dir().filePath(name).toStdString(), trajectory::toJsonText(run)));
  return name.toStdString();
}

Expected<trajectory::Trajectory> TrainingResults::readRun(std::size_t attempt) const {
  const QString name = QString::fromStdString(session_.attempts[attempt].recording);
  return trajectory::readTrajectory(QFileInfo(file()).dir().filePath(name).toStdString());
}

}  // namespace hapticell::app
