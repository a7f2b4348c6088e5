// SPDX-License-Identifier: Apache-2.0
#include "app/studies/study_run_section.h"

#include <QFileInfo>
#include <QFontDatabase>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/form.h"
#include "app/studies/study_draft.h"
#include "app/style/library_text.h"
#include "app/style/value_field.h"

namespace hapticell::app {

StudyRunSection::StudyRunSection(Host& host, StudyDraft& draft, StudyRunner& runner, QWidget* parent)
    : QWidget(parent), host_(host), draft_(draft), runner_(runner) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  auto* line = new QHBoxLayout;
  run_ = new QPushButton(tr("Run"));
  run_->setObjectName("buttonRunStudy");
  run_->setProperty("main", true);
  stop_ = new QPushButton(tr("Stop now"));
  stop_->setObjectName("buttonStopStudy");
  cluster_ = new QPushButton(tr("Cluster"));
  cluster_->setObjectName("buttonCluster");
  cluster_->setCheckable(true);
  for (QPushButton* button : {run_, stop_, cluster_}) line->addWidget(button, 1);
  column->addLayout(line);
  bar_ = new QProgressBar;
  bar_->setTextVisible(false);
  bar_->setMaximumHeight(6);
  column->addWidget(bar_);
  says_ = makeLive(3, TextRole::kSecond);
  says_->setObjectName("labelStudyRun");
  column->addWidget(says_);
  addCluster(*column);
  connect(run_, &QPushButton::clicked, this, &StudyRunSection::run);
  connect(stop_, &QPushButton::clicked, &runner_, [this] {
    runner_.cancel();
    refresh();
  });
  connect(cluster_, &QPushButton::toggled, this, [this](bool on) { cluster_page_->setVisible(on); });
  connect(script_, &QPushButton::clicked, this, &StudyRunSection::makeScript);
  connect(submit_, &QPushButton::clicked, this, &StudyRunSection::submit);
  connect(&runner_, &StudyRunner::progressed, this, &StudyRunSection::refresh);
  connect(&runner_, &StudyRunner::ended, this, [this](bool complete) {
    last_ = complete ? tr("Complete.") : tr("Stopped; the rows so far are kept. Run continues.");
    refresh();
  });
  connect(&runner_, &StudyRunner::merged, this, [this] {
    last_ = tr("The job has ended; its results are merged.");
    refresh();
  });
  connect(&runner_, &StudyRunner::failed, this, [this](const Error& error) {
    last_ = shownText(error);
    host_.messages().reportCause(Severity::kWarning, tr("The study could not be run"), error);
    refresh();
  });
  connect(&draft_, &StudyDraft::changed, this, [this] {
    job_.reset();
    last_.clear();
    refresh();
  });
  refresh();
}

void StudyRunSection::addCluster(QVBoxLayout& column) {
  cluster_page_ = new QWidget;
  auto* page = new QVBoxLayout(cluster_page_);
  page->setContentsMargins(0, 0, 0, 0);
  page->setSpacing(6);
  const auto field = [&](const char* name, const QString& words, double most, double value) {
    auto* made = new ValueField({{}, 0, 1.0, most, 1.0});
    made->setObjectName(QString::fromLatin1(name));
    made->setValue(value);
    addRow(*page, words, made);
    return made;
  };
  chunks_ = field("fieldChunks", tr("Chunks"), 100'000.0, 16.0);
  cpus_ = field("fieldCpus", tr("Cores each"), 4096.0, 1.0);
  const auto edit = [&](const char* name, const QString& words, const QString& hint) {
    auto* made = new QLineEdit;
    made->setObjectName(QString::fromLatin1(name));
    made->setPlaceholderText(hint);
    addRow(*page, words, made);
    connect(made, &QLineEdit::textEdited, this, [this] {
      job_.reset();
      refresh();
    });
    return made;
  };
  time_ = edit("editClusterTime", tr("Time limit"), tr("the cluster's, or 02:00:00"));
  partition_ = edit("editPartition", tr("Partition"), tr("the cluster's"));
  for (ValueField* one : {chunks_, cpus_})
    connect(one, &ValueField::edited, this, [this] {
      job_.reset();
      refresh();
    });
  script_ = new QPushButton(tr("Show the script"));
  script_->setObjectName("buttonScript");
  submit_ = new QPushButton(tr("Submit"));
  submit_->setObjectName("buttonSubmit");
  page->addWidget(sideBySide({script_, submit_}));
  text_ = new QPlainTextEdit;
  text_->setObjectName("textScript");
  text_->setAccessibleName(tr("Script of the job"));
  text_->setReadOnly(true);
  text_->setLineWrapMode(QPlainTextEdit::NoWrap);
  text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  text_->setFixedHeight(150);
  page->addWidget(text_);
  column.addWidget(cluster_page_);
  cluster_page_->hide();
}

QString StudyRunSection::durationText(double seconds) {
  const auto whole = static_cast<int>(std::lround(std::min(seconds, 1e8)));
  if (whole < 60) return tr("%1 s").arg(whole);
  const auto two = [](int number) { return QStringLiteral("%1").arg(number, 2, 10, QLatin1Char('0')); };
  if (whole < 3600) return tr("%1 min %2 s").arg(whole / 60).arg(two(whole % 60));
  return tr("%1 h %2 min").arg(whole / 3600).arg(two(whole / 60 % 60));
}

QString StudyRunSection::resultsFile() const {
  const QFileInfo file(draft_.file());
  return file.absolutePath() + '/' + file.completeBaseName() + QStringLiteral(".hresults");
}

/// The study as it is shown, in its file; what it is about, in the cell's file.
bool StudyRunSection::isReady() {
  if (const auto fault = draft_.fault()) {
    last_ = shownText(*fault);
    refresh();
    return false;
  }
  if ((draft_.isChanged() || draft_.file().isEmpty()) && !saveWanted()) return false;
  const DocumentModel& model = host_.documentModel();
  if (QString::fromStdString(model.document().path().string()) == draft_.cell() && model.isDirty()) {
    last_ = tr("The workcell has changes that are not saved, and the study reads its file. Save the workcell first.");
    refresh();
    return false;
  }
  return true;
}

void StudyRunSection::run() {
  if (runner_.isBusy() || !isReady()) return;
  last_.clear();
  runner_.start(draft_.file(), resultsFile());
}

void StudyRunSection::makeScript() {
  if (!isReady()) return;
  output_ = resultsFile();
  for (int number = 2; QFileInfo::exists(output_); ++number)
    output_ = QFileInfo(draft_.file()).absolutePath() + '/' + QFileInfo(draft_.file()).completeBaseName() +
              QStringLiteral("-%1.hresults").arg(number);
  studies::ClusterPlan plan;
  plan.study = draft_.file().toStdString();
  plan.output = output_.toStdString();
  plan.chunks = static_cast<std::size_t>(chunks_->value());
  plan.cpus = static_cast<int>(cpus_->value());
  plan.time = time_->text().trimmed().toStdString();
  plan.partition = partition_->text().trimmed().toStdString();
  const auto job = studies::slurmJobOf(plan);
  const auto script = job ? studies::writeSlurmScript(*job) : Expected<std::string>(tl::unexpected<Error>(job.error()));
  job_.reset();
  if (script) {
    job_ = *job;
    text_->setPlainText(QString::fromStdString(*script));
    last_ = tr("Written to %1. Submit starts it.").arg(QString::fromStdString(job->script().string()));
  } else {
    text_->clear();
    last_ = shownText(script.error());
  }
  refresh();
}

void StudyRunSection::submit() {
  if (!job_ || runner_.isBusy()) return;
  last_.clear();
  runner_.submit(*job_, output_, {});
}

void StudyRunSection::refresh() {
  using State = StudyRunner::State;
  const State state = runner_.state();
  run_->setEnabled(state == State::kIdle && !draft_.isEmpty());
  stop_->setEnabled(state != State::kIdle && state != State::kStopping);
  script_->setEnabled(state == State::kIdle && !draft_.isEmpty());
  submit_->setEnabled(state == State::kIdle && job_.has_value());
  bar_->setRange(0, state == State::kPreparing ? 0 : 1000);
  if (state == State::kIdle) {
    bar_->setValue(0);
    if (!last_.isEmpty()) return says_->setText(last_);
    return says_->setText(draft_.isEmpty() ? tr("Create a study of the open workcell, or open one.") : QString());
  }
  if (state == State::kPreparing) return says_->setText(tr("Reading the cell and preparing all shapes…"));
  if (state == State::kCluster) {
    const studies::ClusterProgress now = runner_.clusterProgress();
    const std::size_t chunks = job_ ? job_->chunks : 0;
    bar_->setValue(chunks > 0 ? static_cast<int>(1000 * now.complete / chunks) : 0);
    return says_->setText(now.number.empty()
                              ? tr("Submitting…")
                              : tr("Job %1: %2 of %3 chunks complete. Stop only ends the following.")
                                    .arg(QString::fromStdString(now.number))
                                    .arg(now.complete)
                                    .arg(chunks));
  }
  const StudyRunner::Progress now = runner_.progress();
  bar_->setValue(now.total > 0 ? static_cast<int>(1000 * now.done / now.total) : 0);
  if (state == State::kStopping) return says_->setText(tr("Stopping after the variants that are being evaluated…"));
  const QString left = now.seconds_left ? tr("%1 left").arg(durationText(*now.seconds_left)) : tr("starting");
  says_->setText(tr("%1 of %2, %3").arg(now.done).arg(now.total).arg(left));
}

}  // namespace hapticell::app
