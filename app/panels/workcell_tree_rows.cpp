// SPDX-License-Identifier: Apache-2.0
// Which rows the tree has, from the document.
#include "app/panels/workcell_tree_model.h"

#include <algorithm>
#include <map>
#include <set>


namespace hapticell::app {

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
  if (!entity.tip_link.empty()) {
    const QString tip = QString::fromStdString(entity.tip_link);
    append(nodes, row, {Kind::kTcp, QStringLiteral("TCP · ") + tip, tip, entity.id, -1, 0, {}, {}});
  }
  for (const auto& link : entity.robot->links) {
    if (link.visuals.empty() && link.collisions.empty()) continue;
    const QString name = QString::fromStdString(link.name);
    append(nodes, row, {Kind::kLink, name, name, entity.id, -1, 0, {}, {}});
  }
}

void WorkcellTreeModel::appendEntity(std::vector<Node>& nodes, int parent, const workcell::Entity& entity,
                                     const Children& children) {
  const int row =
      append(nodes, parent, {Kind::kEntity, QString::fromStdString(entity.name), {}, entity.id, -1, 0, {}, {}});
  if (entity.robot) appendRobot(nodes, row, entity);
  for (const workcell::Frame& frame : entity.frames) {
    const QString name = QString::fromStdString(frame.name);
    append(nodes, row, {Kind::kFrame, name, name, entity.id, -1, 0, {}, {}});
  }
  const auto [first, last] = children.equal_range(entity.name);
  for (auto child = first; child != last; ++child) appendEntity(nodes, row, *child->second, children);
}

std::vector<WorkcellTreeModel::Node> WorkcellTreeModel::build(const DocumentModel& document) {
  std::vector<Node> nodes;
  const auto& state = document.document().state();
  const int cell = append(nodes, -1, {Kind::kCell, document.title(), {}, 0, -1, 0, {}, {}});
  std::set<std::string> names;
  Children children;
  for (const auto& entity : state.entities) {
    names.insert(entity->name);
    if (!entity->parent.empty()) children.emplace(entity->parent, entity.get());
  }
  std::map<std::string, int> folders;
  for (const auto& entity : state.entities) {
    if (names.contains(entity->parent)) continue;
    int parent = cell;
    if (!entity->parent.empty()) {
      const auto [place, added] = folders.try_emplace(entity->parent, -1);
      if (added)
        place->second =
            append(nodes, cell, {Kind::kFolder, QString::fromStdString(entity->parent), {}, 0, -1, 0, {}, {}});
      parent = place->second;
    }
    appendEntity(nodes, parent, *entity, children);
  }
  if (!state.pair_sets.empty()) {
    const int sets = append(nodes, cell, {Kind::kPairSets, tr("Pair sets"), {}, 0, -1, 0, {}, {}});
    for (const auto& set : state.pair_sets)
      append(nodes, sets, {Kind::kPairSet, QString::fromStdString(set.name), {}, 0, -1, 0, {}, {}});
  }
  if (!state.trajectories.empty()) {
    const int all = append(nodes, cell, {Kind::kTrajectories, tr("Trajectories"), {}, 0, -1, 0, {}, {}});
    for (const auto& trajectory : state.trajectories)
      append(nodes, all, {Kind::kTrajectory, QString::fromStdString(trajectory.name), {}, 0, -1, 0, {}, {}});
  }
  return nodes;
}

}  // namespace hapticell::app
