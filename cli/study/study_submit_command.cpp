// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/kit/result_writer.h"
#include "cli/kit/stop_signal.h"
#include "cli/study/study_commands.h"
#include "cli/study/study_progress.h"
#include "cli/study/study_report.h"
#include "studies/cluster/cluster_run.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

struct SubmitOptions {
  std::string study, output, folder, time, partition;
  std::vector<std::string> more;
  int chunks = 16, cpus = 1, retries = 3, poll = 10;
  bool slurm = false, yes = false;
};

Expected<ordered_json> shown(const studies::SlurmJob& job) {
  return ordered_json{{"submitted", false},
                      {"script", job.script().string()},
                      {"chunks", job.chunks},
                      {"fix", "Run the same command with --yes to submit this script."}};
}

void show(const studies::ClusterProgress& now, std::size_t chunks) {
  if (now.submitted.empty()) {
    std::fprintf(stderr, "job %s: %zu of %zu chunks complete\n", now.number.c_str(), now.complete, chunks);
  } else {
    std::fprintf(stderr, "%s job %s: chunks %s\n", now.again ? "submitted again as" : "submitted", now.number.c_str(),
                 studies::chunkList(now.submitted).c_str());
  }
}

Expected<ordered_json> submitAndFollow(const studies::SlurmJob& job, const SubmitOptions& options) {
  const StopSignal stop;
  studies::ClusterOptions run{options.retries, options.poll, {}, &stop.asked()};
  run.progress = [&](const studies::ClusterProgress& now) { show(now, job.chunks); };
  const auto summary = studies::runOnCluster(job, options.output, run);
  HAPTICELL_TRY(summary);
  return ordered_json{{"submitted", true},        {"jobs", summary->numbers},   {"script", job.script().string()},
                      {"chunks", job.chunks},     {"results", options.output}, {"rows", summary->rows},
                      {"complete", true}};
}

Expected<ordered_json> submit(const SubmitOptions& options) {
  if (!options.slurm) return makeError({.place = "study submit", .found = "no cluster", .expected = "--slurm"});
  const auto job = studies::slurmJobOf({options.study, options.output, options.folder,
                                        static_cast<std::size_t>(options.chunks), options.cpus, options.time,
                                        options.partition, options.more});
  HAPTICELL_TRY(job);
  const auto script = studies::writeSlurmScript(*job);
  HAPTICELL_TRY(script);
  std::fputs(script->c_str(), stderr);
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
