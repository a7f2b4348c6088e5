// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QTimer>

#include "app/trajectory/motions/motion_export.h"
#include "app/trajectory/docks/time_bar.h"
#include "app/trajectory/motions/track_rows.h"
#include "tests/app/pages/cell_page.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::app {

/// What a user does with motions.
class MotionPage : public CellPage {
 public:
  static constexpr int kPatience = 20000;
  MotionPage() {
    window().resize(1300, 860);
    box_ = addSolid("box", geometry::makeBox(dvec3(0.1)));
    addSolid("wall", geometry::makeBox({0.02, 0.4, 0.4}), Pose::translation({0.5, 0, 0}));
    showDock("dockTrajectory");
    showDock("dockMotion");
    window().activateWindow();
    window().viewport().setFocus();
    settle();
  }
  workcell::EntityId box() const { return box_; }
  TimeBar& bar() { return *find<TimeBar>("timeBar"); }
  const std::vector<TrackRow>& rows() { return bar().rows(); }
  /// A motion of the box along x as a file, imported through the panel's own work.
  bool import(const std::vector<std::pair<double, dvec3>>& points, const QString& name) {
    trajectory::Trajectory motion;
    motion.entity = "box";
    for (const auto& [t, p] : points) motion.addFrame({t, Pose::translation(p)});
    return importMotion(std::move(motion), name);
  }
  bool importMotion(trajectory::Trajectory motion, const QString& name) {
    motion.name = name.toStdString();
    const QString path = folder_.filePath(name + ".htraj");
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(trajectory::toJsonText(motion)));
    file.close();
    const std::size_t before = motions();
    window().findChild<MotionExport*>()->importFrom({path}, "box");
    return until([&] { return motions() == before + 1 && isIdle(); }, kPatience);
  }
  std::size_t motions() { return state().trajectories.size(); }
  bool isIdle() {
    const auto* cancel = window().findChild<QAbstractButton*>("buttonCancelMotionWork");
    return cancel && !cancel->isVisibleTo(cancel->parentWidget());
  }
  /// Clicks and waits until the new motion is there.
  bool pressForMotion(const char* button) {
    const std::size_t before = motions();
    press(button);
    return until([&] { return motions() == before + 1 && isIdle(); }, kPatience);
  }
  const trajectory::Trajectory& newest() { return *state().trajectories.back().motion; }
  Pose shownBox() {
    const auto& scene = window().viewport().scene();
    return scene.placement_W(*scene.find(box_));
  }
  void scrub(double t) {
    QTest::mouseClick(&bar(), Qt::LeftButton, Qt::NoModifier,
                      QPoint(static_cast<int>(bar().axis().x(t)), TimeBar::kRuler / 2));
    settle();
  }
  /// Takes hold of the frame whose dot stands at `t` in a row of the time bar.
  void clickDot(double t, int row = 0) {
    click(&bar(), QPoint(static_cast<int>(std::lround(bar().axis().x(t))),
                         TimeBar::kRuler + row * TimeBar::kRow + TimeBar::kRow / 2));
  }
  /// The window's next file dialog gets this name and Enter.
  void answerFileDialog(const QString& path) {
    auto* timer = new QTimer(&window());
    QObject::connect(timer, &QTimer::timeout, &window(), [timer, path] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (!dialog) return;
      timer->deleteLater();
      dialog->selectFile(path);
      static_cast<QDialog*>(dialog)->accept();
    });
    timer->start(10);
  }
  /// Drags with the left button from one point of the cell to where another is seen; false: not both are seen.
  bool dragScene(const dvec3& p_WFrom, const dvec3& p_WTo, bool let_go = true) {
    ViewportWidget& viewport = window().viewport();
    const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    const auto from = viewport.camera().project(p_WFrom, size), to = viewport.camera().project(p_WTo, size);
    if (!from || !to) return false;
    const QPoint a(static_cast<int>(std::lround(from->x)), static_cast<int>(std::lround(from->y)));
    const QPoint b(static_cast<int>(std::lround(to->x)), static_cast<int>(std::lround(to->y)));
    QTest::mouseMove(&viewport, a);
    QTest::mousePress(&viewport, Qt::LeftButton, Qt::NoModifier, a);
    for (int i = 1; i <= 4; ++i) {
      // QTest's own moves tell no buttons.
      const QPointF place = a + (b - a) * i / 4;
      QMouseEvent event(QEvent::MouseMove, place, viewport.mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                        Qt::NoModifier);
      QApplication::sendEvent(&viewport, &event);
    }
    settle();
    if (let_go) QTest::mouseRelease(&viewport, Qt::LeftButton, Qt::NoModifier, b);
    settle();
    return true;
  }
  QString words(const char* label) { return find<QLabel>(label)->text(); }
  QDir& folder() { return folder_; }

 private:
  struct Folder : QDir {
    Folder() : QDir(QDir::temp().filePath(QStringLiteral("motions-%1").arg(::getpid()))) { QDir().mkpath(path()); }
    ~Folder() { removeRecursively(); }
  } folder_;
  workcell::EntityId box_ = 0;
};

}  // namespace hapticell::app
