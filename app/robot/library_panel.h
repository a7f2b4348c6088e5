// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSortFilterProxyModel>
#include <QThreadPool>
#include <QTimer>
#include <QWidget>
#include <optional>
#include <set>

#include "app/robot/library_model.h"
#include "app/controls/robot_picture.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QListView;
class QPushButton;

namespace hapticell::app {

class GhostPlacer;
class Host;
class PlaceFields;

/// Shows the robots that match the search and are of the chosen maker.
class LibraryFilter : public QSortFilterProxyModel {
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;
  void set(const QString& search, const QString& maker);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  QString search_, maker_;
};

/// "Add robot": the built-in robots with pictures, search and maker, the placement of the new robot, and the button
/// that adds it as one undo step. A robot that is clicked follows the pointer over the scene as a ghost until a click
/// there adds it.
class LibraryPanel : public QWidget {
  Q_OBJECT
 public:
  explicit LibraryPanel(Host& host, QWidget* parent = nullptr);
  ~LibraryPanel() override;
  LibraryModel& model() { return *model_; }
  /// Chooses a robot by its library name ("kuka_kr16_2").
  void choose(const std::string& name);
  void add();

 signals:
  void fileWanted();
  void added();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeSheet();
  QWidget* makePlace();
  int chosenRow() const;
  void showChosen();
  void showGhost();
  void addThere();
  std::optional<workcell::Entity> chosenRobot();
  void load(int row);
  void drawNext();
  Host& host_;
  LibraryModel* model_;
  LibraryFilter filter_;
  RobotPicture picture_;
  QLineEdit* search_;
  QComboBox* maker_;
  QListView* list_;
  QLabel *big_picture_, *name_, *sheet_;
  PlaceFields* place_;
  GhostPlacer* ghost_;
  QPushButton* add_;
  std::set<int> asked_;
  QTimer draw_;
  QThreadPool pool_;
};

}  // namespace hapticell::app
