// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/training/exercise_files.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>

#include "config/configuration.h"
#include "trajectory/checks/motion_promises.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::app {

namespace fs = std::filesystem;

QString ownExercisesFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/exercises");
}

std::vector<fs::path> exercisesWith(const QString& folder) {
  std::vector<fs::path> files;
  const auto add = [&](const fs::path& place) {
    for (const fs::path& file : manipulation::exercisesIn(place))
      if (manipulation::readExercise(file)) files.push_back(file);
  };
  if (const auto shipped = config::findShippedFile("exercises")) add(*shipped);
  add(folder.toStdString());
  return files;
}

bool isOwnExercise(const QString& file, const QString& folder) {
  return !file.isEmpty() && QFileInfo(file).absolutePath() == QDir(folder).absolutePath();
}

QString newExerciseFile(const QString& name, const QString& folder) {
  static const QRegularExpression kNotInFileNames(QStringLiteral("[^\\w.-]+"),
                                                  QRegularExpression::UseUnicodePropertiesOption);
  const QString stem = QString(name).replace(kNotInFileNames, QStringLiteral("-"));
  QString file = QDir(folder).filePath(stem + QStringLiteral(".hexercise"));
  for (int k = 2; QFileInfo::exists(file); ++k)
    file = QDir(folder).filePath(QStringLiteral("%1-%2.hexercise").arg(stem).arg(k));
  return file;
}

namespace {

/// The recording that trainees are measured against: every frame where the expert was.
Expected<void> writeRecording(const trajectory::Trajectory& expert, const fs::path& place) {
  return workcell::writeFileChecked(place, trajectory::toJsonText(expert), [&](const fs::path& file) -> Expected<void> {
    // s: copied times but for rounding. Half, twice: no effect.
    constexpr double kSameTime = 1e-9;
    const auto promises = trajectory_checks::copyPromises(expert, true, kSameTime, file);
    HAPTICELL_TRY(promises);
    if (promises->areKept()) return {};
    return makeError(promises->missed(place.string()));
  });
}

}  // namespace

Expected<void> saveExercise(manipulation::Exercise exercise, const trajectory::Trajectory& expert,
                            const QString& file) {
  const QFileInfo info(file);
  const QDir folder = info.absoluteDir();
  QDir().mkpath(folder.path());
  // Never over the recording that the exercise of before names: a name of its own each time.
  QString recording = folder.filePath(info.completeBaseName() + QStringLiteral("-expert.htraj"));
  for (int k = 2; QFileInfo::exists(recording); ++k)
    recording = folder.filePath(QStringLiteral("%1-expert-%2.htraj").arg(info.completeBaseName()).arg(k));
  const QString named = QString::fromStdString(exercise.recording.string());
  const bool keeps = !named.isEmpty() && QFileInfo(named).absolutePath() == folder.absolutePath();
  if (!keeps) {
    exercise.recording = recording.toStdString();
    const auto written = writeRecording(expert, exercise.recording);
    HAPTICELL_TRY(written);
  }
  const std::string text = manipulation::exerciseText(exercise, folder.absolutePath().toStdString());
  const auto written = workcell::writeFileChecked(
      file.toStdString(), text, [&](const fs::path& aside) { return manipulation::checkExercise(exercise, aside); });
  std::error_code ignored;
  if (!written && !keeps) fs::remove(exercise.recording, ignored);
  return written;
}

}  // namespace hapticell::app
