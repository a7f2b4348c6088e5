// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>
#include <QComboBox>
#include <QCursor>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTest>

#include "app/kit/typed_key.h"
#include "app/style/segmented.h"
#include "app/style/value_field.h"
#include "geometry/shapes/shapes.h"
#include "manipulation/scene/prepared_scene.h"
#include "tests/app/pages/window_page.h"
#include "workcell/entity/built_in_parts.h"

namespace hapticell::app {

/// A window with a small cell, and what a user does in its docks, by real events.
class CellPage : public WindowPage {
 public:
  explicit CellPage(const config::Configuration& configuration = {}) : WindowPage(configuration) {
    window().resize(900, 640);
    window().viewport().setMotion(false);
    settle();
  }
  /// A cube that a document can name, so that it is there again when the document is read.
  workcell::EntityId addBox(const char* name, double size) {
    const std::string side = std::to_string(size);
    workcell::Entity entity = workcell::makeBuiltInPart("box:" + side + "," + side + "," + side, 1.0).value();
    entity.name = name;
    window().documentModel().execute(workcell::AddEntity{entity});
    return document().findByName(name)->id;
  }
  workcell::EntityId addSolid(const char* name, geometry::TriangleMesh mesh, const Pose& X_WE = {}) {
    workcell::Entity entity;
    entity.name = name;
    entity.X_WE = X_WE;
    entity.body = workcell::Solid{std::make_shared<geometry::TriangleMesh>(std::move(mesh))};
    window().documentModel().execute(workcell::AddEntity{entity});
    return document().findByName(name)->id;
  }
  const workcell::Document& document() { return window().documentModel().document(); }
  const workcell::DocumentState& state() { return document().state(); }
  void select(workcell::EntityId entity) {
    window().selection().set(entity);
    settle();
  }
  void showDock(const char* name) {
    auto* dock = window().findChild<QDockWidget*>(name);
    ASSERT_NE(dock, nullptr) << name;
    dock->show();
    dock->raise();
    settle();
  }
  template <class Widget>
  Widget* find(const char* name) {
    auto* found = window().findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void click(QWidget* widget, const QPoint& place) {
    QTest::mouseClick(widget, Qt::LeftButton, Qt::NoModifier, place);
    settle();
  }
  void press(const char* button) {
    auto* found = find<QAbstractButton>(button);
    if (found) click(found, found->rect().center());
  }
  void chooseSegment(const char* name, int index) {
    auto* segments = find<Segmented>(name);
    if (segments) click(segments->button(index), segments->button(index)->rect().center());
  }
  /// Types a number into a field and presses Enter.
  void type(const char* field, const QString& text) {
    auto* found = find<ValueField>(field);
    if (!found) return;
    found->setFocus();
    found->selectAll();
    QTest::keyClicks(found, text);
    QTest::keyClick(found, Qt::Key_Return);
    settle();
  }
  /// Over the scene, as who presses a letter has the pointer.
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    activate();
    if (isTypedKey(key, modifiers)) pointAt(window().viewport());
    QTest::keyClick(&window().viewport(), key, modifiers);
    settle();
  }
  /// The pointer goes to the middle of it, if it is not over it already.
  void pointAt(const QWidget& widget) {
    if (QApplication::widgetAt(QCursor::pos()) == &widget) return;
    QCursor::setPos(widget.mapToGlobal(widget.rect().center()));
    settle();
  }
  /// Presses the keys of a text, wherever the focus is.
  void typeText(const char* text) {
    activate();
    for (; *text; ++text) QTest::keyClick(window().windowHandle(), *text);
    settle();
  }
  /// A click of the left button where the scene shows this point.
  void clickPoint(const dvec3& p_W) {
    const ViewportWidget& viewport = window().viewport();
    const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    const auto pixel = viewport.camera().project(p_W, size);
    ASSERT_TRUE(pixel.has_value());
    clickScene(pixel->x / size.width, pixel->y / size.height);
  }
  /// Looks at a box of this half width about a point, from the front above.
  void lookAt(const dvec3& p_W, double half) {
    geometry::Bounds bounds;
    bounds.add(p_W - dvec3(half));
    bounds.add(p_W + dvec3(half));
    window().viewport().fit(bounds, false);
    window().viewport().finishedPicture();
    settle();
  }
  /// What a running module would hand to the window of the document as it stands.
  void prepareScene() {
    window().setPreparedScene(
        manipulation::PreparedScene::prepare(document().snapshotEntities(), state().pairPolicy(), {}));
  }
};

}  // namespace hapticell::app
