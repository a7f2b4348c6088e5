// SPDX-License-Identifier: Apache-2.0
// workcell pack, workcell changes
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "cli/workcell/workcell_commands.h"
#include "workcell/files/pack.h"
#include "workcell/format/document_io.h"
#include "workcell/import/change_report.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct PackOptions {
  std::string file, folder;
  bool allow_outside = false;
};

struct ChangesOptions {
  std::string before, after, output;
  bool all = false;
  bool since_import = false;
};

/// The two states that are compared: of two documents, or of one and the files that its entities came from.
Expected<std::pair<workcell::DocumentState, workcell::DocumentState>> comparedStates(const ChangesOptions& options,
                                                                                     Diagnostics& notes) {
  const auto first = workcell::loadDocument(options.before, notes);
  HAPTICELL_TRY(first);
  if (options.since_import) {
    const auto imported = workcell::stateAtImport(first->state(), nullptr, notes);
    HAPTICELL_TRY(imported);
    return std::pair(*imported, first->state());
  }
  const auto second = workcell::loadDocument(options.after, notes);
  HAPTICELL_TRY(second);
  return std::pair(first->state(), second->state());
}

ExitStatus finish(const Expected<ordered_json>& result, const Diagnostics& notes, const ResultWriter& writer) {
  for (const Text& note : notes.warnings) warn(note);
  const auto written = result ? writer.write(*result) : tl::unexpected(result.error());
  if (written) return ExitStatus::kDone;
  report(written.error());
  return ExitStatus::kBadInput;
}

Expected<ordered_json> pack(const PackOptions& options, Diagnostics& notes) {
  const auto document = workcell::loadDocument(options.file, notes);
  HAPTICELL_TRY(document);
  const std::string name = fs::path(options.file).filename().string();
  std::error_code fault;
  const workcell::PackScope scope{fs::absolute(options.file, fault).parent_path(), options.allow_outside};
  const auto packed = workcell::pack(document->state(), options.folder, name, scope, notes);
  HAPTICELL_TRY(packed);
  ordered_json outside = ordered_json::array();
  for (const fs::path& file : packed->outside) outside.push_back(file.string());
  if (!packed->isWritten()) {
    for (const fs::path& file : packed->outside) notes.warn(Text("outside the folder: %1", file.string()));
    return makeError({.file = options.file,
                      .found = Text("%1 files are outside its folder", packed->outside.size()),
                      .expected = Text("only files in %1", scope.folder.string()),
                      .fix = "Nothing was written. A workcell from someone else can name any file of this machine. "
                             "Check the list, then pack with --allow-outside, or move the files into the folder."});
  }
  return ordered_json{{"workcell", packed->document.string()},
                      {"files", packed->copied},
                      {"outside", std::move(outside)},
                      {"bytes", packed->bytes}};
}

Expected<ordered_json> changes(const ChangesOptions& options, Diagnostics& notes) {
  if (options.since_import != options.after.empty()) {
    return makeError({.place = "the command line",
                      .found = options.since_import ? Text("a second document") : Text("one document"),
                      .expected = "two documents, or one with --since-import"});
  }
  const auto states = comparedStates(options, notes);
  HAPTICELL_TRY(states);
  const auto list = workcell::compareStates(states->first, states->second);
  if (!options.output.empty()) {
    const auto written = writeFileAtomically(options.output, workcell::changesAsCsv(list, options.all));
    HAPTICELL_TRY(written);
  }
  ordered_json rows = ordered_json::array();
  for (const workcell::EntityChange& change : list) {
    if (!options.all && change.kind == workcell::EntityChange::Kind::kUnchanged) continue;
    rows.push_back({{"name", change.name},
                    {"change", workcell::wordOf(change.kind)},
                    {"distance", change.distance},
                    {"angle", change.angle},
                    {"joints", change.joints}});
  }
  return ordered_json{{"changes", std::move(rows)}};
}

}  // namespace

void addWorkcellExchangeCommands(Subcommand workcell, Action& chosen) {
  Subcommand packing = workcell.add("pack", "Pack a document with all its files into one folder or archive");
  const auto pack_options = std::make_shared<PackOptions>();
  packing.option("file", pack_options->file, "Document (.hcell)").takes(ValueKind::kWorkcell).required();
  packing.option("-o,--output", pack_options->folder, "A new or empty folder, or an archive: .zip, .tar.gz")
      .takes(ValueKind::kFile)
      .required();
  packing.flag("--allow-outside", pack_options->allow_outside,
               "Also pack files outside the document's folder (default: list them and write nothing)");
  packing.onChosen([pack_options, &chosen] {
    chosen = [pack_options](ResultWriter& writer) {
      Diagnostics notes;
      const auto result = pack(*pack_options, notes);
      return finish(result, notes, writer);
    };
  });
  Subcommand changing =
      workcell.add("changes", "List what was moved, added and removed between two documents, or since the import");
  const auto options = std::make_shared<ChangesOptions>();
  changing.option("before", options->before, "Earlier document (.hcell)").takes(ValueKind::kWorkcell).required();
  changing.option("after", options->after, "Later document (.hcell)").takes(ValueKind::kWorkcell);
  changing.flag("--since-import", options->since_import,
                "Compare the document with the files that its entities came from");
  changing.option("-o,--output", options->output, "Also write a table (CSV)").takes(ValueKind::kTable);
  changing.flag("--all", options->all, "Also list what did not change");
  changing.onChosen([options, &chosen] {
    chosen = [options](ResultWriter& writer) {
      Diagnostics notes;
      const auto result = changes(*options, notes);
      return finish(result, notes, writer);
    };
  });
}

}  // namespace hapticell::cli
