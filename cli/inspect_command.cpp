// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>

#include "cli/commands.h"
#include "cli/entity_report.h"
#include "cli/import_arguments.h"
#include "cli/progress_line.h"
#include "geometry/topology.h"
#include "workcell/document_io.h"
#include "workcell/entity_source.h"
#include "workcell/import_scene.h"
#include "workcell/length_unit.h"
#include "workcell/mesh_reader.h"
#include "workcell/robot_reader.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct InspectOptions {
  std::string file;
  std::string unit;  ///< Empty: as the file says, else guessed.
  workcell::Tessellation tessellation;
};

ordered_json inspection(const char* format, const char* unit, ordered_json entities, const Diagnostics& notes) {
  return {{"format", format},
          {"unit", unit},
          {"up_axis", "z"},
          {"warnings", notes.warnings},
          {"entities", std::move(entities)}};
}

bool looksLikeDocument(const fs::path& file) {
  return file.extension() == ".hcell";
}

/// Welding is tried on a copy, so that the counts and sizes shown are those of the file.
void warnAboutTriangles(const workcell::MeshFile& file, const ordered_json& report, Diagnostics& notes) {
  geometry::TriangleMesh welded = file.mesh;
  const geometry::WeldReport dropped = geometry::weld(welded, geometry::weldTolerance(welded));
  const auto say = [&](std::uint32_t count, const char* what) {
    if (count > 0) notes.warn(what + (": " + std::to_string(count)));
  };
  say(dropped.degenerate_triangles, "triangles without area, left out in a workcell");
  say(dropped.duplicate_triangles, "triangles that are there twice, left out once in a workcell");
  const geometry::Topology topology = geometry::topologyOf(welded);
  say(topology.rejected_triangles, "triangles at an edge of more than two faces, or turned over");
  say(topology.holes, "holes in the surface");
  if (!report["closed"].get<bool>()) notes.warn("the surface is not closed, so the volume means little");
  if (report["volume"].get<double>() < 0.0) notes.warn("the triangles face inward, so the volume is negative");
}

Expected<ordered_json> inspectMesh(const InspectOptions& options, Diagnostics& notes) {
  workcell::MeshReadOptions reading;
  reading.weld = false;
  reading.warn_about_unit = false;
  Expected<workcell::MeshFile> file = workcell::readMeshFile(options.file, reading, notes);
  if (!file) return tl::unexpected(file.error());
  workcell::LengthUnit unit = workcell::guessUnit(file->mesh.bounds());
  if (options.unit.empty()) {
    notes.warn(std::string("the file names no unit; by its size it is taken as ") + workcell::unitName(unit) +
               " (--unit says otherwise)");
  } else {
    const auto said = workcell::parseLengthUnit(options.unit);
    if (!said) return tl::unexpected(said.error());
    unit = *said;
  }
  for (dvec3& vertex : file->mesh.vertices) vertex *= workcell::metresPer(unit);
  const std::string name = fs::path(options.file).stem().string();
  const workcell::Entity plain;
  ordered_json report = meshReport(name, file->mesh, Pose::identity(), plain.color);
  warnAboutTriangles(*file, report, notes);
  ordered_json result = inspection(workcell::formatName(file->format), workcell::unitName(unit),
                                   ordered_json::array({std::move(report)}), notes);
  if (file->format == workcell::MeshFormat::kStlAscii) result["encoding"] = "ascii";
  if (file->format == workcell::MeshFormat::kStlBinary) result["encoding"] = "binary";
  return result;
}

/// The names that users know; other units are shown as metres per unit.
std::string unitWord(double metres_per_unit) {
  for (workcell::LengthUnit unit :
       {workcell::LengthUnit::kMetre, workcell::LengthUnit::kMillimetre, workcell::LengthUnit::kInch}) {
    if (std::abs(workcell::metresPer(unit) - metres_per_unit) < 1e-9 * metres_per_unit) return workcell::unitName(unit);
  }
  std::ostringstream text;
  text << metres_per_unit << " m";
  return text.str();
}

Expected<ordered_json> inspectCad(const InspectOptions& options, Diagnostics& notes) {
  workcell::ImportOptions reading;
  reading.tessellation = options.tessellation;
  if (!options.unit.empty()) {
    const auto said = workcell::parseLengthUnit(options.unit);
    if (!said) return tl::unexpected(said.error());
    reading.metres_per_unit = workcell::metresPer(*said);
  }
  ProgressLine progress;
  const auto scene = workcell::readScene(options.file, reading, &progress.monitor());
  if (!scene) return tl::unexpected(scene.error());
  notes.warnings = scene->warnings;
  if (!scene->unit_is_stated) notes.warn("the file names no unit; it is taken as " + unitWord(scene->metres_per_unit));
  if (scene->up_axis != workcell::UpAxis::kZ) {
    notes.warn(std::string("the file has ") + workcell::axisName(scene->up_axis) +
               " up; it was turned so that z is up");
  }
  const std::string unit = unitWord(scene->metres_per_unit);
  ordered_json result = inspection(scene->format.c_str(), unit.c_str(), sceneReport(*scene), notes);
  result["up_axis"] = workcell::axisName(scene->up_axis);
  return result;
}

bool isRobot(const std::string& file) {
  return file.starts_with("library:") || workcell::looksLikeRobot(file);
}

Expected<ordered_json> inspectRobot(const InspectOptions& options, Diagnostics& notes) {
  if (!options.unit.empty() && options.unit != "m") {
    return makeError({options.file, "--unit", "'" + options.unit + "'", "none: robot files are in metres", ""});
  }
  const auto robot = workcell::EntityLoader(fs::current_path()).load(options.file, 1.0, notes);
  if (!robot) return tl::unexpected(robot.error());
  const auto format = workcell::robotFormatOf(options.file);
  return inspection(format ? workcell::formatName(*format) : "library", "m",
                    ordered_json::array({entityReport(*robot)}), notes);
}

Expected<ordered_json> inspectDocument(const InspectOptions& options, Diagnostics& notes) {
  const auto document = workcell::loadDocument(options.file, notes);
  if (!document) return tl::unexpected(document.error());
  ordered_json result = inspection("hcell", "m", treeReport(document->snapshotEntities()), notes);
  result["pair_sets"] = ordered_json::array();
  for (const workcell::PairSet& set : document->state().pair_sets) {
    result["pair_sets"].push_back({{"name", set.name},
                                   {"enabled", set.enabled},
                                   {"first", set.first},
                                   {"second", set.second},
                                   {"safety_distance", set.safety_distance},
                                   {"near_miss", set.near_miss}});
  }
  return result;
}

ExitStatus runInspect(const InspectOptions& options, const ResultWriter& writer) {
  Diagnostics notes;
  const auto result = looksLikeDocument(options.file)      ? inspectDocument(options, notes)
                      : workcell::holdsScene(options.file) ? inspectCad(options, notes)
                      : isRobot(options.file)              ? inspectRobot(options, notes)
                                                           : inspectMesh(options, notes);
  const auto written = result ? writer.write(*result) : tl::unexpected(result.error());
  if (written) return ExitStatus::kDone;
  report(written.error());
  return ExitStatus::kBadInput;
}

}  // namespace

void addInspectCommand(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("inspect", "What is in a file: entities, sizes, joints, and what is wrong with it");
  const auto options = std::make_shared<InspectOptions>();
  command
      ->add_option("file", options->file,
                   "A mesh (STL, OBJ, PLY, OFF), a CAD file (STEP, IGES, glTF, Collada, 3MF, FBX, 3DS), a robot (URDF, "
                   "xacro, SDF, "
                   "robot.toml, library:NAME) or a workcell (.hcell)")
      ->required();
  command->add_option("--unit", options->unit,
                      "What one unit of a mesh file is: m, mm or in; as the file says, or guessed, when not given");
  addTessellationOptions(*command, options->tessellation);
  command->callback(
      [options, &chosen] { chosen = [options](ResultWriter& writer) { return runInspect(*options, writer); }; });
}

}  // namespace hapticell::cli
