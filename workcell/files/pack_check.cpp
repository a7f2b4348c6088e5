// SPDX-License-Identifier: Apache-2.0
#include "workcell/files/pack_check.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>

#include "workcell/entity/mechanism.h"
#include "workcell/format/document_io.h"
#include "workcell/import/change_report.h"
#include "workcell/import/entity_source.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

// m: the same triangles read twice, but for rounding of units. Half, twice: no effect, changed shapes are off by more.
constexpr double kSameLength = 1e-9;
constexpr const char* kFix =
    "A file may have been changed since the workcell was opened: save the workcell, open it again and pack it.";

Error differs(const std::string& entity, std::string found, std::string expected) {
  return {.place = "entity '" + entity + "' read back from the pack",
          .found = std::move(found),
          .expected = std::move(expected),
          .fix = kFix};
}

using MeshPointer = std::shared_ptr<const geometry::TriangleMesh>;

Expected<void> compareMeshes(const std::string& entity, const MeshPointer& packed, const MeshPointer& read) {
  if (packed == read) return {};
  if (!packed || !read) return makeError(differs(entity, read ? "a shape" : "no shape", packed ? "one" : "none"));
  if (packed->triangles.size() != read->triangles.size()) {
    return makeError(differs(entity, std::to_string(read->triangles.size()) + " triangles",
                             std::to_string(packed->triangles.size()) + " as in the workcell"));
  }
  const geometry::Bounds was = packed->bounds(), is = read->bounds();
  if (was.isEmpty() && is.isEmpty()) return {};
  const double off = std::max(glm::length(was.min - is.min), glm::length(was.max - is.max));
  if (off <= kSameLength) return {};
  std::ostringstream text;
  text << "a shape whose box is off by " << off << " m";
  return makeError(differs(entity, text.str(), "the box of the workcell's shape within 1e-9 m"));
}

Expected<void> compareLinks(const Entity& packed, const Entity& read) {
  const auto& was = packed.robot->links;
  const auto& is = read.robot->links;
  if (was.size() != is.size() || packed.joints.size() != read.joints.size()) {
    return makeError(differs(packed.name,
                             std::to_string(is.size()) + " links, " + std::to_string(read.joints.size()) + " joints",
                             std::to_string(was.size()) + " and " + std::to_string(packed.joints.size())));
  }
  for (std::size_t i = 0; i < was.size(); ++i) {
    const std::string name = packed.name + "', link '" + was[i].name;
    if (was[i].name != is[i].name || was[i].visuals.size() != is[i].visuals.size())
      return makeError(differs(name, "a link '" + is[i].name + "' of other shapes", "the link of the workcell"));
    for (std::size_t k = 0; k < was[i].visuals.size(); ++k) {
      if (auto same = compareMeshes(name, was[i].visuals[k].mesh, is[i].visuals[k].mesh); !same) return same;
    }
  }
  return {};
}

/// Why the entity could not be read: the reader's own words.
std::string whyUnloaded(const Entity& entity, const std::vector<UnloadedEntity>& unloaded) {
  const auto found = std::find_if(unloaded.begin(), unloaded.end(),
                                  [&](const UnloadedEntity& one) { return one.name == entity.name; });
  return found == unloaded.end() ? "its file cannot be read" : found->cause.message();
}

Expected<void> compareEntities(const DocumentState& packed, const DocumentState& read,
                               const std::vector<UnloadedEntity>& unloaded) {
  for (const auto& entity : packed.entities) {
    const Entity* again = read.findByName(entity->name);
    if (!again) return makeError(differs(entity->name, "it is not there", "all that was packed"));
    if (entity->unloaded) continue;
    if (again->unloaded) return makeError(differs(entity->name, whyUnloaded(*again, unloaded), "a file that is whole"));
    if (entity->kind != again->kind || !entity->robot != !again->robot)
      return makeError(differs(entity->name, "another kind of thing", "what was packed"));
    if (auto same = compareMeshes(entity->name, entity->mesh, again->mesh); !same) return same;
    if (!entity->robot) continue;
    if (auto same = compareLinks(*entity, *again); !same) return same;
  }
  for (const EntityChange& change : compareStates(packed, read)) {
    if (change.kind == EntityChange::Kind::kUnchanged) continue;
    std::ostringstream text;
    text << wordOf(change.kind) << " by " << change.distance << " m, " << change.angle << " rad";
    if (!change.joints.empty()) text << "; " << change.joints;
    return makeError(differs(change.name, text.str(), "the place and the joints of the workcell"));
  }
  return {};
}

/// A file that the document names: inside the pack, and there.
Expected<void> checkPlace(const std::string& who, const std::string& path, const fs::path& pack) {
  if (path.empty() || isBuiltIn(path)) return {};
  std::error_code fault;
  const fs::path inside = fs::weakly_canonical(path, fault).lexically_relative(fs::weakly_canonical(pack, fault));
  if (inside.empty() || *inside.begin() == "..")
    return makeError({.file = path,
                      .place = who,
                      .found = "it lies outside of the pack",
                      .expected = "files inside " + pack.string(),
                      .fix = "Put it below the folder of the file that names it."});
  if (!fs::is_regular_file(path, fault))
    return makeError({.file = path, .place = who, .found = "it is not in the pack", .expected = "the copied file"});
  return {};
}

/// The files that a robot's own file names.
Expected<void> checkShapes(const std::string& who, const kinematics::RobotModel& robot, const fs::path& pack) {
  for (const kinematics::Link& link : robot.links) {
    for (const auto* shapes : {&link.visuals, &link.collisions}) {
      for (const kinematics::LinkShape& shape : *shapes) {
        if (!fs::path(shape.source).is_absolute()) continue;
        if (auto inside = checkPlace(who + ", link '" + link.name + "'", shape.source, pack); !inside) return inside;
      }
    }
  }
  return {};
}

Expected<void> checkPlaces(const DocumentState& read, const fs::path& pack) {
  for (const auto& entity : read.entities) {
    if (entity->unloaded) continue;
    const std::string who = "entity '" + entity->name + "'";
    if (auto inside = checkPlace(who, entity->source.path, pack); !inside) return inside;
    if (entity->mechanism) {
      for (const MechanismPart& part : entity->mechanism->parts) {
        if (auto inside = checkPlace(who, part.source.path, pack); !inside) return inside;
      }
    } else if (entity->robot && !isBuiltIn(entity->source.path)) {
      if (auto inside = checkShapes(who, *entity->robot, pack); !inside) return inside;
    }
  }
  for (const TrajectoryReference& trajectory : read.trajectories) {
    if (auto inside = checkPlace("trajectory '" + trajectory.name + "'", trajectory.path, pack); !inside) return inside;
  }
  return {};
}

/// What has no place of its own: how many of each, and of which names.
Expected<void> compareRest(const DocumentState& packed, const DocumentState& read, const std::string& file) {
  const auto compare = [&](const char* what, const auto& was, const auto& is) -> Expected<void> {
    const bool same = std::equal(was.begin(), was.end(), is.begin(), is.end(),
                                 [](const auto& a, const auto& b) { return a.name == b.name; });
    if (same) return {};
    return makeError({.file = file,
                      .place = what,
                      .found = std::to_string(is.size()) + " read back, or others",
                      .expected = "the " + std::to_string(was.size()) + " that were packed",
                      .fix = kFix});
  };
  if (auto same = compare("pair sets", packed.pair_sets, read.pair_sets); !same) return same;
  if (auto same = compare("guides", packed.guides, read.guides); !same) return same;
  if (auto same = compare("tasks", packed.work_tasks, read.work_tasks); !same) return same;
  if (auto same = compare("trajectories", packed.trajectories, read.trajectories); !same) return same;
  if (packed.pair_rules == read.pair_rules) return {};
  return makeError({.file = file,
                    .place = "pair rules",
                    .found = "others than those that were packed",
                    .expected = "the same",
                    .fix = kFix});
}

struct ReadCloser {
  void operator()(archive* in) const { archive_read_free(in); }
};

Error inArchive(const fs::path& file, const std::string& name, std::string found) {
  return {.file = file.string(),
          .place = "'" + name + "' in the archive",
          .found = std::move(found),
          .expected = "the bytes of the file that was packed",
          .fix = "Pack again, or elsewhere: what was written to the disk is not what was read back from it."};
}

/// One file of the archive beside the file that it was made from.
Expected<void> compareEntry(archive* in, const std::string& name, const fs::path& original, const fs::path& file) {
  std::ifstream stream(original, std::ios::binary);
  if (!stream) return makeError(inArchive(file, name, "a file that was not packed"));
  std::array<char, 1 << 16> read{}, was{};
  for (la_ssize_t got = 1; got > 0;) {
    got = archive_read_data(in, read.data(), read.size());
    if (got < 0) {
      const char* why = archive_error_string(in);
      return makeError(inArchive(file, name, why ? why : "it cannot be read"));
    }
    stream.read(was.data(), got);
    if (stream.gcount() != got || !std::equal(read.begin(), read.begin() + got, was.begin()))
      return makeError(inArchive(file, name, "other bytes"));
  }
  if (stream.peek() != std::ifstream::traits_type::eof()) return makeError(inArchive(file, name, "fewer bytes"));
  return {};
}

std::set<std::string> namesBelow(const fs::path& folder) {
  std::set<std::string> names;
  std::error_code fault;
  for (fs::recursive_directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
    if (at->is_regular_file(fault)) names.insert(at->path().lexically_relative(folder).generic_string());
  }
  return names;
}

}  // namespace

Expected<void> checkPack(const DocumentState& packed, const fs::path& document, ImportMonitor* monitor) {
  LoadOptions options;
  options.keep_unloaded = true;  // Those that had no shape have none in the pack either.
  options.monitor = monitor;
  std::vector<UnloadedEntity> unloaded;
  options.unloaded = &unloaded;
  Diagnostics notes;
  const auto read = loadDocument(document, notes, options);
  HAPTICELL_TRY(read);
  const DocumentState& state = read->state();
  if (auto inside = checkPlaces(state, document.parent_path()); !inside) return inside;
  if (auto same = compareRest(packed, state, document.string()); !same) return same;
  auto same = compareEntities(packed, state, unloaded);
  if (same) return same;
  Error error = same.error();
  error.file = document.filename().string();
  return makeError(error);
}

Expected<void> checkCopy(const fs::path& copy, const fs::path& original) {
  std::ifstream first(copy, std::ios::binary), second(original, std::ios::binary);
  std::array<char, 1 << 16> read{}, was{};
  bool same = first && second;
  while (same && first && second) {
    first.read(read.data(), read.size());
    second.read(was.data(), was.size());
    same = first.gcount() == second.gcount() && std::equal(read.begin(), read.begin() + first.gcount(), was.begin());
  }
  if (same) return {};
  return makeError({.file = copy.string(),
                    .found = "other bytes than in " + original.string(),
                    .expected = "a copy of it",
                    .fix = "It may have been changed while it was packed: pack again."});
}

Expected<void> checkArchive(const fs::path& file, const fs::path& folder) {
  const std::unique_ptr<archive, ReadCloser> in(archive_read_new());
  archive_read_support_format_all(in.get());
  archive_read_support_filter_all(in.get());
  constexpr std::size_t kBlock = 1 << 16;
  std::set<std::string> missing = namesBelow(folder);
  archive_entry* entry = nullptr;
  int status = missing.empty() ? ARCHIVE_EOF : archive_read_open_filename(in.get(), file.c_str(), kBlock);
  while (status != ARCHIVE_EOF) {
    status = status == ARCHIVE_OK ? archive_read_next_header(in.get(), &entry) : status;
    if (status == ARCHIVE_EOF) break;
    if (status != ARCHIVE_OK) {
      const char* why = archive_error_string(in.get());
      return makeError({.file = file.string(),
                        .found = why ? why : "it cannot be read back",
                        .expected = "an archive that is whole"});
    }
    const std::string name = archive_entry_pathname(entry);
    if (missing.erase(name) == 0) return makeError(inArchive(file, name, "a file that was not packed, or twice"));
    if (auto same = compareEntry(in.get(), name, folder / name, file); !same) return same;
  }
  if (!missing.empty()) return makeError(inArchive(file, *missing.begin(), "it is not there"));
  return {};
}

}  // namespace hapticell::workcell
