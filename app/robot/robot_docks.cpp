// SPDX-License-Identifier: Apache-2.0
#include "app/robot/robot_docks.h"

#include <QAction>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QTimer>

#include "app/kit/action_face.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/stylus_use.h"
#include "app/kit/dock_front.h"
#include "app/host/selection.h"
#include "app/kit/top_menus.h"
#include "app/kit/form.h"
#include "app/controls/refresh_timer.h"
#include "app/robot/joint_mover.h"
#include "app/robot/library_panel.h"
#include "app/robot/mechanism_panel.h"
#include "app/robot/motion_worker.h"
#include "app/robot/robot_context.h"
#include "app/robot/robot_panel.h"
#include "app/robot/tcp_gizmo.h"
#include "app/robot/tools_panel.h"
#include "app/style/dock_title_bar.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {


/// Docks of one window and what they share; owned by the window.
class RobotDocks : public QObject {
 public:
  explicit RobotDocks(Host& host)
      : QObject(&host.window()),
        host_(host),
        context_(host),
        worker_(host),
        mover_(context_, worker_),
        gizmo_(context_, mover_) {
    panel_ = new RobotPanel(context_, worker_, mover_);
    dock_ = addDock("dockRobot", tr("Robot"), panel_);
    connect(&context_, &RobotContext::robotChanged, this, [this] {
      if (!context_.robot()) return;
      dock_->setWindowTitle(context_.isMechanism() ? tr("Mechanism") : tr("Robot"));
      worker_.warmUp();
    });
    connect(&host.selection(), &Selection::changed, this, [this](workcell::EntityId entity) {
      const bool ours = context_.robot() && context_.robot()->id == entity;
      if (ours && !isStylusInUse(host_)) bringForSelection(dock_);
    });
    if (auto* add = host.window().findChild<QAction*>("actionAddRobot"))
      connect(add, &QAction::triggered, this, [this] { openLibrary(); });
    connect(panel_, &RobotPanel::toolsWanted, this, [this] { openTools(); });
    connect(panel_, &RobotPanel::mechanismWanted, this, [this] { openMechanism(); });
    connect(panel_, &RobotPanel::libraryWanted, this, [this] { openLibrary(); });
    addMenu();
    addGizmo();
    connect(&refreshTimer(host), &QTimer::timeout, panel_, &RobotPanel::showNow);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool escape =
        event->type() == QEvent::KeyPress && static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Escape;
    return (escape && gizmo_.cancel()) || QObject::eventFilter(watched, event);
  }

 private:
  void addMenu() {
    QMenu* menu = topMenu(host_.window(), "menuRobot", tr("Robot"));
    if (auto* add = host_.window().findChild<QAction*>("actionAddRobot")) menu->addAction(add);
    const auto entry = [&](const char* name, const QString& text, auto&& slot) {
      QAction* action = makeAction(&host_.window(), {name, text, {}, {}, {}});
      menu->addAction(action);
      connect(action, &QAction::triggered, this, [this, slot] {
        if (!tellsStylusInUse(host_)) slot();
      });
    };
    entry("actionRobotPanel", tr("Configurations and jogging"), [this] { bringToFront(dock_); });
    entry("actionTools", tr("Tools and carried parts…"), [this] { openTools(); });
    menu->addSeparator();
    entry("actionMechanism", tr("Join parts into a mechanism…"), [this] { openMechanism(); });
  }

  void openTools() {
    if (!tools_dock_) {
      tools_dock_ = addDock("dockTools", tr("Tools"), new ToolsPanel(context_));
      markAsTask(tools_dock_);
    }
    bringToFront(tools_dock_);
  }

  void addGizmo() {
    host_.viewport().setPointerTool(&gizmo_, ToolChain::kHandles);
    host_.viewport().installEventFilter(this);
    connect(panel_, &RobotPanel::cartesianShown, &gizmo_, &TcpGizmo::setOn);
    connect(panel_, &RobotPanel::jogFrameChosen, &gizmo_, &TcpGizmo::setFrame);
    connect(&gizmo_, &TcpGizmo::held, panel_, &RobotPanel::showHeldBack);
    connect(&context_, &RobotContext::robotChanged, &gizmo_, &TcpGizmo::showNow);
    connect(&host_.documentModel(), &DocumentModel::closing, &gizmo_, &TcpGizmo::cancel);
  }

  QDockWidget* addDock(const char* name, const QString& title, QWidget* content) {
    QDockWidget* dock = makeDock(QLatin1String(name), title, scrolledPanel(content));
    host_.addDock(dock, Qt::RightDockWidgetArea);
    dock->hide();
    return dock;
  }

  void openMechanism() {
    if (!mechanism_) {
      mechanism_ = new MechanismPanel(context_);
      mechanism_dock_ = addDock("dockMechanism", tr("Mechanism joints"), mechanism_);
      markAsTask(mechanism_dock_);
      connect(mechanism_, &MechanismPanel::made, this, [this] { bringToFront(dock_); });
    }
    mechanism_->begin();
    bringToFront(mechanism_dock_);
  }

  void openLibrary() {
    if (!library_dock_) {
      auto* library = new LibraryPanel(host_);
      library_dock_ = makeDock(QStringLiteral("dockAddRobot"), tr("Add robot"), library);
      host_.addDock(library_dock_, Qt::RightDockWidgetArea);
      connect(library, &LibraryPanel::added, this, [this] { library_dock_->close(); });
      connect(library, &LibraryPanel::fileWanted, this, [this] {
        if (auto* file = host_.window().findChild<QAction*>("actionAddRobotFile")) file->trigger();
      });
    }
    bringToFront(library_dock_);
    if (auto* search = library_dock_->findChild<QLineEdit*>("searchLibrary")) search->setFocus();
  }

  void bringToFront(QDockWidget* dock) {
    if (!isStylusInUse(host_)) app::bringToFront(dock);
  }

  Host& host_;
  RobotContext context_;
  MotionWorker worker_;
  JointMover mover_;
  TcpGizmo gizmo_;
  RobotPanel* panel_;
  QDockWidget* dock_;
  QDockWidget *library_dock_ = nullptr, *tools_dock_ = nullptr, *mechanism_dock_ = nullptr;
  MechanismPanel* mechanism_ = nullptr;
};

}  // namespace

void addRobotDocks(Host& host) {
  new RobotDocks(host);
}

}  // namespace hapticell::app
