// SPDX-License-Identifier: Apache-2.0
#include "workcell/files/pack_plan.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <set>

#include "trajectory/files/trajectory_io.h"
#include "workcell/entity/mechanism.h"
#include "workcell/files/claimed_content.h"
#include "workcell/files/named_files.h"
#include "workcell/import/entity_source.h"
#include "workcell/robots/robot_reader.h"
#include "workcell/scenes/sdf_cell_reader.h"
#include "workcell/text/package_path.h"
#include "workcell/text/read_record.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

// 2 GB: guards the disk against a wrong folder. Half, twice: other packs are refused with a message.
constexpr std::uintmax_t kMostPackedBytes = std::uintmax_t{2} << 30;
constexpr const char* kPackages[] = {"package.xml", "model.config", "manifest.xml"};

fs::path wholePath(const fs::path& file) {
  std::error_code fault;
  return fs::absolute(file, fault).lexically_normal();
}

/// The folder of the package (the one with package.xml) that a file stands in; empty: in none.
fs::path packageOf(const fs::path& file) {
  std::error_code ignored;
  for (fs::path at = file.parent_path(); at != at.parent_path(); at = at.parent_path()) {
    if (fs::is_regular_file(at / "package.xml", ignored)) return at;
  }
  return {};
}

fs::path commonFolder(const fs::path& a, const fs::path& b) {
  fs::path common;
  for (auto at = a.begin(), other = b.begin(); at != a.end() && other != b.end() && *at == *other; ++at, ++other)
    common /= *at;
  return common;
}

bool isManifest(const fs::path& file) {
  return std::any_of(std::begin(kPackages), std::end(kPackages),
                     [&](const char* name) { return file.filename() == name; });
}

class Planner {
 public:
  Planner(const PackScope& scope, Diagnostics& diagnostics, ImportMonitor* monitor)
      : diagnostics_(diagnostics), monitor_(monitor) {
    std::error_code fault;
    if (!scope.folder.empty()) allowed_ = fs::weakly_canonical(wholePath(scope.folder), fault);
  }

  Expected<void> takeEntity(std::shared_ptr<const Entity>& entity);
  /// An assembly has no shape that was read of its file.
  Expected<void> takeAssembly(std::shared_ptr<const Entity>& entity);
  Expected<void> takeTrajectory(TrajectoryReference& trajectory);

  PackPlan plan;

 private:
  using Files = std::set<fs::path>;

  Expected<void> takeSource(SourceFile& source, const Text& who, bool was_read);
  Expected<std::string> takeShapes(const fs::path& file);
  Expected<std::string> takeWithFolder(const fs::path& file, Files files);
  Expected<void> takeManifests(const fs::path& file, const fs::path& root, const fs::path& place);
  Expected<Files> filesOfRobot(const fs::path& file, const SourceFile& source);
  Expected<void> readAsShapes(const fs::path& file);
  Expected<void> copy(const fs::path& file, const fs::path& place);
  std::string folderFor(const fs::path& root);
  fs::path freePlace(const fs::path& name);

  fs::path allowed_;
  Diagnostics& diagnostics_;
  ImportMonitor* monitor_;
  std::map<std::string, std::string> places_;  // Of what a state names.
  std::map<fs::path, std::string> folders_;    // Of packages, and of robots without one.
  std::set<std::string> taken_, copied_;
  std::set<fs::path> outside_;
  std::uintmax_t bytes_ = 0;
};

fs::path Planner::freePlace(const fs::path& name) {
  const fs::path wanted = name.empty() || name == "/" ? fs::path("robot") : name;
  fs::path place = fs::path("files") / wanted;
  for (int number = 2; !taken_.insert(place.string()).second; ++number)
    place = fs::path("files") / (wanted.stem().string() + "-" + std::to_string(number) + wanted.extension().string());
  return place;
}

Expected<void> Planner::copy(const fs::path& file, const fs::path& place) {
  if (!copied_.insert(place.generic_string()).second) return {};
  std::error_code fault;
  const fs::path real = fs::canonical(file, fault);
  if (fault || !fs::is_regular_file(real, fault))
    return makeError({.file = file.string(),
                      .found = fault ? Text(fault.message()) : Text("not a regular file"),
                      .expected = "a file that can be read"});
  const std::uintmax_t size = fs::file_size(real, fault);
  if (fault) return makeError({.file = file.string(), .found = fault.message(), .expected = "a file that can be read"});
  bytes_ += size;
  if (bytes_ > kMostPackedBytes)
    return makeError(
        {.file = file.string(), .found = "with this file, the pack is larger than 2 GB", .expected = "at most 2 GB"});
  if (allowed_.empty() || !isBelow(real, allowed_)) {
    if (outside_.insert(real).second) plan.outside.push_back(file);
  }
  plan.copies.push_back({real, place.generic_string()});
  return {};
}

/// A file that names others (OBJ its colours, glTF its data, STEP its parts) gets a folder for all of them.
Expected<std::string> Planner::takeShapes(const fs::path& file) {
  std::vector<fs::path> named = filesNamedIn(file);
  std::erase_if(named, [](const fs::path& other) { return !isWhatItClaims(other); });
  const fs::path place = named.empty() ? freePlace(file.filename()) : freePlace(file.stem()) / file.filename();
  HAPTICELL_TRY(copy(file, place));
  for (const fs::path& other : named) {
    const fs::path beside = place.parent_path() / other.lexically_relative(file.parent_path());
    HAPTICELL_TRY(copy(other, beside));
  }
  return place.generic_string();
}

/// Reads the robot or cell again and lists which files that took.
Expected<Planner::Files> Planner::filesOfRobot(const fs::path& file, const SourceFile& source) {
  Diagnostics quiet;
  Files files{file};
  const ReadRecord record;
  if (isSdfCell(file)) {
    const auto cell = EntityLoader("/", true).loadTree(file.string(), {}, quiet, monitor_);
    HAPTICELL_TRY(cell);
  } else {
    const auto robot = readRobot(file, quiet, monitor_, RobotContent::kAll, source.arguments);
    HAPTICELL_TRY(robot);
    for (const kinematics::Link& link : robot->model.links) {
      for (const auto* shapes : {&link.visuals, &link.collisions}) {
        for (const kinematics::LinkShape& shape : *shapes)
          if (fs::path(shape.source).is_absolute()) files.insert(wholePath(shape.source));
      }
    }
  }
  files.insert(record.files().begin(), record.files().end());
  Files named;
  for (const fs::path& one : files) {
    for (const fs::path& other : filesNamedIn(one))
      if (isWhatItClaims(other)) named.insert(other);
  }
  files.merge(named);
  // Manifests are looked into while packages are searched for; copies that readers made are gone.
  std::error_code gone;
  std::erase_if(files, [&](const fs::path& one) { return isManifest(one) || !fs::is_regular_file(one, gone); });
  return files;
}

std::string Planner::folderFor(const fs::path& root) {
  auto [known, is_new] = folders_.try_emplace(root);
  if (is_new) known->second = freePlace(root.filename()).generic_string();
  return known->second;
}

/// What says which package the folders from a file's up to `root` are.
Expected<void> Planner::takeManifests(const fs::path& file, const fs::path& root, const fs::path& place) {
  std::error_code ignored;
  for (fs::path at = file.parent_path(); at == root || isBelow(at, root); at = at.parent_path()) {
    for (const char* name : kPackages) {
      if (!isWhatItClaims(at / name)) continue;
      const fs::path inside = at == root ? fs::path(name) : at.lexically_relative(root) / name;
      if (auto copied = copy(at / name, place / inside); !copied) return copied;
    }
    if (at == root || at == at.parent_path()) break;
  }
  return {};
}

/// A robot's files keep their places to each other; packages stand side by side, where they are looked for.
Expected<std::string> Planner::takeWithFolder(const fs::path& file, Files files) {
  const fs::path package = packageOf(file);
  fs::path root = package.empty() ? file.parent_path() : package;
  if (package.empty()) {
    for (const fs::path& one : files)
      if (packageOf(one).empty()) root = commonFolder(root, one.parent_path());
  }
  for (const fs::path& one : files) {
    const fs::path other = packageOf(one);
    const fs::path& base = isBelow(one, root) && (other.empty() || other == package) ? root : other;
    if (base.empty()) continue;  // An absolute path to elsewhere; the check of the pack refuses it.
    const fs::path place = folderFor(base);
    HAPTICELL_TRY(copy(one, place / one.lexically_relative(base)));
    HAPTICELL_TRY(takeManifests(one, base, place));
  }
  return (fs::path(folderFor(root)) / file.lexically_relative(root)).generic_string();
}

Expected<void> Planner::readAsShapes(const fs::path& file) {
  Diagnostics quiet;
  const auto read = EntityLoader("/", true).loadTree(file.string(), {}, quiet, monitor_);
  return read ? Expected<void>() : makeError(read.error());
}

Expected<void> Planner::takeSource(SourceFile& source, const Text& who, bool was_read) {
  if (source.path.empty() || isBuiltIn(source.path)) return {};
  const fs::path file = wholePath(source.path);
  std::string key = source.path;  // The arguments of a xacro choose what it includes.
  for (const auto& [name, value] : source.arguments) key += '\n' + name + '=' + value;
  const auto known = places_.find(key);
  if (known != places_.end()) {
    source.path = known->second;
    return {};
  }
  const bool with_folder = looksLikeRobot(file) || isSdfCell(file);
  Expected<std::string> place;
  if (with_folder) {
    auto files = filesOfRobot(file, source);
    place = files ? takeWithFolder(file, std::move(*files)) : makeError(files.error());
  } else {
    const auto read = was_read ? Expected<void>() : readAsShapes(file);
    place = read ? takeShapes(file) : makeError(read.error());
  }
  if (!place) {
    Error error = place.error();
    error.place = error.place.empty() ? who : Text("%1, %2", who, error.place);
    if (error.fix.empty())
      error.fix = "Only files that can be read as what they are used for are packed. Remove it from the workcell.";
    return makeError(error);
  }
  places_[key] = *place;
  source.path = *place;
  return {};
}

Expected<void> Planner::takeEntity(std::shared_ptr<const Entity>& entity) {
  if (entity->kind() == EntityKind::kAssembly) return {};  // When the others have been.
  if (entity->unloaded) {
    diagnostics_.warn(Text("entity '%1' is packed without its file, because the file could not be read", entity->name));
    return {};
  }
  auto packed = std::make_shared<Entity>(*entity);
  const Text who("entity '%1'", entity->name);
  const bool was_read = entity->mesh() || (entity->robot() && !entity->mechanism());
  if (auto taken = takeSource(packed->source, who, was_read); !taken) return taken;
  if (entity->mechanism()) {
    auto definition = std::make_shared<MechanismDefinition>(*entity->mechanism());
    for (MechanismPart& part : definition->parts) {
      if (auto taken = takeSource(part.source, Text("%1, part '%2'", who, part.name), part.mesh != nullptr); !taken)
        return taken;
    }
    std::get<Mechanism>(packed->body).definition = std::move(definition);
  }
  entity = std::move(packed);
  return {};
}

Expected<void> Planner::takeAssembly(std::shared_ptr<const Entity>& entity) {
  if (entity->kind() != EntityKind::kAssembly || entity->unloaded) return {};
  auto packed = std::make_shared<Entity>(*entity);
  if (auto taken = takeSource(packed->source, Text("assembly '%1'", entity->name), false); !taken) return taken;
  entity = std::move(packed);
  return {};
}

Expected<void> Planner::takeTrajectory(TrajectoryReference& trajectory) {
  if (trajectory.path.empty()) return {};
  const std::string key = "trajectory\n" + trajectory.path;
  const auto known = places_.find(key);
  if (known != places_.end()) {
    trajectory.path = known->second;
    return {};
  }
  const fs::path file = wholePath(trajectory.path);
  if (const auto read = trajectory::readTrajectory(file); !read) {
    Error error = read.error();
    error.file = file.string();
    const Text who("trajectory '%1'", trajectory.name);
    error.place = error.place.empty() ? who : Text("%1, %2", who, error.place);
    if (error.fix.empty())
      error.fix = "Only files that can be read as recordings are packed. Remove it from the workcell.";
    return makeError(error);
  }
  const fs::path place = freePlace(file.filename());
  if (auto copied = copy(file, place); !copied) return copied;
  places_[key] = place.generic_string();
  trajectory.path = place.generic_string();
  return {};
}

}  // namespace

Expected<PackPlan> planPack(DocumentState state, const PackScope& scope, Diagnostics& diagnostics,
                            ImportMonitor* monitor) {
  Planner planner(scope, diagnostics, monitor);
  for (auto& entity : state.entities) {
    HAPTICELL_TRY(planner.takeEntity(entity));
  }
  for (auto& entity : state.entities) {
    HAPTICELL_TRY(planner.takeAssembly(entity));
  }
  for (TrajectoryReference& trajectory : state.trajectories) {
    HAPTICELL_TRY(planner.takeTrajectory(trajectory));
  }
  planner.plan.state = std::move(state);
  return std::move(planner.plan);
}

}  // namespace hapticell::workcell
