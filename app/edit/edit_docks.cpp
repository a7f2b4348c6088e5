// SPDX-License-Identifier: Apache-2.0
#include "app/edit/edit_docks.h"

#include <QAction>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMainWindow>
#include <QScrollArea>

#include "app/edit/frame_placer.h"
#include "app/edit/move_panel.h"
#include "app/edit/part_panel.h"
#include "app/host/host.h"
#include "app/host/user_settings.h"
#include "app/kit/dock_front.h"
#include "app/kit/form.h"
#include "app/style/dock_title_bar.h"
#include "app/style/icon.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

/// Gizmo, keys and dock of one window; owned by it.
class EditDocks : public QObject {
 public:
  explicit EditDocks(Host& host) : QObject(&host.window()), host_(host), gizmo_(host, this), frames_(host, this) {
    panel_ = new MovePanel(host, gizmo_);
    QDockWidget* dock = makeDock("dockMove", tr("Move"), scrolledPanel(panel_));
    dock->setWindowIcon(icon("move"));
    host.addDock(dock, Qt::RightDockWidgetArea);
    dock->hide();
    host.viewport().setPointerTool(&gizmo_, ToolChain::kGizmo);
    host.viewport().installEventFilter(this);
    using Mode = EntityGizmo::Mode;
    take("actionSelect", Mode::kSelect);
    take("actionMove", Mode::kMove);
    take("actionRotate", Mode::kRotate);
    if (auto* snap = host.window().findChild<QAction*>("actionSnap")) {
      snap->setChecked(gizmo_.snapping());
      connect(snap, &QAction::toggled, this, [this](bool on) {
        host_.userSettings().setValue("edit/snap", on);
        panel_->readSettings();
      });
      connect(&host.userSettings(), &UserSettings::changed, snap, [this, snap](const QString& key) {
        if (key == QLatin1String("edit/snap")) snap->setChecked(host_.userSettings().value(key).toBool());
      });
    }
    if (auto* insert = host.window().findChild<QAction*>("actionInsertPart"))
      connect(insert, &QAction::triggered, this, [this] { openParts(); });
    if (auto* frame = host.window().findChild<QAction*>("actionInsertFrame"))
      connect(frame, &QAction::triggered, this, [this] { frames_.begin(); });
    if (auto* numbers = host.window().findChild<QAction*>("actionMoveBy"))
      connect(numbers, &QAction::triggered, dock, [dock] {
        bringToFront(dock);
      });
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool escape =
        event->type() == QEvent::KeyPress && static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Escape;
    if (!escape || host_.viewport().isPicking()) return QObject::eventFilter(watched, event);
    if (gizmo_.cancel()) return true;
    if (gizmo_.mode() != EntityGizmo::Mode::kSelect) {
      gizmo_.setMode(EntityGizmo::Mode::kSelect);
      return true;
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  void openParts() {
    if (!parts_dock_) {
      parts_dock_ = makeDock("dockInsertPart", tr("Insert part"), new PartPanel(host_));
      host_.addDock(parts_dock_, Qt::RightDockWidgetArea);
    }
    bringToFront(parts_dock_);
  }

  void take(const char* name, EntityGizmo::Mode mode) {
    auto* action = host_.window().findChild<QAction*>(name);
    if (!action) return;
    connect(action, &QAction::triggered, this, [this, mode] { gizmo_.setMode(mode); });
    connect(&gizmo_, &EntityGizmo::modeChanged, action,
            [this, action, mode] { action->setChecked(gizmo_.mode() == mode); });
  }

  Host& host_;
  EntityGizmo gizmo_;
  FramePlacer frames_;
  MovePanel* panel_;
  QDockWidget* parts_dock_ = nullptr;
};

}  // namespace

void addEditDocks(Host& host) {
  new EditDocks(host);
}

}  // namespace hapticell::app
