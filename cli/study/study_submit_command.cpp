// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "cli/kit/result_writer.h"
#include "cli/kit/stop_signal.h"
#include "cli/study/slurm_job.h"
#include "cli/study/study_commands.h"
#include "cli/study/study_progress.h"
#include "cli/study/study_report.h"
#include "config/program_folders.h"
#include "geometry/system/listed.h"
#include "studies/document/study_document.h"
#include "studies/store/result_merge.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct SubmitOptions {
  std::string study, output, folder, time, partition;
  std::vector<std::string> more;
  int chunks = 16, cpus = 1, retries = 3, poll = 10;
  bool slurm = false, yes = false;
};

/// The job's name: letters, digits and dashes, as Slurm shows it.
std::string jobName(const std::string& study) {
  std::string name;
  for (const char c : study) name += (std::isalnum(static_cast<unsigned char>(c)) != 0) ? c : '-';
  return name.substr(0, 40);
}

Expected<SlurmJob> jobOf(const SubmitOptions& options) {
  if (!options.slurm)
    return makeError({.place = "study submit", .found = "no cluster", .expected = "--slurm", .fix = ""});
  const auto document = studies::StudyDocument::read(options.study);
  HAPTICELL_TRY(document);
  const auto folders = config::programFolders();
  if (folders.empty()) return makeError({.found = "the place of this program is not known"});
  SlurmJob job;
  job.name = jobName(document->name);
  job.program = folders.front() / "hapticell-cli";
  job.study = document->file;
  job.folder = fs::absolute(options.folder.empty() ? options.output + ".chunks" : options.folder).lexically_normal();
  job.chunks = static_cast<std::size_t>(options.chunks);
  job.cpus = options.cpus;
  job.time = options.time;
  job.partition = options.partition;
  job.more = options.more;
  for (const std::string& word : {job.study.string(), job.folder.string(), job.time, job.partition, listed(job.more)}) {
    if (word.find('\n') == std::string::npos) continue;
    return makeError({.place = "study submit", .found = "a line break", .expected = "names in one line"});
  }
  return job;
}

/// Waits until Slurm has no task of the job any more. False: asked to stop.
Expected<bool> follow(const SlurmJob& job, const std::string& number, int poll, const StopSignal& stop) {
  std::size_t left = job.chunks + 1;
  while (true) {
    const auto queued = isInQueue(number);
    HAPTICELL_TRY(queued);
    if (!*queued) return true;
    const std::size_t missing = missingChunks(job).size();
    if (missing != left) {
      left = missing;
      std::fprintf(stderr, "job %s: %zu of %zu chunks complete\n", number.c_str(), job.chunks - missing, job.chunks);
    }
    for (int tenth = 0; tenth < 10 * poll; ++tenth) {
      if (stop.asked()) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
}

Expected<ordered_json> shown(const SlurmJob& job) {
  return ordered_json{{"submitted", false},
                      {"script", job.script().string()},
                      {"chunks", job.chunks},
                      {"fix", "Run the same command with --yes to submit this script."}};
}

Expected<ordered_json> submitAndFollow(const SlurmJob& job, const SubmitOptions& options) {
  const StopSignal stop;
  std::vector<std::string> numbers;
  for (int round = 0; round <= options.retries; ++round) {
    const std::vector<std::size_t> missing = missingChunks(job);
    if (missing.empty()) break;
    const auto number = submitChunks(job, missing);
    HAPTICELL_TRY(number);
    numbers.push_back(*number);
    std::fprintf(stderr, "%s job %s: chunks %s\n", round == 0 ? "submitted" : "submitted again as", number->c_str(),
                 chunkList(missing).c_str());
    const auto ended = follow(job, *number, options.poll, stop);
    HAPTICELL_TRY(ended);
    if (!*ended)
      return makeError({.file = job.folder.string(),
                        .found = Text("no longer following job %1; Slurm continues with it", *number),
                        .fix = "Run the same command again: it submits only the chunks that are missing then."});
  }
  const std::vector<std::size_t> missing = missingChunks(job);
  if (!missing.empty())
    return makeError({.file = job.folder.string(),
                      .found = Text("chunks %1 failed %2 times", chunkList(missing), options.retries + 1),
                      .expected = "complete results of every chunk",
                      .fix = "Read the files task-N.log in this folder, then run the same command again."});
  std::vector<fs::path> parts;
  for (std::size_t chunk = 1; chunk <= job.chunks; ++chunk) parts.push_back(job.resultsOf(chunk));
  const auto merged = studies::mergeResults(parts, options.output, false);
  HAPTICELL_TRY(merged);
  return ordered_json{{"submitted", true},        {"jobs", numbers},        {"script", job.script().string()},
                      {"chunks", job.chunks},     {"results", options.output}, {"rows", merged->rows},
                      {"complete", true}};
}

Expected<ordered_json> submit(const SubmitOptions& options) {
  const auto job = jobOf(options);
  HAPTICELL_TRY(job);
  std::error_code fault;
  if (fs::exists(options.output, fault))
    return makeError({.file = options.output, .found = "the file exists", .expected = "a new results file"});
  fs::create_directories(job->folder, fault);
  if (fault) return makeError({.file = job->folder.string(), .found = systemText(fault.value())});
  const std::string script = slurmScript(*job);
  HAPTICELL_TRY(writeFileAtomically(job->script(), script));
  std::fputs(script.c_str(), stderr);
  return options.yes ? submitAndFollow(*job, options) : shown(*job);
}

}  // namespace

void addStudySubmit(Subcommand study, Action& chosen) {
  Subcommand command =
      study.add("submit", "Run a study as an array job of a cluster, follow it, repeat failed chunks and merge");
  const auto options = std::make_shared<SubmitOptions>();
  command.option("study", options->study, "Study document (.hstudy)").takes(ValueKind::kStudy).required();
  command.option("-o,--output", options->output, "Results file to write (.hresults)")
      .takes(ValueKind::kStudyResults)
      .required();
  command.flag("--slurm", options->slurm, "Use Slurm, the only one so far");
  command.flag("--yes", options->yes, "Submit; without it the script is only written and shown");
  command.option("--chunks", options->chunks, "Number of chunks (default: 16)").withinWhole(1, 100'000);
  command.option("--cpus", options->cpus, "Cores of a task (default: 1)").withinWhole(1, 4096);
  command.option("--time", options->time, "Limit of a task, as sbatch takes it: 02:00:00");
  command.option("--partition", options->partition, "Partition (default: the cluster's)");
  command.option("--sbatch", options->more, "Further option of sbatch, such as --sbatch=--mem=4G; may be repeated")
      .oneAtATime();
  command.option("--folder", options->folder, "Folder for script, logs and chunks (default: RESULTS.chunks)")
      .takes(ValueKind::kFolder);
  command.option("--retries", options->retries, "How often a failed chunk is submitted again (default: 3)")
      .withinWhole(0, 100);
  command.option("--poll", options->poll, "Seconds between two looks at the queue (default: 10)").withinWhole(1, 3600);
  command.onChosen([options, &chosen] {
    chosen = [options](ResultWriter& writer) {
      const auto answer = submit(*options);
      const auto written = answer ? writer.write(*answer) : Expected<void>(tl::unexpected<Error>(answer.error()));
      if (written) return ExitStatus::kDone;
      report(written.error());
      return ExitStatus::kBadInput;
    };
  });
}

}  // namespace hapticell::cli
