// SPDX-License-Identifier: Apache-2.0
#include "workcell/files/pack.h"

#include <sys/stat.h>

#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "geometry/system/scratch_folder.h"
#include "workcell/entity/mechanism.h"
#include "workcell/files/archive.h"
#include "workcell/files/pack_check.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

Expected<void> copyInto(const fs::path& folder, const PlannedCopy& planned, PackReport& report) {
  const fs::path to = folder / planned.place;
  std::error_code fault;
  fs::create_directories(to.parent_path(), fault);
  if (!fault) fs::copy_file(planned.from, to, fs::copy_options::overwrite_existing, fault);
  if (fault)
    return makeError({.file = planned.from.string(),
                      .found = fault.message(),
                      .expected = Text("a file that can be copied to %1", to.string())});
  if (auto same = checkCopy(to, planned.from); !same) return same;
  report.bytes += fs::file_size(to, fault);
  report.copied.push_back(planned.place);
  return {};
}

/// The document names its files by whole paths while in memory.
std::string inFolder(const std::string& place, const fs::path& folder) {
  return place.empty() || isBuiltIn(place) || fs::path(place).is_absolute() ? place : (folder / place).string();
}

DocumentState placedIn(const fs::path& folder, DocumentState state) {
  for (auto& entity : state.entities) {
    auto placed = std::make_shared<Entity>(*entity);
    placed->source.path = inFolder(placed->source.path, folder);
    if (placed->mechanism()) {
      auto definition = std::make_shared<MechanismDefinition>(*placed->mechanism());
      for (MechanismPart& part : definition->parts) part.source.path = inFolder(part.source.path, folder);
      std::get<Mechanism>(placed->body).definition = std::move(definition);
    }
    entity = std::move(placed);
  }
  for (TrajectoryReference& trajectory : state.trajectories) trajectory.path = inFolder(trajectory.path, folder);
  return state;
}

Expected<PackReport> packInto(const PackPlan& plan, const fs::path& folder, const std::string& name) {
  PackReport report;
  report.outside = plan.outside;
  for (const PlannedCopy& planned : plan.copies) {
    HAPTICELL_TRY(copyInto(folder, planned, report));
  }
  report.document = folder / name;
  const std::string text = documentText(placedIn(folder, plan.state), folder);
  HAPTICELL_TRY(writeFileAtomically(report.document, text));
  return report;
}

/// Packs into a folder that does not stay there, and reads it back.
Expected<PackReport> packAside(const DocumentState& state, const PackPlan& plan, const fs::path& aside,
                               const std::string& name, ImportMonitor* monitor) {
  auto report = packInto(plan, aside, name);
  if (!report) return report;
  const auto kept = checkPack(state, report->document, monitor);
  return kept ? std::move(report) : makeError(kept.error());
}

bool areOnOneDisk(const fs::path& a, const fs::path& b) {
  struct stat facts_a {
  }, facts_b{};
  return ::stat(a.c_str(), &facts_a) == 0 && ::stat(b.c_str(), &facts_b) == 0 && facts_a.st_dev == facts_b.st_dev;
}

/// Beside the place, so that it can take it; inside of it, where it is a folder that cannot be replaced.
Expected<ScratchFolder> scratchFolderNextTo(const fs::path& place) {
  std::error_code ignored;
  if (!fs::exists(place, ignored)) return ScratchFolder::make(place.parent_path());
  if (areOnOneDisk(place, place.parent_path())) {
    if (auto beside = ScratchFolder::make(place.parent_path())) return beside;
  }
  return ScratchFolder::make(place);
}

void putInPlace(std::string& words, const fs::path& aside, const fs::path& place) {
  for (std::size_t at = words.find(aside.string()); at != std::string::npos; at = words.find(aside.string(), at)) {
    words.replace(at, aside.string().size(), place.string());
    at += place.string().size();
  }
}

Text inPlace(const Text& text, const fs::path& aside, const fs::path& place) {
  std::vector<Text::Argument> arguments = text.arguments();
  for (Text::Argument& argument : arguments) {
    if (auto* words = std::get_if<std::string>(&argument)) putInPlace(*words, aside, place);
    if (auto* texts = std::get_if<std::vector<Text>>(&argument)) {
      for (Text& one : *texts) one = inPlace(one, aside, place);
    }
  }
  return arguments == text.arguments() ? text : Text::received(text.id(), std::move(arguments));
}

/// Says the place that the user knows instead of the folder aside.
Error inPlace(Error error, const fs::path& aside, const fs::path& place) {
  putInPlace(error.file, aside, place);
  for (Text* text : {&error.place, &error.found, &error.expected, &error.fix}) *text = inPlace(*text, aside, place);
  return error;
}

}  // namespace

Expected<PackReport> packDocument(const DocumentState& state, const fs::path& folder, const std::string& name,
                                  const PackScope& scope, Diagnostics& diagnostics, ImportMonitor* monitor) {
  std::error_code fault;
  const bool there = fs::exists(folder, fault);
  if (there && (!fs::is_directory(folder, fault) || !fs::is_empty(folder, fault))) {
    return makeError({.file = folder.string(),
                      .found = "the folder already exists and is not empty",
                      .expected = "a new or empty folder"});
  }
  const auto plan = planPack(state, scope, diagnostics, monitor);
  HAPTICELL_TRY(plan);
  if (!plan->outside.empty() && !scope.allow_outside) return PackReport{.outside = plan->outside};
  fs::path place = there ? fs::canonical(folder, fault) : fs::absolute(folder).lexically_normal();
  if (!place.has_filename()) place = place.parent_path();
  fs::create_directories(place.parent_path(), fault);
  if (fault)
    return makeError({.file = folder.string(), .found = fault.message(), .expected = "a folder that can be created"});
  auto aside = scratchFolderNextTo(place);
  HAPTICELL_TRY(aside);
  auto report = packAside(state, *plan, aside->path(), name, monitor);
  if (!report) return makeError(inPlace(report.error(), aside->path(), place));
  auto moved = aside->path().parent_path() == place ? aside->moveContentTo(place, name) : aside->moveTo(place);
  HAPTICELL_TRY(moved);
  report->document = place / name;
  return report;
}

Expected<PackReport> pack(const DocumentState& state, const fs::path& output, const std::string& name,
                          const PackScope& scope, Diagnostics& diagnostics, ImportMonitor* monitor) {
  if (!isArchiveName(output)) return packDocument(state, output, name, scope, diagnostics, monitor);
  const auto plan = planPack(state, scope, diagnostics, monitor);
  HAPTICELL_TRY(plan);
  if (!plan->outside.empty() && !scope.allow_outside) return PackReport{.outside = plan->outside};
  const fs::path archive = fs::absolute(output).lexically_normal();
  const auto aside = ScratchFolder::make(archive.parent_path());
  if (!aside) {
    return makeError(
        {.file = output.string(), .found = "no folder can be created next to it", .expected = "permission to write"});
  }
  auto report = packAside(state, *plan, aside->path(), name, monitor);
  if (!report) return makeError(inPlace(report.error(), aside->path(), archive));
  const auto written = writeArchive(aside->path(), archive);  // Read back before it takes its place.
  if (!written) return makeError(inPlace(written.error(), aside->path(), archive));
  report->document = report->document.lexically_relative(aside->path());
  return report;
}

}  // namespace hapticell::workcell
