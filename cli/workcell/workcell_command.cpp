// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/kit/workcell_arguments.h"
#include "cli/workcell/workcell_commands.h"
#include "geometry/system/listed.h"
#include "workcell/files/document_lock.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/import/imported_entities.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct NewOptions {
  std::string file;
  std::vector<std::string> additions;
  std::vector<std::string> checks;
};

/// Gives what was imported the name that was asked for: its root, or an assembly above its roots.
void nameImported(const std::string& name, std::vector<workcell::Entity>& entities) {
  const auto isRoot = [](const workcell::Entity& entity) { return entity.parent.empty(); };
  const bool one = std::count_if(entities.begin(), entities.end(), isRoot) == 1;
  const std::string old = entities.front().name;
  for (workcell::Entity& entity : entities) {
    if (one ? entity.parent == old : entity.parent.empty()) entity.parent = name;
  }
  if (one) {
    entities.front().name = name;
  } else {
    workcell::Entity group;
    group.body = workcell::Assembly{};
    group.name = name;
    entities.insert(entities.begin(), std::move(group));
  }
}

/// Hangs what was added on an entity or on one of its links.
Expected<void> hang(workcell::EntityId id, const Addition& addition, workcell::Document& document) {
  const auto colon = addition.on.rfind(':');
  const bool whole = colon == std::string::npos || document.findByName(addition.on) != nullptr;
  const workcell::Entity* carrier = document.findByName(whole ? addition.on : addition.on.substr(0, colon));
  if (carrier == nullptr) {
    return makeError({.file = "--add " + addition.what,
                      .place = "on",
                      .found = Text("no entity is named '%1'", addition.on),
                      .expected = "NAME or NAME:LINK of an entity that an earlier --add added"});
  }
  const std::string link = whole ? "" : addition.on.substr(colon + 1);
  const auto hung = document.execute(workcell::Attach{id, carrier->id, link});
  if (!hung) return makeError({.file = "--add " + addition.what, .place = "on", .found = hung.error().message()});
  return {};
}

Expected<void> addEntity(const std::string& text, workcell::EntityLoader& loader, workcell::Document& document,
                         Diagnostics& notes) {
  const auto addition = parseAddition(text);
  HAPTICELL_TRY(addition);
  auto imported = loader.loadTree(addition->what, addition->options, notes);
  HAPTICELL_TRY(imported);
  if (!addition->name.empty()) {
    if (document.findByName(addition->name)) {
      return makeError({.file = "--add " + text,
                        .found = Text("the name '%1' is already in use", addition->name),
                        .expected = "a unique name"});
    }
    nameImported(addition->name, imported->entities);
  }
  const auto added = workcell::addImported(document, std::move(imported->entities), addition->X_WE);
  if (!added) return makeError({.file = "--add " + text, .found = added.error().message()});
  return addition->on.empty() ? Expected<void>{} : hang(added->front(), *addition, document);
}

Expected<void> addCheck(const std::string& text, workcell::Document& document) {
  auto set = parseCheck(text);
  HAPTICELL_TRY(set);
  for (const auto* side : {&set->first, &set->second}) {
    for (const std::string& name : *side) {
      if (document.findByName(name) != nullptr) continue;
      const std::string known = listed(document.state().entities, [](const auto& entity) { return entity->name; });
      return makeError({.place = Text("--check %1", text),
                        .found = Text("no entity is named '%1'", name),
                        .expected = Text("one of %1", known)});
    }
  }
  set->name = "Set " + std::to_string(document.state().pair_sets.size() + 1);
  const auto added = document.execute(workcell::AddPairSet{std::move(*set)});
  HAPTICELL_TRY(added);
  return {};
}

/// Builds the whole document before anything is written.
Expected<workcell::Document> makeDocument(const NewOptions& options, Diagnostics& notes) {
  workcell::Document document;
  workcell::EntityLoader loader(fs::current_path());
  for (const std::string& text : options.additions) {
    HAPTICELL_TRY(addEntity(text, loader, document, notes));
  }
  for (const std::string& text : options.checks) {
    HAPTICELL_TRY(addCheck(text, document));
  }
  return document;
}

ExitStatus runNew(const NewOptions& options, const ResultWriter& writer) {
  const auto failed = [](const Error& error) {
    report(error);
    return ExitStatus::kBadInput;
  };
  if (fs::path(options.file).extension() != ".hcell") {
    return failed({options.file, "", "the name of the document", "one that ends in .hcell", ""});
  }
  if (options.additions.empty()) {
    return failed({"", "--add", "nothing is added", "at least one entity: --add FILE or --add library:NAME", ""});
  }
  const auto lock = workcell::DocumentLock::takeForWriting(options.file);
  if (!lock) return failed(lock.error());
  Diagnostics notes;
  auto document = makeDocument(options, notes);
  if (!document) return failed(document.error());
  for (const Text& note : notes.warnings) warn(note);
  if (auto saved = workcell::saveDocument(*document, options.file); !saved) return failed(saved.error());
  ordered_json names = ordered_json::array();
  for (const auto& entity : document->state().entities) names.push_back(entity->name);
  const auto written = writer.write({{"workcell", options.file},
                                     {"entities", std::move(names)},
                                     {"pair_sets", document->state().pair_sets.size()},
                                     {"warnings", notes.warnings}});
  return written ? ExitStatus::kDone : failed(written.error());
}

}  // namespace

void addWorkcellCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("workcell", "Create workcell documents");
  command.mustGoOn();
  Subcommand make = command.add("new", "Create a document from the given entities and checks");
  const auto options = std::make_shared<NewOptions>();
  make.option("file", options->file, "Document to write (.hcell)").takes(ValueKind::kWorkcell).required();
  make.option(
          "--add", options->additions,
          "WHAT[,name=N][,unit=m|mm|in][,up=x|y|z][,tree=keep|merge][,chord=M][,angle=RAD][,on=NAME[:LINK]][,"
          "pose=x,y,z,qw,qx,qy,qz]; "
          "WHAT is a mesh, CAD or robot file, library:NAME, mannequin:SEX:PERCENTILE, or a built-in part: box:X,Y,Z, "
          "cylinder:R,H, table:W,D,H, fence:L,H, ... (docs/user/command-line.md; none of the sizes: the standard "
          "ones). "
          "May be given several times")
      .oneAtATime();
  make.option("--check", options->checks,
              "A+B:C+D[,near_miss=M][,safety=M]: check A and B against C and D. May be given several times; "
              "without it everything is checked against everything")
      .oneAtATime();
  addWorkcellExchangeCommands(command, chosen);
  make.onChosen([options, &chosen] { chosen = [options](ResultWriter& writer) { return runNew(*options, writer); }; });
}

}  // namespace hapticell::cli
