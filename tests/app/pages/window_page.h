// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QThread>
#include <optional>

#include "app/shell/main_window.h"
#include "app/import/file_work.h"
#include "app/viewport/widget/view_picture.h"

namespace hapticell::app {

/// What a user does with the window, so that tests do not know its widgets. The scene is drawn at half the resolution without
/// a picture at rest, which by software took half of the tests' time: what looks at edges, shadows or texts of the picture
/// asks for fine pictures.
class WindowPage {
 public:
  explicit WindowPage(const config::Configuration& configuration = {}) : window_(configuration) {
    window_.viewport().setProperty(ViewPicture::kRestSamples, 0);
    window_.resize(1200, 800);
    window_.show();
    settle();
  }
  MainWindow& window() { return window_; }
  /// Keys are heard by the active window only, and becoming that takes a slow machine its time.
  void activate() {
    if (window_.isActiveWindow()) return;
    window_.activateWindow();
    EXPECT_TRUE(until([&] { return window_.isActiveWindow(); }, 30000));
  }
  void trigger(const char* action) {
    auto* found = window_.findChild<QAction*>(action);
    ASSERT_NE(found, nullptr) << action;
    found->trigger();
    settle();
  }
  bool enabled(const char* action) const {
    const auto* found = window_.findChild<QAction*>(action);
    return found && found->isEnabled();
  }
  /// A click of the left button at parts of the viewport's width and height.
  void clickScene(double right, double down) {
    ViewportWidget& viewport = window_.viewport();
    const QPointF place(right * viewport.width(), down * viewport.height());
    for (const auto type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
      const auto held = type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton;
      QMouseEvent event(type, place, viewport.mapToGlobal(place), Qt::LeftButton, held, Qt::NoModifier);
      QApplication::sendEvent(&viewport, &event);
    }
    settle();
  }
  /// Opens a workcell and waits until it is there, or not: whether it is.
  bool open(const QString& path) {
    return ends([&] { window_.openFile(path); }, &FileWork::opened);
  }
  /// Imports a file without asking and waits: whether it is in the cell.
  bool add(const QString& path) {
    return ends([&] { window_.importFiles({path}, false); }, &FileWork::imported);
  }
  bool hasDock(const char* name) const { return window_.findChild<QDockWidget*>(name) != nullptr; }
  QString sentence() const { return window_.statusLine().sentence(); }
  std::size_t entities() { return window_.documentModel().document().state().entities.size(); }
  /// Pictures at rest and finished ones as users see them.
  void setFinePictures() {
    window_.viewport().setProperty(ViewPicture::kRestSamples, {});
    window_.viewport().update();
    settle();
  }
  /// Lets the window work off its events.
  static void settle() {
    for (int i = 0; i < 5; ++i) QApplication::processEvents(QEventLoop::AllEvents, 50);
  }
  /// Works until `done` or for `limit_ms` at most; whether it was done.
  template <typename Condition>
  static bool until(Condition done, int limit_ms) {
    QElapsedTimer clock;
    clock.start();
    while (!done() && clock.elapsed() < limit_ms) {
      QApplication::processEvents(QEventLoop::AllEvents, 20);
      QThread::msleep(1);  // What is waited for is worked out by other threads and programs: they get the processor.
    }
    return done();
  }

 private:
  template <typename Begin, typename Signal>
  bool ends(Begin begin, Signal signal) {
    std::optional<bool> done;
    const auto connection =
        QObject::connect(&window_.files(), signal, &window_, [&done](const QString&, bool is_there) { done = is_there; });
    begin();
    constexpr int kPatience = 60000;
    until([&done] { return done.has_value(); }, kPatience);
    QObject::disconnect(connection);
    settle();
    return done.value_or(false);
  }

  MainWindow window_;
};

}  // namespace hapticell::app
