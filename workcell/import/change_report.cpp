// SPDX-License-Identifier: Apache-2.0
#include "workcell/import/change_report.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>

#include "workcell/import/entity_source.h"

namespace hapticell::workcell {

namespace {

// m, rad: unchanged but for rounding. Half, twice: no effect, changes in CAD files are larger.
constexpr double kSame = 1e-9;

std::string number(double value) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string changedJoints(const Entity& before, const Entity& after) {
  std::string text;
  if (!after.robot() || before.joints().size() != after.joints().size()) return text;
  for (std::size_t k = 0; k < after.joints().size(); ++k) {
    if (std::abs(after.joints()[k] - before.joints()[k]) <= kSame) continue;
    const std::string& name = after.robot()->joints[static_cast<std::size_t>(after.robot()->moving[k])].name;
    text += (text.empty() ? "" : "; ") + name + " " + number(before.joints()[k]) + " -> " + number(after.joints()[k]);
  }
  return text;
}

EntityChange compare(const Entity* before, const Entity* after) {
  EntityChange change;
  const Entity& known = after ? *after : *before;
  change.name = known.name;
  change.entity_kind = wordOf(known.kind());
  if (before) change.X_WBefore = before->X_WE;
  if (after) change.X_WAfter = after->X_WE;
  if (!before || !after) {
    change.kind = after ? EntityChange::Kind::kAdded : EntityChange::Kind::kRemoved;
    return change;
  }
  const Twist motion = difference(after->X_WE, before->X_WE);
  change.distance = glm::length(motion.linear);
  change.angle = glm::length(motion.angular);
  change.joints = changedJoints(*before, *after);
  const bool moved = change.distance > kSame || change.angle > kSame || !change.joints.empty();
  change.kind = moved ? EntityChange::Kind::kMoved : EntityChange::Kind::kUnchanged;
  return change;
}

/// A field in quotes where it must be (RFC 4180).
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted.append(c == '"' ? 2u : 1u, c);
  return quoted + "\"";
}

std::string poseFields(const Pose& X) {
  std::string text;
  for (double value : {X.p.x, X.p.y, X.p.z, X.q.w, X.q.x, X.q.y, X.q.z}) text += "," + number(value);
  return text;
}

}  // namespace

const char* wordOf(EntityChange::Kind kind) {
  switch (kind) {
    case EntityChange::Kind::kMoved:
      return "moved";
    case EntityChange::Kind::kAdded:
      return "added";
    case EntityChange::Kind::kRemoved:
      return "removed";
    case EntityChange::Kind::kUnchanged:
      break;
  }
  return "unchanged";
}

Expected<DocumentState> stateAtImport(const DocumentState& state, ImportMonitor* monitor, Diagnostics& diagnostics) {
  EntityLoader loader(std::filesystem::current_path(), true);
  std::map<std::string, std::map<std::string, Pose>> trees;  // Placements by file and part.
  DocumentState before = state;
  for (auto& entity : before.entities) {
    auto changed = std::make_shared<Entity>(*entity);
    changed->X_WE = {};
    if (changed->robot()) changed->setJoints(kinematics::restPositions(*changed->robot()));
    const SourceFile& source = changed->source;
    if (!source.part.empty()) {
      const auto [tree, is_new] = trees.try_emplace(source.path);
      if (is_new) {
        ImportOptions options;
        options.metres_per_unit = source.scale;
        options.up_axis = source.up_axis;
        options.relative_chord = 0.1;
        options.weld = false;
        const auto read = loader.loadTree(source.path, options, diagnostics, monitor);
        HAPTICELL_TRY(read);
        for (const Entity& part : read->entities) tree->second[part.source.part] = part.X_WE;
      }
      if (const auto placed = tree->second.find(source.part); placed != tree->second.end())
        changed->X_WE = placed->second;
    }
    entity = std::move(changed);
  }
  return before;
}

std::vector<EntityChange> compareStates(const DocumentState& before, const DocumentState& after) {
  std::vector<EntityChange> changes;
  for (const auto& entity : after.entities) changes.push_back(compare(before.findByName(entity->name), entity.get()));
  for (const auto& entity : before.entities) {
    if (!after.findByName(entity->name)) changes.push_back(compare(entity.get(), nullptr));
  }
  return changes;
}

std::string changesAsCsv(const std::vector<EntityChange>& changes, bool all) {
  std::string text =
      "name,kind,change,from_x,from_y,from_z,from_qw,from_qx,from_qy,from_qz,to_x,to_y,to_z,to_qw,to_qx,to_qy,to_qz,"
      "distance_m,angle_rad,joints\n";
  for (const EntityChange& change : changes) {
    if (!all && change.kind == EntityChange::Kind::kUnchanged) continue;
    text += field(change.name) + "," + change.entity_kind + "," + wordOf(change.kind) + poseFields(change.X_WBefore) +
            poseFields(change.X_WAfter) + "," + number(change.distance) + "," + number(change.angle) + "," +
            field(change.joints) + "\n";
  }
  return text;
}

}  // namespace hapticell::workcell
