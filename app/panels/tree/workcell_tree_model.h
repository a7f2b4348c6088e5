// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractItemModel>
#include <array>
#include <optional>
#include <vector>

#include "app/host/document_model.h"
#include "app/panels/tree/workcell_tree_rows.h"
#include "app/viewport/scene/strip_text.h"
#include "manipulation/engine/scene_snapshot.h"

namespace hapticell::app {

/// The workcell as a tree: the cell, its folders and entities, assemblies and solids with what stands below them,
/// robots with tool centre point, their motions with the points, links and what is attached to them, frames, pair sets;
/// motions of nothing that is in the cell.
///
/// Names, places in the tree, visibility and lock are changed through the document's commands, each one step of undo.
/// State marks come from the newest snapshot and are a role of their own, so that a screen reader can say them. GUI
/// thread.
class WorkcellTreeModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Role {
    kEntityRole = Qt::UserRole,  ///< EntityId as qulonglong; 0 for folders.
    kPartRole,                   ///< Link name; empty for others.
    kIconRole,                   ///< Name of an icon.
    kMarkRole,                   ///< Mark as int, of the row itself.
    kInnerMarkRole,              ///< The strongest mark of the rows below: for collapsed rows.
    kSuffixRole,                 ///< "held", else empty.
    kVisibleRole,                ///< bool.
    kLockedRole,                 ///< bool.
    kCanHideRole,                ///< bool: the row has an eye.
    kFilterRole,                 ///< Name and state words.
    kMotionRole,                 ///< Of a trajectory and its frames: the trajectory's name; else empty.
    kMotionFrameRole,            ///< Index of a trajectory's frame as qulonglong; no value for other rows.
    kCheckedRole,                ///< bool: of a trajectory's frame, a check went over it.
  };
  using Kind = TreeRow::Kind;
  using MotionFrame = TreeMotionFrame;
  using MotionRows = TreeMotionRows;
  using MotionFrames = TreeMotionFrames;

  explicit WorkcellTreeModel(DocumentModel& document, QObject* parent = nullptr);

  /// Marks and what is held; nothing: no marks.
  void setSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot);
  /// The rows below the trajectories; those of names that the cell does not have wait.
  void setMotionFrames(MotionFrames frames);
  QModelIndex indexOf(workcell::EntityId entity) const;
  /// The row of a motion's frame; not valid where it has none.
  QModelIndex indexOfFrame(const QString& motion, std::size_t frame) const;
  Kind kindOf(const QModelIndex& index) const;
  /// Shows or hides, locks or unlocks the entities of the row and below it, as one step of undo.
  bool setShown(const QModelIndex& index, bool shown);
  bool setLocked(const QModelIndex& index, bool locked);
  /// The entities of the row and those that the document has below it; what is attached only hangs there.
  std::vector<workcell::EntityId> entitiesOf(const QModelIndex& index) const;

  QModelIndex index(int row, int column, const QModelIndex& parent) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent) const override;
  int columnCount(const QModelIndex&) const override { return 1; }
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
  /// Puts dragged entities below the row they are dropped on.
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                    const QModelIndex& parent) override;
  Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Dragged rows carry the names of their entities too, one a line, UTF-8.
  static constexpr const char* kNamesFormat = "application/x-hapticell-entity-names";

 signals:
  /// A trajectory was given another name in its row; whoever keeps what is known of it renames it.
  void motionRenameWanted(const QString& name, const QString& new_name);
  /// A motion's frame was given a name in its row (empty: none), or dragged to another place in the order.
  void pointRenameWanted(const QString& motion, qulonglong frame, const QString& name);
  void pointMoveWanted(const QString& motion, qulonglong frame, qulonglong to);

 private:
  using Node = TreeRow;
  std::vector<Node> build() const;
  bool dropFrame(const QByteArray& dragged, int row, const Node& onto);
  void documentChanged();
  void takeRows(std::vector<Node> fresh);
  void updateMarks();
  std::array<workcell::EntityId, 2> heldEntities() const;
  bool isHeld(const workcell::Entity* entity) const;
  Mark markOf(const Node& node) const;
  Mark innerMark(int node) const;
  static QString attachedText(const workcell::Entity& entity);
  const workcell::Entity* entityOf(const Node& node) const;
  QString accessibleText(const Node& node) const;
  QString stateWords(const Node& node) const;
  QModelIndex indexOfNode(int node) const;
  bool renameFolder(const Node& node, const QString& name);

  DocumentModel& document_;
  MotionFrames motion_frames_;
  std::vector<Node> nodes_;
  std::optional<manipulation::SceneSnapshot> snapshot_;
};

}  // namespace hapticell::app
