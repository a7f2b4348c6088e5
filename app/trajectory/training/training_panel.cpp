// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/training/training_panel.h"

#include <QDateTime>
#include <QFileInfo>
#include <QLineEdit>
#include <QTimer>
#include <QVBoxLayout>

#include "app/controls/refresh_timer.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/style/library_text.h"
#include "app/style/value_field.h"
#include "app/trajectory/motions/motion_list.h"
#include "app/trajectory/training/exercise_editor.h"
#include "app/trajectory/training/exercise_files.h"
#include "app/trajectory/training/exercise_section.h"
#include "app/trajectory/training/results_section.h"
#include "app/trajectory/training/run_section.h"
#include "app/trajectory/training/training_play.h"
#include "app/trajectory/training/training_report.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::app {

TrainingPanel::TrainingPanel(Host& host, MotionList& list, QWidget* parent)
    : QWidget(parent), host_(host), list_(list), play_(new TrainingPlay(host, this)) {
  setMinimumWidth(320);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addExercise(*column);
  addTrainee(*column);
  addRun(*column);
  addResults(*column);
  column->addStretch(1);
  connect(&list_, &MotionList::currentChanged, this, &TrainingPanel::show);
  connect(play_, &TrainingPlay::ended, this, &TrainingPanel::show);
  connect(&host_.documentModel(), &DocumentModel::trialEnded, this, &TrainingPanel::giveUp);
  show();
}

TrainingPanel::~TrainingPanel() = default;

void TrainingPanel::addExercise(QVBoxLayout& column) {
  exercises_ = new ExerciseSection(column, this);
  connect(exercises_, &ExerciseSection::chosen, this, &TrainingPanel::openExercise);
  connect(exercises_, &ExerciseSection::playWanted, this, [this] { play_->isPlaying() ? play_->stop() : play({}); });
  connect(exercises_, &ExerciseSection::newWanted, this, [this] { editExercise(true); });
  connect(exercises_, &ExerciseSection::editWanted, this, [this] { editExercise(false); });
  connect(exercises_, &ExerciseSection::teachWanted, this, &TrainingPanel::useCurrentMotion);
}

void TrainingPanel::addTrainee(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Trainee"));
  trainee_ = new QLineEdit;
  trainee_->setObjectName("editTrainee");
  trainee_->setPlaceholderText(tr("name"));
  addRow(*section, tr("Name"), trainee_);
  radius_ = new ValueField({tr("mm"), 1, 0.1, 1000, 1});
  radius_->setObjectName("fieldTube");
  radius_->setValue(20);
  addRow(*section, tr("Tube"), radius_);
  help_ = new ValueField({QStringLiteral("%"), 0, 0, 100, 10});
  help_->setObjectName("fieldHelp");
  help_->setValue(100);
  addRow(*section, tr("Guidance"), help_);
  connect(trainee_, &QLineEdit::editingFinished, this, &TrainingPanel::loadResults);
  connect(radius_, &ValueField::edited, this, [this](double mm) {
    if (exercise_) exercise_->tube_radius = 1e-3 * mm;
  });
}

void TrainingPanel::addRun(QVBoxLayout& column) {
  runs_ = new RunSection(host_, column, this);
  connect(runs_, &RunSection::kindChosen, this, &TrainingPanel::show);
  connect(runs_, &RunSection::startClicked, this, [this] {
    if (run_) return endRun();
    if (runs_->forcesAreOff()) switchForcesOn();
    start();
  });
  connect(runs_, &RunSection::startWithoutForces, this, &TrainingPanel::start);
  // The forces go on and off without a word to panels.
  connect(&refreshTimer(host_), &QTimer::timeout, this, [this] {
    if (isSeen(*this)) runs_->showForces();
  });
}

void TrainingPanel::addResults(QVBoxLayout& column) {
  shown_results_ = new ResultsSection(column, this);
  connect(shown_results_, &ResultsSection::replayWanted, this, &TrainingPanel::replayRun);
  connect(shown_results_, &ResultsSection::runChosen, this, &TrainingPanel::show);
  connect(shown_results_, &ResultsSection::exportWanted, this, &TrainingPanel::exportResults);
}

void TrainingPanel::setExercises(const QString& folder) {
  exercises_->setFolder(folder);
  exercises_->fill(exercise_file_);
}

void TrainingPanel::openResults(const QString& path) {
  const auto session = trajectory::readTraining(path.toStdString());
  QString exercise, why = session ? QString() : shownText(session.error());
  if (session) {
    for (const auto& file : exercisesWith(QFileInfo(path).absolutePath())) {
      const auto read = manipulation::readExercise(file);
      if (read && read->name == session->exercise) exercise = QString::fromStdString(file.string());
    }
    const Error missing{.file = path.toStdString(),
                        .found = Text("the exercise '%1' of these results was not found", session->exercise),
                        .expected = "its *.hexercise file in the same folder"};
    if (exercise.isEmpty()) why = shownText(missing);
  }
  if (!why.isEmpty()) {
    host_.messages().tell(Severity::kWarning, tr("The exercise cannot be opened"), why);
    return say(why, true);
  }
  trainee_->setText(QString::fromStdString(session->trainee));
  setResults(path);
  openExercise(exercise);
}

bool TrainingPanel::openExercise(const QString& path) {
  const auto exercise = manipulation::readExercise(path.toStdString());
  auto expert = exercise ? trajectory::readTrajectory(exercise->recording)
                         : Expected<trajectory::Trajectory>(makeError(exercise.error()));
  if (!expert || expert->empty()) {
    const QString why = expert ? tr("The expert's recording has no frames.") : shownText(expert.error());
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
  auto* editor = new ExerciseEditor(host_, list_, exercises_->folder(), &host_.window());
  if (!fresh && exercise_) editor->edit(exercise_file_, *exercise_, expert_);
  connect(editor, &ExerciseEditor::saved, this, [this](const QString& file) {
    exercise_file_ = file;
    exercises_->fill(exercise_file_);
    if (openExercise(file)) say(tr("The exercise is saved."), false);
  });
  editor->show();
}

void TrainingPanel::play(const trajectory::Trajectory& run) {
  const auto& snapshot = host_.snapshot();
  if (snapshot && snapshot->stylus.held != 0) return say(tr("Release what is held first."), true);
  emit sceneWanted();
  const auto played = play_->play(expert_, run);
  if (!played) say(shownText(played.error()), true);
  show();
}

void TrainingPanel::replayRun() {
  const auto run = results_.readRun(shown_results_->chosenRun());
  if (!run) return say(shownText(run.error()), true);
  play(*run);
}

void TrainingPanel::setResults(const QString& path) {
  results_.setPath(path);
  loadResults();
}

void TrainingPanel::loadResults() {
  if (run_) return;
  const auto read = results_.load(trainee_->text().trimmed(), exercise_ ? exercise_->name : std::string());
  if (!read) say(shownText(read.error()), true);
  help_->setValue(100.0 * results_.session().nextHelp());
  shown_results_->fillRuns(results_.session());
  show();
}

void TrainingPanel::exportResults() {
  const QString path =
      askToSave(&host_.window(), tr("Export results"), tr("results.pdf"), tr("PDF (*.pdf);;Table (*.csv)"));
  if (path.isEmpty()) return;
  const auto written = writeTrainingReport(path, results_.session(), neededPoints());
  say(written ? tr("Saved: %1").arg(QFileInfo(path).fileName()) : shownText(written.error()), !written);
}

double TrainingPanel::neededPoints() const {
  // Of 100: the score that passes where an exercise says nothing; our choice. Half, twice: runs pass more or less
  // readily.
  constexpr double kUsualPass = 60.0;
  return exercise_ ? exercise_->pass : kUsualPass;
}

std::string TrainingPanel::nowText() {
  return QDateTime::currentDateTime().toTimeSpec(Qt::OffsetFromUTC).toString(Qt::ISODate).toStdString();
}

bool TrainingPanel::isLed() const {
  return run_ && runs_->kind() == trajectory::RunKind::kPractice;
}

void TrainingPanel::say(const QString& line, bool careful) {
  note_ = line;
  emit told(line, careful);
  show();
}

void TrainingPanel::show() {
  const Motion* motion = list_.current();
  const bool has_motion = motion && motion->trajectory && motion->trajectory->size() > 1;
  const bool is_running = run_ != nullptr;
  exercises_->show({&exercise_, is_running, play_->isPlaying(), has_motion});
  trainee_->setEnabled(!is_running);
  radius_->setEnabled(!is_running);
  help_->setEnabled(!is_running && runs_->kind() == trajectory::RunKind::kPractice);
  runs_->show({is_running, exercise_.has_value(), note_, run_ ? run_->share() : 0.0});
  runs_->showKind(results_.session(), nowText());
  shown_results_->show(results_.session(), exercise_ && !is_running, neededPoints());
}

}  // namespace hapticell::app
