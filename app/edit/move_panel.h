// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>

#include "app/edit/entity_gizmo.h"
#include "app/viewport/tools/picked_feature.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class ReferenceChoice;
class Segmented;
class ValueField;

/// Moves and rotates by numbers: whose axes, about which point, how far; steps and snapping of drags; puts a picked
/// feature of the selection onto another one. Remembers the gizmo's settings that it changes.
class MovePanel : public QWidget {
  Q_OBJECT
 public:
  MovePanel(Host& host, EntityGizmo& gizmo, QWidget* parent = nullptr);
  /// Reads steps, axes and snapping from the settings, as at the start.
  void readSettings();

 private:
  void addTool(QVBoxLayout& column);
  void addNumbers(QVBoxLayout& column);
  void addSteps(QVBoxLayout& column);
  void addOnto(QVBoxLayout& column);
  void showTool();
  void chooseAxes(int index);
  void showFrames();
  void showSelection();
  void showMotion(const Twist& motion_G);
  void applyNumbers();
  void storeSteps();
  void pickFrom();
  void pickTo(const PickedFeature& from);

  Host& host_;
  EntityGizmo& gizmo_;
  QLabel *title_, *note_;
  Segmented *mode_, *axes_, *about_;
  ReferenceChoice* frame_;  ///< The frame whose axes are used, for EditAxes::kFrame.
  QWidget* frame_row_;
  std::array<ValueField*, 6> numbers_{};
  QPushButton *apply_, *onto_;
  QCheckBox *grid_on_, *angle_on_, *snap_, *align_;
  ValueField *grid_, *angle_;
  bool reading_ = false;
};

}  // namespace hapticell::app
