// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/training/training_panel.h"

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTimer>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/recording_hub.h"
#include "app/kit/form.h"
#include "app/controls/refresh_timer.h"
#include "app/kit/file_dialog.h"
#include "app/style/theme.h"
#include "app/style/units.h"
#include "app/style/value_field.h"
#include "app/trajectory/training/exercise_files.h"
#include "app/trajectory/motions/motion_list.h"
#include "app/trajectory/training/progress_plot.h"
#include "app/trajectory/training/training_play.h"
#include "app/trajectory/training/training_report.h"
#include "app/trajectory/training/training_words.h"
#include "app/viewport/widget/viewport_widget.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::app {
namespace {

QLabel* said(const char* name, int lines, TextRole role, bool quiet) {
  auto* label = makeLive(lines, role, quiet);
  label->setObjectName(name);
  return label;
}

}  // namespace

TrainingPanel::TrainingPanel(Host& host, MotionList& list, QWidget* parent)
    : QWidget(parent),
      host_(host),
      list_(list),
      own_folder_(ownExercisesFolder()),
      play_(new TrainingPlay(host, this)) {
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
  QVBoxLayout* section = addSection(column, tr("Exercise"));
  exercises_ = new QComboBox;
  exercises_->setObjectName("comboExercise");
  fillExercises();
  addRow(*section, tr("Exercise"), exercises_);
  text_ = said("labelExercise", 4, TextRole::kText, false);
  section->addWidget(text_);
  show_me_ = new QPushButton(tr("Show me"));
  show_me_->setObjectName("buttonShowMe");
  show_me_->setToolTip(tr("The part goes the expert's way; the cell stays as it is"));
  new_ = new QPushButton(tr("New…"));
  new_->setObjectName("buttonNewExercise");
  new_->setToolTip(tr("An exercise of this cell and an expert's motion in it"));
  edit_ = new QPushButton(tr("Edit…"));
  edit_->setObjectName("buttonEditExercise");
  edit_->setToolTip(tr("Name, task, guidance; of a shipped exercise a copy"));
  section->addWidget(sideBySide({show_me_, new_, edit_}));
  connect(show_me_, &QPushButton::clicked, this, [this] { play_->isPlaying() ? play_->stop() : play({}); });
  connect(new_, &QPushButton::clicked, this, [this] { editExercise(true); });
  connect(edit_, &QPushButton::clicked, this, [this] { editExercise(false); });
  use_ = new QPushButton(tr("Teach the current motion"));
  use_->setObjectName("buttonTeachMotion");
  use_->setToolTip(tr("The chosen motion becomes the expert's, in the cell as it is"));
  section->addWidget(use_);
  connect(exercises_, &QComboBox::activated, this, &TrainingPanel::chooseExercise);
  connect(use_, &QPushButton::clicked, this, &TrainingPanel::useCurrentMotion);
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
  addRow(*section, tr("Help"), help_);
  connect(trainee_, &QLineEdit::editingFinished, this, &TrainingPanel::loadResults);
  connect(radius_, &ValueField::edited, this, [this](double mm) {
    if (exercise_) exercise_->tube_radius = 1e-3 * mm;
  });
}

void TrainingPanel::addRun(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Run"));
  kind_ = new QComboBox;
  kind_->setObjectName("comboRunKind");
  for (const auto each :
       {trajectory::RunKind::kPractice, trajectory::RunKind::kRetention, trajectory::RunKind::kTransfer})
    kind_->addItem(runKindName(each));
  addRow(*section, tr("Kind"), kind_);
  help_label_ = said("labelHelp", 2, TextRole::kSecond, true);
  section->addWidget(help_label_);
  connect(kind_, &QComboBox::currentIndexChanged, this, &TrainingPanel::show);
  state_ = said("labelRun", 2, TextRole::kPanelState, false);
  section->addWidget(state_);
  way_ = new QProgressBar;
  way_->setObjectName("progressWay");
  way_->setTextVisible(false);
  way_->setFixedHeight(8);
  section->addWidget(way_);
  forces_ = said("labelForces", 2, TextRole::kSecond, false);
  section->addWidget(forces_);
  start_ = new QPushButton(tr("Start the run"));
  start_->setObjectName("buttonStartRun");
  start_->setProperty("main", true);
  without_ = new QPushButton(tr("Start without forces"));
  without_->setObjectName("buttonStartWithoutForces");
  section->addWidget(start_);
  section->addWidget(without_);
  connect(start_, &QPushButton::clicked, this, [this] {
    if (run_) return endRun();
    if (forcesAreOff()) switchForcesOn();
    start();
  });
  connect(without_, &QPushButton::clicked, this, &TrainingPanel::start);
  // The forces go on and off without a word to panels.
  connect(&refreshTimer(host_), &QTimer::timeout, this, [this] {
    if (isSeen(*this)) showForces();
  });
}

void TrainingPanel::addResults(QVBoxLayout& column) {
  QVBoxLayout* section = addSection(column, tr("Results"));
  score_ = said("labelScore", 4, TextRole::kSecond, false);
  section->addWidget(score_);
  unaided_ = said("labelUnaided", 2, TextRole::kSecond, false);
  section->addWidget(unaided_);
  plot_ = new ProgressPlot;
  section->addWidget(plot_);
  auto* legend = said("labelLegend", 2, TextRole::kSecond, true);
  legend->setText(tr("Bars: points of each run, hatched where it was not passed; without guidance apart. Line: help."));
  section->addWidget(legend);
  runs_ = new QComboBox;
  runs_->setObjectName("comboRuns");
  addRow(*section, tr("Run"), runs_);
  replay_ = new QPushButton(tr("Replay beside the expert"));
  replay_->setObjectName("buttonReplayRun");
  replay_->setToolTip(tr("The part goes the way of the run, a ghost the expert's, both at once"));
  section->addWidget(replay_);
  connect(replay_, &QPushButton::clicked, this, &TrainingPanel::replayRun);
  connect(runs_, &QComboBox::currentIndexChanged, this, &TrainingPanel::show);
  export_ = new QPushButton(tr("Export results…"));
  export_->setObjectName("buttonExportResults");
  section->addWidget(export_);
  connect(export_, &QPushButton::clicked, this, &TrainingPanel::exportResults);
}

QString TrainingPanel::resultsFile() const {
  if (!results_.isEmpty()) return results_;
  static const QRegularExpression kOdd(QStringLiteral("[^\\w.-]+"));
  const QString folder =
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/training");
  const QString name = trainee_->text().trimmed().isEmpty() ? tr("trainee") : trainee_->text().trimmed();
  const QString exercise = exercise_ ? QString::fromStdString(exercise_->name) : QString();
  return QDir(folder).filePath(QString(name + '-' + exercise).replace(kOdd, QStringLiteral("-")) +
                               QStringLiteral(".htrain"));
}

void TrainingPanel::setResults(const QString& path) {
  results_ = path;
  loadResults();
}

void TrainingPanel::loadResults() {
  if (run_) return;
  session_ = {trainee_->text().trimmed().toStdString(), exercise_ ? exercise_->name : std::string(), {}};
  if (exercise_ && QFileInfo::exists(resultsFile())) {
    auto kept = trajectory::readTraining(resultsFile().toStdString());
    if (kept)
      session_ = std::move(*kept);
    else
      say(QString::fromStdString(kept.error().message()), true);
  }
  help_->setValue(100.0 * session_.nextHelp());
  fillRuns();
  show();
}

void TrainingPanel::keepResults() {
  const QString path = resultsFile();
  QDir().mkpath(QFileInfo(path).path());
  const auto written = workcell::writeFileAtomically(path.toStdString(), trajectory::toJsonText(session_));
  if (!written)
    host_.messages().tell(Severity::kWarning, tr("The result is not kept"),
                          QString::fromStdString(written.error().message()));
}

void TrainingPanel::exportResults() {
  const QString path =
      askToSave(&host_.window(), tr("Export results"), tr("results.pdf"), tr("PDF (*.pdf);;Table (*.csv)"));
  if (path.isEmpty()) return;
  const auto written = writeTrainingReport(path, session_, exercise_ ? exercise_->pass : 60.0);
  say(written ? tr("Written: %1").arg(QFileInfo(path).fileName()) : QString::fromStdString(written.error().message()),
      !written);
}

void TrainingPanel::show() {
  const Motion* motion = list_.current();
  use_->setEnabled(!run_ && motion && motion->trajectory && motion->trajectory->size() > 1);
  show_me_->setEnabled(exercise_ && !run_);
  const bool replays = play_->isPlaying();
  show_me_->setText(replays ? tr("Stop") : tr("Show me"));
  new_->setEnabled(!run_);
  edit_->setEnabled(exercise_ && !run_);
  text_->setText(exercise_
                     ? QString::fromStdString(exercise_->text)
                     : tr("An expert's recording leads the stylus along its way; the guide waits for the trainee."));
  showForces();
  for (QWidget* widget : std::initializer_list<QWidget*>{exercises_, trainee_, radius_, kind_})
    widget->setEnabled(!run_);
  help_->setEnabled(!run_ && kind() == trajectory::RunKind::kPractice);
  showKind();
  way_->setValue(run_ ? static_cast<int>(100.0 * run_->share()) : 0);
  const auto& snapshot = host_.snapshot();
  if (run_)
    state_->setText(snapshot && snapshot->held == 0 ? tr("Take the part with the stylus")
                                                    : tr("%1 % of the way").arg(100.0 * run_->share(), 0, 'f', 0));
  else
    state_->setText(!note_.isEmpty() ? note_ : exercise_ ? tr("Ready") : tr("No exercise"));
  export_->setEnabled(!session_.attempts.empty());
  unaided_->setText(unaidedText(session_));
  const int chosen = runs_->currentData().toInt();
  replay_->setEnabled(!run_ && exercise_ && runs_->count() > 0 &&
                      !session_.attempts[std::size_t(chosen)].recording.empty());
  plot_->setAttempts(session_.attempts, exercise_ ? exercise_->pass : 60.0);
  if (session_.attempts.empty()) {
    score_->setText(tr("No run yet"));
    return;
  }
  const auto& last = session_.attempts.back();
  score_->setText(tr("Last run: %1 points. %2 s (expert %3 s), %4 off the path, at most %5 N, contacts: %8, "
                     "smoothness %6 (expert %7).")
                      .arg(last.score.points, 0, 'f', 0)
                      .arg(last.score.time, 0, 'f', 1)
                      .arg(last.score.expert_time, 0, 'f', 1)
                      .arg(lengthText(last.score.mean_deviation))
                      .arg(last.score.max_force, 0, 'f', 1)
                      .arg(last.score.smoothness, 0, 'f', 1)
                      .arg(last.score.expert_smoothness, 0, 'f', 1)
                      .arg(last.score.contacts));
}

}  // namespace hapticell::app
