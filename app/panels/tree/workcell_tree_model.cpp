// SPDX-License-Identifier: Apache-2.0
#include "app/panels/tree/workcell_tree_model.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "app/controls/entity_icon.h"
#include "app/panels/tree/tree_edits.h"
#include "app/style/plain_lines.h"
#include "app/style/units.h"

namespace hapticell::app {
namespace {

int strength(Mark mark) {
  switch (mark) {
    case Mark::kContact:
      return 3;
    case Mark::kLimit:
      return 2;
    case Mark::kNearMiss:
      return 1;
    case Mark::kNone:
      break;
  }
  return 0;
}

Mark stronger(Mark a, Mark b) {
  return strength(a) >= strength(b) ? a : b;
}

QString markWord(Mark mark) {
  switch (mark) {
    case Mark::kContact:
      return QObject::tr("contact");
    case Mark::kNearMiss:
      return QObject::tr("near miss");
    case Mark::kLimit:
      return QObject::tr("limit");
    case Mark::kNone:
      break;
  }
  return {};
}

}  // namespace

WorkcellTreeModel::WorkcellTreeModel(DocumentModel& document, QObject* parent)
    : QAbstractItemModel(parent), document_(document) {
  nodes_ = build();
  connect(&document_, &DocumentModel::changed, this, &WorkcellTreeModel::documentChanged);
}

std::vector<TreeRow> WorkcellTreeModel::build() const {
  return WorkcellTreeRows(document_, motion_frames_).build();
}

void WorkcellTreeModel::documentChanged() {
  takeRows(build());
}

void WorkcellTreeModel::setMotionFrames(MotionFrames frames) {
  if (frames == motion_frames_) return;
  const MotionFrames before = std::exchange(motion_frames_, std::move(frames));  // Rows point there till they are new.
  takeRows(build());
}

void WorkcellTreeModel::takeRows(std::vector<Node> fresh) {
  const bool same = fresh == nodes_;
  if (!same) beginResetModel();
  nodes_ = std::move(fresh);
  for (Node& node : nodes_) node.mark = markOf(node);
  if (!same) return endResetModel();
  for (const Node& node : nodes_)
    if (!node.children.empty()) emit dataChanged(indexOfNode(node.children.front()), indexOfNode(node.children.back()));
}

/// What the stylus holds, and what a second one holds; 0: nothing.
std::array<workcell::EntityId, 2> WorkcellTreeModel::heldEntities() const {
  if (!snapshot_) return {};
  return {snapshot_->stylus.held, snapshot_->second ? snapshot_->second->held : 0};
}

bool WorkcellTreeModel::isHeld(const workcell::Entity* entity) const {
  const auto held = heldEntities();
  return entity && (entity->id == held[0] || entity->id == held[1]);
}

void WorkcellTreeModel::setSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot) {
  const auto held_before = heldEntities();
  snapshot_ = snapshot;
  const auto held = heldEntities();
  updateMarks();
  if (held == held_before) return;
  for (const workcell::EntityId id : {held[0], held[1], held_before[0], held_before[1]})
    if (const QModelIndex row = indexOf(id); row.isValid()) emit dataChanged(row, row);
}

void WorkcellTreeModel::updateMarks() {
  bool any = false;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Mark mark = markOf(nodes_[i]);
    if (mark == nodes_[i].mark) continue;
    nodes_[i].mark = mark;
    any = true;
    const QModelIndex row = indexOfNode(static_cast<int>(i));
    emit dataChanged(row, row);
  }
  if (!any) return;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (!nodes_[i].children.empty())
      emit dataChanged(indexOfNode(static_cast<int>(i)), indexOfNode(static_cast<int>(i)));
}

Mark WorkcellTreeModel::markOf(const Node& node) const {
  if (node.frame) return node.frame->mark;
  if (!snapshot_ || node.entity == 0 || node.kind == Kind::kTcp || node.kind == Kind::kFrame) return Mark::kNone;
  Mark mark = Mark::kNone;
  for (const auto& pair : snapshot_->pairs) {
    const std::string part = node.part.toStdString();
    const bool first = pair.moved == node.entity && (node.part.isEmpty() || pair.moved_part == part);
    const bool second = pair.other == node.entity && (node.part.isEmpty() || pair.other_part == part);
    if (first || second) mark = stronger(mark, pairMark(pair));
  }
  if (mark == Mark::kNone && node.kind == Kind::kEntity && node.entity == snapshot_->stylus.held &&
      !snapshot_->limits.empty())
    mark = Mark::kLimit;
  return mark;
}

Mark WorkcellTreeModel::innerMark(int index) const {
  const Node& node = nodes_[static_cast<std::size_t>(index)];
  Mark mark = node.mark;
  for (const int child : node.children) mark = stronger(mark, innerMark(child));
  return mark;
}

QModelIndex WorkcellTreeModel::indexOfNode(int node) const {
  return createIndex(nodes_[static_cast<std::size_t>(node)].row, 0, static_cast<quintptr>(node));
}

QModelIndex WorkcellTreeModel::indexOf(workcell::EntityId entity) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].kind == Kind::kEntity && nodes_[i].entity == entity) return indexOfNode(static_cast<int>(i));
  return {};
}

QModelIndex WorkcellTreeModel::indexOfFrame(const QString& motion, std::size_t frame) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    if (node.frame && node.frame->frame == frame && nodes_[static_cast<std::size_t>(node.parent)].name == motion)
      return indexOfNode(static_cast<int>(i));
  }
  return {};
}

WorkcellTreeModel::Kind WorkcellTreeModel::kindOf(const QModelIndex& index) const {
  return nodes_[index.internalId()].kind;
}

QModelIndex WorkcellTreeModel::index(int row, int column, const QModelIndex& parent) const {
  if (column != 0 || row < 0) return {};
  if (!parent.isValid()) return row == 0 ? createIndex(0, 0, quintptr{0}) : QModelIndex();
  const auto& children = nodes_[parent.internalId()].children;
  if (row >= static_cast<int>(children.size())) return {};
  return createIndex(row, 0, static_cast<quintptr>(children[static_cast<std::size_t>(row)]));
}

QModelIndex WorkcellTreeModel::parent(const QModelIndex& child) const {
  if (!child.isValid()) return {};
  const int parent = nodes_[child.internalId()].parent;
  return parent < 0 ? QModelIndex() : indexOfNode(parent);
}

int WorkcellTreeModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? static_cast<int>(nodes_[parent.internalId()].children.size()) : 1;
}

const workcell::Entity* WorkcellTreeModel::entityOf(const Node& node) const {
  return document_.document().find(node.entity);
}

/// By where the document has them below, not by what they hang on: hiding a robot leaves the part in its gripper.
std::vector<workcell::EntityId> WorkcellTreeModel::entitiesOf(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  const Node& node = nodes_[index.internalId()];
  const auto& all = document_.document().state().entities;
  std::vector<workcell::EntityId> found;
  if (node.kind == Kind::kCell)
    for (const auto& entity : all) found.push_back(entity->id);
  if (node.kind != Kind::kFolder && node.kind != Kind::kEntity) return found;
  std::unordered_multimap<std::string_view, const workcell::Entity*> below;
  for (const auto& entity : all) below.emplace(entity->parent, entity.get());
  const std::string top = node.name.toStdString();
  if (node.kind == Kind::kEntity) found.push_back(node.entity);
  std::vector<std::string_view> open{top};
  while (!open.empty()) {
    const auto [first, last] = below.equal_range(open.back());
    open.pop_back();
    for (auto child = first; child != last; ++child) {
      found.push_back(child->second->id);
      open.push_back(child->second->name);
    }
  }
  return found;
}

QString WorkcellTreeModel::stateWords(const Node& node) const {
  if (node.frame) return node.frame->finding;
  QStringList words;
  const workcell::Entity* entity = node.kind == Kind::kEntity ? entityOf(node) : nullptr;
  if (node.mark != Mark::kNone) words << markWord(node.mark);
  if (isHeld(entity)) words << tr("held");
  if (entity && entity->locked) words << tr("locked");
  if (entity && !entity->visible) words << tr("hidden");
  return words.join(QStringLiteral(", "));
}

QString WorkcellTreeModel::accessibleText(const Node& node) const {
  const QString words = stateWords(node);
  QString text = words.isEmpty() ? node.name : node.name + QStringLiteral(", ") + words;
  if (!snapshot_ || node.mark != Mark::kNearMiss) return text;
  for (const auto& pair : snapshot_->pairs)
    if (pair.near_miss && (pair.moved == node.entity || pair.other == node.entity))
      return text + QStringLiteral(", ") + lengthText(pair.distance);
  return text;
}

QString WorkcellTreeModel::attachedText(const workcell::Entity& entity) {
  const QString to = QString::fromStdString(entity.attachment.to),
                link = QString::fromStdString(entity.attachment.link);
  return link.isEmpty() ? tr("Attached to %1").arg(to) : tr("Attached to %1 of %2").arg(link, to);
}

QVariant WorkcellTreeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Node& node = nodes_[index.internalId()];
  const auto entities = [&] { return entitiesOf(index); };
  const auto all = [&](auto&& holds) {
    const auto ids = entities();
    return !ids.empty() &&
           std::all_of(ids.begin(), ids.end(), [&](auto id) { return holds(*document_.document().find(id)); });
  };
  const workcell::Entity* entity = node.kind == Kind::kEntity ? entityOf(node) : nullptr;
  switch (role) {
    case Qt::DisplayRole:
      return plainLines(node.name);
    case Qt::EditRole:
      return node.frame ? node.frame->own_name : node.name;
    case Qt::AccessibleTextRole:
      return accessibleText(node);
    case Qt::ToolTipRole:
      if (entity && !entity->attachment.to.empty()) return attachedText(*entity);
      return node.frame && !node.frame->finding.isEmpty() ? node.frame->finding : QVariant();
    case kEntityRole:
      return static_cast<qulonglong>(node.entity);
    case kPartRole:
      return node.part;
    case kMarkRole:
      return static_cast<int>(node.mark);
    case kInnerMarkRole:
      return static_cast<int>(innerMark(static_cast<int>(index.internalId())));
    case kMotionRole:
      if (node.kind == Kind::kTrajectory) return node.name;
      return node.frame ? nodes_[static_cast<std::size_t>(node.parent)].name : QString();
    case kMotionFrameRole:
      return node.frame ? QVariant(static_cast<qulonglong>(node.frame->frame)) : QVariant();
    case kCheckedRole:
      return node.frame && node.frame->checked;
    case kSuffixRole:
      if (node.frame) return node.frame->finding;
      if (entity && entity->unloaded) return tr("file missing");
      return isHeld(entity) ? tr("held") : QString();
    case kCanHideRole:
      return node.kind == Kind::kCell || node.kind == Kind::kFolder || node.kind == Kind::kEntity;
    case kVisibleRole:
      return entity ? entity->visible : !all([](const auto& e) { return !e.visible; });
    case kLockedRole:
      return entity ? entity->locked : node.kind == Kind::kFolder && all([](const auto& e) { return e.locked; });
    case kFilterRole:
      return QString(node.name + QLatin1Char(' ') + stateWords(node));
    case kIconRole:
      switch (node.kind) {
        case Kind::kCell:
          return QStringLiteral("cell");
        case Kind::kFolder:
          return QStringLiteral("folder");
        case Kind::kEntity:
          return entity ? QString::fromLatin1(entityIcon(*entity)) : QStringLiteral("cube");
        case Kind::kTcp:
        case Kind::kFrame:
          return QStringLiteral("frame");
        case Kind::kTrajectories:
          return QStringLiteral("folder");
        case Kind::kTrajectory:
          return QStringLiteral("record");
        case Kind::kLink:
          return QStringLiteral("cube");
        case Kind::kPairSets:
          return QStringLiteral("measure");
        case Kind::kPairSet:
          return QStringLiteral("near_miss");
        case Kind::kMotionFrame:
          break;  // A dot, drawn by the view.
      }
      return {};
    default:
      return {};
  }
}

Qt::ItemFlags WorkcellTreeModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  const Kind kind = kindOf(index);
  Qt::ItemFlags result = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  if (kind == Kind::kFolder || kind == Kind::kEntity || kind == Kind::kFrame || kind == Kind::kPairSet ||
      kind == Kind::kTrajectory || kind == Kind::kMotionFrame)
    result |= Qt::ItemIsEditable;
  if (kind == Kind::kFolder || kind == Kind::kEntity || kind == Kind::kMotionFrame) result |= Qt::ItemIsDragEnabled;
  if (kind == Kind::kCell || kind == Kind::kFolder || kind == Kind::kEntity || kind == Kind::kTrajectory ||
      kind == Kind::kMotionFrame)
    result |= Qt::ItemIsDropEnabled;
  return result;
}

bool WorkcellTreeModel::renameFolder(const Node& node, const QString& name) {
  std::vector<workcell::Command> commands;
  const std::string folder = node.name.toStdString();
  for (const auto& entity : document_.document().state().entities) {
    if (entity->parent != folder) continue;
    workcell::SetProperties change;
    change.id = entity->id;
    change.parent = name.toStdString();
    commands.emplace_back(change);
  }
  return document_.executeAll(tr("Rename %1").arg(node.name), commands);
}

bool WorkcellTreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::EditRole) return false;
  const Node node = nodes_[index.internalId()];
  const QString name = value.toString().trimmed();
  if (node.frame) {
    if (name == node.frame->own_name) return false;
    emit pointRenameWanted(index.data(kMotionRole).toString(), node.frame->frame, name);
    return true;
  }
  if (name.isEmpty() || name == node.name) return false;
  if (node.kind == Kind::kEntity) return document_.execute(workcell::RenameEntity{node.entity, name.toStdString()});
  if (node.kind == Kind::kFolder) return renameFolder(nodes_[index.internalId()], name);
  if (node.kind == Kind::kFrame) return renameOwnFrame(document_, node.entity, node.part, name);
  if (node.kind == Kind::kTrajectory) {
    emit motionRenameWanted(node.name, name);
    return true;
  }
  if (node.kind != Kind::kPairSet) return false;
  const workcell::PairSet* set = document_.document().state().findPairSet(node.name.toStdString());
  if (!set) return false;
  workcell::PairSet renamed = *set;
  renamed.name = name.toStdString();
  return document_.execute(workcell::EditPairSet{node.name.toStdString(), renamed});
}

bool WorkcellTreeModel::setShown(const QModelIndex& index, bool shown) {
  return showEntities(document_, entitiesOf(index), shown);
}

bool WorkcellTreeModel::setLocked(const QModelIndex& index, bool locked) {
  return lockEntities(document_, entitiesOf(index), locked);
}

}  // namespace hapticell::app
