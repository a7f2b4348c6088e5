// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>

#include "workcell/entity/guide.h"

class QButtonGroup;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class GuideFields;
class GuideGeometryFields;
class Host;
class SwitchList;
struct PickedFeature;

/// The guides of the cell: the list with its switches, and the editor of the chosen one. To make a guide, the user
/// chooses its kind and picks its geometry in the scene. Every edit is a command of the document, so it is felt at once
/// and can be undone. The scene shows guides as dash-dot lines.
class GuidesPanel : public QWidget {
  Q_OBJECT
 public:
  explicit GuidesPanel(Host& host, QWidget* parent = nullptr);
  /// The chosen guide's name; empty: none.
  QString current() const { return current_; }
  /// Updates the lines in the scene; called a few times a second.
  void showCurves();

 private:
  void addList(QVBoxLayout& column);
  void addKinds(QVBoxLayout& column);
  void connectGeometry();
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
  void show();
  const workcell::Guide* guide() const;
  dvec3 movedPoint_W(const workcell::Guide& guide) const;

  Host& host_;
  QString current_;
  workcell::GuideKind wanted_ = workcell::GuideKind::kHinge;
  SwitchList* list_;
  QPushButton *new_, *remove_;
  QButtonGroup* kinds_;
  QWidget *editor_, *empty_;
  GuideGeometryFields* geometry_;
  GuideFields* fields_;
};

}  // namespace hapticell::app
