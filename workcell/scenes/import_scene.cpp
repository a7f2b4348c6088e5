// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/import_scene.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "geometry/system/plain_number.h"
#include "geometry/system/regular_file.h"
#include "geometry/system/text_case.h"
#include "workcell/scenes/import_process.h"
#include "workcell/scenes/scene_call.h"
#include "workcell/scenes/scene_exchange.h"
#include "workcell/scenes/sdf_cell_reader.h"

namespace hapticell::workcell {

namespace {

// Bytes looked at for a format's first words. Half, twice: long comments hide COLLADA, or no effect.
constexpr std::size_t kSceneHead = 4096;

std::string number(double value) {
  return plainNumber(value, std::chars_format::general, 17);
}

std::string plainName(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  std::replace(name.begin(), name.end(), '#', '_');
  return name.empty() ? "_" : name;
}

/// A chord that is no number would have the mesher divide for ever.
Expected<void> checkTessellation(const ImportOptions& options, const std::filesystem::path& file) {
  const auto within = [](double value, double least, double greatest) { return value >= least && value <= greatest; };
  const Tessellation& t = options.tessellation;
  if (!within(t.chord, 1e-9, 1e3))
    return makeError({.file = file.string(), .place = "chord", .found = number(t.chord), .expected = "1e-9 to 1000 m"});
  if (!within(t.angle, 1e-3, 3.2))
    return makeError(
        {.file = file.string(), .place = "angle", .found = number(t.angle), .expected = "0.001 to 3.2 rad"});
  if (!within(options.relative_chord, 0.0, 1.0))
    return makeError({.file = file.string(),
                      .place = "relative chord",
                      .found = number(options.relative_chord),
                      .expected = "0 to 1"});
  if (options.metres_per_unit && !within(*options.metres_per_unit, 1e-12, 1e12))
    return makeError({.file = file.string(),
                      .place = "unit",
                      .found = number(*options.metres_per_unit),
                      .expected = "metres above 0"});
  return {};
}

}  // namespace

bool isFiner(const ImportOptions& options) {
  // Of the size: finer chords than the usual quality's make more triangles than limitBySize() expects. Half: limits by
  // size refuse fine imports; twice: usual ones have none.
  constexpr double kUsualShare = 1e-4;
  const Tessellation usual;
  if (options.relative_chord > 0.0) return options.relative_chord < kUsualShare;
  return options.tessellation.chord < usual.chord || options.tessellation.angle < usual.angle;
}

std::uintmax_t bytesToRead(const std::filesystem::path& file) {
  // Fold of a zip, by which limits by size count: between a fifth and a fiftieth (kMostFold of
  // importer/model_package.cpp). Half: packed files have half the time; twice: broken ones have twice.
  constexpr std::uintmax_t kPacked = 10;
  std::error_code fault;
  const std::uintmax_t size = std::filesystem::file_size(file, fault);
  if (fault) return 0;
  const std::string extension = lowerExtension(file), head = geometry::headOfFile(file, 4);
  const bool packed =
      extension == ".stpz" || extension == ".3mf" || head.starts_with("PK") || head.starts_with("\x1F\x8B");
  return packed ? kPacked * size : size;
}

bool holdsScene(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 12> kExtensions = {".step", ".stp", ".p21", ".stpz", ".iges", ".igs",
                                                            ".gltf", ".glb", ".dae", ".3mf",  ".fbx",  ".3ds"};
  const std::string head = geometry::headOfFile(file, kSceneHead);
  if (head.starts_with("ISO-10303-21") || head.starts_with("glTF") || head.starts_with("Kaydara FBX")) return true;
  if (head.find("<COLLADA") != std::string::npos) return true;
  const std::string extension = lowerExtension(file);
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end() || isSdfCell(file);
}

Expected<ImportedScene> readScene(const std::filesystem::path& file, const ImportOptions& options,
                                  ImportMonitor* monitor) {
  HAPTICELL_TRY(geometry::checkRegularFile(file));
  const std::filesystem::path absolute = std::filesystem::absolute(file);
  HAPTICELL_TRY(checkTessellation(options, file));
  if (isSdfCell(absolute)) return readSdfCell(absolute, monitor, !options.merge);
  ImporterCall call;
  call.file = file.string();
  call.arguments = {"read", absolute.string()};
  for (std::string& word : importerWords(options)) call.arguments.push_back(std::move(word));
  call.limits = options.limits;
  limitBySize(call, bytesToRead(absolute), isFiner(options));
  call.monitor = monitor;
  const Expected<std::string> bytes = callImporter(call);
  HAPTICELL_TRY(bytes);
  return uprightScene(*bytes, file, options);
}

std::vector<std::string> importerWords(const ImportOptions& options) {
  std::vector<std::string> words = {"--chord", number(options.tessellation.chord), "--angle",
                                    number(options.tessellation.angle)};
  if (options.relative_chord > 0.0) words.insert(words.end(), {"--relative-chord", number(options.relative_chord)});
  if (options.metres_per_unit) words.insert(words.end(), {"--unit", number(*options.metres_per_unit)});
  return words;
}

Expected<ImportedScene> uprightScene(std::string_view bytes, const std::filesystem::path& file,
                                     const ImportOptions& options) {
  Expected<ImportedScene> scene = sceneFromBytes(bytes);
  if (!scene) {
    Error error = scene.error();
    error.file = file.string();
    return makeError(error);
  }
  if (options.up_axis) scene->up_axis = *options.up_axis;
  for (SceneNode& node : scene->nodes) {
    if (node.parent < 0 && scene->up_axis != UpAxis::kZ) node.X_PN = turnedUp(scene->up_axis) * node.X_PN;
  }
  return scene;
}

std::vector<Pose> nodePoses(const ImportedScene& scene) {
  std::vector<Pose> poses;
  poses.reserve(scene.nodes.size());
  for (const SceneNode& node : scene.nodes) {
    poses.push_back(node.parent < 0 ? node.X_PN : poses[static_cast<std::size_t>(node.parent)] * node.X_PN);
  }
  return poses;
}

std::vector<std::string> partPaths(const ImportedScene& scene) {
  std::vector<std::string> paths;
  std::unordered_map<std::string, int> used;
  for (const SceneNode& node : scene.nodes) {
    std::string path = node.parent < 0 ? "" : paths[static_cast<std::size_t>(node.parent)] + "/";
    path += plainName(node.name);
    if (const int times = ++used[path]; times > 1) path += "#" + std::to_string(times);
    paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace hapticell::workcell
