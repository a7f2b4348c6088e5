// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/files/entity_report.h"
#include "cli/files/file_commands.h"
#include "cli/files/import_arguments.h"
#include "cli/kit/progress_line.h"
#include "cli/kit/xacro_arguments.h"
#include "geometry/shapes/mass_properties.h"
#include "geometry/shapes/topology.h"
#include "geometry/system/in_parallel.h"
#include "workcell/document/carried_load.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/meshes/length_unit.h"
#include "workcell/meshes/mesh_care.h"
#include "workcell/meshes/mesh_reader.h"
#include "workcell/robots/robot_library.h"
#include "workcell/robots/robot_reader.h"
#include "workcell/scenes/import_scene.h"
#include "workcell/scenes/whole_mesh.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct InspectOptions {
  std::string file;
  std::vector<std::string> arguments;  ///< NAME:=VALUE of a xacro.
  std::string unit;                    ///< Empty: as the file says, else guessed.
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

/// Nothing was dropped, and every shell is closed and faces outward by more than what welding moved.
bool facesOutward(const geometry::WeldReport& dropped, const geometry::Topology& topology) {
  // Of what a shell sweeps: welding moves vertices by a millionth of the size, which a shell of a thousandth of it does
  // not feel. Half and twice as well; a mesh below is looked at in full, which takes longer.
  constexpr double kClear = 0.05;
  return dropped.degenerate_triangles + dropped.duplicate_triangles == 0 && topology.least_volume_share > kClear;
}

/// What the report of each part shows of it. Welding is tried on copies, so that the counts and sizes shown are those of
/// the file.
std::vector<SolidFacts> warnAboutTriangles(const std::vector<workcell::MeshPart>& parts, Diagnostics& notes) {
  std::size_t degenerate = 0, duplicate = 0, rejected = 0, holes = 0;
  bool open = false, inward = false;
  std::vector<SolidFacts> facts;
  std::vector<const geometry::TriangleMesh*> unclear;
  for (const workcell::MeshPart& part : parts) {
    geometry::TriangleMesh welded = part.mesh;
    const geometry::WeldReport dropped = geometry::weld(welded, geometry::weldTolerance(welded));
    const geometry::Topology topology = geometry::topologyOf(welded);
    degenerate += dropped.degenerate_triangles;
    duplicate += dropped.duplicate_triangles;
    rejected += topology.rejected_triangles;
    holes += topology.holes;
    facts.push_back({geometry::enclosedVolume(part.mesh), topology.closed});
    open = open || !topology.closed;
    inward = inward || facts.back().volume < 0.0;
    if (!facesOutward(dropped, topology)) unclear.push_back(&part.mesh);
  }
  const auto say = [&](std::size_t count, const char* what) {
    if (count > 0) notes.warn(Text("%1: %2", Text(what), count));
  };
  say(degenerate, HAPTICELL_TRANSLATED("zero-area triangles, left out in a workcell"));
  say(duplicate, HAPTICELL_TRANSLATED("duplicate triangles, kept once in a workcell"));
  say(rejected, HAPTICELL_TRANSLATED("triangles that share an edge with more than two faces, or are flipped"));
  say(holes, HAPTICELL_TRANSLATED("holes in the surface"));
  if (open) notes.warn("the surface is not closed, so the volume is not reliable");
  if (inward) {
    notes.warn("the triangles face inward, so the volume is negative");
  } else {
    workcell::FacingNote facing;
    for (const geometry::TriangleMesh* mesh : unclear) facing.look(*mesh);
    facing.tell(notes);
  }
  return facts;
}

/// What one unit of the file means: as --unit says, else the file, else its size.
Expected<double> unitOf(const InspectOptions& options, const workcell::MeshFileParts& file, Diagnostics& notes) {
  if (!options.unit.empty()) {
    const auto said = workcell::parseLengthUnit(options.unit);
    HAPTICELL_TRY(said);
    return workcell::metresPer(*said);
  }
  if (file.unit_is_stated) return file.metres_per_unit;
  geometry::Bounds bounds;
  for (const workcell::MeshPart& part : file.parts) bounds.add(part.mesh.bounds());
  const workcell::LengthUnit unit = workcell::guessUnit(bounds);
  notes.warn(
      Text("the file has no unit; %1 is assumed from its size (to change this, use --unit)", workcell::unitName(unit)));
  return workcell::metresPer(unit);
}

/// The names that users know; other units are shown as metres per unit.
std::string unitWord(double metres_per_unit) {
  for (workcell::LengthUnit unit :
       {workcell::LengthUnit::kMetre, workcell::LengthUnit::kMillimetre, workcell::LengthUnit::kInch}) {
    if (std::abs(workcell::metresPer(unit) - metres_per_unit) < 1e-9 * metres_per_unit) return workcell::unitName(unit);
  }
  for (const auto& [metres, word] : {std::pair(0.01, "cm"), std::pair(0.3048, "ft")}) {
    if (std::abs(metres - metres_per_unit) < 1e-9 * metres_per_unit) return word;
  }
  std::ostringstream text;
  text << metres_per_unit << " m";
  return text.str();
}

void scale(geometry::TriangleMesh& mesh, double factor) {
  // Vertices for a thread to be worth it. Half, twice: no effect.
  constexpr std::size_t kLeast = 100'000;
  const std::size_t count = factor == 1.0 ? 0 : mesh.vertices.size();
  geometry::inRanges(count, geometry::rangesOf(count, kLeast), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) mesh.vertices[k] *= factor;
  });
}

Expected<ordered_json> inspectMesh(const InspectOptions& options, Diagnostics& notes) {
  workcell::MeshReadOptions reading;
  reading.weld = false;
  reading.warn_about_unit = false;
  Expected<workcell::MeshFileParts> file = workcell::readMeshParts(options.file, reading, true, notes);
  HAPTICELL_TRY(file);
  const auto unit = unitOf(options, *file, notes);
  HAPTICELL_TRY(unit);
  for (workcell::MeshPart& part : file->parts) {
    scale(part.mesh, *unit / file->metres_per_unit);
  }
  const std::vector<SolidFacts> facts = warnAboutTriangles(file->parts, notes);
  const workcell::MeshFormat format = file->format;
  const auto scene = workcell::sceneOfParts(std::move(*file), fs::path(options.file).stem().string());
  ordered_json result = inspection(workcell::formatName(format), unitWord(*unit).c_str(), sceneReport(scene, facts), notes);
  if (format == workcell::MeshFormat::kStlAscii) result["encoding"] = "ascii";
  if (format == workcell::MeshFormat::kStlBinary) result["encoding"] = "binary";
  return result;
}

Expected<ordered_json> inspectCad(const InspectOptions& options, Diagnostics& notes) {
  workcell::ImportOptions reading;
  reading.tessellation = options.tessellation;
  if (!options.unit.empty()) {
    const auto said = workcell::parseLengthUnit(options.unit);
    HAPTICELL_TRY(said);
    reading.metres_per_unit = workcell::metresPer(*said);
  }
  ProgressLine progress;
  const auto scene = workcell::readScene(options.file, reading, &progress.monitor());
  HAPTICELL_TRY(scene);
  notes.warnings = scene->warnings;
  if (!scene->unit_is_stated) notes.warn(Text("the file has no unit; %1 is assumed", unitWord(scene->metres_per_unit)));
  if (scene->up_axis != workcell::UpAxis::kZ) {
    notes.warn(Text("in the file, %1 points up; the model was rotated so that z points up",
                    workcell::axisName(scene->up_axis)));
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
    return makeError({.file = options.file,
                      .place = "--unit",
                      .found = "'" + options.unit + "'",
                      .expected = "no --unit: robot files are in metres"});
  }
  const auto arguments = parseXacroArguments(options.arguments);
  HAPTICELL_TRY(arguments);
  workcell::SourceFile source{options.file, 1.0};
  source.arguments = *arguments;
  const auto robot = workcell::EntityLoader(fs::current_path()).loadSource(source, notes);
  HAPTICELL_TRY(robot);
  const auto format = workcell::robotFormatOf(options.file);
  ordered_json result = inspection(format ? workcell::formatName(*format) : "library", "m",
                                   ordered_json::array({entityReport(*robot)}), notes);
  if (format == workcell::RobotFormat::kXacro) {
    result["arguments"] = ordered_json::array();
    for (const auto& one : workcell::robotArguments(options.file, *arguments))
      result["arguments"].push_back(
          {{"name", one.name},
           {"value", one.value},
           {"default", one.otherwise ? ordered_json(*one.otherwise) : ordered_json(nullptr)}});
  }
  return result;
}

const char* wordOf(workcell::LoadVerdict verdict) {
  switch (verdict) {
    case workcell::LoadVerdict::kNothing:
      return "none";
    case workcell::LoadVerdict::kTooHeavy:
      return "too heavy";
    case workcell::LoadVerdict::kAllowed:
      return "allowed";
    case workcell::LoadVerdict::kOpen:
      break;
  }
  return "not known";
}

/// What each robot of the cell carries, against what its maker allows.
ordered_json loadsReport(const workcell::DocumentState& state) {
  ordered_json loads = ordered_json::array();
  for (const auto& entity : state.entities) {
    if (entity->kind() != workcell::EntityKind::kRobot || !entity->robot()) continue;
    const workcell::CarriedLoad load = workcell::carriedLoad(state, *entity);
    const double payload = workcell::ratedPayload(entity->source.path).value_or(0.0);
    ordered_json parts = ordered_json::array(), other = ordered_json::array();
    for (const auto& part : load.parts) parts.push_back(part->name);
    for (const auto& part : load.other) other.push_back(part->name);
    loads.push_back({{"robot", entity->name},
                     {"link", load.link},
                     {"payload", payload > 0.0 ? ordered_json(payload) : ordered_json(nullptr)},
                     {"mass", load.mass},
                     {"center_of_mass", toJson(load.p_LC)},
                     {"distance", glm::length(load.p_LC)},
                     {"parts", std::move(parts)},
                     {"mass_not_entered", load.starting},
                     {"on_other_links", std::move(other)},
                     {"verdict", wordOf(workcell::verdictOn(load, payload))}});
  }
  return loads;
}

Expected<ordered_json> inspectDocument(const InspectOptions& options, Diagnostics& notes) {
  const auto document = workcell::loadDocument(options.file, notes);
  HAPTICELL_TRY(document);
  ordered_json result = inspection("hcell", "m", treeReport(document->snapshotEntities()), notes);
  result["loads"] = loadsReport(document->state());
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

/// By what the file holds.
Expected<ordered_json> inspect(const InspectOptions& options, Diagnostics& notes) {
  if (looksLikeDocument(options.file)) return inspectDocument(options, notes);
  if (workcell::holdsScene(options.file)) return inspectCad(options, notes);
  if (isRobot(options.file)) return inspectRobot(options, notes);
  return inspectMesh(options, notes);
}

ExitStatus runInspect(const InspectOptions& options, const ResultWriter& writer) {
  Diagnostics notes;
  if (!options.arguments.empty() && workcell::robotFormatOf(options.file) != workcell::RobotFormat::kXacro) {
    report({.file = options.file,
            .found = Text("'%1' after a file that is not xacro", options.arguments.front()),
            .expected = "no further arguments"});
    return ExitStatus::kBadInput;
  }
  const auto result = inspect(options, notes);
  const auto written = result ? writer.write(*result) : tl::unexpected(result.error());
  if (written) return ExitStatus::kDone;
  report(written.error());
  return ExitStatus::kBadInput;
}

}  // namespace

void addInspectCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("inspect", "Show what a file contains: entities, sizes, joints, and its problems");
  const auto options = std::make_shared<InspectOptions>();
  command
      .option("file", options->file,
              "Mesh (STL, OBJ, PLY, OFF), CAD file (STEP, IGES, glTF, Collada, 3MF, FBX, 3DS), robot (URDF, xacro, "
              "SDF, robot.toml, library:NAME) or workcell (.hcell)")
      .takes(ValueKind::kModel)
      .required();
  command.option("arguments", options->arguments, "Xacro arguments, NAME:=VALUE; can be repeated");
  command.option("--unit", options->unit, "Unit of a mesh file: m, mm or in (default: from the file, else guessed)");
  addTessellationOptions(command, options->tessellation);
  command.onChosen(
      [options, &chosen] { chosen = [options](ResultWriter& writer) { return runInspect(*options, writer); }; });
}

}  // namespace hapticell::cli
