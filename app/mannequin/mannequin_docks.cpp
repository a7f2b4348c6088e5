// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/mannequin_docks.h"

#include <QAction>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

#include "app/controls/refresh_timer.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/host/stylus_use.h"
#include "app/kit/action_face.h"
#include "app/kit/dock_front.h"
#include "app/kit/form.h"
#include "app/kit/thread_pool_task.h"
#include "app/kit/top_menus.h"
#include "app/mannequin/figure_drag.h"
#include "app/mannequin/figure_drawings.h"
#include "app/mannequin/figure_skins.h"
#include "app/mannequin/hand_gizmo.h"
#include "app/mannequin/hands_to_part.h"
#include "app/mannequin/mannequin_context.h"
#include "app/mannequin/mannequin_edits.h"
#include "app/mannequin/mannequin_panel.h"
#include "app/mannequin/marker_panel.h"
#include "app/style/dock_title_bar.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

/// What of the window is the mannequin's; owned by the window.
class MannequinDocks : public QObject {
 public:
  explicit MannequinDocks(Host& host)
      : QObject(&host.window()), host_(host), context_(host), drag_(context_), gizmo_(context_, drag_), skins_(host) {
    panel_ = new MannequinPanel(context_, drag_);
    drawings_ = new FigureDrawings(context_);
    panel_->drawings().addWidget(drawings_);
    dock_ = makeDock("dockMannequin", tr("Mannequin"), scrolledPanel(panel_));
    host_.addDock(dock_, Qt::RightDockWidgetArea);
    dock_->hide();
    markers_ = makeDock("dockMarkers", tr("Recorded markers"), new MarkerPanel(context_));
    host_.addDock(markers_, Qt::BottomDockWidgetArea, host_.window().findChild<QDockWidget*>("dockCollisions"));
    markers_->hide();
    connect(panel_, &MannequinPanel::addWanted, this, [this] { add({}); });
    connect(&host.selection(), &Selection::changed, this, [this](workcell::EntityId entity) {
      const bool ours = context_.entity() && context_.entity()->id == entity;
      if (ours && !isStylusInUse(host_)) bringForSelection(dock_);
      gizmo_.setOn(ours);
    });
    addMenu();
    host_.viewport().setPointerTool(&gizmo_, ToolChain::kFigure);
    host_.viewport().installEventFilter(this);
    connect(&host_.documentModel(), &DocumentModel::closing, &gizmo_, &HandGizmo::cancel);
    const QTimer& timer = refreshTimer(host);
    connect(&timer, &QTimer::timeout, panel_, &MannequinPanel::showNow);
    connect(&timer, &QTimer::timeout, drawings_, &FigureDrawings::showNow);
    connect(&timer, &QTimer::timeout, this, [this] { skins_.look(); });
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool escape =
        event->type() == QEvent::KeyPress && static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Escape;
    return (escape && gizmo_.cancel()) || QObject::eventFilter(watched, event);
  }

 private:
  void addMenu() {
    QMenu* menu = topMenu(host_.window(), "menuMannequin", tr("Mannequin"));
    const auto entry = [&](const char* name, const QString& text, const QKeySequence& key, auto&& slot) {
      QAction* action = makeAction(&host_.window(), {name, text, {}, key, {}});
      host_.window().addAction(action);
      menu->addAction(action);
      connect(action, &QAction::triggered, this, slot);
    };
    entry("actionAddMannequin", tr("Add mannequin"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_M),
          [this] { add({}); });
    QMenu* sizes = menu->addMenu(tr("Add with size"));
    const std::pair<const char*, mannequin::BodyRequest> boundary[]{
        {QT_TR_NOOP("P5 woman"),
         {mannequin::Sex::kFemale, *mannequin::statureOfPercentile(mannequin::Sex::kFemale, 5)}},
        {QT_TR_NOOP("P50 woman"),
         {mannequin::Sex::kFemale, *mannequin::statureOfPercentile(mannequin::Sex::kFemale, 50)}},
        {QT_TR_NOOP("P50 man"), {mannequin::Sex::kMale, *mannequin::statureOfPercentile(mannequin::Sex::kMale, 50)}},
        {QT_TR_NOOP("P95 man"), {mannequin::Sex::kMale, *mannequin::statureOfPercentile(mannequin::Sex::kMale, 95)}}};
    for (const auto& [name, request] : boundary)
      sizes->addAction(tr(name), this, [this, request = request] { add(request); });
    new HandsToPart(context_, *menu, this);
    menu->addSeparator();
    entry("actionMannequinPanel", tr("Hands, size and posture"), {}, [this] {
      if (!tellsStylusInUse(host_)) bringToFront();
    });
    entry("actionOpenPosture", tr("Open a posture…"), {}, [this] { panel_->openPosture(); });
    entry("actionSavePosture", tr("Save this posture (JSON, H-Anim X3D, BVH)…"), {}, [this] { panel_->savePosture(); });
    entry("actionMarkers", tr("Recorded markers (C3D)…"), {}, [this] {
      app::bringToFront(markers_);
    });
  }

  void add(const mannequin::BodyRequest& request) {
    std::vector<std::string> taken;
    for (const auto& entity : host_.documentModel().document().state().entities) taken.push_back(entity->name);
    runInThreadPool(
        this, [request, place = freePlace(), taken] { return newMannequin(request, place, taken); },
        [this, number = host_.documentModel().number()](Expected<workcell::Entity> made) {
          if (number != host_.documentModel().number()) return;
          if (!made)
            return host_.messages().reportCause(Severity::kProblem, tr("No mannequin was added"), made.error());
          const std::string name = made->name;
          if (!host_.documentModel().execute(workcell::AddEntity{std::move(*made)})) return;
          if (const auto* entity = host_.documentModel().document().findByName(name)) {
            host_.selection().set(entity->id);
            if (!isStylusInUse(host_)) bringForSelection(dock_);
          }
        });
  }

  /// In front of the cell, looking at it; the middle of the floor where it is empty.
  Pose freePlace() const {
    const geometry::Bounds bounds = host_.viewport().scene().bounds_W();
    Pose place;
    if (bounds.isEmpty()) return place;
    constexpr double kAway = 0.55;
    place.p = {0.5 * (bounds.min.x + bounds.max.x), bounds.min.y - kAway, 0.0};
    place.q = dquat(std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5));  // Faces +Y.
    return place;
  }

  void bringToFront() {
    if (!isStylusInUse(host_)) app::bringToFront(dock_);
  }

  Host& host_;
  MannequinContext context_;
  FigureDrag drag_;
  HandGizmo gizmo_;
  FigureSkins skins_;
  MannequinPanel* panel_;
  FigureDrawings* drawings_;
  QDockWidget *dock_, *markers_;
};

}  // namespace

void addMannequinDocks(Host& host) {
  new MannequinDocks(host);
}

}  // namespace hapticell::app
