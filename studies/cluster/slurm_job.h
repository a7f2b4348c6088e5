// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::studies {

/// A study as an array job of Slurm: one task a chunk.
struct SlurmJob {
  std::string name;               ///< Of the job.
  std::filesystem::path program;  ///< hapticell-cli on the nodes.
  std::filesystem::path study;    ///< The document; on a file system that all nodes see.
  std::filesystem::path folder;   ///< For script, logs and results of the chunks; likewise.
  std::size_t chunks = 1;
  int cpus = 1;         ///< Of a task.
  std::string time;     ///< Slurm's --time; empty: the partition's.
  std::string partition;  ///< Empty: the default one.
  std::vector<std::string> more;  ///< Further options of sbatch.

  std::filesystem::path script() const { return folder / "study.sbatch"; }
  std::filesystem::path resultsOf(std::size_t chunk) const;
};

/// The script of the array job. Tasks that are repeated continue their results file.
std::string slurmScript(const SlurmJob& job);

/// "1-3,7" of chunk numbers in rising order.
std::string chunkList(const std::vector<std::size_t>& chunks);

/// Submits the script for these chunks; gives the job's number. Errors: sbatch is missing, or what it said.
Expected<std::string> submitChunks(const SlurmJob& job, const std::vector<std::size_t>& chunks);

/// True while Slurm has tasks of this job waiting or running. Errors: squeue is missing, or what it said.
Expected<bool> isInQueue(const std::string& job_number);

/// Chunks without a complete results file.
std::vector<std::size_t> missingChunks(const SlurmJob& job);

}  // namespace hapticell::studies
