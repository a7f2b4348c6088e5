// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>
#include <functional>

#include "workcell/entity/guide.h"

class QBoxLayout;
class QButtonGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class SwitchList;
class ValueField;
struct PickedFeature;

/// The guides of the cell: the list with its switches, and the editor of the chosen one. A guide is made by choosing
/// its kind and picking its geometry in the scene; every edit is a command of the document, so it is felt at once and
/// can be undone. The guides stand in the scene as dash-dot lines.
class GuidesPanel : public QWidget {
  Q_OBJECT
 public:
  explicit GuidesPanel(Host& host, QWidget* parent = nullptr);
  /// The chosen guide's name; empty: none.
  QString current() const { return current_; }
  /// Puts the lines into the scene as things stand now; called a few times a second.
  void showCurves();

 private:
  void addList(QVBoxLayout& column);
  void addKinds(QVBoxLayout& column);
  void addGeometry(QVBoxLayout& column);
  void addFields(QVBoxLayout& column);
  void addStops(QVBoxLayout& section);
  void addLocks(QVBoxLayout& section);
  void choose(const QString& name);
  void chooseKind(workcell::GuideKind kind);
  void startNew();
  void pickGeometry(workcell::GuideKind kind, bool make);
  void take(const PickedFeature& feature, workcell::GuideKind kind, bool make);
  void pickHandle();
  void takePath();
  void removeGuide();
  void reverseAxis();
  void placeAtEntity();
  void edit(const std::function<void(workcell::Guide&)>& change);
  void editStop(bool upper);
  void show();
  void showGuide(const workcell::Guide* guide);
  void showStops(const workcell::Guide& guide);
  const workcell::Guide* guide() const;
  dvec3 movedPoint_W(const workcell::Guide& guide) const;

  Host& host_;
  QString current_;
  workcell::GuideKind wanted_ = workcell::GuideKind::kHinge;
  SwitchList* list_;
  QPushButton *new_, *remove_, *pick_, *path_, *handle_pick_, *reverse_, *place_;
  QButtonGroup* kinds_;
  QWidget *editor_, *empty_;
  QLineEdit *name_, *geometry_, *handle_, *detents_;
  QComboBox* entity_;
  ValueField *radius_, *pitch_, *offset_, *friction_, *detent_width_, *detent_force_;
  std::array<QCheckBox*, 2> has_stop_{};
  std::array<ValueField*, 2> mm_stop_{}, degree_stop_{};
  QSlider* help_;
  QLabel* help_value_;
  std::array<QPushButton*, 6> locks_{};
  QWidget *radius_row_, *pitch_row_, *offset_row_, *stops_row_, *detents_row_, *detent_row_, *help_row_, *locks_row_,
      *path_row_;
};

}  // namespace hapticell::app
