// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>
#include <array>
#include <optional>

#include "app/controls/robot_picture.h"
#include "workcell/entity/built_in_parts.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace hapticell::app {

class GhostPlacer;
class Host;
class PlaceFields;
class ValueField;

/// "Insert part": the built-in parts with pictures, their sizes, the placement of a new part, and the button that adds
/// it as one undo step. A part that is clicked follows the pointer over the scene as a ghost until a click there
/// inserts it. A gripper can be mounted on a robot: it is placed on the flange and attached to it; if the robot's tool
/// centre point was at the flange, it moves to between the fingers.
class PartPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PartPanel(Host& host, QWidget* parent = nullptr);
  /// Chooses a part by its scheme: "table".
  void choose(const QString& scheme);
  void insert();
  /// The part with the sizes and the placement of the fields; empty if the sizes cannot be used.
  std::optional<workcell::Entity> part() const;

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  static constexpr std::size_t kMostSizes = 3;
  QWidget* makeSizes();
  QWidget* makePlace();
  const workcell::BuiltInPart& chosen() const;
  std::string source() const;
  void showChosen();
  void showPart();
  void showGhost();
  void insertThere();
  void showRobots();
  void drawPictures();
  const workcell::Entity* robotToMountOn() const;
  void mount(workcell::EntityId part, const workcell::Entity& robot);

  Host& host_;
  RobotPicture picture_;
  QListWidget* list_;
  QLabel *big_picture_, *problem_;
  std::array<QWidget*, kMostSizes> rows_{};
  std::array<QLabel*, kMostSizes> names_{};
  std::array<ValueField*, kMostSizes> sizes_{};
  PlaceFields* place_;
  GhostPlacer* ghost_;
  QWidget* mount_row_;
  QComboBox* mount_on_;
  QPushButton* insert_;
  QTimer draw_;
};

}  // namespace hapticell::app
