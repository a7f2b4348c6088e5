// SPDX-License-Identifier: Apache-2.0
// The run: what it needs before it begins, what happens in it, how it ends.
#include <QAction>

#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/recording_hub.h"
#include "app/host/selection.h"
#include "app/style/library_text.h"
#include "app/style/value_field.h"
#include "app/trajectory/training/exercise_section.h"
#include "app/trajectory/training/results_section.h"
#include "app/trajectory/training/run_section.h"
#include "app/trajectory/training/training_panel.h"
#include "app/trajectory/training/training_play.h"
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

}  // namespace

void TrainingPanel::switchForcesOn() {
  if (auto* action = host_.window().findChild<QAction*>("actionForcesOn")) action->trigger();
}

/// The part where the expert began. From here on what is moved is only tried.
bool TrainingPanel::placeAtBeginning() {
  DocumentModel& cell = host_.documentModel();
  const auto replay = manipulation::MotionReplay::create(cell.document().state().entities, expert_.entity,
                                                         std::make_shared<const trajectory::Trajectory>(expert_));
  if (!replay) {
    say(shownText(replay.error()), true);
    return false;
  }
  if (const auto& snapshot = host_.snapshot(); snapshot && snapshot->stylus.held != 0) {
    say(tr("Release what is held first, then start the run."), true);
    return false;
  }
  cell.beginTrial();
  const auto at = replay->at(expert_[0].t);
  if (cell.execute(workcell::SetConfiguration{replay->entity(), at.X_WE, at.joints})) return true;
  cell.endTrial();
  return false;
}

/// Points without guidance prove something only where it is known what was practised.
bool TrainingPanel::mayStart() {
  const auto practised = results_.session().count(trajectory::RunKind::kPractice);
  if (runs_->kind() == trajectory::RunKind::kRetention && practised == 0) {
    say(tr("Nothing has been practised yet. Practise first."), true);
    return false;
  }
  if (runs_->kind() == trajectory::RunKind::kTransfer && practised > 0) {
    say(tr("This exercise was practised. Choose Retention here, or test transfer on another exercise."), true);
    return false;
  }
  return true;
}

void TrainingPanel::start() {
  if (!exercise_ || !mayStart()) return;
  play_->stop();
  emit sceneWanted();
  note_.clear();
  const workcell::Entity* entity = host_.documentModel().document().findByName(expert_.entity);
  if (!entity) {
    say(tr("%1 is not in this cell.").arg(QString::fromStdString(expert_.entity)), true);
    return;
  }
  if (!placeAtBeginning()) return;
  // What the stylus's button takes, by the frame that the guide leads.
  host_.selection().set(entity->id);
  if (const auto way = manipulation::parseMovedBy(expert_.moved)) host_.holdChoice().set(*way);
  run_ = std::make_unique<manipulation::TrainingRun>(
      *exercise_, expert_, runs_->kind() == trajectory::RunKind::kPractice ? 0.01 * help_->value() : 0.0);
  manipulation::command::StartRecording wanted;
  wanted.take = tr("Run %1").arg(results_.session().attempts.size() + 1).toStdString();
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
    say(tr("The run has no frames. Hold the part with the stylus and move it."), true);
    return show();
  }
  attempt.kind = runs_->kind();
  auto kept = results_.keepRun(run);
  if (!kept) host_.messages().reportCause(Severity::kWarning, tr("The run cannot be replayed later"), kept.error());
  attempt.recording = kept.value_or(std::string());
  results_.session().attempts.push_back(attempt);
  if (const auto written = results_.keep(); !written)
    host_.messages().reportCause(Severity::kWarning, tr("The result was not saved"), written.error());
  help_->setValue(100.0 * results_.session().nextHelp());
  shown_results_->fillRuns(results_.session());
  say(attempt.success ? tr("Passed with %1 points").arg(attempt.score.points, 0, 'f', 0)
                      : tr("%1 points. To pass: %2 points and the whole path")
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
  exercises_->chooseNone();
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
  say(tr("The cell was changed or saved, so the run was cancelled. The part is back in its place."), true);
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
