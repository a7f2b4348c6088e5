// SPDX-License-Identifier: Apache-2.0
// Rows of the tree that are dragged: entities below others, points of a motion to another place in its order.
#include <QMimeData>

#include "app/panels/tree/tree_edits.h"
#include "app/panels/tree/workcell_tree_model.h"

namespace hapticell::app {
namespace {

constexpr const char* kMimeType = "application/x-hapticell-entities";
constexpr const char* kFrameMimeType = "application/x-hapticell-motion-frame";  // Its number, then the motion's name.

}  // namespace

QStringList WorkcellTreeModel::mimeTypes() const {
  return {QString::fromLatin1(kMimeType), QString::fromLatin1(kFrameMimeType)};
}

QMimeData* WorkcellTreeModel::mimeData(const QModelIndexList& indexes) const {
  if (indexes.size() == 1 && kindOf(indexes.front()) == Kind::kMotionFrame) {
    auto* dragged = new QMimeData;
    dragged->setData(QString::fromLatin1(kFrameMimeType),
                     QByteArray::number(indexes.front().data(kMotionFrameRole).toULongLong()) + '\n' +
                         indexes.front().data(kMotionRole).toString().toUtf8());
    return dragged;
  }
  QStringList ids, names;
  for (const QModelIndex& index : indexes) {
    const Kind kind = kindOf(index);
    if (kind != Kind::kEntity && kind != Kind::kFolder) continue;
    for (const auto id : entitiesOf(index)) ids << QString::number(id);
    // An entity's own name means all that stands below it; a folder has none.
    const auto meant = kind == Kind::kEntity ? Entities{nodes_[index.internalId()].entity} : entitiesOf(index);
    for (const auto id : meant)
      if (const workcell::Entity* entity = document_.document().find(id)) names << QString::fromStdString(entity->name);
  }
  auto* data = new QMimeData;
  data->setData(QString::fromLatin1(kMimeType), ids.join(' ').toLatin1());
  data->setData(QString::fromLatin1(kNamesFormat), names.join('\n').toUtf8());
  return data;
}

/// A motion's frame, dropped between rows of its motion or onto one of them. The document does it.
bool WorkcellTreeModel::dropFrame(const QByteArray& dragged, int row, const Node& onto) {
  const auto line = dragged.indexOf('\n');
  const QString motion = QString::fromUtf8(dragged.mid(line + 1));
  const auto from = static_cast<std::size_t>(dragged.left(line).toULongLong());
  const Node& of = onto.frame ? nodes_[static_cast<std::size_t>(onto.parent)] : onto;
  if (of.kind != Kind::kTrajectory || of.name != motion || of.children.empty()) return false;
  const auto frameOf = [&](int child) { return nodes_[static_cast<std::size_t>(child)].frame->frame; };
  const bool before_a_row = !onto.frame && row >= 0 && row < static_cast<int>(of.children.size());
  const int child = before_a_row ? of.children[static_cast<std::size_t>(row)] : of.children.back();
  std::size_t to = onto.frame ? onto.frame->frame : frameOf(child);
  if (before_a_row && to > from) --to;  // It leaves its own place.
  if (to != from) emit pointMoveWanted(motion, from, to);
  return false;
}

bool WorkcellTreeModel::dropMimeData(const QMimeData* data, Qt::DropAction, int row, int, const QModelIndex& parent) {
  if (const QString format = QString::fromLatin1(kFrameMimeType); data->hasFormat(format) && parent.isValid())
    return dropFrame(data->data(format), row, nodes_[parent.internalId()]);
  if (!data->hasFormat(QString::fromLatin1(kMimeType)) || !parent.isValid()) return false;
  Entities ids;
  for (const QByteArray& id : data->data(QString::fromLatin1(kMimeType)).split(' ')) ids.push_back(id.toULongLong());
  const Kind kind = kindOf(parent);
  if (kind != Kind::kCell && kind != Kind::kFolder && kind != Kind::kEntity) return false;
  moveBelow(document_, ids, kind == Kind::kCell ? QString() : nodes_[parent.internalId()].name);
  return false;  // The document has done it; the view has nothing to take away.
}

}  // namespace hapticell::app
