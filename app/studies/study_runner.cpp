// SPDX-License-Identifier: Apache-2.0
#include "app/studies/study_runner.h"

#include <atomic>
#include <filesystem>
#include <mutex>

#include "app/kit/thread_pool_task.h"
#include "config/program_version.h"

namespace hapticell::app {

namespace fs = std::filesystem;
using studies::ResultRow;
using studies::ResultStore;
using studies::Study;

namespace {

/// ms between two looks at a run. Half: twice the drawing; twice: numbers jerk.
constexpr int kPollMilliseconds = 100;
/// Results files that are tried for a study that changed. Half and twice: somebody must tidy up sooner or later.
constexpr int kMostFiles = 1000;

/// "NAME.hresults", "NAME-2.hresults" ...
fs::path numbered(const fs::path& file, int number) {
  if (number < 2) return file;
  return file.parent_path() / (file.stem().string() + "-" + std::to_string(number) + file.extension().string());
}

/// The first file of that name that is new or belongs to this very study.
Expected<ResultStore> storeFor(const fs::path& wanted, const studies::ResultHead& head) {
  for (int number = 1; number < kMostFiles; ++number) {
    const fs::path file = numbered(wanted, number);
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return ResultStore::create(file, head);
    const auto there = ResultStore::open(file, false);
    if (there && studies::checkSameStudy(there->head(), head, file)) return ResultStore::open(file, true);
  }
  return makeError({.file = wanted.string(), .found = "too many results files of this name", .fix = "Move some away."});
}

}  // namespace

std::string studyVersion() {
  return HAPTICELL_VERSION " " + std::string(config::builtCommit());
}

/// What the thread of a run and the window share.
struct StudyRunner::Run {
  std::atomic<bool> cancelled{false};
  std::mutex mutex;
  // Guarded.
  State state = State::kPreparing;
  studies::RunProgress progress;
  studies::ClusterProgress cluster;
  std::vector<ResultRow> rows;  ///< That the window has not taken yet.
  std::shared_ptr<const Study> study;  ///< Until the window has taken it.
  std::vector<ResultRow> before;
  fs::path results;

  Expected<bool> evaluate(const fs::path& document, const fs::path& wanted);
};

Expected<bool> StudyRunner::Run::evaluate(const fs::path& document, const fs::path& wanted) {
  auto loaded = Study::load(document, studyVersion());
  HAPTICELL_TRY(loaded);
  const std::shared_ptr<const Study> ready = std::move(*loaded);
  auto store = storeFor(wanted, ready->head());
  HAPTICELL_TRY(store);
  std::vector<ResultRow> there;
  HAPTICELL_TRY(store->forEachRow([&](const ResultRow& row) {
    there.push_back(row);
    return Expected<void>();
  }));
  {
    const std::lock_guard lock(mutex);
    study = ready;
    before = std::move(there);
    results = store->file();
    state = State::kRunning;
  }
  studies::RunOptions options;
  options.cancelled = &cancelled;
  options.progress = [this](const studies::RunProgress& now) {
    const std::lock_guard lock(mutex);
    progress = now;
  };
  options.rows = [this](const std::vector<ResultRow>& more) {
    const std::lock_guard lock(mutex);
    rows.insert(rows.end(), more.begin(), more.end());
  };
  const auto summary = studies::runStudy(*ready, *store, options);
  HAPTICELL_TRY(summary);
  return summary->complete;
}

StudyRunner::StudyRunner(QObject* parent) : QObject(parent) {
  poll_.setInterval(kPollMilliseconds);
  connect(&poll_, &QTimer::timeout, this, &StudyRunner::look);
}

StudyRunner::~StudyRunner() {
  cancel();
}

StudyRunner::State StudyRunner::state() const {
  if (!run_) return State::kIdle;
  const std::lock_guard lock(run_->mutex);
  return run_->cancelled ? State::kStopping : run_->state;
}

StudyRunner::Progress StudyRunner::progress() const {
  if (!run_) return {};
  const std::lock_guard lock(run_->mutex);
  const studies::RunProgress& now = run_->progress;
  Progress shown{now.done, now.total, std::nullopt};
  if (now.done > 0)
    shown.seconds_left = now.seconds * static_cast<double>(now.total - now.done) / static_cast<double>(now.done);
  return shown;
}

studies::ClusterProgress StudyRunner::clusterProgress() const {
  if (!run_) return {};
  const std::lock_guard lock(run_->mutex);
  return run_->cluster;
}

void StudyRunner::begin(std::shared_ptr<Run> run) {
  run_ = std::move(run);
  poll_.start();
  emit progressed();
}

void StudyRunner::start(const QString& study, const QString& results) {
  if (run_) return;
  begin(std::make_shared<Run>());
  runInThreadPool(
      this,
      [run = run_, document = fs::path(study.toStdString()), wanted = fs::path(results.toStdString())] {
        return run->evaluate(document, wanted);
      },
      [this](const Expected<bool>& complete) {
        look();  // The last rows.
        run_.reset();
        poll_.stop();
        if (complete) {
          emit ended(*complete);
        } else {
          emit failed(complete.error());
        }
        emit progressed();
      });
}

void StudyRunner::submit(const studies::SlurmJob& job, const QString& output, const studies::ClusterOptions& options) {
  if (run_) return;
  auto run = std::make_shared<Run>();
  run->state = State::kCluster;
  begin(run);
  runInThreadPool(
      this,
      [run, job, options, target = fs::path(output.toStdString())]() -> Expected<studies::ClusterSummary> {
        studies::ClusterOptions followed = options;
        followed.cancelled = &run->cancelled;
        followed.progress = [&run](const studies::ClusterProgress& now) {
          const std::lock_guard lock(run->mutex);
          run->cluster = now;
        };
        return studies::runOnCluster(job, target, followed);
      },
      [this, output](const Expected<studies::ClusterSummary>& summary) {
        run_.reset();
        poll_.stop();
        if (summary) {
          emit merged(output);
        } else {
          emit failed(summary.error());
        }
        emit progressed();
      });
}

void StudyRunner::cancel() {
  if (run_) run_->cancelled = true;
}

void StudyRunner::look() {
  if (!run_) return;
  std::shared_ptr<const Study> study;
  std::vector<ResultRow> before, rows;
  QString results;
  {
    const std::lock_guard lock(run_->mutex);
    study = std::move(run_->study);
    run_->study = nullptr;
    before = std::move(run_->before);
    rows = std::move(run_->rows);
    run_->rows.clear();
    results = QString::fromStdString(run_->results.string());
  }
  if (study) emit began(results, study, before);
  if (!rows.empty()) emit rowsCame(rows);
  emit progressed();
}

}  // namespace hapticell::app
