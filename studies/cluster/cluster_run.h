// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "studies/cluster/slurm_job.h"

namespace hapticell::studies {

/// What a user decides about a job.
struct ClusterPlan {
  std::filesystem::path study;        ///< The document.
  std::filesystem::path output;       ///< Merged results; must not exist.
  std::filesystem::path folder = {};  ///< For script, logs and chunks; empty: OUTPUT.chunks.
  std::size_t chunks = 16;
  int cpus = 1;                           ///< Of a task.
  std::string time = {}, partition = {};  ///< Empty: the cluster's.
  std::vector<std::string> more = {};     ///< Further options of sbatch.
};

/// The job of a plan, with hapticell-cli beside this program. Errors: a document that cannot be read, a line break in a
/// name, results that exist.
Expected<SlurmJob> slurmJobOf(const ClusterPlan& plan);

/// Writes the script into the job's folder, which is made; gives its text. Errors: those of the disk.
Expected<std::string> writeSlurmScript(const SlurmJob& job);

/// How a job is going.
struct ClusterProgress {
  std::string number;                       ///< Of the job in Slurm.
  std::size_t complete = 0;                 ///< Chunks.
  std::vector<std::size_t> submitted = {};  ///< Chunks that were submitted right now; empty: only news of `complete`.
  bool again = false;                       ///< They had failed before.
};

struct ClusterOptions {
  int retries = 3;                                            ///< How often a failed chunk is submitted again.
  int poll = 10;                                              ///< s between two looks at the queue.
  std::function<void(const ClusterProgress&)> progress = {};  ///< Called in the thread of runOnCluster().
  const std::atomic<bool>* cancelled = nullptr;               ///< Stops following the job; the job in Slurm continues.
};

struct ClusterSummary {
  std::vector<std::string> numbers;  ///< Of all jobs.
  std::int64_t rows = 0;
};

/// Submits the chunks that are not complete, follows the job, submits failed chunks again, and merges all into
/// `output`. Blocks until it ends. Errors: Slurm's, no longer following, chunks that failed too often, those of
/// mergeResults().
Expected<ClusterSummary> runOnCluster(const SlurmJob& job, const std::filesystem::path& output,
                                      const ClusterOptions& options);

}  // namespace hapticell::studies
