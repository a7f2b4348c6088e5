// SPDX-License-Identifier: Apache-2.0
// Exercises: which there are, chosen, made and changed; the expert's motion and the runs played.
#include <QComboBox>
#include <QDir>
#include <QFileInfo>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/file_dialog.h"
#include "app/style/value_field.h"
#include "app/trajectory/training/exercise_editor.h"
#include "app/trajectory/training/exercise_files.h"
#include "app/trajectory/motions/motion_list.h"
#include "app/trajectory/training/training_panel.h"
#include "app/trajectory/training/training_play.h"
#include "app/trajectory/training/training_words.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::app {

void TrainingPanel::setExercises(const QString& folder) {
  own_folder_ = folder;
  fillExercises();
}

void TrainingPanel::fillExercises() {
  const QSignalBlocker quiet(exercises_);
  exercises_->clear();
  exercises_->addItem(tr("Choose an exercise"), QString());
  for (const auto& file : exercisesWith(own_folder_))
    if (const auto exercise = manipulation::readExercise(file))
      exercises_->addItem(QString::fromStdString(exercise->name), QString::fromStdString(file.string()));
  exercises_->addItem(tr("From a file…"), QStringLiteral("?"));
  exercises_->setCurrentIndex(std::max(0, exercise_file_.isEmpty() ? 0 : exercises_->findData(exercise_file_)));
}

void TrainingPanel::chooseExercise(int index) {
  QString path = exercises_->itemData(index).toString();
  if (path == QStringLiteral("?"))
    path = askToOpen(&host_.window(), tr("Open an exercise"), {}, tr("Exercises (*.hexercise)"));
  if (!path.isEmpty()) openExercise(path);
}

bool TrainingPanel::openExercise(const QString& path) {
  const auto exercise = manipulation::readExercise(path.toStdString());
  auto expert = exercise ? trajectory::readTrajectory(exercise->recording)
                         : Expected<trajectory::Trajectory>(makeError(exercise.error()));
  if (!expert || expert->empty()) {
    const QString why =
        expert ? tr("The expert's recording has no frames.") : QString::fromStdString(expert.error().message());
    host_.messages().tell(Severity::kWarning, tr("The exercise cannot be opened"), why);
    say(why, true);
    return false;
  }
  setExercise(*exercise, std::move(*expert));
  exercise_file_ = path;
  show();
  cell_wanted_ = true;
  emit cellWanted(QString::fromStdString(exercise->workcell.string()));
  return true;
}

void TrainingPanel::useCurrentMotion() {
  const Motion* motion = list_.current();
  if (!motion || !motion->trajectory || motion->trajectory->size() < 2) return;
  manipulation::Exercise exercise;
  exercise.name = motion->name;
  exercise.text = tr("Follow %1.").arg(QString::fromStdString(motion->name)).toStdString();
  exercise.workcell = host_.documentModel().origin();
  exercise.recording = motion->path;
  setExercise(exercise, *motion->trajectory);
}

void TrainingPanel::setExercise(const manipulation::Exercise& exercise, trajectory::Trajectory expert) {
  cancel();
  play_->stop();
  note_.clear();
  exercise_file_.clear();
  exercise_ = exercise;
  expert_ = std::move(expert);
  radius_->setValue(1e3 * exercise.tube_radius);
  loadResults();
}

void TrainingPanel::cellCame(const QString& problem) {
  cell_wanted_ = false;
  if (!problem.isEmpty()) say(problem, true);
}

void TrainingPanel::editExercise(bool fresh) {
  auto* editor = new ExerciseEditor(host_, list_, own_folder_, &host_.window());
  if (!fresh && exercise_) editor->edit(exercise_file_, *exercise_, expert_);
  connect(editor, &ExerciseEditor::saved, this, [this](const QString& file) {
    exercise_file_ = file;
    fillExercises();
    if (openExercise(file)) say(tr("The exercise is saved."), false);
  });
  editor->show();
}

void TrainingPanel::play(const trajectory::Trajectory& run) {
  const auto& snapshot = host_.snapshot();
  if (snapshot && snapshot->held != 0) return say(tr("Let go of what is held first."), true);
  emit sceneWanted();
  const auto played = play_->play(expert_, run);
  if (!played) say(QString::fromStdString(played.error().message()), true);
  show();
}

void TrainingPanel::fillRuns() {
  const QSignalBlocker quiet(runs_);
  runs_->clear();
  for (std::size_t i = session_.attempts.size(); i-- > 0;) {
    const auto& attempt = session_.attempts[i];
    runs_->addItem(
        tr("%1 · %2 · %3 points").arg(i + 1).arg(runKindName(attempt.kind)).arg(attempt.score.points, 0, 'f', 0),
        static_cast<int>(i));
  }
}

void TrainingPanel::replayRun() {
  const auto& attempt = session_.attempts[static_cast<std::size_t>(runs_->currentData().toInt())];
  const QString file = QFileInfo(resultsFile()).dir().filePath(QString::fromStdString(attempt.recording));
  const auto run = trajectory::readTrajectory(file.toStdString());
  if (!run) return say(QString::fromStdString(run.error().message()), true);
  play(*run);
}

/// Beside the results; the name relative to them. Empty, and told, where it cannot be written.
std::string TrainingPanel::keepRun(const trajectory::Trajectory& run) {
  const QFileInfo results(resultsFile());
  const QString folder = results.completeBaseName() + QStringLiteral("-runs");
  QDir().mkpath(results.dir().filePath(folder));
  QString name;
  for (std::size_t k = session_.attempts.size() + 1; name.isEmpty() || QFileInfo::exists(results.dir().filePath(name));
       ++k)
    name = QStringLiteral("%1/%2.htraj").arg(folder).arg(k);
  const auto written =
      workcell::writeFileAtomically(results.dir().filePath(name).toStdString(), trajectory::toJsonText(run));
  if (written) return name.toStdString();
  host_.messages().tell(Severity::kWarning, tr("The run cannot be replayed later"),
                        QString::fromStdString(written.error().message()));
  return {};
}

}  // namespace hapticell::app
