// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/training/results_section.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/kit/form.h"
#include "app/style/units.h"
#include "app/trajectory/training/progress_plot.h"
#include "app/trajectory/training/training_words.h"

namespace hapticell::app {
namespace {

QLabel* resultLine(const char* name, int lines, TextRole role, bool quiet) {
  auto* label = makeLive(lines, role, quiet);
  label->setObjectName(name);
  return label;
}

}  // namespace

ResultsSection::ResultsSection(QVBoxLayout& column, QObject* parent) : QObject(parent) {
  QVBoxLayout* section = addSection(column, tr("Results"));
  score_ = resultLine("labelScore", 4, TextRole::kSecond, false);
  section->addWidget(score_);
  unaided_ = resultLine("labelUnaided", 2, TextRole::kSecond, false);
  section->addWidget(unaided_);
  plot_ = new ProgressPlot;
  section->addWidget(plot_);
  auto* legend = resultLine("labelLegend", 2, TextRole::kSecond, true);
  legend->setText(tr("Bars: points of each run, hatched if not passed; runs without guidance apart. Line: guidance."));
  section->addWidget(legend);
  runs_ = new QComboBox;
  runs_->setObjectName("comboRuns");
  addRow(*section, tr("Run"), runs_);
  replay_ = new QPushButton(tr("Replay beside the expert"));
  replay_->setObjectName("buttonReplayRun");
  replay_->setToolTip(tr("The part follows the run and a ghost follows the expert, both at once"));
  section->addWidget(replay_);
  connect(replay_, &QPushButton::clicked, this, &ResultsSection::replayWanted);
  connect(runs_, &QComboBox::currentIndexChanged, this, &ResultsSection::runChosen);
  export_ = new QPushButton(tr("Export results…"));
  export_->setObjectName("buttonExportResults");
  section->addWidget(export_);
  connect(export_, &QPushButton::clicked, this, &ResultsSection::exportWanted);
}

void ResultsSection::fillRuns(const trajectory::TrainingSession& session) {
  const QSignalBlocker quiet(runs_);
  runs_->clear();
  for (std::size_t i = session.attempts.size(); i-- > 0;) {
    const auto& attempt = session.attempts[i];
    runs_->addItem(
        tr("%1 · %2 · %3 points").arg(i + 1).arg(runKindName(attempt.kind)).arg(attempt.score.points, 0, 'f', 0),
        static_cast<int>(i));
  }
}

std::size_t ResultsSection::chosenRun() const {
  return static_cast<std::size_t>(runs_->currentData().toInt());
}

void ResultsSection::show(const trajectory::TrainingSession& session, bool may_replay, double pass) {
  export_->setEnabled(!session.attempts.empty());
  unaided_->setText(unaidedText(session));
  replay_->setEnabled(may_replay && runs_->count() > 0 && !session.attempts[chosenRun()].recording.empty());
  plot_->setAttempts(session.attempts, pass);
  if (session.attempts.empty()) {
    score_->setText(tr("No run yet"));
    return;
  }
  const auto& last = session.attempts.back();
  score_->setText(tr("Last run: %1 points. %2 s (expert %3 s), %4 off the path, at most %5 N, contacts: %7, "
                     "smoothness %6 % of the expert's.")
                      .arg(last.score.points, 0, 'f', 0)
                      .arg(last.score.time, 0, 'f', 1)
                      .arg(last.score.expert_time, 0, 'f', 1)
                      .arg(lengthText(last.score.mean_deviation))
                      .arg(last.score.max_force, 0, 'f', 1)
                      .arg(smoothnessPercent(last.score))
                      .arg(last.score.contacts));
}

}  // namespace hapticell::app
