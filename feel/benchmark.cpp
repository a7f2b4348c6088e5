// SPDX-License-Identifier: Apache-2.0
#include "feel/benchmark.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>
#include <thread>

#include "feel/figure_job.h"
#include "feel/stop_of_thread.h"
#include "geometry/system/text_case.h"

namespace hapticell::feel {

namespace {

// Jobs at a time: of the machine that the figures in docs/dev/feel.md are from. Sessions run in virtual time, so half
// and twice change only how long it takes.
constexpr unsigned kThreads = 2;

bool sameId(const std::string& id, const std::string& only) {
  const std::string low = lowerCase(id);
  return low == only || low.substr(0, low.find('.')) == only;
}

bool wanted(const FigureJob& job, const std::string& only) {
  if (only.empty() || lowerCase(job.scene).find(only) != std::string::npos) return true;
  return std::any_of(job.ids.begin(), job.ids.end(), [&](const std::string& id) {
    return sameId(id, only) || id == only.substr(0, only.find('.')) || lowerCase(id) == only.substr(0, only.find('.'));
  });
}

bool wanted(const Figure& figure, const std::string& only) {
  return only.empty() || sameId(figure.id, only) || lowerCase(figure.scene).find(only) != std::string::npos;
}

std::vector<FigureJob> allJobs(const BenchmarkOptions& options) {
  std::vector<FigureJob> jobs;
  addSlidingJobs(options, jobs);
  addEnergyJobs(options, jobs);
  addStabilityJobs(options, jobs);
  addWallJobs(options, jobs);
  addMeshJobs(options, jobs);
  addNetworkJobs(options, jobs);
  if (options.timing) addTimedJobs(options, jobs);
  return jobs;
}

std::string names(const std::vector<FigureJob>& jobs) {
  std::set<std::string> scenes;
  for (const FigureJob& job : jobs) scenes.insert(job.scene);
  std::string text = "M1 .. M14, NET";
  for (const std::string& scene : scenes) text += ", " + scene;
  return text;
}

bool isStopped(const BenchmarkOptions& options) {
  return options.stop != nullptr && *options.stop;
}

using Answers = std::vector<Expected<std::vector<Figure>>>;

/// Does the jobs that may run beside each other, then those that must not.
void runAll(const std::vector<FigureJob>& jobs, const BenchmarkOptions& options, Answers& answers) {
  std::mutex telling;
  const auto run = [&](std::size_t i) {
    if (isStopped(options)) return;
    if (options.progress) {
      const std::lock_guard<std::mutex> lock(telling);
      options.progress(jobs[i].ids.front() + " " + jobs[i].scene);
    }
    const StopOfThread stop(options.stop);
    try {
      answers[i] = jobs[i].run();
    } catch (const MeasurementStopped&) {  // runBenchmark() says so.
    }
  };
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < jobs.size(); i = next++) {
      if (!jobs[i].alone) run(i);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < std::min(kThreads, std::thread::hardware_concurrency()); ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (jobs[i].alone) run(i);
  }
}

}  // namespace

Expected<std::vector<Figure>> runBenchmark(const BenchmarkOptions& options) {
  const std::string only = lowerCase(options.only);
  std::vector<FigureJob> jobs = allJobs(options);
  const std::string known = names(jobs);
  std::erase_if(jobs, [&](const FigureJob& job) { return !wanted(job, only); });
  if (jobs.empty()) {
    return makeError({.place = "--only",
                      .found = "'" + options.only + "'",
                      .expected = Text("one of %1", known),
                      .fix = options.timing ? Text() : Text("M7 and M11 are measured only with --timing.")});
  }
  Answers answers(jobs.size(), Expected<std::vector<Figure>>(std::vector<Figure>{}));
  runAll(jobs, options, answers);
  if (isStopped(options)) return makeError({.found = "stopped before its end", .fix = "Start it again."});
  std::vector<Figure> figures;
  for (const auto& answer : answers) {
    HAPTICELL_TRY(answer);
    std::copy_if(answer->begin(), answer->end(), std::back_inserter(figures),
                 [&](const Figure& figure) { return wanted(figure, only); });
  }
  return figures;
}

}  // namespace hapticell::feel
