// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QListWidget>
#include <QWidget>
#include <array>
#include <functional>

#include "workcell/entity/entity.h"

class QLabel;
class QPushButton;

namespace hapticell::app {

class Host;

/// One column of a pair set: names of entities, dropped here from the tree or from the other column. Delete removes the
/// chosen one.
class NameList : public QListWidget {
  Q_OBJECT
 public:
  explicit NameList(QWidget* parent = nullptr);

 signals:
  void dropped(const QStringList& names);
  void removed(const QStringList& names);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

/// The two columns of the chosen set. Entities are added by dragging rows of the tree, by picking in the scene, or by
/// adding the selection; each is one command of the document and takes effect at the next step of the loop, even while
/// something is held. An empty column means everything, and says so.
class PairColumns : public QWidget {
  Q_OBJECT
 public:
  explicit PairColumns(Host& host, QWidget* parent = nullptr);
  /// The set to show, by name; empty: none.
  void setSet(const QString& name);

 private:
  QWidget* makeColumn(int side);
  void show();
  void add(int side, const QStringList& names);
  void remove(int side, const QStringList& names);
  void pick(int side);
  const workcell::PairSet* set() const;

  Host& host_;
  QString name_;
  std::array<NameList*, 2> lists_{};
  std::array<QPushButton*, 2> picks_{}, adds_{}, removes_{};
};

}  // namespace hapticell::app
