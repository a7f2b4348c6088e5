// SPDX-License-Identifier: Apache-2.0
#include "workcell/files/pack_check.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <set>

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
constexpr const char* kFix = HAPTICELL_TRANSLATED(
    "A file may have been changed since the workcell was opened: save the workcell, open it again and pack it.");

/// `who`: "entity 'A'".
Error differs(const Text& who, Text found, Text expected) {
  return {.place = Text("%1 in the pack", who),
          .found = std::move(found),
          .expected = std::move(expected),
          .fix = Text(kFix)};
}

Text entityNamed(const std::string& name) {
  return Text("entity '%1'", name);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

using MeshPointer = std::shared_ptr<const geometry::TriangleMesh>;

Expected<void> compareMeshes(const Text& who, const MeshPointer& packed, const MeshPointer& read) {
  if (packed == read) return {};
  if (!packed || !read)
    return makeError(differs(who, read ? Text("a shape") : Text("no shape"), packed ? Text("one") : Text("none")));
  if (packed->triangles.size() != read->triangles.size()) {
    return makeError(differs(who, Text("%1 triangles", read->triangles.size()),
                             Text("%1 as in the workcell", packed->triangles.size())));
  }
  const geometry::Bounds was = packed->bounds(), is = read->bounds();
  if (was.isEmpty() && is.isEmpty()) return {};
  const double off = std::max(glm::length(was.min - is.min), glm::length(was.max - is.max));
  if (off <= kSameLength) return {};
  return makeError(differs(who, Text("a shape with a bounding box that differs by %1 m", number(off)),
                           Text("the bounding box of the shape in the workcell, within 1e-9 m")));
}

Expected<void> compareLinks(const Entity& packed, const Entity& read) {
  const auto& was = packed.robot()->links;
  const auto& is = read.robot()->links;
  if (was.size() != is.size() || packed.joints().size() != read.joints().size()) {
    return makeError(differs(entityNamed(packed.name), Text("%1 links, %2 joints", is.size(), read.joints().size()),
                             Text("%1 and %2", was.size(), packed.joints().size())));
  }
  for (std::size_t i = 0; i < was.size(); ++i) {
    const Text who("entity '%1', link '%2'", packed.name, was[i].name);
    if (was[i].name != is[i].name || was[i].visuals.size() != is[i].visuals.size())
      return makeError(
          differs(who, Text("link '%1' has different shapes", is[i].name), Text("the same link as in the workcell")));
    for (std::size_t k = 0; k < was[i].visuals.size(); ++k) {
      if (auto same = compareMeshes(who, was[i].visuals[k].mesh, is[i].visuals[k].mesh); !same) return same;
    }
  }
  return {};
}

/// Why the entity could not be read: the reader's own words.
Text whyUnloaded(const Entity& entity, const std::vector<UnloadedEntity>& unloaded) {
  const auto found = std::find_if(unloaded.begin(), unloaded.end(),
                                  [&](const UnloadedEntity& one) { return one.name == entity.name; });
  return found == unloaded.end() ? Text("its file cannot be read") : found->cause.text();
}

Expected<void> compareEntities(const DocumentState& packed, const DocumentState& read,
                               const std::vector<UnloadedEntity>& unloaded) {
  for (const auto& entity : packed.entities) {
    const Text who = entityNamed(entity->name);
    const Entity* again = read.findByName(entity->name);
    if (!again) return makeError(differs(who, Text("it is missing"), Text("everything that was packed")));
    if (entity->unloaded) continue;
    if (again->unloaded) return makeError(differs(who, whyUnloaded(*again, unloaded), Text("a complete file")));
    if (entity->kind() != again->kind() || !entity->robot() != !again->robot())
      return makeError(differs(who, Text("another kind of entity"), Text("what was packed")));
    if (auto same = compareMeshes(who, entity->mesh(), again->mesh()); !same) return same;
    if (!entity->robot()) continue;
    if (auto same = compareLinks(*entity, *again); !same) return same;
  }
  for (const EntityChange& change : compareStates(packed, read)) {
    if (change.kind == EntityChange::Kind::kUnchanged) continue;
    Text found("moved by %1 m, %2 rad", number(change.distance), number(change.angle));
    if (change.kind == EntityChange::Kind::kAdded) found = Text("added");
    if (change.kind == EntityChange::Kind::kRemoved) found = Text("removed");
    if (!change.joints.empty()) found = Text("%1; %2", found, change.joints);
    return makeError(differs(entityNamed(change.name), found, Text("the pose and joint values of the workcell")));
  }
  return {};
}

/// A file that the document names: inside the pack, and there.
Expected<void> checkPlace(const Text& who, const std::string& path, const fs::path& pack) {
  if (path.empty() || isBuiltIn(path)) return {};
  std::error_code fault;
  const fs::path inside = fs::weakly_canonical(path, fault).lexically_relative(fs::weakly_canonical(pack, fault));
  if (inside.empty() || *inside.begin() == "..")
    return makeError({.file = path,
                      .place = who,
                      .found = "the file is outside the pack",
                      .expected = Text("files inside %1", pack.string()),
                      .fix = "Move it into the folder of the file that refers to it."});
  if (!fs::is_regular_file(path, fault))
    return makeError(
        {.file = path, .place = who, .found = "the file is missing in the pack", .expected = "the copied file"});
  return {};
}

/// The files that a robot's own file names.
Expected<void> checkShapes(const Text& who, const kinematics::RobotModel& robot, const fs::path& pack) {
  for (const kinematics::Link& link : robot.links) {
    for (const auto* shapes : {&link.visuals, &link.collisions}) {
      for (const kinematics::LinkShape& shape : *shapes) {
        if (!fs::path(shape.source).is_absolute()) continue;
        if (auto inside = checkPlace(Text("%1, link '%2'", who, link.name), shape.source, pack); !inside) return inside;
      }
    }
  }
  return {};
}

Expected<void> checkPlaces(const DocumentState& read, const fs::path& pack) {
  for (const auto& entity : read.entities) {
    if (entity->unloaded) continue;
    const Text who = entityNamed(entity->name);
    if (auto inside = checkPlace(who, entity->source.path, pack); !inside) return inside;
    if (entity->mechanism()) {
      for (const MechanismPart& part : entity->mechanism()->parts) {
        if (auto inside = checkPlace(who, part.source.path, pack); !inside) return inside;
      }
    } else if (entity->robot() && !isBuiltIn(entity->source.path)) {
      if (auto inside = checkShapes(who, *entity->robot(), pack); !inside) return inside;
    }
  }
  for (const TrajectoryReference& trajectory : read.trajectories) {
    const Text who("trajectory '%1'", trajectory.name);
    if (auto inside = checkPlace(who, trajectory.path, pack); !inside) return inside;
  }
  return {};
}

/// What has no place of its own: how many of each, and of which names.
Expected<void> compareRest(const DocumentState& packed, const DocumentState& read, const std::string& file) {
  const auto compare = [&](const Text& what, const auto& was, const auto& is) -> Expected<void> {
    const bool same = std::equal(was.begin(), was.end(), is.begin(), is.end(),
                                 [](const auto& a, const auto& b) { return a.name == b.name; });
    if (same) return {};
    return makeError({.file = file,
                      .place = what,
                      .found = Text("%1 after packing, or different ones", is.size()),
                      .expected = Text("the %1 that were packed", was.size()),
                      .fix = Text(kFix)});
  };
  if (auto same = compare(Text("pair sets"), packed.pair_sets, read.pair_sets); !same) return same;
  if (auto same = compare(Text("guides"), packed.guides, read.guides); !same) return same;
  if (auto same = compare(Text("tasks"), packed.work_tasks, read.work_tasks); !same) return same;
  if (auto same = compare(Text("trajectories"), packed.trajectories, read.trajectories); !same) return same;
  if (packed.pair_rules == read.pair_rules) return {};
  return makeError({.file = file,
                    .place = "pair rules",
                    .found = "they differ from the packed ones",
                    .expected = "the same",
                    .fix = Text(kFix)});
}

struct ReadCloser {
  void operator()(archive* in) const { archive_read_free(in); }
};

Error inArchive(const fs::path& file, const std::string& name, Text found) {
  return {.file = file.string(),
          .place = Text("'%1' in the archive", name),
          .found = std::move(found),
          .expected = "the same content as the packed file",
          .fix = "The disk returned other data than was written. Pack again, or pack to another disk."};
}

/// One file of the archive beside the file that it was made from.
Expected<void> compareEntry(archive* in, const std::string& name, const fs::path& original, const fs::path& file) {
  std::ifstream stream(original, std::ios::binary);
  if (!stream) return makeError(inArchive(file, name, Text("an unexpected file")));
  std::array<char, 1 << 16> read{}, was{};
  for (la_ssize_t got = 1; got > 0;) {
    got = archive_read_data(in, read.data(), read.size());
    if (got < 0) {
      const char* why = archive_error_string(in);
      return makeError(inArchive(file, name, why ? Text(std::string(why)) : Text("it cannot be read")));
    }
    stream.read(was.data(), got);
    if (stream.gcount() != got || !std::equal(read.begin(), read.begin() + got, was.begin()))
      return makeError(inArchive(file, name, Text("different content")));
  }
  if (stream.peek() != std::ifstream::traits_type::eof())
    return makeError(inArchive(file, name, Text("the file is too short")));
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
                    .found = Text("the content differs from %1", original.string()),
                    .expected = "an exact copy",
                    .fix = "The file may have changed during packing. Pack again."});
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
                        .found = why ? Text(std::string(why)) : Text("it cannot be read back"),
                        .expected = "a complete archive"});
    }
    const std::string name = archive_entry_pathname(entry);
    if (missing.erase(name) == 0) return makeError(inArchive(file, name, Text("an unexpected or repeated file")));
    if (auto same = compareEntry(in.get(), name, folder / name, file); !same) return same;
  }
  if (!missing.empty()) return makeError(inArchive(file, *missing.begin(), Text("it is missing")));
  return {};
}

}  // namespace hapticell::workcell
