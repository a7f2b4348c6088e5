// SPDX-License-Identifier: Apache-2.0
#include "workcell/pack.h"

#include <sys/stat.h>

#include <map>
#include <memory>
#include <set>

#include "geometry/scratch_folder.h"
#include "workcell/archive.h"
#include "workcell/document_io.h"
#include "workcell/entity_source.h"
#include "workcell/file_content.h"
#include "workcell/mechanism.h"
#include "workcell/named_files.h"
#include "workcell/pack_check.h"
#include "workcell/robot_reader.h"
#include "workcell/sdf_cell_reader.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMostPackedBytes = std::uintmax_t{2} << 30;

/// The folder that a robot or cell needs: its package (the one with package.xml), else that of the file.
fs::path packageOf(const fs::path& file) {
  std::error_code ignored;
  for (fs::path at = file.parent_path(); at != at.parent_path(); at = at.parent_path()) {
    if (fs::exists(at / "package.xml", ignored)) return at;
  }
  return file.parent_path();
}

class Packer {
 public:
  Packer(fs::path folder, Diagnostics& diagnostics) : folder_(std::move(folder)), diagnostics_(diagnostics) {}

  /// Copies what the path names, once; gives its place in the pack.
  Expected<std::string> take(const std::string& path) {
    if (path.empty() || isBuiltIn(path)) return path;
    const auto known = places_.find(path);
    if (known != places_.end()) return known->second;
    const bool with_folder = looksLikeRobot(path) || isSdfCell(path);
    auto place = with_folder ? takeFolder(path) : takeFile(path);
    if (place) places_[path] = place->string();
    return place ? Expected<std::string>(place->string()) : makeError(place.error());
  }

  /// A mesh that a robot's file names in another package: that package stands beside the robot's then, where it is
  /// looked for.
  Expected<void> takeOtherPackage(const std::string& mesh) {
    std::error_code ignored;
    const fs::path package = packageOf(mesh);
    if (!fs::exists(package / "package.xml", ignored) || packages_.contains(package.string())) return {};
    const auto taken = takeFolder(mesh);
    return taken ? Expected<void>() : makeError(taken.error());
  }

  PackReport report;

 private:
  fs::path freePlace(const fs::path& name) {
    fs::path place = folder_ / "files" / name;
    for (int number = 2; !taken_.insert(place.string()).second; ++number) {
      place = folder_ / "files" / (name.stem().string() + "-" + std::to_string(number) + name.extension().string());
    }
    return place;
  }

  /// A file that names others (OBJ its colours, glTF its data, STEP its parts) gets a folder for all of them.
  Expected<fs::path> takeFile(const fs::path& file) {
    const std::vector<fs::path> named = filesNamedIn(file);
    const fs::path place = named.empty() ? freePlace(file.filename()) : freePlace(file.stem()) / file.filename();
    if (auto copied = copy(file, place); !copied) return makeError(copied.error());
    const fs::path folder = fs::absolute(file).lexically_normal().parent_path();
    for (const fs::path& other : named) {
      if (auto copied = copy(other, place.parent_path() / other.lexically_relative(folder)); !copied) {
        return makeError(copied.error());
      }
    }
    return place;
  }

  Expected<fs::path> takeFolder(const fs::path& file) {
    const fs::path package = packageOf(file);
    auto [known, is_new] = packages_.try_emplace(package.string());
    if (is_new) {
      known->second = freePlace(package.filename()).string();
      std::error_code fault;
      for (fs::recursive_directory_iterator at(package, fault), end; !fault && at != end; at.increment(fault)) {
        if (at.depth() == 0 && at->path().filename().string().starts_with(".")) at.disable_recursion_pending();
        if (!at->is_regular_file(fault)) continue;
        const fs::path place = fs::path(known->second) / at->path().lexically_relative(package);
        if (auto copied = copy(at->path(), place); !copied) return makeError(copied.error());
      }
      diagnostics_.warn("'" + file.filename().string() + "' was packed with all of the folder " + package.string());
    }
    return fs::path(known->second) / file.lexically_relative(package);
  }

  Expected<void> copy(const fs::path& from, const fs::path& to) {
    std::error_code fault;
    const std::uintmax_t size = fs::file_size(from, fault);
    if (!fault && report.bytes + size > kMostPackedBytes) {
      return makeError({from.string(), "", "it makes the pack larger than 2 GB", "less",
                        "Put the file into a folder of its own, without what does not belong to it."});
    }
    if (!fault) fs::create_directories(to.parent_path(), fault);
    if (!fault) fs::copy_file(from, to, fs::copy_options::overwrite_existing, fault);
    if (fault)
      return makeError({from.string(), "", fault.message(), "a file that can be copied to " + to.string(), ""});
    if (auto same = checkCopy(to, from); !same) return same;
    report.bytes += size;
    report.copied.push_back(to.lexically_relative(folder_).generic_string());
    return {};
  }

  fs::path folder_;
  Diagnostics& diagnostics_;
  std::map<std::string, std::string> places_, packages_;
  std::set<std::string> taken_;
};

/// The meshes of a robot that stand in other packages than its own file.
Expected<void> takeOtherPackages(const Entity& entity, Packer& packer) {
  for (const kinematics::Link& link : entity.robot->links) {
    for (const auto* shapes : {&link.visuals, &link.collisions}) {
      for (const kinematics::LinkShape& shape : *shapes) {
        if (!fs::path(shape.source).is_absolute()) continue;
        if (auto taken = packer.takeOtherPackage(shape.source); !taken) return taken;
      }
    }
  }
  return {};
}

/// What was opened without its file has none in the pack either, and is told.
Expected<void> takeAll(Entity& entity, Packer& packer, Diagnostics& diagnostics) {
  if (entity.unloaded) {
    diagnostics.warn("entity '" + entity.name + "' is packed without its file, which could not be read");
    return {};
  }
  const auto take = [&](std::string& path) -> Expected<void> {
    auto place = packer.take(path);
    if (!place) return makeError(place.error());
    path = *place;
    return {};
  };
  if (entity.kind != EntityKind::kAssembly) {
    if (auto taken = take(entity.source.path); !taken) return taken;
  } else if (!entity.source.path.empty() && !isBuiltIn(entity.source.path)) {
    if (auto taken = take(entity.source.path); !taken) return taken;
  }
  if (entity.robot && !entity.mechanism && !isBuiltIn(entity.source.path)) return takeOtherPackages(entity, packer);
  if (!entity.mechanism) return {};
  auto definition = std::make_shared<MechanismDefinition>(*entity.mechanism);
  for (MechanismPart& part : definition->parts) {
    if (auto taken = take(part.source.path); !taken) return taken;
  }
  entity.mechanism = std::move(definition);
  return {};
}

Expected<PackReport> packInto(DocumentState state, const fs::path& folder, const std::string& name,
                              Diagnostics& diagnostics) {
  Packer packer(folder, diagnostics);
  for (auto& entity : state.entities) {
    auto packed = std::make_shared<Entity>(*entity);
    if (auto taken = takeAll(*packed, packer, diagnostics); !taken) return makeError(taken.error());
    entity = std::move(packed);
  }
  for (TrajectoryReference& trajectory : state.trajectories) {
    auto place = packer.take(trajectory.path);
    if (!place) return makeError(place.error());
    trajectory.path = *place;
  }
  packer.report.document = folder / name;
  if (auto written = writeFileAtomically(packer.report.document, documentText(state, folder)); !written) {
    return makeError(written.error());
  }
  return std::move(packer.report);
}

/// Packs into a folder that does not stay there, and reads it back.
Expected<PackReport> packAside(const DocumentState& state, const fs::path& aside, const std::string& name,
                               Diagnostics& diagnostics, ImportMonitor* monitor) {
  auto report = packInto(state, aside, name, diagnostics);
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
Expected<ScratchFolder> folderBeside(const fs::path& place) {
  std::error_code ignored;
  if (!fs::exists(place, ignored)) return ScratchFolder::make(place.parent_path());
  if (areOnOneDisk(place, place.parent_path())) {
    if (auto beside = ScratchFolder::make(place.parent_path())) return beside;
  }
  return ScratchFolder::make(place);
}

/// Says the place that the user knows instead of the folder aside.
Error inPlace(Error error, const fs::path& aside, const fs::path& place) {
  for (std::string* words : {&error.file, &error.place, &error.found, &error.expected, &error.fix}) {
    for (std::size_t at = words->find(aside.string()); at != std::string::npos; at = words->find(aside.string(), at)) {
      words->replace(at, aside.string().size(), place.string());
      at += place.string().size();
    }
  }
  return error;
}

}  // namespace

Expected<PackReport> packDocument(const DocumentState& state, const fs::path& folder, const std::string& name,
                                  Diagnostics& diagnostics, ImportMonitor* monitor) {
  std::error_code fault;
  const bool there = fs::exists(folder, fault);
  if (there && (!fs::is_directory(folder, fault) || !fs::is_empty(folder, fault))) {
    return makeError({folder.string(), "", "something stands there already", "a new or empty folder", ""});
  }
  fs::path place = there ? fs::canonical(folder, fault) : fs::absolute(folder).lexically_normal();
  if (!place.has_filename()) place = place.parent_path();
  fs::create_directories(place.parent_path(), fault);
  if (fault) return makeError({folder.string(), "", fault.message(), "a folder that can be made", ""});
  auto aside = folderBeside(place);
  if (!aside) return makeError(aside.error());
  auto report = packAside(state, aside->path(), name, diagnostics, monitor);
  if (!report) return makeError(inPlace(report.error(), aside->path(), place));
  auto moved = aside->path().parent_path() == place ? aside->moveContentTo(place, name) : aside->moveTo(place);
  if (!moved) return makeError(moved.error());
  report->document = place / name;
  return report;
}

Expected<PackReport> pack(const DocumentState& state, const fs::path& output, const std::string& name,
                          Diagnostics& diagnostics, ImportMonitor* monitor) {
  if (!isArchiveName(output)) return packDocument(state, output, name, diagnostics, monitor);
  const fs::path archive = fs::absolute(output).lexically_normal();
  const auto aside = ScratchFolder::make(archive.parent_path());
  if (!aside) {
    return makeError({output.string(), "", "no folder can be made beside it", "permission to write", ""});
  }
  auto report = packAside(state, aside->path(), name, diagnostics, monitor);
  if (!report) return makeError(inPlace(report.error(), aside->path(), archive));
  const auto written = writeArchive(aside->path(), archive);  // Read back before it takes its place.
  if (!written) return makeError(inPlace(written.error(), aside->path(), archive));
  report->document = report->document.lexically_relative(aside->path());
  return report;
}

}  // namespace hapticell::workcell
