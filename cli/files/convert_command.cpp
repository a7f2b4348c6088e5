// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string>

#include "cli/files/file_commands.h"
#include "cli/files/import_arguments.h"
#include "cli/kit/kept_result.h"
#include "cli/kit/progress_line.h"
#include "exchange/recordings/recording_reader.h"
#include "exchange/recordings/recording_writer.h"
#include "geometry/shapes/surface_distance.h"
#include "geometry/system/promise.h"
#include "geometry/system/scratch_folder.h"
#include "geometry/system/text_case.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/files/scene_export.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/meshes/length_unit.h"
#include "workcell/meshes/mesh_care.h"

namespace hapticell::cli {

namespace {

struct ConvertOptions {
  std::string file;
  std::string output;
  std::string unit;         ///< Of the read file; empty: as it says, else guessed from the size as `inspect` does.
  std::string output_unit;  ///< Of a written mesh file; empty: metres, but the guessed unit where one was guessed.
  std::string up;
  workcell::Tessellation tessellation;
  double simplify = 0.0;  ///< Metres; 0: not.
  bool hull = false;
  bool allow_miss = false;
};

/// A robot's file, or the one robot of a workcell, as URDF.
Expected<nlohmann::ordered_json> convertToUrdf(const ConvertOptions& options, Diagnostics& notes) {
  workcell::DocumentState state;
  if (lowerExtension(options.file) == ".hcell") {
    const auto document = workcell::loadDocument(options.file, notes);
    HAPTICELL_TRY(document);
    state = document->state();
  } else {
    auto entity = workcell::EntityLoader(std::filesystem::current_path()).load(options.file, 0.0, notes);
    HAPTICELL_TRY(entity);
    entity->id = 1;
    state.entities.push_back(std::make_shared<const workcell::Entity>(std::move(*entity)));
  }
  const auto written = workcell::exportState(state, options.output, {}, notes);
  HAPTICELL_TRY(written);
  return nlohmann::ordered_json{{"output", options.output}, {"warnings", notes.warnings}};
}

/// A motion from or to MCAP.
Expected<nlohmann::ordered_json> convertMotion(const ConvertOptions& options, Diagnostics& notes) {
  auto motion = exchange::isMcapFile(options.file)
                    ? exchange::readMcapMotion(options.file, {}, &notes.warnings)
                    : trajectory::readTrajectory(options.file, &notes.warnings);
  HAPTICELL_TRY(motion);
  const std::string extension = lowerExtension(options.output);
  nlohmann::ordered_json result{{"output", options.output}, {"frames", motion->size()}};
  if (extension == ".mcap") {
    exchange::Recording recording;
    recording.motions.push_back(std::move(*motion));
    HAPTICELL_TRY(exchange::writeMcapRecording(recording, options.output));
  } else if (extension == ".htraj" || extension == ".csv") {
    HAPTICELL_TRY(
        writeFileAtomically(options.output, extension == ".csv" ? toCsvText(*motion) : toJsonText(*motion)));
  } else {
    return makeError({.file = options.output,
                      .found = Text("the extension '%1'", extension),
                      .expected = ".htraj, .csv or .mcap for a motion"});
  }
  result["warnings"] = notes.warnings;
  return result;
}

/// Replaces meshes by ones with fewer triangles or by their hulls. Gives the largest deviation, metres.
Expected<double> careFor(workcell::ImportedScene& scene, const ConvertOptions& options, double allowed) {
  double most = 0.0;
  for (geometry::TriangleMesh& mesh : scene.meshes) {
    geometry::weld(mesh, geometry::weldTolerance(mesh));
    auto made = options.hull ? workcell::convexMesh(mesh) : workcell::simplify(mesh, allowed);
    if (!made) {
      Error error = made.error();
      error.file = options.file;
      return makeError(error);
    }
    mesh = std::move(made->mesh);
    most = std::max(most, made->deviation);
  }
  for (workcell::SceneNode& node : scene.nodes) node.origin.reset();  // The exact shape is not what was asked for.
  return most;
}

Expected<workcell::ImportOptions> importOptions(const ConvertOptions& options) {
  workcell::ImportOptions reading;
  reading.tessellation = options.tessellation;
  reading.weld = false;
  reading.warn_about_unit = false;
  if (!options.unit.empty()) {
    const auto unit = workcell::parseLengthUnit(options.unit);
    HAPTICELL_TRY(unit);
    reading.metres_per_unit = workcell::metresPer(*unit);
  }
  if (!options.up.empty()) {
    const auto axis = workcell::parseAxis(options.up);
    HAPTICELL_TRY(axis);
    reading.up_axis = *axis;
  }
  return reading;
}

void rescale(workcell::ImportedScene& scene, double factor) {
  for (geometry::TriangleMesh& mesh : scene.meshes) {
    for (dvec3& vertex : mesh.vertices) vertex *= factor;
  }
  for (workcell::SceneNode& node : scene.nodes) node.X_PN.p *= factor;
}

/// A mesh file that names no unit was read in metres; where its size makes another one likely, that is taken instead,
/// as `inspect` does, and a mesh file is written in it: its numbers stay, and both have one size. Gives metres per
/// unit.
double takeLikelyUnit(workcell::ImportedScene& scene, Diagnostics& notes) {
  geometry::Bounds bounds;
  const std::vector<Pose> X_W = workcell::nodePoses(scene);
  for (std::size_t k = 0; k < X_W.size(); ++k) {
    const int mesh = scene.nodes[k].mesh;
    if (mesh < 0) continue;
    bounds.add(geometry::transformed(X_W[k], scene.meshes[static_cast<std::size_t>(mesh)].bounds()));
  }
  const workcell::LengthUnit unit = workcell::guessUnit(bounds);
  notes.warn(
      Text("the file has no unit; %1 is assumed from its size (to change this, use --unit)", workcell::unitName(unit)));
  if (unit != workcell::LengthUnit::kMetre) rescale(scene, workcell::metresPer(unit));
  return workcell::metresPer(unit);
}

bool namesNoUnit(const workcell::ImportedScene& scene) {
  const bool mesh = scene.format == "stl" || scene.format == "obj" || scene.format == "ply" || scene.format == "off";
  return mesh && !scene.unit_is_stated;
}

/// All of a scene in one mesh, in the file's frame.
geometry::TriangleMesh wholeOf(const workcell::ImportedScene& scene) {
  geometry::TriangleMesh whole;
  const std::vector<Pose> X_W = workcell::nodePoses(scene);
  for (std::size_t k = 0; k < X_W.size(); ++k) {
    if (scene.nodes[k].mesh < 0) continue;
    const geometry::TriangleMesh& mesh = scene.meshes[static_cast<std::size_t>(scene.nodes[k].mesh)];
    const auto first = static_cast<std::uint32_t>(whole.vertices.size());
    for (const dvec3& vertex : mesh.vertices) whole.vertices.push_back(X_W[k] * vertex);
    for (const auto& triangle : mesh.triangles)
      whole.triangles.push_back({first + triangle[0], first + triangle[1], first + triangle[2]});
  }
  return whole;
}

/// How far the surfaces of a simplified scene's file are from those that were read: written into a folder that does not
/// stay, read back as any file is, and measured.
Expected<Promises> simplifyPromises(const geometry::TriangleMesh& given, const workcell::ImportedScene& scene,
                                    const ConvertOptions& options, const workcell::ExportOptions& writing) {
  // Of the size: files of meshes have numbers of seven digits. Half: rounding alone fails a promise; twice: twice the
  // rounding passes.
  constexpr double kFloats = 1e-6;
  const auto folder = ScratchFolder::make();
  HAPTICELL_TRY(folder);
  const std::filesystem::path file = folder->path() / std::filesystem::path(options.output).filename();
  Diagnostics unheard;
  if (auto written = workcell::exportScene(scene, file, writing, unheard); !written)
    return tl::unexpected(written.error());
  workcell::ImportOptions reading;
  reading.weld = false;
  reading.warn_about_unit = false;
  reading.metres_per_unit = writing.metres_per_unit;
  auto again = workcell::sceneOfFile(file, reading, unheard);
  HAPTICELL_TRY(again);
  const auto most = geometry::surfaceDistance(given, wholeOf(*again));
  geometry::Bounds bounds = given.bounds();
  const std::string place =
      "at x " + std::to_string(most.p.x) + ", y " + std::to_string(most.p.y) + ", z " + std::to_string(most.p.z) + " m";
  Promises promises;
  promises.help = "Use a larger --simplify.";
  promises.list.push_back({"surface", options.simplify, most.distance, "m", place, false,
                           kFloats * (glm::length(bounds.max - bounds.min) + glm::length(bounds.center()))});
  return promises;
}

/// Simplifies the scene so that its file keeps the promise; where what was left is too far off between the places that
/// simplifying looks at, with a smaller tolerance.
Expected<double> simplifyKept(const geometry::TriangleMesh& given, workcell::ImportedScene& scene,
                              const ConvertOptions& options, const workcell::ExportOptions& writing,
                              nlohmann::ordered_json& kept) {
  // Rounds with 0.7 of the tolerance each: to a sixth. Half: some meshes fail to keep their promise; twice: time.
  constexpr int kTries = 5;
  double allowed = options.simplify;
  for (int round = 0;; ++round, allowed *= 0.7) {
    workcell::ImportedScene trial = scene;
    const auto deviation = careFor(trial, options, allowed);
    if (!deviation) return deviation;
    const auto promises = simplifyPromises(given, trial, options, writing);
    HAPTICELL_TRY(promises);
    if (!promises->areKept() && round < kTries) continue;
    if (auto told = reportPromises(*promises, options.output, options.allow_miss, kept); !told)
      return tl::unexpected(told.error());
    scene = std::move(trial);
    return deviation;
  }
}

Expected<nlohmann::ordered_json> convert(const ConvertOptions& options, Diagnostics& notes) {
  if (lowerExtension(options.output) == ".urdf") return convertToUrdf(options, notes);
  if (exchange::isMcapFile(options.file) || exchange::isMcapFile(options.output)) return convertMotion(options, notes);
  const auto reading = importOptions(options);
  HAPTICELL_TRY(reading);
  workcell::ExportOptions writing;
  if (!options.output_unit.empty()) {
    const auto unit = workcell::parseLengthUnit(options.output_unit);
    HAPTICELL_TRY(unit);
    writing.metres_per_unit = workcell::metresPer(*unit);
  }
  ProgressLine progress;
  auto scene = workcell::sceneOfFile(options.file, *reading, notes, &progress.monitor());
  HAPTICELL_TRY(scene);
  if (options.unit.empty() && namesNoUnit(*scene)) {
    const double likely = takeLikelyUnit(*scene, notes);
    if (options.output_unit.empty()) writing.metres_per_unit = likely;
  }
  workcell::FacingNote facing;
  for (const geometry::TriangleMesh& mesh : scene->meshes) facing.look(mesh);
  facing.tell(notes);
  const bool cared = options.hull || options.simplify > 0.0;
  const geometry::TriangleMesh given = options.simplify > 0.0 ? wholeOf(*scene) : geometry::TriangleMesh{};
  nlohmann::ordered_json kept = nlohmann::ordered_json::object();
  auto deviation = options.hull ? careFor(*scene, options, 0.0) : Expected<double>(0.0);
  if (options.simplify > 0.0) deviation = simplifyKept(given, *scene, options, writing, kept);
  HAPTICELL_TRY(deviation);
  const auto written = workcell::exportScene(*scene, options.output, writing, notes);
  HAPTICELL_TRY(written);
  std::size_t parts = 0, triangles = 0;
  for (const workcell::SceneNode& node : scene->nodes) {
    if (node.mesh < 0) continue;
    ++parts;
    triangles += scene->meshes[static_cast<std::size_t>(node.mesh)].triangles.size();
  }
  nlohmann::ordered_json result{{"output", options.output}, {"parts", parts}, {"triangles", triangles}};
  if (cared) result["deviation"] = *deviation;
  result.update(kept);
  result["warnings"] = notes.warnings;
  return result;
}

ExitStatus runConvert(const ConvertOptions& options, const ResultWriter& writer) {
  Diagnostics notes;
  const auto result = convert(options, notes);
  for (const Text& note : notes.warnings) warn(note);
  const auto written = result ? writer.write(*result) : tl::unexpected(result.error());
  if (written) return ExitStatus::kDone;
  report(written.error());
  return ExitStatus::kBadInput;
}

}  // namespace

void addConvertCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("convert", "Convert between formats, by file extension");
  const auto options = std::make_shared<ConvertOptions>();
  command.option("file", options->file, "Mesh, CAD, robot or workcell file; or a motion, from or to MCAP").takes(ValueKind::kModel).required();
  command.option("-o,--output", options->output, "STEP, GLB, glTF, STL, OBJ, PLY or OFF; URDF for a robot; MCAP for a motion")
      .takes(ValueKind::kModel)
      .required();
  command.option("--unit", options->unit, "Unit of the input file: m, mm or in (default: from the file, else guessed)");
  command.option(
      "--output-unit", options->output_unit,
      "Unit of the written STL, OBJ, PLY or OFF: m, mm or in (default: m, or that of an input mesh without a unit)");
  const Option simplify =
      command.option("--simplify", options->simplify, "Reduce triangles, within this distance of the surface, m")
          .within(1e-9, 1e3);
  addAllowMiss(command, options->allow_miss);
  command.flag("--hull", options->hull, "Write the convex hull of each part").excludes(simplify);
  command.option("--up", options->up, "Up axis of the input file: x, y or z");
  addTessellationOptions(command, options->tessellation);
  command.onChosen(
      [options, &chosen] { chosen = [options](ResultWriter& writer) { return runConvert(*options, writer); }; });
}

}  // namespace hapticell::cli
