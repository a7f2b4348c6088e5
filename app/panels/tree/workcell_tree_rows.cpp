// SPDX-License-Identifier: Apache-2.0
#include "app/panels/tree/workcell_tree_rows.h"

#include <algorithm>
#include <set>
#include <utility>

namespace hapticell::app {

namespace {

/// What an entity's row stands below: what it is attached to, else its parent in the document.
std::string shownParent(const workcell::DocumentState& state, const workcell::Entity& entity) {
  const std::string& carrier = entity.attachment.to;
  if (carrier.empty() || !state.findByName(carrier)) return entity.parent;
  // What it hangs on may itself stand below it; then neither would be seen.
  const workcell::Entity* at = state.findByName(carrier);
  for (std::size_t steps = 0; at && steps < state.entities.size(); ++steps) {
    if (at == &entity) return entity.parent;
    const workcell::Entity* on = at->attachment.to.empty() ? nullptr : state.findByName(at->attachment.to);
    at = on ? on : state.findByName(at->parent);
  }
  return carrier;
}

}  // namespace

int WorkcellTreeRows::append(int parent, TreeRow row) {
  const int index = static_cast<int>(rows_.size());
  row.parent = parent;
  if (parent >= 0) {
    row.row = static_cast<int>(rows_[static_cast<std::size_t>(parent)].children.size());
    rows_[static_cast<std::size_t>(parent)].children.push_back(index);
  }
  rows_.push_back(std::move(row));
  return index;
}

void WorkcellTreeRows::appendRobot(int row, const workcell::Entity& entity) {
  for (const auto& link : entity.robot()->links) {
    if (link.visuals.empty() && link.collisions.empty() && !link.isUnchecked()) continue;
    const QString name = QString::fromStdString(link.name);
    const QString shown = link.isUnchecked() ? QObject::tr("%1 · no shape").arg(name) : name;
    append(row, {TreeRow::Kind::kLink, shown, name, entity.id, -1, 0, {}, {}, {}});
  }
}

void WorkcellTreeRows::appendEntity(int parent, const workcell::Entity& entity) {
  const int row =
      append(parent, {TreeRow::Kind::kEntity, QString::fromStdString(entity.name), {}, entity.id, -1, 0, {}, {}, {}});
  if (entity.robot() && !entity.jointed().tip_link.empty()) {
    const QString tip = QString::fromStdString(entity.jointed().tip_link);
    append(row, {TreeRow::Kind::kTcp, QStringLiteral("TCP · ") + tip, tip, entity.id, -1, 0, {}, {}, {}});
  }
  const auto [first_motion, last_motion] = motions_.equal_range(entity.name);
  for (auto motion = first_motion; motion != last_motion; ++motion) appendMotion(row, *motion->second);
  if (entity.robot()) appendRobot(row, entity);
  for (const workcell::Frame& frame : entity.frames) {
    const QString name = QString::fromStdString(frame.name);
    append(row, {TreeRow::Kind::kFrame, name, name, entity.id, -1, 0, {}, {}, {}});
  }
  const auto [first, last] = children_.equal_range(entity.name);
  for (auto child = first; child != last; ++child) appendEntity(row, *child->second);
}

void WorkcellTreeRows::appendMotion(int parent, const workcell::TrajectoryReference& motion) {
  const int row =
      append(parent, {TreeRow::Kind::kTrajectory, QString::fromStdString(motion.name), {}, 0, -1, 0, {}, {}, {}});
  const auto rows = motion_frames_.find(motion.name);
  if (rows == motion_frames_.end()) return;
  for (const TreeMotionFrame& frame : rows->second.frames)
    append(row, {TreeRow::Kind::kMotionFrame, frame.name, {}, 0, -1, 0, {}, frame.mark, &frame});
}

/// Those of nothing that is in the cell, or that are still being read, are by the empty name.
WorkcellTreeRows::Motions WorkcellTreeRows::motionsByEntity() const {
  const workcell::DocumentState& state = document_.document().state();
  Motions motions;
  for (const auto& motion : state.trajectories) {
    const auto rows = motion_frames_.find(motion.name);
    const std::string entity = rows == motion_frames_.end() ? std::string() : rows->second.entity;
    motions.emplace(state.findByName(entity) ? entity : std::string(), &motion);
  }
  return motions;
}

std::vector<TreeRow> WorkcellTreeRows::build() {
  const auto& state = document_.document().state();
  const int cell = append(-1, {TreeRow::Kind::kCell, document_.title(), {}, 0, -1, 0, {}, {}, {}});
  std::set<std::string> names;
  for (const auto& entity : state.entities) {
    names.insert(entity->name);
    if (const std::string above = shownParent(state, *entity); !above.empty()) children_.emplace(above, entity.get());
  }
  motions_ = motionsByEntity();
  std::map<std::string, int> folders;
  for (const auto& entity : state.entities) {
    if (names.contains(shownParent(state, *entity))) continue;
    int parent = cell;
    if (!entity->parent.empty()) {
      const auto [place, added] = folders.try_emplace(entity->parent, -1);
      if (added)
        place->second =
            append(cell, {TreeRow::Kind::kFolder, QString::fromStdString(entity->parent), {}, 0, -1, 0, {}, {}, {}});
      parent = place->second;
    }
    appendEntity(parent, *entity);
  }
  if (!state.pair_sets.empty()) {
    const int sets = append(cell, {TreeRow::Kind::kPairSets, QObject::tr("Pair sets"), {}, 0, -1, 0, {}, {}, {}});
    for (const auto& set : state.pair_sets)
      append(sets, {TreeRow::Kind::kPairSet, QString::fromStdString(set.name), {}, 0, -1, 0, {}, {}, {}});
  }
  if (const auto [first, last] = motions_.equal_range(std::string()); first != last) {
    const int others =
        append(cell, {TreeRow::Kind::kTrajectories, QObject::tr("Trajectories"), {}, 0, -1, 0, {}, {}, {}});
    for (auto motion = first; motion != last; ++motion) appendMotion(others, *motion->second);
  }
  return std::move(rows_);
}

}  // namespace hapticell::app
