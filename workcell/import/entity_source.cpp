// SPDX-License-Identifier: Apache-2.0
#include "workcell/import/entity_source.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "geometry/shapes/shapes.h"
#include "mannequin/body/body_request_text.h"
#include "mannequin/motion/free_hand.h"
#include "mannequin/shape/figure_model.h"
#include "workcell/entity/built_in_parts.h"
#include "workcell/meshes/mesh_care.h"
#include "workcell/meshes/mesh_reader.h"
#include "workcell/robots/robot_library.h"
#include "workcell/robots/robot_reader.h"
#include "workcell/scenes/placeholder_name.h"
#include "workcell/scenes/scene_exchange.h"
#include "workcell/scenes/whole_mesh.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

/// The same path of a part; in documents of 0.2 the top of a file may have a name that says nothing, which is now that
/// of the file.
bool isSamePart(const std::string& written, const std::string& now, const std::string& stem) {
  if (written == now) return true;
  const std::size_t end = std::min(written.find('/'), written.size());
  const std::size_t number = std::min(written.rfind('#', end), end);
  return saysNothing(written.substr(0, number)) && now == stem + written.substr(number);
}

std::string schemeOf(const std::string& what) {
  const std::size_t colon = what.find(':');
  if (colon == std::string::npos) return {};
  std::string scheme = what.substr(0, colon);
  for (const char* known : {"library", "mannequin", "hand", "frame"}) {
    if (scheme == known) return scheme;
  }
  return findBuiltInPart(scheme) != nullptr ? scheme : std::string();
}

void turnUp(geometry::TriangleMesh& mesh, const std::optional<UpAxis>& up) {
  if (!up || *up == UpAxis::kZ) return;
  const Pose X_WF = turnedUp(*up);
  for (dvec3& vertex : mesh.vertices) vertex = X_WF * vertex;
}

/// A hand by itself, for a glove: "hand:left" or "hand:right", with ":SEX:PERCENTILE" another body's.
Expected<Entity> loadFreeHand(const std::string& what) {
  const std::string words = what.substr(what.find(':') + 1);
  const std::string side = words.substr(0, words.find(':'));
  const std::string body = "mannequin:" + (words == side ? "male:50" : words.substr(side.size() + 1));
  if (side != "left" && side != "right") {
    return makeError({.file = what,
                      .found = Text("the hand '%1'", side),
                      .expected = "hand:left or hand:right, and :SEX:PERCENTILE"});
  }
  const Expected<mannequin::BodyRequest> request = mannequin::parseBodyRequest(body);
  const Expected<mannequin::Figure> figure =
      request ? mannequin::makeFigure(*request) : Expected<mannequin::Figure>(makeError(request.error()));
  if (!figure) {
    Error error = figure.error();
    error.file = what;
    return makeError(std::move(error));
  }
  const auto model =
      mannequin::freeHandModel(*figure, side == "left" ? mannequin::Side::kLeft : mannequin::Side::kRight);
  Entity entity;
  entity.body =
      Robot{{.model = model, .joints = std::vector<double>(model->dof(), 0.0), .tip_link = model->links.front().name}};
  entity.name = side + " hand";
  entity.source = {what, 1.0};
  entity.contact.mass = 0.4;
  return entity;
}

/// "frame:".
Expected<Entity> loadFrame(const std::string& what) {
  if (what.back() != ':') {
    return makeError({.file = what,
                      .found = Text("'%1' after frame:", what.substr(what.find(':') + 1)),
                      .expected = "frame: alone",
                      .fix = "A frame has no dimensions. Set its name and pose (name=N, pose=x,y,z,qw,qx,qy,qz)."});
  }
  return makeFrame("frame", {});
}

/// Triangles of a solid, or of all visual shapes of a robot.
std::size_t shownTriangles(const Entity& entity) {
  std::size_t count = entity.mesh() ? entity.mesh()->triangles.size() : 0;
  if (!entity.robot()) return count;
  for (const kinematics::Link& link : entity.robot()->links)
    for (const kinematics::LinkShape& shape : link.visuals) count += shape.mesh ? shape.mesh->triangles.size() : 0;
  return count;
}

}  // namespace

Entity makeFrame(std::string name, const Pose& X_WE) {
  Entity entity;
  entity.body = CellFrame{};
  entity.name = std::move(name);
  entity.source = {"frame:", 1.0};
  entity.X_WE = X_WE;
  entity.checked = false;
  return entity;
}

bool isBuiltIn(const std::string& what) {
  return !schemeOf(what).empty();
}

Expected<Entity> EntityLoader::load(const std::string& what, double scale, Diagnostics& diagnostics) {
  return loadSource({what, scale}, diagnostics);
}

Expected<Entity> EntityLoader::loadSource(const SourceFile& source, Diagnostics& diagnostics) {
  Expected<Entity> entity = loadShapeOf(source, diagnostics);
  if (!entity || !entity->mesh() || (!source.oriented && source.simplified == 0.0)) return entity;
  entity->source.oriented = source.oriented;
  entity->source.simplified = source.simplified;
  auto& cared = cared_meshes_[{entity->mesh(), {source.oriented, source.simplified}}];
  if (!cared) {
    geometry::TriangleMesh mesh = *entity->mesh();
    if (source.oriented) orient(mesh);
    if (source.simplified > 0.0) {
      Expected<MadeMesh> made = simplify(mesh, source.simplified);
      HAPTICELL_TRY(made);
      mesh = std::move(made->mesh);
    }
    cared = std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
  }
  entity->body = Solid{cared};
  return entity;
}

Expected<Entity> EntityLoader::loadShapeOf(const SourceFile& source, Diagnostics& diagnostics) {
  const std::string& what = source.path;
  const std::string scheme = schemeOf(what);
  const bool said = source.scale != 0.0 && source.scale != 1.0;
  if (scheme == "mannequin") return loadMannequin(what);
  if (scheme == "hand") return loadFreeHand(what);
  if (scheme == "frame") return loadFrame(what);
  if (scheme == "library") return loadLibraryRobot(what, diagnostics);
  if (!scheme.empty()) return makeBuiltInPart(what, said ? source.scale : 1.0);
  const fs::path file = (folder_ / what).lexically_normal();
  if (holdsScene(file)) return loadPart(file, source, diagnostics);
  if (!looksLikeRobot(file)) {
    return source.part.empty() ? loadMesh(file, source, diagnostics) : loadPart(file, source, diagnostics);
  }
  if (said) {
    return makeError({.file = file.string(),
                      .found = "a unit for a robot",
                      .expected = "no unit: robot files are in metres",
                      .fix = "Leave the unit out."});
  }
  return loadRobot(file, source.arguments, diagnostics);
}

Expected<ImportResult> EntityLoader::loadTree(const std::string& what, const ImportOptions& options,
                                              Diagnostics& diagnostics, ImportMonitor* monitor) {
  const fs::path file = (folder_ / what).lexically_normal();
  if (!isBuiltIn(what) && holdsScene(file)) {
    Expected<ImportedScene> scene = readScene(file, options, monitor);
    HAPTICELL_TRY(scene);
    return entitiesFromScene(std::move(*scene), {file.string()}, options, diagnostics);
  }
  if (monitor) monitor->report(Text("reading"), 0.0);
  if (!isBuiltIn(what) && !looksLikeRobot(file)) return loadMeshTree(file, options, diagnostics);
  ImportMonitor* const usual = monitor_;
  if (monitor) monitor_ = monitor;
  SourceFile source{what, options.metres_per_unit.value_or(0.0)};
  source.arguments = options.arguments;
  declared_.clear();
  Expected<Entity> entity = loadSource(source, diagnostics);
  monitor_ = usual;
  HAPTICELL_TRY(entity);
  ImportResult result;
  const std::optional<RobotFormat> format = robotFormatOf(file);
  result.report.format = entity->robot() ? "library" : "shape";
  if (format) result.report.format = formatName(*format);
  result.report.parts = 1;
  result.report.arguments = declared_;
  result.report.triangles = shownTriangles(*entity);
  result.entities.push_back(std::move(*entity));
  return result;
}

Expected<ImportResult> EntityLoader::loadMeshTree(const fs::path& file, const ImportOptions& options,
                                                  Diagnostics& diagnostics) const {
  MeshReadOptions reading{options.metres_per_unit, options.weld, options.warn_about_unit && !options.metres_per_unit};
  Expected<MeshFileParts> read = readMeshParts(file, reading, !options.merge, diagnostics);
  HAPTICELL_TRY(read);
  const geometry::WeldReport weld = read->weld;
  const bool one = read->parts.size() == 1;
  const UpAxis up = options.up_axis.value_or(UpAxis::kZ);
  if (one) turnUp(read->parts[0].mesh, up);  // A file of one solid is a part without a name, as loadMesh() reads it.
  ImportedScene scene = sceneOfParts(std::move(*read), file.stem().string());
  for (SceneNode& node : scene.nodes) {
    if (!one && node.parent < 0) node.X_PN = turnedUp(up) * node.X_PN;
  }
  ImportOptions made;  // All else is done.
  made.up_axis = options.up_axis;
  made.weld = false;
  Expected<ImportResult> result = entitiesFromScene(std::move(scene), {file.string()}, made, diagnostics);
  if (!result) return result;
  if (one) result->entities[0].source.part.clear();
  result->report.up_axis = up;
  result->report.merged_vertices = weld.merged_vertices;
  result->report.degenerate_triangles = weld.degenerate_triangles;
  result->report.duplicate_triangles = weld.duplicate_triangles;
  return result;
}

Expected<Entity> EntityLoader::loadPart(const fs::path& file, const SourceFile& source, Diagnostics& diagnostics) {
  ImportOptions options;
  if (source.scale != 0.0) options.metres_per_unit = source.scale;
  options.up_axis = source.up_axis;
  options.tessellation = source.tessellation;
  options.merge = source.part.empty();
  char how[120];
  std::snprintf(how, sizeof how, "|%.17g|%d|%.17g|%.17g|%d", source.scale,
                source.up_axis ? static_cast<int>(*source.up_axis) : -1, source.tessellation.chord,
                source.tessellation.angle, options.merge);
  const std::string key = file.string() + how;
  auto known = trees_.find(key);
  if (known == trees_.end()) {
    Expected<ImportResult> tree = loadTree(file.string(), options, diagnostics, monitor_);
    HAPTICELL_TRY(tree);
    known = trees_.emplace(key, std::move(*tree)).first;
  }
  for (const Entity& entity : known->second.entities) {
    if (!options.merge && !isSamePart(source.part, entity.source.part, file.stem().string())) continue;
    Entity found = entity;
    found.parent.clear();
    return found;
  }
  return makeError({.file = file.string(),
                    .found = Text("no part is named '%1'", source.part),
                    .expected = "a part that the file still has",
                    .fix = "Import the file again."});
}

Expected<Entity> EntityLoader::loadLibraryRobot(const std::string& what, Diagnostics& diagnostics) {
  const std::string name = what.substr(what.find(':') + 1);
  const Expected<fs::path> file = findLibraryRobot(name);
  HAPTICELL_TRY(file);
  Expected<Entity> entity = loadRobot(*file, {}, diagnostics);
  if (!entity) return entity;
  entity->source = {what, 1.0};
  entity->name = name;
  return entity;
}

Expected<Entity> EntityLoader::loadMannequin(const std::string& what) {
  const Expected<mannequin::BodyRequest> request = mannequin::parseBodyRequest(what);
  Expected<mannequin::Figure> figure =
      request ? mannequin::makeFigure(*request) : Expected<mannequin::Figure>(makeError(request.error()));
  if (!figure) {
    Error error = figure.error();
    error.file = what;
    return makeError(std::move(error));
  }
  auto& model = robots_[what].model;
  if (!model) model = mannequin::figureModel(*figure);
  Entity entity;
  entity.body =
      Mannequin{{.model = model,
                 .joints = mannequin::toModel(*figure, *mannequin::libraryPosture(*figure, "standing")).joints,
                 .tip_link = "r_hand"},
                std::make_shared<const mannequin::Figure>(*figure)};
  entity.name = "mannequin";
  entity.source = {what, 1.0};
  entity.contact.mass = figure->totalMass();
  return entity;
}

Expected<Entity> EntityLoader::loadRobot(const fs::path& file, const xacro::Arguments& arguments,
                                         Diagnostics& diagnostics) {
  std::string key = file.string();
  for (const auto& [name, value] : arguments) key += "|" + name + ":=" + value;
  auto& known = robots_[key];
  if (!known.model) {
    declared_.clear();
    Expected<TomlRobot> robot = readRobot(file, diagnostics, monitor_, RobotContent::kAll, arguments, &declared_);
    HAPTICELL_TRY(robot);
    known = {std::make_shared<const kinematics::RobotModel>(std::move(robot->model)), std::move(robot->tools),
             robot->X_FB};
  }
  Entity entity = robotEntity(known.model, known.model->name.empty() ? file.stem().string() : known.model->name);
  entity.X_WE = known.X_FB;
  entity.editJointed().tools = known.tools;
  entity.source = {file.string(), 1.0};
  entity.source.arguments = arguments;
  return entity;
}

Expected<Entity> EntityLoader::loadMesh(const fs::path& file, const SourceFile& source, Diagnostics& diagnostics) {
  const char* up = source.up_axis ? axisName(*source.up_axis) : "";
  KnownMesh& known = meshes_[{file.string() + "|" + up, source.scale}];
  if (!known.mesh) {
    Diagnostics notes;
    MeshReadOptions reading;
    if (source.scale != 0.0) reading.scale = source.scale;
    reading.warn_about_unit = !unit_is_stated_;
    Expected<MeshFileParts> read = readMeshParts(file, reading, false, notes);
    HAPTICELL_TRY(read);
    MeshPart& part = read->parts[0];
    turnUp(part.mesh, source.up_axis);
    known = {std::make_shared<const geometry::TriangleMesh>(std::move(part.mesh)), part.color, read->metres_per_unit};
    for (const Text& note : notes.warnings) diagnostics.warn(Text("%1: %2", file.filename().string(), note));
  }
  Entity entity;
  entity.body = Solid{known.mesh};
  entity.name = file.stem().string();
  if (known.color) entity.color = *known.color;
  entity.source = {file.string(), known.metres_per_unit, "", source.up_axis, {}};
  return entity;
}

}  // namespace hapticell::workcell
