// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/training/run_section.h"

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/trajectory/training/training_words.h"

namespace hapticell::app {
namespace {

QLabel* saidLine(const char* name, int lines, TextRole role, bool quiet) {
  auto* label = makeLive(lines, role, quiet);
  label->setObjectName(name);
  return label;
}

QString forcesText(bool connected, bool off, bool running) {
  if (!connected) return RunSection::tr("No stylus is connected. You see the guide but do not feel it.");
  if (!off) return RunSection::tr("Forces are on.");
  return running ? RunSection::tr("Forces are off. You do not feel the guide.")
                 : RunSection::tr("Forces are off. Without them you do not feel the guide.");
}

}  // namespace

RunSection::RunSection(Host& host, QVBoxLayout& column, QObject* parent) : QObject(parent), host_(host) {
  QVBoxLayout* section = addSection(column, tr("Run"));
  kind_ = new QComboBox;
  kind_->setObjectName("comboRunKind");
  for (const auto each :
       {trajectory::RunKind::kPractice, trajectory::RunKind::kRetention, trajectory::RunKind::kTransfer})
    kind_->addItem(runKindName(each));
  addRow(*section, tr("Type"), kind_);
  help_label_ = saidLine("labelHelp", 2, TextRole::kSecond, true);
  section->addWidget(help_label_);
  connect(kind_, &QComboBox::currentIndexChanged, this, &RunSection::kindChosen);
  state_ = saidLine("labelRun", 2, TextRole::kPanelState, false);
  section->addWidget(state_);
  way_ = new QProgressBar;
  way_->setObjectName("progressWay");
  way_->setTextVisible(false);
  way_->setFixedHeight(8);
  section->addWidget(way_);
  forces_ = saidLine("labelForces", 2, TextRole::kSecond, false);
  section->addWidget(forces_);
  start_ = new QPushButton(tr("Start the run"));
  start_->setObjectName("buttonStartRun");
  start_->setProperty("main", true);
  without_ = new QPushButton(tr("Start without forces"));
  without_->setObjectName("buttonStartWithoutForces");
  section->addWidget(start_);
  section->addWidget(without_);
  connect(start_, &QPushButton::clicked, this, &RunSection::startClicked);
  connect(without_, &QPushButton::clicked, this, &RunSection::startWithoutForces);
}

trajectory::RunKind RunSection::kind() const {
  return static_cast<trajectory::RunKind>(std::max(0, kind_->currentIndex()));
}

void RunSection::show(const State& state) {
  is_running_ = state.is_running;
  has_exercise_ = state.has_exercise;
  showForces();
  kind_->setEnabled(!is_running_);
  way_->setValue(is_running_ ? static_cast<int>(100.0 * state.share) : 0);
  const auto& snapshot = host_.snapshot();
  if (is_running_)
    state_->setText(snapshot && snapshot->stylus.held == 0
                        ? tr("Hold the part with the stylus")
                        : tr("%1 % of the path").arg(100.0 * state.share, 0, 'f', 0));
  else if (!state.note.isEmpty())
    state_->setText(state.note);
  else
    state_->setText(has_exercise_ ? tr("Ready") : tr("No exercise"));
}

bool RunSection::forcesAreOff() const {
  const auto& snapshot = host_.snapshot();
  return snapshot && snapshot->stylus.connected && !snapshot->stylus.forces_on;
}

void RunSection::showForces() {
  const auto& snapshot = host_.snapshot();
  const bool off = forcesAreOff();
  const QString words = forcesText(snapshot && snapshot->stylus.connected, off, is_running_);
  if (words != forces_->text()) forces_->setText(words);
  start_->setEnabled(has_exercise_);
  const QString start = off ? tr("Forces on and start") : tr("Start the run");
  start_->setText(is_running_ ? tr("End the run") : start);
  without_->setEnabled(has_exercise_ && !is_running_ && off);
}

void RunSection::showKind(const trajectory::TrainingSession& session, const std::string& now) {
  const auto rest = session.restBefore(now);
  switch (kind()) {
    case trajectory::RunKind::kPractice:
      return help_label_->setText(
          tr("Guidance drops by a fifth with each success, down to 0 %. After two failures it rises again."));
    case trajectory::RunKind::kRetention:
      return help_label_->setText(
          rest ? tr("Without guidance, a day and a week after practice. Last practice: %1 ago.").arg(restText(*rest))
               : tr("Without guidance, a day and a week after practice."));
    case trajectory::RunKind::kTransfer:
      return help_label_->setText(tr("Without guidance, on an exercise that was not practised."));
  }
}

}  // namespace hapticell::app
