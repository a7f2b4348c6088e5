// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSet>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <QWidget>

#include "app/panels/tree/workcell_tree_model.h"

class QLineEdit;
class QMenu;

namespace hapticell::app {

class Host;

/// The tree view of the workcell: rows with icon, name, state mark, lock and eye.
class WorkcellTreeView : public QTreeView {
  Q_OBJECT
 public:
  explicit WorkcellTreeView(QWidget* parent = nullptr);
  /// Position of the eye and the lock of a row, in pixels of the viewport.
  QRect eyeRect(const QModelIndex& index) const;
  QRect lockRect(const QModelIndex& index) const;

 signals:
  void eyeClicked(const QModelIndex& index);
  void lockClicked(const QModelIndex& index);
  void removeWanted();        ///< Delete was pressed: remove the selection.
  void moveWanted(int rows);  ///< Alt and an arrow key: move the current row up (-1) or down (1).

 protected:
  void drawRow(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  bool pressedMark(const QPoint& place);
};

/// The content of the dock: filter and tree, synchronized with the selection of the window.
class WorkcellPanel : public QWidget {
  Q_OBJECT
 public:
  explicit WorkcellPanel(Host& host, QWidget* parent = nullptr);
  void showSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot) { model_.setSnapshot(snapshot); }
  WorkcellTreeModel& model() { return model_; }
  WorkcellTreeView& tree() { return *tree_; }
  /// The entities of the selected rows and of all rows below them.
  std::vector<workcell::EntityId> chosenEntities() const;
  /// Adds what can be done with the selected rows; `index` is the row under the pointer.
  void fillMenu(QMenu& menu, const QModelIndex& index);
  /// Makes the row of a motion's frame the current one.
  void chooseFrame(const QString& motion, std::size_t frame);
  /// Brings the tree to the front and starts editing the name there.
  void rename(workcell::EntityId entity);

 signals:
  /// The menu of a row is about to be shown: receivers may add entries.
  void menuFilled(QMenu* menu, const QModelIndex& index);
  /// Delete was pressed on a motion or one of its frames; or Alt and an arrow key on a frame.
  void motionRemoveWanted(const QModelIndex& index);
  void pointStepWanted(const QModelIndex& index, int rows);

 private:
  void takeSelection();
  void showSelection();
  void openMenu(const QPoint& place);
  void keepExpanded();
  QString keyOf(const QModelIndex& index) const;
  QModelIndex source(const QModelIndex& index) const { return filter_model_.mapToSource(index); }

  Host& host_;
  WorkcellTreeModel model_;
  QSortFilterProxyModel filter_model_;
  QLineEdit* filter_;
  WorkcellTreeView* tree_;
  QSet<QString> collapsed_, expanded_;
  bool restoring_ = false;
};

}  // namespace hapticell::app
