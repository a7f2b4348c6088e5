// SPDX-License-Identifier: Apache-2.0
#include "studies/cluster/cluster_run.h"

#include <cctype>
#include <chrono>
#include <thread>

#include "config/program_folders.h"
#include "geometry/system/atomic_file.h"
#include "geometry/system/listed.h"
#include "studies/document/study_document.h"
#include "studies/store/result_merge.h"

namespace hapticell::studies {

namespace fs = std::filesystem;

namespace {

/// Slurm shows no longer ones. Half: names that cannot be told apart; twice: cut by squeue.
constexpr std::size_t kLongestName = 40;

/// The job's name: letters, digits and dashes, as Slurm shows it.
std::string jobName(const std::string& study) {
  std::string name;
  for (const char c : study) name += (std::isalnum(static_cast<unsigned char>(c)) != 0) ? c : '-';
  return name.substr(0, kLongestName);
}

bool isCancelled(const ClusterOptions& options) {
  return options.cancelled != nullptr && *options.cancelled;
}

void tell(const ClusterOptions& options, const ClusterProgress& progress) {
  if (options.progress) options.progress(progress);
}

/// Waits until Slurm has no task of the job any more. False: asked to stop.
Expected<bool> follow(const SlurmJob& job, const std::string& number, const ClusterOptions& options) {
  std::size_t left = job.chunks + 1;
  while (true) {
    const auto queued = isInQueue(number);
    HAPTICELL_TRY(queued);
    if (!*queued) return true;
    const std::size_t missing = missingChunks(job).size();
    if (missing != left) {
      left = missing;
      tell(options, {number, job.chunks - missing});
    }
    for (int tenth = 0; tenth < 10 * options.poll; ++tenth) {
      if (isCancelled(options)) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
}

}  // namespace

Expected<SlurmJob> slurmJobOf(const ClusterPlan& plan) {
  const auto document = StudyDocument::read(plan.study);
  HAPTICELL_TRY(document);
  const auto folders = config::programFolders();
  if (folders.empty()) return makeError({.found = "the place of this program is not known"});
  std::error_code fault;
  if (fs::exists(plan.output, fault))
    return makeError({.file = plan.output.string(), .found = "the file exists", .expected = "a new results file"});
  SlurmJob job;
  job.name = jobName(document->name);
  job.program = folders.front() / "hapticell-cli";
  job.study = document->file;
  job.folder = fs::absolute(plan.folder.empty() ? fs::path(plan.output.string() + ".chunks") : plan.folder).lexically_normal();
  job.chunks = plan.chunks;
  job.cpus = plan.cpus;
  job.time = plan.time;
  job.partition = plan.partition;
  job.more = plan.more;
  for (const std::string& word : {job.study.string(), job.folder.string(), job.time, job.partition, listed(job.more)}) {
    if (word.find('\n') == std::string::npos) continue;
    return makeError({.place = "Slurm", .found = "a line break", .expected = "names in one line"});
  }
  return job;
}

Expected<std::string> writeSlurmScript(const SlurmJob& job) {
  std::error_code fault;
  fs::create_directories(job.folder, fault);
  if (fault) return makeError({.file = job.folder.string(), .found = systemText(fault.value())});
  std::string script = slurmScript(job);
  HAPTICELL_TRY(writeFileAtomically(job.script(), script));
  return script;
}

Expected<ClusterSummary> runOnCluster(const SlurmJob& job, const fs::path& output, const ClusterOptions& options) {
  ClusterSummary summary;
  for (int round = 0; round <= options.retries; ++round) {
    const std::vector<std::size_t> missing = missingChunks(job);
    if (missing.empty()) break;
    const auto number = submitChunks(job, missing);
    HAPTICELL_TRY(number);
    summary.numbers.push_back(*number);
    tell(options, {*number, job.chunks - missing.size(), missing, round > 0});
    const auto ended = follow(job, *number, options);
    HAPTICELL_TRY(ended);
    if (!*ended)
      return makeError({.file = job.folder.string(),
                        .found = Text("no longer following job %1; Slurm continues with it", *number),
                        .fix = "Submit again: only the chunks that are missing then are submitted."});
  }
  const std::vector<std::size_t> missing = missingChunks(job);
  if (!missing.empty())
    return makeError({.file = job.folder.string(),
                      .found = Text("chunks %1 failed %2 times", chunkList(missing), options.retries + 1),
                      .expected = "complete results of every chunk",
                      .fix = "Read the files task-N.log in this folder, then submit again."});
  std::vector<fs::path> parts;
  for (std::size_t chunk = 1; chunk <= job.chunks; ++chunk) parts.push_back(job.resultsOf(chunk));
  const auto merged = mergeResults(parts, output, false);
  HAPTICELL_TRY(merged);
  summary.rows = merged->rows;
  return summary;
}

}  // namespace hapticell::studies
