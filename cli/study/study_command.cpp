// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/kit/result_writer.h"
#include "cli/kit/stop_signal.h"
#include "cli/study/chunk_option.h"
#include "cli/study/study_commands.h"
#include "cli/study/study_progress.h"
#include "cli/study/study_report.h"
#include "studies/runner/study_run.h"
#include "studies/store/result_merge.h"
#include "studies/store/result_ranking.h"
#include "workcell/files/document_lock.h"
#include "workcell/format/document_io.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using studies::ResultRow;
using studies::ResultStore;
using studies::Study;

struct StudyOptions {
  std::string study, results, output, chunk, csv;
  std::vector<std::string> parts, csv_words;
  int jobs = 0, variant = -1, count = 10;
  bool pareto = false, partial = false;
};
using Options = std::shared_ptr<StudyOptions>;

ExitStatus finish(const Expected<ordered_json>& answer, const ResultWriter& writer) {
  const auto written = answer ? writer.write(*answer) : Expected<void>(tl::unexpected<Error>(answer.error()));
  if (written) return ExitStatus::kDone;
  report(written.error());
  return ExitStatus::kBadInput;
}

Expected<ordered_json> runStudyCommand(const StudyOptions& options) {
  const auto chunk = parseChunk(options.chunk);
  HAPTICELL_TRY(chunk);
  const StopSignal stop;
  const auto study = Study::load(options.study, studyVersion());
  HAPTICELL_TRY(study);
  for (const Text& note : (*study)->notes()) warn(note);
  auto store = ResultStore::openOrCreate(options.output, (*study)->head());
  HAPTICELL_TRY(store);
  StudyProgress progress;
  studies::RunOptions run{chunk->chunk, chunk->chunks, options.jobs, {}, {}, &stop.asked()};
  run.progress = [&](const studies::RunProgress& now) { progress.show(now); };
  const auto summary = studies::runStudy(**study, *store, run);
  HAPTICELL_TRY(summary);
  if (!summary->complete)
    return makeError({.file = options.output,
                      .found = "stopped before all variants were evaluated; the rows so far are kept",
                      .fix = "Run the same command again to continue."});
  const double rate = summary->seconds > 0.0 ? static_cast<double>(summary->rows) / summary->seconds : 0.0;
  return ordered_json{{"results", options.output},
                      {"study", (*study)->head().name},
                      {"variants", (*study)->head().variants},
                      {"chunk", std::to_string(chunk->chunk) + "/" + std::to_string(chunk->chunks)},
                      {"rows", summary->rows},
                      {"kept", summary->kept_units},
                      {"complete", summary->complete},
                      {"notes", (*study)->notes()},
                      {"timing", {{"seconds", summary->seconds}, {"per_second", rate}}}};
}

Expected<ordered_json> showStudy(const StudyOptions& options) {
  const auto store = ResultStore::open(options.results, false);
  HAPTICELL_TRY(store);
  return summaryJson(*store);
}

Expected<ordered_json> bestOfStudy(const StudyOptions& options) {
  const auto store = ResultStore::open(options.results, false);
  HAPTICELL_TRY(store);
  std::vector<ResultRow> rows;
  if (options.pareto) {
    const auto document = studies::StudyDocument::parse(store->head().study, store->head().file);
    HAPTICELL_TRY(document);
    auto front = studies::paretoRows(*store, *document);
    HAPTICELL_TRY(front);
    rows = std::move(*front);
  } else {
    auto best = studies::bestRows(*store, static_cast<std::size_t>(options.count));
    HAPTICELL_TRY(best);
    rows = std::move(*best);
  }
  return ordered_json{{"study", store->head().name},
                      {"pareto", options.pareto},
                      {"variants", rowsJson(store->head(), rows)}};
}

/// The file to read and the one to write, however --csv was given: with the file to write, or alone.
Expected<ordered_json> exportStudy(const StudyOptions& options, bool& printed) {
  std::string results = options.results;
  std::string output = options.output;
  // Without a word the option holds an empty one.
  for (const std::string& word : options.csv_words)
    if (!word.empty()) (results.empty() ? results : output) = word;
  if (results.empty())
    return makeError({.place = "RESULTS", .found = "no results file", .expected = "the file that study run wrote"});
  const auto store = ResultStore::open(results, false);
  HAPTICELL_TRY(store);
  const auto text = studies::csvOf(*store);
  HAPTICELL_TRY(text);
  const auto rows = store->rowCount();
  HAPTICELL_TRY(rows);
  if (output.empty()) {
    HAPTICELL_TRY(printText(*text));
    printed = true;
    return ordered_json();
  }
  HAPTICELL_TRY(writeFileAtomically(output, *text));
  return ordered_json{{"results", results}, {"csv", output}, {"rows", *rows}};
}

Expected<ordered_json> openVariant(const StudyOptions& options) {
  const auto store = ResultStore::open(options.results, false);
  HAPTICELL_TRY(store);
  const auto row = store->row(options.variant);
  HAPTICELL_TRY(row);
  if (!*row)
    return makeError({.file = options.results,
                      .place = "--variant",
                      .found = Text("no variant %1", options.variant),
                      .expected = Text("a number of a row, below %1", store->head().variants)});
  const auto study = Study::load(store->head().study, store->head().file, store->head().version);
  HAPTICELL_TRY(study);
  HAPTICELL_TRY(studies::checkSameStudy(store->head(), (*study)->head(), options.results));
  // A second evaluation, from the values in the row: what is opened is what was measured.
  const ResultRow again = (*study)->evaluate((*row)->number, (*row)->values);
  const bool same = again == **row;
  if (!same && store->head().version == studyVersion())
    return makeError({.file = options.results,
                      .place = Text("variant %1", options.variant),
                      .found = "results that differ from a new evaluation",
                      .expected = "equal results",
                      .fix = "Run the study again: the row was changed, or made by another kind of processor."});
  auto document = (*study)->cellOf((*row)->values);
  HAPTICELL_TRY(document);
  const auto lock = workcell::DocumentLock::takeForWriting(options.output);
  HAPTICELL_TRY(lock);
  HAPTICELL_TRY(workcell::saveDocument(*document, options.output));
  ordered_json opened = rowJson(store->head(), **row);
  opened["workcell"] = options.output;
  opened["same_as_row"] = same;
  return opened;
}

Expected<ordered_json> mergeStudy(const StudyOptions& options) {
  std::vector<fs::path> parts(options.parts.begin(), options.parts.end());
  const auto summary = studies::mergeResults(parts, options.output, options.partial);
  HAPTICELL_TRY(summary);
  return ordered_json{{"results", options.output},
                      {"parts", options.parts.size()},
                      {"rows", summary->rows},
                      {"missing", summary->missing_units},
                      {"complete", summary->missing_units == 0}};
}

using Answering = Expected<ordered_json> (*)(const StudyOptions&);

void choose(Subcommand command, const Options& options, Action& chosen, Answering answer) {
  command.onChosen([options, &chosen, answer] {
    chosen = [options, answer](ResultWriter& writer) { return finish(answer(*options), writer); };
  });
}

void addRun(Subcommand study, Action& chosen) {
  Subcommand command = study.add("run", "Evaluate all variants of a study; continues what an earlier run began");
  const auto options = std::make_shared<StudyOptions>();
  command.option("study", options->study, "Study document (.hstudy)").takes(ValueKind::kStudy).required();
  command.option("-o,--output", options->output, "Results file (.hresults, SQLite): made, or continued")
      .takes(ValueKind::kStudyResults)
      .required();
  command.option("--chunk", options->chunk, "I/N: only this part of N equal parts, for several machines");
  command.option("--jobs", options->jobs, "Threads (default: one a core)").withinWhole(1, 4096);
  choose(command, options, chosen, runStudyCommand);
}

void addShow(Subcommand study, Action& chosen) {
  Subcommand command = study.add("show", "Summarise a results file: rows, ranges of the results, runs");
  const auto options = std::make_shared<StudyOptions>();
  command.option("results", options->results, "Results file").takes(ValueKind::kStudyResults).required();
  choose(command, options, chosen, showStudy);
}

void addBest(Subcommand study, Action& chosen) {
  Subcommand command = study.add("best", "List the best variants by their objective, or the Pareto front");
  const auto options = std::make_shared<StudyOptions>();
  command.option("results", options->results, "Results file").takes(ValueKind::kStudyResults).required();
  command.option("--count", options->count, "How many (default: 10)").withinWhole(1, 100'000);
  command.flag("--pareto", options->pareto, "All variants that no other one beats in every objective");
  choose(command, options, chosen, bestOfStudy);
}

void addExport(Subcommand study, Action& chosen) {
  Subcommand command = study.add("export", "Write all rows as a table");
  const auto options = std::make_shared<StudyOptions>();
  command.option("results", options->results, "Results file").takes(ValueKind::kStudyResults);
  command.option("--csv", options->csv_words, "As CSV (the only form); may be followed by the file to write")
      .takes(ValueKind::kTable)
      .values(0, 1);
  command.option("-o,--output", options->output, "Table to write (default: standard output)").takes(ValueKind::kTable);
  command.onChosen([options, &chosen] {
    chosen = [options](ResultWriter& writer) {
      bool printed = false;
      const auto answer = exportStudy(*options, printed);
      return printed ? ExitStatus::kDone : finish(answer, writer);
    };
  });
}

void addOpen(Subcommand study, Action& chosen) {
  Subcommand command = study.add("open", "Evaluate one variant again, compare it with its row, and write its cell");
  const auto options = std::make_shared<StudyOptions>();
  command.option("results", options->results, "Results file").takes(ValueKind::kStudyResults).required();
  command.option("--variant", options->variant, "Number of the variant").withinWhole(0, 2'000'000'000).required();
  command.option("-o,--output", options->output, "Document to write (.hcell)").takes(ValueKind::kWorkcell).required();
  choose(command, options, chosen, openVariant);
}

void addMerge(Subcommand study, Action& chosen) {
  Subcommand command = study.add("merge", "Join the results of chunks into one file");
  const auto options = std::make_shared<StudyOptions>();
  command.option("parts", options->parts, "Results files of the chunks").takes(ValueKind::kStudyResults).required();
  command.option("-o,--output", options->output, "Results file to write").takes(ValueKind::kStudyResults).required();
  command.flag("--partial", options->partial, "Accept missing chunks; study run completes the result");
  choose(command, options, chosen, mergeStudy);
}

}  // namespace

void addStudyCommand(Subcommand app, Action& chosen) {
  Subcommand study = app.add("study", "Evaluate many variants of a cell and choose among them");
  study.mustGoOn();
  addRun(study, chosen);
  addShow(study, chosen);
  addBest(study, chosen);
  addExport(study, chosen);
  addOpen(study, chosen);
  addMerge(study, chosen);
  addStudySubmit(study, chosen);
}

}  // namespace hapticell::cli
