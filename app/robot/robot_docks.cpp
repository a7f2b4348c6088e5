// SPDX-License-Identifier: Apache-2.0
#include "app/robot/robot_docks.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QTimer>

#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/robot/joint_mover.h"
#include "app/robot/motion_worker.h"
#include "app/robot/robot_context.h"
#include "app/robot/robot_panel.h"
#include "app/style/dock_title_bar.h"

namespace hapticell::app {
namespace {

constexpr int kRefreshMilliseconds = 100;
constexpr int kDockWidth = 332;

QScrollArea* scrolled(QWidget* content) {
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(kDockWidth);
  scroll->setWidget(content);
  return scroll;
}

/// Docks of one window and what they share; owned by the window.
class RobotDocks : public QObject {
 public:
  explicit RobotDocks(Host& host)
      : QObject(&host.window()), host_(host), context_(host), worker_(host), mover_(context_, worker_) {
    panel_ = new RobotPanel(context_, worker_, mover_);
    dock_ = addDock("dockRobot", tr("Robot"), panel_);
    connect(&context_, &RobotContext::robotChanged, this, [this] {
      if (!context_.robot()) return;
      dock_->setWindowTitle(context_.isMechanism() ? tr("Mechanism") : tr("Robot"));
      worker_.warmUp();
    });
    connect(&host.selection(), &Selection::changed, this, [this](workcell::EntityId entity) {
      if (context_.robot() && context_.robot()->id == entity) bringToFront(dock_);
    });
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, panel_, &RobotPanel::showNow);
    timer->start(kRefreshMilliseconds);
  }

 private:
  QDockWidget* addDock(const char* name, const QString& title, QWidget* content) {
    QDockWidget* dock = makeDock(QLatin1String(name), title, scrolled(content));
    host_.addDock(dock, Qt::RightDockWidgetArea);
    dock->hide();
    return dock;
  }

  void bringToFront(QDockWidget* dock) {
    const auto& snapshot = host_.snapshot();
    if (snapshot && (snapshot->held != 0 || snapshot->forces_on)) return;
    dock->show();
    dock->raise();
  }

  Host& host_;
  RobotContext context_;
  MotionWorker worker_;
  JointMover mover_;
  RobotPanel* panel_;
  QDockWidget* dock_;
};

}  // namespace

void addRobotDocks(Host& host) {
  new RobotDocks(host);
}

}  // namespace hapticell::app
