// SPDX-License-Identifier: Apache-2.0
// The run: what it needs before it begins, what happens in it, how it ends.
#include <QAction>
#include <QComboBox>
#include <QDateTime>
#include <QLabel>
#include <QPushButton>

#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/recording_hub.h"
#include "app/host/selection.h"
#include "app/style/value_field.h"
#include "app/trajectory/training/training_panel.h"
#include "app/trajectory/training/training_play.h"
#include "app/trajectory/training/training_words.h"
#include "manipulation/checks/motion_replay.h"

namespace hapticell::app {
namespace {

/// The run by the frame that the expert's is of: what is moved without a stylus is recorded by its origin.
trajectory::Trajectory asTheExpert(const std::vector<std::shared_ptr<const workcell::Entity>>& entities,
                                   const trajectory::Trajectory& expert, const trajectory::Trajectory& run) {
  if (run.moved == expert.moved || run.empty()) return run;
  const auto replay = [&](const trajectory::Trajectory& motion) {
    return manipulation::MotionReplay::create(entities, expert.entity,
                                              std::make_shared<const trajectory::Trajectory>(motion));
  };
  const auto theirs = replay(expert), mine = replay(run);
  if (!theirs || !mine) return run;
  trajectory::Trajectory seen = run.emptyRecording();
  seen.moved = expert.moved;
  seen.touches = run.touches;
  for (std::size_t i = 0; i < run.size(); ++i) {
    trajectory::Trajectory::Frame frame = run[i];
    frame.X_WT = theirs->movedFrame(mine->at(frame.t));
    seen.addFrame(frame, run.joints(i), run.channels(i));
  }
  return seen;
}

std::string nowText() {
  return QDateTime::currentDateTime().toTimeSpec(Qt::OffsetFromUTC).toString(Qt::ISODate).toStdString();
}

}  // namespace

bool TrainingPanel::forcesAreOff() const {
  const auto& snapshot = host_.snapshot();
  return snapshot && snapshot->connected && !snapshot->forces_on;
}

void TrainingPanel::switchForcesOn() {
  if (auto* action = host_.window().findChild<QAction*>("actionForcesOn")) action->trigger();
}

void TrainingPanel::showForces() {
  const auto& snapshot = host_.snapshot();
  const bool off = forcesAreOff();
  const QString words = !snapshot || !snapshot->connected ? tr("No stylus is connected: the guide is seen, not felt.")
                        : !off                            ? tr("Forces are on.")
                        : run_                            ? tr("Forces are off: the guide is not felt.")
                                                          : tr("Forces are off. Without them the guide is not felt.");
  if (words != forces_->text()) forces_->setText(words);
  start_->setEnabled(exercise_.has_value());
  start_->setText(run_ ? tr("End the run") : off ? tr("Forces on and start") : tr("Start the run"));
  without_->setEnabled(exercise_ && !run_ && off);
}

/// The part where the expert began. From here on what is moved is only tried.
bool TrainingPanel::placeAtBeginning() {
  DocumentModel& cell = host_.documentModel();
  const auto replay = manipulation::MotionReplay::create(cell.document().state().entities, expert_.entity,
                                                         std::make_shared<const trajectory::Trajectory>(expert_));
  if (!replay) {
    say(QString::fromStdString(replay.error().message()), true);
    return false;
  }
  if (const auto& snapshot = host_.snapshot(); snapshot && snapshot->held != 0) {
    say(tr("Let go of what is held first; then start the run."), true);
    return false;
  }
  cell.beginTrial();
  const auto at = replay->at(expert_[0].t);
  if (cell.execute(workcell::SetConfiguration{replay->entity(), at.X_WE, at.joints})) return true;
  cell.endTrial();
  return false;
}

trajectory::RunKind TrainingPanel::kind() const {
  return static_cast<trajectory::RunKind>(std::max(0, kind_->currentIndex()));
}

void TrainingPanel::say(const QString& line, bool careful) {
  note_ = line;
  emit told(line, careful);
  show();
}

/// Points without guidance prove something only where it is known what was practised.
bool TrainingPanel::mayStart() {
  const auto practised = session_.count(trajectory::RunKind::kPractice);
  if (kind() == trajectory::RunKind::kRetention && practised == 0) {
    say(tr("There is no practice yet that could be retained: practise first."), true);
    return false;
  }
  if (kind() == trajectory::RunKind::kTransfer && practised > 0) {
    say(tr("This exercise was practised: transfer is shown at another one, here choose Retention."), true);
    return false;
  }
  return true;
}

void TrainingPanel::showKind() {
  const auto rest = session_.restBefore(nowText());
  switch (kind()) {
    case trajectory::RunKind::kPractice:
      return help_label_->setText(
          tr("Help fades by a fifth with each success, to nothing; after two failures it grows again."));
    case trajectory::RunKind::kRetention:
      return help_label_->setText(
          rest ? tr("Without guidance, a day and a week after practice. Last practice: %1 ago.").arg(restText(*rest))
               : tr("Without guidance, a day and a week after practice."));
    case trajectory::RunKind::kTransfer:
      return help_label_->setText(tr("Without guidance, at an exercise that was not practised."));
  }
}

void TrainingPanel::start() {
  if (!exercise_ || !mayStart()) return;
  play_->stop();
  emit sceneWanted();
  note_.clear();
  const workcell::Entity* entity = host_.documentModel().document().findByName(expert_.entity);
  if (!entity) {
    say(tr("There is no %1 in this cell.").arg(QString::fromStdString(expert_.entity)), true);
    return;
  }
  if (!placeAtBeginning()) return;
  // What the stylus's button takes, by the frame that the guide leads.
  host_.selection().set(entity->id);
  if (const auto way = manipulation::parseMovedBy(expert_.moved)) host_.holdChoice().set(*way);
  run_ = std::make_unique<manipulation::TrainingRun>(
      *exercise_, expert_, kind() == trajectory::RunKind::kPractice ? 0.01 * help_->value() : 0.0);
  manipulation::command::StartRecording wanted;
  wanted.take = tr("Run %1").arg(session_.attempts.size() + 1).toStdString();
  host_.recording().start(wanted);
  emit runStarted(expert_);
  showGuide();
  show();
}

void TrainingPanel::follow(const Pose& X_WM) {
  if (!run_) return;
  run_->follow(X_WM);
  showGuide();
  show();
  if (run_->isDone()) endRun();
}

/// What is held is let go first, so that where it was left is known when the recording comes.
void TrainingPanel::endRun() {
  if (!host_.recording().isRecording()) return;  // It ends already: what was recorded is on its way.
  host_.holdChoice().letGo();
  host_.recording().stop();
}

void TrainingPanel::showGuide() {
  if (!run_) return emit guideChanged(std::nullopt);
  emit guideChanged(run_->guide());
}

bool TrainingPanel::takeRecorded(const std::vector<trajectory::Trajectory>& recorded) {
  if (!run_) return false;
  trajectory::Trajectory mine = expert_.emptyCopy();
  for (const trajectory::Trajectory& one : recorded)
    if (one.entity == expert_.entity)
      mine = asTheExpert(host_.documentModel().document().state().entities, expert_, one);
  finish(mine);
  return true;
}

void TrainingPanel::finish(const trajectory::Trajectory& run) {
  auto attempt = run_->finish(run, nowText());
  dropRun();
  if (run.empty()) {
    say(tr("The run has no frames: take the part with the stylus and move it."), true);
    return show();
  }
  attempt.kind = kind();
  attempt.recording = keepRun(run);
  session_.attempts.push_back(attempt);
  keepResults();
  help_->setValue(100.0 * session_.nextHelp());
  fillRuns();
  say(attempt.success ? tr("Passed with %1 points").arg(attempt.score.points, 0, 'f', 0)
                      : tr("%1 points; %2 are needed and the whole way")
                            .arg(attempt.score.points, 0, 'f', 0)
                            .arg(exercise_->pass, 0, 'f', 0),
      !attempt.success);
  show();
}

void TrainingPanel::forgetCell() {
  dropRun();
  if (cell_wanted_) return show();
  exercise_.reset();
  exercise_file_.clear();
  note_.clear();
  expert_ = {};
  exercises_->setCurrentIndex(0);
  loadResults();
}

void TrainingPanel::cancel() {
  if (!run_) return;
  host_.recording().abandon();
  dropRun();
}

void TrainingPanel::giveUp() {
  if (!run_) return;
  cancel();
  say(tr("The cell was changed or saved, so the run was given up. The part stands where it stood before."), true);
  show();
}

/// Without a score; the part goes back to where it stood before.
void TrainingPanel::dropRun() {
  if (!run_) return;
  run_.reset();
  host_.documentModel().endTrial();
  showGuide();
  emit runEnded();
}

}  // namespace hapticell::app
