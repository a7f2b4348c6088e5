// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QTableView>
#include <QtTest/QTest>
#include <algorithm>
#include <cmath>

#include "app/style/value_field.h"
#include "app/viewport/widget/viewport_widget.h"
#include "kinematics/model/robot_model.h"
#include "tests/app/pages/window_page.h"
#include "workcell/import/entity_source.h"

namespace hapticell::app {

/// What a user does with robots in the window: real clicks and keys on the widgets of the docks.
class RobotPage : public WindowPage {
 public:
  static constexpr int kPatience = 20000;  // ms; checks run in a thread of their own.

  explicit RobotPage(const config::Configuration& configuration = withoutMotion()) : WindowPage(configuration) {
    window().resize(1600, 1000);
    settle();
  }
  static config::Configuration withoutMotion() {
    config::Configuration configuration;
    configuration.gui.motion = false;
    return configuration;
  }
  DocumentModel& document() { return window().documentModel(); }
  template <class Widget>
  Widget* find(const QString& name) {
    Widget* found = window().findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name.toStdString();
    return found;
  }
  /// A built-in robot at home, selected.
  workcell::EntityId addRobot(const std::string& library_name) {
    Diagnostics diagnostics;
    auto entity = workcell::EntityLoader({}).load("library:" + library_name, 0.0, diagnostics);
    EXPECT_TRUE(entity.has_value());
    if (!entity) return 0;
    entity->setJoints(kinematics::restPositions(*entity->robot()));
    return add(std::move(*entity));
  }
  workcell::EntityId add(workcell::Entity entity) {
    const std::string name = entity.name;
    EXPECT_TRUE(document().execute(workcell::AddEntity{std::move(entity)}));
    const workcell::Entity* made = document().document().findByName(name);
    if (!made) return 0;
    window().selection().set(made->id);
    settle();
    return made->id;
  }
  const workcell::Entity* selected() { return document().document().find(window().selection().current()); }
  std::vector<double> joints() { return selected() ? selected()->joints() : std::vector<double>{}; }
  std::size_t steps() { return document().document().undoTexts().size(); }
  /// Clicks a button and waits until what it began is one finished step of undo.
  bool clickForStep(const QString& button) {
    const std::size_t before = steps();
    click(button);
    return until([&] { return steps() == before + 1 && !document().document().inCompound(); }, kPatience);
  }
  void click(const QString& button) {
    auto* found = find<QAbstractButton>(button);
    if (!found) return;
    QTest::mouseClick(found, Qt::LeftButton);
    settle();
  }
  /// Types a number into a field and ends with Enter.
  void type(const QString& field, const QString& number) {
    auto* found = find<ValueField>(field);
    if (!found) return;
    found->setFocus();
    found->selectAll();
    QTest::keyClicks(found, number);
    QTest::keyClick(found, Qt::Key_Return);
    settle();
  }
  bool typeForStep(const QString& field, const QString& number) {
    const std::size_t before = steps();
    type(field, number);
    return until([&] { return steps() == before + 1 && !document().document().inCompound(); }, kPatience);
  }
  QString words(const QString& label) {
    auto* found = find<QLabel>(label);
    return found ? found->text() : QString();
  }
  /// A pixel of the scene where a point of the cell lies.
  QPoint pixelOfPoint(const dvec3& p_W) {
    ViewportWidget& scene = window().viewport();
    const auto seen =
        scene.camera().project(p_W, {static_cast<double>(scene.width()), static_cast<double>(scene.height())});
    return seen ? QPoint(static_cast<int>(std::lround(seen->x)), static_cast<int>(std::lround(seen->y))) : QPoint();
  }
  /// The pointer goes to a place of the scene, and clicks there where it is told so.
  void overScene(const QPoint& place, bool click) {
    ViewportWidget& scene = window().viewport();
    const auto send = [&](QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons held) {
      QMouseEvent event(type, QPointF(place), scene.mapToGlobal(QPointF(place)), button, held, Qt::NoModifier);
      QApplication::sendEvent(&scene, &event);
      settle();
    };
    send(QEvent::MouseMove, Qt::NoButton, Qt::NoButton);
    if (!click) return;
    send(QEvent::MouseButtonPress, Qt::LeftButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, Qt::LeftButton, Qt::NoButton);
  }
  /// How many shapes are in the scene only as ghosts.
  std::size_t ghosts() {
    const auto items = window().viewport().scene().items({});
    return static_cast<std::size_t>(
        std::count_if(items.begin(), items.end(), [](const RenderItem& item) { return item.ghost != Ghost::kNone; }));
  }
  bool isShown(const char* dock) {
    const auto* found = window().findChild<QDockWidget*>(dock);
    return found && found->isVisible();
  }
};

}  // namespace hapticell::app
