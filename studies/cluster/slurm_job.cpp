// SPDX-License-Identifier: Apache-2.0
#include "studies/cluster/slurm_job.h"

#include <algorithm>

#include "studies/cluster/program_call.h"
#include "studies/store/result_store.h"
#include "studies/variants/variant_space.h"

namespace hapticell::studies {

namespace fs = std::filesystem;

namespace {

/// For a shell: in single quotes, those inside written apart.
std::string shellWord(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string withoutBlanks(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

bool isComplete(const SlurmJob& job, std::size_t chunk) {
  const auto store = ResultStore::open(job.resultsOf(chunk), false);
  if (!store) return false;
  const auto units = store->completeUnits();
  if (!units) return false;
  const auto wanted = unitsOfChunk(static_cast<std::size_t>(store->head().units), chunk, job.chunks);
  for (std::size_t unit = wanted.begin; unit < wanted.end; ++unit)
    if (units->count(static_cast<std::int64_t>(unit)) == 0) return false;
  return true;
}

}  // namespace

fs::path SlurmJob::resultsOf(std::size_t chunk) const {
  return folder / ("chunk-" + std::to_string(chunk) + ".hresults");
}

std::string slurmScript(const SlurmJob& job) {
  std::string text = "#!/bin/sh\n";
  const auto option = [&](const std::string& words) { text += "#SBATCH " + words + "\n"; };
  option("--job-name=" + job.name);
  option("--cpus-per-task=" + std::to_string(job.cpus));
  option("--requeue");
  option("--output=" + (job.folder / "task-%a.log").string());
  option("--open-mode=append");
  if (!job.time.empty()) option("--time=" + job.time);
  if (!job.partition.empty()) option("--partition=" + job.partition);
  for (const std::string& more : job.more) option(more);
  const std::string results = shellWord((job.folder / "chunk-").string());
  text += "# One task a chunk: sbatch --array=1-" + std::to_string(job.chunks) + " SCRIPT\n";
  text += "exec " + shellWord(job.program.string()) + " study run " + shellWord(job.study.string()) + " \\\n  -o " +
          results + "\"$SLURM_ARRAY_TASK_ID\".hresults \\\n  --chunk \"$SLURM_ARRAY_TASK_ID\"/" +
          std::to_string(job.chunks) + " --jobs " + std::to_string(job.cpus) + "\n";
  return text;
}

std::string chunkList(const std::vector<std::size_t>& chunks) {
  std::string list;
  for (std::size_t i = 0; i < chunks.size();) {
    std::size_t end = i;
    while (end + 1 < chunks.size() && chunks[end + 1] == chunks[end] + 1) ++end;
    if (!list.empty()) list += ",";
    list += std::to_string(chunks[i]);
    if (end > i) list += "-" + std::to_string(chunks[end]);
    i = end + 1;
  }
  return list;
}

Expected<std::string> submitChunks(const SlurmJob& job, const std::vector<std::size_t>& chunks) {
  const auto answer = callProgram("sbatch", {"--parsable", "--array=" + chunkList(chunks), job.script().string()});
  HAPTICELL_TRY(answer);
  // "42" or "42;cluster", after any warnings.
  const std::string said = withoutBlanks(answer->output);
  const std::string last = said.substr(said.find_last_of('\n') + 1);
  const std::string number = last.substr(0, last.find(';'));
  const bool good = answer->status == 0 && !number.empty() &&
                    std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (good) return number;
  return makeError({.file = "sbatch",
                    .found = said.empty() ? Text("status %1", answer->status) : Text::plain(said),
                    .expected = "the number of a job",
                    .fix = "Check the options for this cluster; the script stays in the folder."});
}

Expected<bool> isInQueue(const std::string& job_number) {
  const auto answer = callProgram("squeue", {"--noheader", "--jobs", job_number, "--format=%i"});
  HAPTICELL_TRY(answer);
  // Slurm forgets a job some minutes after its end, and then says so.
  if (answer->output.find("Invalid job id") != std::string::npos) return false;
  if (answer->status != 0) return makeError({.file = "squeue", .found = Text::plain(withoutBlanks(answer->output))});
  return !withoutBlanks(answer->output).empty();
}

std::vector<std::size_t> missingChunks(const SlurmJob& job) {
  std::vector<std::size_t> missing;
  for (std::size_t chunk = 1; chunk <= job.chunks; ++chunk)
    if (!isComplete(job, chunk)) missing.push_back(chunk);
  return missing;
}

}  // namespace hapticell::studies
