// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>

#include "app/mannequin/mannequin_edits.h"
#include "app/style/segmented.h"
#include "tests/app/pages/robot_page.h"

namespace hapticell::app {

/// What a user does with a mannequin in the window: real clicks and keys.
class MannequinPage : public RobotPage {
 public:
  /// Adds one by the menu's entry and waits until it stands there, selected.
  bool addMannequin() {
    const std::size_t before = entities();
    trigger("actionAddMannequin");
    const bool added = until([&] { return entities() == before + 1; }, kPatience);
    settle();
    return added;
  }
  mannequin::Posture posture() { return postureOf(*selected()); }
  double stature() { return selected()->figure()->body[mannequin::Dimension::kStature]; }
  void segment(const char* name, int index) {
    auto* segments = find<Segmented>(name);
    if (!segments) return;
    QTest::mouseClick(segments->button(index), Qt::LeftButton);
    settle();
  }
  bool segmentForStep(const char* name, int index) {
    const std::size_t before = steps();
    segment(name, index);
    return until([&] { return steps() > before; }, kPatience);
  }
  /// Chooses an entry of the menu that a button opens.
  bool choose(const char* button, const char* entry) {
    const std::size_t before = steps();
    click(button);
    for (auto* menu : window().findChildren<QMenu*>()) {
      auto* action = menu->findChild<QAction*>(entry);
      if (!action || !menu->isVisible()) continue;
      QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(action).center());
      settle();
      return until([&] { return steps() == before + 1; }, kPatience);
    }
    return false;
  }
  /// Drags in the scene from one point of the cell to another with the left button; `moves` is how much of the way is
  /// told: 0 is a flick of which only the press and the release are heard, as on a machine that is busy.
  void dragScene(const dvec3& p_WFrom, const dvec3& p_WTo, int moves = 8) {
    ViewportWidget& viewport = window().viewport();
    const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    const auto from = viewport.camera().project(p_WFrom, size), to = viewport.camera().project(p_WTo, size);
    ASSERT_TRUE(from && to);
    const auto send = [&](QEvent::Type type, const QPointF& place, Qt::MouseButtons held) {
      const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
      QMouseEvent event(type, place, viewport.mapToGlobal(place), button, held, Qt::NoModifier);
      QApplication::sendEvent(&viewport, &event);
      settle();
    };
    const auto place = [&](double s) {
      return QPointF(from->x + s * (to->x - from->x), from->y + s * (to->y - from->y));
    };
    send(QEvent::MouseMove, place(0.0), Qt::NoButton);
    send(QEvent::MouseButtonPress, place(0.0), Qt::LeftButton);
    for (int i = 1; i <= moves; ++i) send(QEvent::MouseMove, place(static_cast<double>(i) / moves), Qt::LeftButton);
    send(QEvent::MouseButtonRelease, place(1.0), Qt::NoButton);
  }
  void bringDock(const char* action) {
    trigger(action);
    settle();
  }
};

}  // namespace hapticell::app
