// SPDX-License-Identifier: Apache-2.0
#include "studies/runner/study_run.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <mutex>
#include <optional>

namespace hapticell::studies {

namespace {

using Clock = std::chrono::steady_clock;

/// Rows are written at least so often. Half: more waiting for the disk; twice: a kill loses two more seconds of work.
constexpr double kWriteEvery = 2.0;    // s
constexpr std::size_t kMostHeld = 500;  // Rows; half and twice as kWriteEvery.

std::string hostName() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

std::string timeNow() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

/// Collects rows of all threads and writes them from time to time.
class Writer {
 public:
  Writer(ResultStore& store, const RunOptions& options, std::size_t total)
      : store_(store), options_(options), total_(total) {}

  /// False once the store has failed.
  bool add(std::int64_t unit, std::vector<ResultRow> rows) {
    const std::lock_guard lock(mutex_);
    if (fault_) return false;
    std::move(rows.begin(), rows.end(), std::back_inserter(rows_));
    units_.push_back(unit);
    ++done_;
    if (rows_.size() >= kMostHeld || secondsSince(written_) > kWriteEvery) flush();
    if (options_.progress) options_.progress({done_, total_, secondsSince(began_)});
    return !fault_;
  }

  Expected<void> finish() {
    const std::lock_guard lock(mutex_);
    if (!fault_) flush();
    if (fault_) return tl::unexpected(*fault_);
    return {};
  }

  std::int64_t rows() const { return count_; }
  double seconds() const { return secondsSince(began_); }

 private:
  static double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }

  void flush() {
    // In the order of the numbers: the file then grows at its end.
    std::sort(rows_.begin(), rows_.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
    const auto written = store_.add(rows_, units_);
    if (!written) fault_ = written.error();
    if (written) count_ += static_cast<std::int64_t>(rows_.size());
    if (written && options_.rows) options_.rows(rows_);
    rows_.clear();
    units_.clear();
    written_ = Clock::now();
  }

  ResultStore& store_;
  const RunOptions& options_;
  std::size_t total_ = 0, done_ = 0;
  std::mutex mutex_;
  std::vector<ResultRow> rows_;
  std::vector<std::int64_t> units_;
  std::optional<Error> fault_;
  std::int64_t count_ = 0;
  Clock::time_point began_ = Clock::now(), written_ = began_;
};

}  // namespace

Expected<RunSummary> runStudy(const Study& study, ResultStore& store, const RunOptions& options) {
  const auto complete = store.completeUnits();
  HAPTICELL_TRY(complete);
  const ChunkUnits chunk = unitsOfChunk(study.space().units(), options.chunk, options.chunks);
  std::vector<std::size_t> units;
  for (std::size_t unit = chunk.begin; unit < chunk.end; ++unit) {
    if (complete->count(static_cast<std::int64_t>(unit)) == 0) units.push_back(unit);
  }
  tbb::task_arena arena(options.jobs > 0 ? options.jobs : tbb::task_arena::automatic);
  RunRecord record{static_cast<std::int64_t>(options.chunk),
                   static_cast<std::int64_t>(options.chunks),
                   hostName(),
                   timeNow(),
                   0.0,
                   arena.max_concurrency(),
                   0,
                   false};
  const auto id = store.beginRun(record);
  HAPTICELL_TRY(id);
  static const std::atomic<bool> kNever{false};
  const std::atomic<bool>& cancelled = options.cancelled != nullptr ? *options.cancelled : kNever;
  std::atomic<bool> failed{false};
  Writer writer(store, options, units.size());
  arena.execute([&] {
    // One unit at a time and in their order: an interrupted run then lacks the last ones.
    tbb::parallel_for(
        std::size_t{0}, units.size(),
        [&](std::size_t i) {
          if (cancelled || failed) return;
          // Whatever waits inside a search must not begin another search in this thread.
          auto rows = tbb::this_task_arena::isolate([&] { return study.runUnit(units[i], cancelled); });
          if (rows.empty()) return;
          if (!writer.add(static_cast<std::int64_t>(units[i]), std::move(rows))) failed = true;
        },
        tbb::simple_partitioner());
  });
  HAPTICELL_TRY(writer.finish());
  const auto now = store.completeUnits();
  HAPTICELL_TRY(now);
  RunSummary summary{writer.rows(), static_cast<std::int64_t>(chunk.end - chunk.begin - units.size()), true,
                     writer.seconds()};
  for (std::size_t unit = chunk.begin; unit < chunk.end; ++unit)
    summary.complete = summary.complete && now->count(static_cast<std::int64_t>(unit)) != 0;
  record.seconds = summary.seconds;
  record.rows = summary.rows;
  record.complete = summary.complete;
  HAPTICELL_TRY(store.finishRun(*id, record));
  return summary;
}

}  // namespace hapticell::studies
