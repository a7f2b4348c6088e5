// SPDX-License-Identifier: Apache-2.0
// Which rows the tree has, from the document.
#include "app/panels/tree/workcell_tree_model.h"

#include <algorithm>
#include <map>
#include <set>

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

int WorkcellTreeModel::append(std::vector<Node>& nodes, int parent, Node node) {
  const int index = static_cast<int>(nodes.size());
  node.parent = parent;
  if (parent >= 0) {
    node.row = static_cast<int>(nodes[static_cast<std::size_t>(parent)].children.size());
    nodes[static_cast<std::size_t>(parent)].children.push_back(index);
  }
  nodes.push_back(std::move(node));
  return index;
}

void WorkcellTreeModel::appendRobot(std::vector<Node>& nodes, int row, const workcell::Entity& entity) {
  for (const auto& link : entity.robot->links) {
    if (link.visuals.empty() && link.collisions.empty() && !link.isUnchecked()) continue;
    const QString name = QString::fromStdString(link.name);
    const QString shown = link.isUnchecked() ? tr("%1 · no shape").arg(name) : name;
    append(nodes, row, {Kind::kLink, shown, name, entity.id, -1, 0, {}, {}, {}});
  }
}

void WorkcellTreeModel::appendEntity(std::vector<Node>& nodes, int parent, const workcell::Entity& entity,
                                     const Children& children, const Motions& motions) const {
  const int row =
      append(nodes, parent, {Kind::kEntity, QString::fromStdString(entity.name), {}, entity.id, -1, 0, {}, {}, {}});
  if (entity.robot && !entity.tip_link.empty()) {
    const QString tip = QString::fromStdString(entity.tip_link);
    append(nodes, row, {Kind::kTcp, QStringLiteral("TCP · ") + tip, tip, entity.id, -1, 0, {}, {}, {}});
  }
  const auto [first_motion, last_motion] = motions.equal_range(entity.name);
  for (auto motion = first_motion; motion != last_motion; ++motion) appendMotion(nodes, row, *motion->second);
  if (entity.robot) appendRobot(nodes, row, entity);
  for (const workcell::Frame& frame : entity.frames) {
    const QString name = QString::fromStdString(frame.name);
    append(nodes, row, {Kind::kFrame, name, name, entity.id, -1, 0, {}, {}, {}});
  }
  const auto [first, last] = children.equal_range(entity.name);
  for (auto child = first; child != last; ++child) appendEntity(nodes, row, *child->second, children, motions);
}

void WorkcellTreeModel::appendMotion(std::vector<Node>& nodes, int parent,
                                     const workcell::TrajectoryReference& motion) const {
  const int row =
      append(nodes, parent, {Kind::kTrajectory, QString::fromStdString(motion.name), {}, 0, -1, 0, {}, {}, {}});
  const auto rows = motion_frames_.find(motion.name);
  if (rows == motion_frames_.end()) return;
  for (const MotionFrame& frame : rows->second.frames)
    append(nodes, row, {Kind::kMotionFrame, frame.name, {}, 0, -1, 0, {}, frame.mark, &frame});
}

/// Those of nothing that is in the cell, or that are still being read, are by the empty name.
WorkcellTreeModel::Motions WorkcellTreeModel::motionsByEntity() const {
  const workcell::DocumentState& state = document_.document().state();
  Motions motions;
  for (const auto& motion : state.trajectories) {
    const auto rows = motion_frames_.find(motion.name);
    const std::string entity = rows == motion_frames_.end() ? std::string() : rows->second.entity;
    motions.emplace(state.findByName(entity) ? entity : std::string(), &motion);
  }
  return motions;
}

std::vector<WorkcellTreeModel::Node> WorkcellTreeModel::build() const {
  std::vector<Node> nodes;
  const auto& state = document_.document().state();
  const int cell = append(nodes, -1, {Kind::kCell, document_.title(), {}, 0, -1, 0, {}, {}, {}});
  std::set<std::string> names;
  Children children;
  for (const auto& entity : state.entities) {
    names.insert(entity->name);
    if (const std::string above = shownParent(state, *entity); !above.empty()) children.emplace(above, entity.get());
  }
  const Motions motions = motionsByEntity();
  std::map<std::string, int> folders;
  for (const auto& entity : state.entities) {
    if (names.contains(shownParent(state, *entity))) continue;
    int parent = cell;
    if (!entity->parent.empty()) {
      const auto [place, added] = folders.try_emplace(entity->parent, -1);
      if (added)
        place->second =
            append(nodes, cell, {Kind::kFolder, QString::fromStdString(entity->parent), {}, 0, -1, 0, {}, {}, {}});
      parent = place->second;
    }
    appendEntity(nodes, parent, *entity, children, motions);
  }
  if (!state.pair_sets.empty()) {
    const int sets = append(nodes, cell, {Kind::kPairSets, tr("Pair sets"), {}, 0, -1, 0, {}, {}, {}});
    for (const auto& set : state.pair_sets)
      append(nodes, sets, {Kind::kPairSet, QString::fromStdString(set.name), {}, 0, -1, 0, {}, {}, {}});
  }
  if (const auto [first, last] = motions.equal_range(std::string()); first != last) {
    const int others = append(nodes, cell, {Kind::kTrajectories, tr("Trajectories"), {}, 0, -1, 0, {}, {}, {}});
    for (auto motion = first; motion != last; ++motion) appendMotion(nodes, others, *motion->second);
  }
  return nodes;
}

}  // namespace hapticell::app
