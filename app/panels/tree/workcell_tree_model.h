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

/// The workcell as a tree: the cell, its folders and entities; assemblies and solids with what is below them; robots
/// with tool centre point, their motions with the frames, links and what is attached to them; frames, pair sets;
/// motions whose entity is not in the cell.
///
/// Changes of names, tree positions, visibility and lock are commands of the document, each one undo step. State
/// marks are taken from the newest snapshot and have a role of their own, so that a screen reader can say them. GUI
/// thread.
class WorkcellTreeModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Role {
    kEntityRole = Qt::UserRole,  ///< EntityId as qulonglong; 0 for folders.
    kPartRole,                   ///< Link name; empty for other rows.
    kIconRole,                   ///< Name of an icon.
    kMarkRole,                   ///< Mark of the row itself, as int.
    kInnerMarkRole,              ///< The strongest mark of the rows below: for collapsed rows.
    kSuffixRole,                 ///< "held", else empty.
    kVisibleRole,                ///< bool.
    kLockedRole,                 ///< bool.
    kCanHideRole,                ///< bool: the row has an eye.
    kFilterRole,                 ///< Name and state words.
    kMotionRole,                 ///< For a trajectory and its frames: the trajectory's name; else empty.
    kMotionFrameRole,            ///< Index of a trajectory's frame as qulonglong; no value for other rows.
    kCheckedRole,                ///< bool: for a trajectory's frame: a check covered it.
  };
  using Kind = TreeRow::Kind;
  using MotionFrame = TreeMotionFrame;
  using MotionRows = TreeMotionRows;
  using MotionFrames = TreeMotionFrames;

  explicit WorkcellTreeModel(DocumentModel& document, QObject* parent = nullptr);

  /// Marks and what is held; empty: no marks.
  void setSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot);
  /// Sets the rows below the trajectories; rows for unknown names are kept until the cell has such a trajectory.
  void setMotionFrames(MotionFrames frames);
  QModelIndex indexOf(workcell::EntityId entity) const;
  /// The row of a motion's frame; invalid if it has none.
  QModelIndex indexOfFrame(const QString& motion, std::size_t frame) const;
  Kind kindOf(const QModelIndex& index) const;
  /// Shows or hides, locks or unlocks the entities of the row and below it, as one undo step.
  bool setShown(const QModelIndex& index, bool shown);
  bool setLocked(const QModelIndex& index, bool locked);
  /// The entities of the row and those that the document has below it, without those that are only attached.
  std::vector<workcell::EntityId> entitiesOf(const QModelIndex& index) const;

  QModelIndex index(int row, int column, const QModelIndex& parent) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent) const override;
  int columnCount(const QModelIndex&) const override { return 1; }
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
  /// Moves dragged entities below the row on which they are dropped.
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                    const QModelIndex& parent) override;
  Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Dragged rows also carry the names of their entities, one per line, UTF-8.
  static constexpr const char* kNamesFormat = "application/x-hapticell-entity-names";

 signals:
  /// A trajectory was renamed in its row; receivers that keep data by its name must rename it too.
  void motionRenameWanted(const QString& name, const QString& new_name);
  /// A motion's frame was given a name in its row (empty: none), or was dragged to another position in the order.
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
