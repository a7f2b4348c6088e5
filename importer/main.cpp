// SPDX-License-Identifier: Apache-2.0
// hapticell-importer: reads and writes CAD files for the other programs, so that a library that crashes, hangs or eats
// all memory takes nobody with it. What it is told and what it answers: workcell/scenes/import_process.h.
#include <assimp/version.h>
#include <unistd.h>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <map>
#include <new>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "config/program_version.h"
#include "geometry/system/regular_file.h"
#include "geometry/system/text_case.h"
#include "importer/assimp_reader.h"
#include "importer/cad_reader.h"
#include "importer/library_fault.h"
#include "importer/parent_link.h"
#include "importer/resource_limits.h"
#include "importer/sdf_resolver.h"
#include "importer/step_text.h"
#include "importer/step_writer.h"
#include "workcell/scenes/scene_batch.h"
#include "workcell/scenes/scene_exchange.h"
#include "workcell/scenes/sdf_exchange.h"

namespace {

namespace fs = std::filesystem;
using hapticell::Error;
using hapticell::Expected;
using namespace hapticell::importer;

struct Call {
  std::string action;
  fs::path file;
  std::map<std::string, double> numbers;  // By option.
  std::set<int> skipped;

  std::optional<double> number(const std::string& option) const {
    const auto found = numbers.find(option);
    return found == numbers.end() ? std::nullopt : std::optional(found->second);
  }
};

Call parse(int argc, char** argv) {
  Call call;
  if (argc > 1) call.action = argv[1];
  if (argc > 2) call.file = argv[2];
  for (int k = 3; k + 1 < argc; k += 2) {
    const double number = std::strtod(argv[k + 1], nullptr);
    if (std::string_view(argv[k]) == "--skip") {
      call.skipped.insert(static_cast<int>(number));
    } else {
      call.numbers[argv[k]] = number;
    }
  }
  return call;
}

/// STEP and IGES are OpenCASCADE's, told by content; glTF and 3MF have readers of their own, the rest is assimp's.
bool isCad(const fs::path& file) {
  if (beginsAsStep(hapticell::geometry::headOfFile(file, 65536))) return true;
  const std::string extension = hapticell::lowerExtension(file);
  return extension == ".step" || extension == ".stp" || extension == ".p21" || extension == ".stpz" ||
         extension == ".iges" || extension == ".igs";
}

Expected<std::string> readOne(const Call& call, const fs::path& file, ParentLink& parent) {
  Reading reading;
  reading.file = file;
  reading.metres_per_unit = call.number("--unit");
  reading.tessellation.chord = call.number("--chord").value_or(reading.tessellation.chord);
  reading.tessellation.angle = call.number("--angle").value_or(reading.tessellation.angle);
  reading.relative_chord = call.number("--relative-chord").value_or(0.0);
  reading.skipped = call.skipped;
  const auto scene = isCad(file) ? readCad(reading, parent) : readWithAssimp(reading, parent);
  if (!scene) return hapticell::makeError(scene.error());
  if (scene->meshes.empty()) {
    return hapticell::makeError({.found = "no shape in it", .expected = "at least one solid or surface"});
  }
  parent.progress(1.0, hapticell::Text("handing over"));
  return hapticell::workcell::sceneBytes(*scene);
}

Expected<void> handOver(const std::string& bytes, ParentLink& parent) {
  if (parent.writeScene(bytes)) return {};
  return hapticell::makeError({.found = "not enough memory or disk space to transfer the result"});
}

/// What the libraries throw becomes an error.
template <typename Result, typename Work>
Expected<Result> guarded(const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return hapticell::makeError({.found = "the import needs more memory than its limit allows",
                                 .expected = "a smaller or coarser model",
                                 .fix = "Choose a coarser tessellation or import it in parts."});
  } catch (const Standard_Failure& failure) {
    return hapticell::makeError(libraryFault(failure.DynamicType()->Name()));
  } catch (const std::exception& failure) {
    return hapticell::makeError(libraryFault(failure.what()));
  }
}

Expected<void> read(const Call& call, ParentLink& parent) {
  const Expected<std::string> bytes = readOne(call, call.file, parent);
  if (!bytes) return hapticell::makeError(bytes.error());
  return handOver(*bytes, parent);
}

/// The files whose names the parent left, a line each; one that cannot be read is an entry, not the end.
Expected<void> readAll(const Call& call, ParentLink& parent) {
  std::istringstream names(parent.readScene());
  std::vector<fs::path> files;
  for (std::string name; std::getline(names, name);) files.emplace_back(name);
  std::vector<hapticell::workcell::BatchEntry> entries;
  for (const fs::path& file : files) {
    parent.setRange(static_cast<double>(entries.size()) / static_cast<double>(files.size()),
                    static_cast<double>(entries.size() + 1) / static_cast<double>(files.size()));
    parent.progress(0.0, hapticell::Text("reading %1", file.filename().string()));
    const auto bytes = guarded<std::string>([&] { return readOne(call, file, parent); });
    const Error error = bytes ? Error{} : bytes.error();
    entries.push_back({bytes.has_value(), bytes ? *bytes : parent.flatParts(error)});
  }
  return handOver(hapticell::workcell::batchBytes(entries), parent);
}

Expected<void> write(const Call& call, ParentLink& parent) {
  const auto scene = hapticell::workcell::sceneFromBytes(parent.readScene());
  if (!scene) return hapticell::makeError(scene.error());
  return writeStep(*scene, call.file, parent);
}

/// The text that the parent left, as libsdformat understands it.
Expected<void> resolve(const Call& call, ParentLink& parent) {
  parent.progress(0.0, "reading " + call.file.filename().string());
  const auto content = resolveSdf(parent.readScene());
  if (!content) return hapticell::makeError(content.error());
  return handOver(hapticell::workcell::sdfBytes(*content), parent);
}

Expected<void> perform(const Call& call, ParentLink& parent) {
  if (call.action == "read-all") return readAll(call, parent);
  if (call.action == "resolve-sdf") return resolve(call, parent);
  return call.action == "write" ? write(call, parent) : read(call, parent);
}

constexpr const char* kUsage = R"(usage: hapticell-importer ACTION [FILE] [OPTION VALUE]...

Reads and writes CAD files for hapticell and hapticell-cli, which start it, so that a fault in a CAD library cannot end
them. It is not meant to be started by hand: use hapticell-cli convert.

Actions:
  read FILE              read a STEP, IGES, glTF, Collada, 3MF, FBX or 3DS file
  read-all               read the files named by the starting program, one per line
  resolve-sdf FILE       read the SDF text that the starting program made of this file
  write FILE             write the scene of the starting program as STEP

Options:
  --unit METRES          length of one unit of the file
  --chord METRES         largest distance of a triangle from the exact face
  --relative-chord N     the same as a fraction of the model size
  --angle RADIANS        largest angle between segments of an edge
  --skip PART            leave out this part of the file; can be repeated
  --memory BYTES         memory limit
  --seconds N            processor time limit
  --help                 show this text and exit
  --version              show version, commit, compiler and libraries, and exit
)";

/// Answers --help and --version; false for everything else.
bool answers(std::string_view option) {
  if (option == "--help" || option == "-h") return std::fputs(kUsage, stdout), true;
  if (option != "--version") return false;
  const std::string assimp_version = std::to_string(aiGetVersionMajor()) + "." + std::to_string(aiGetVersionMinor()) +
                                     "." + std::to_string(aiGetVersionPatch());
  const std::string text = hapticell::config::versionText(
      "hapticell-importer", {{"Open CASCADE", OCC_VERSION_COMPLETE}, {"assimp", assimp_version}});
  return std::puts(text.c_str()), true;
}

}  // namespace

int main(int argc, char** argv) {
  const Call call = parse(argc, argv);
  if (answers(call.action)) return 0;
  const std::set<std::string> actions = {"read", "read-all", "resolve-sdf", "write"};
  if (!actions.contains(call.action)) return 2;
  limitResources(static_cast<std::uint64_t>(call.number("--memory").value_or(6e9)),
                 static_cast<std::uint64_t>(call.number("--seconds").value_or(600.0)));
  ParentLink parent;
  const auto result = guarded<void>([&] { return perform(call, parent); });
  if (result) {
    parent.done();
  } else {
    parent.error(result.error());
  }
  ::_exit(result ? 0 : 1);  // The libraries' own tidying up takes long and may crash.
}
