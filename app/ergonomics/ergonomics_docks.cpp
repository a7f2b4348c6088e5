// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/ergonomics_docks.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QTimer>

#include "app/ergonomics/ergonomics_panel.h"
#include "app/ergonomics/live_scores.h"
#include "app/ergonomics/motion_scores_model.h"
#include "app/ergonomics/report_panel.h"
#include "app/ergonomics/scene_marks.h"
#include "app/ergonomics/score_painting.h"
#include "app/ergonomics/time_panel.h"
#include "app/ergonomics/work_task_panel.h"
#include "app/ergonomics/workplace_panel.h"
#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/stylus_use.h"
#include "app/kit/dock_front.h"
#include "app/kit/action_face.h"
#include "app/kit/form.h"
#include "app/kit/top_menus.h"
#include "app/mannequin/mannequin_context.h"
#include "app/style/dock_title_bar.h"
#include "app/viewport/widget/viewport_widget.h"
#include "mannequin/shape/body_shape.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::app {
namespace {

// ms between two looks: 30 times a second moves smoothly; five times where nothing is seen. Half: twice the work;
// twice: strips jerk.
constexpr int kFrameMilliseconds = 33, kUnseenMilliseconds = 200;

/// What of the window is the ergonomics'; owned by the window.
class ErgonomicsDocks : public QObject {
 public:
  explicit ErgonomicsDocks(Host& host) : QObject(&host.window()), host_(host), context_(host), scores_(context_) {
    panel_ = new ErgonomicsPanel(context_, scores_);
    dock_ = addDock("dockErgonomics", tr("Ergonomics"), scrolledPanel(panel_, 420), Qt::RightDockWidgetArea);
    task_ = addDock("dockWorkTask", tr("Task data"), scrolledPanel(new WorkTaskPanel(context_), 332),
                    Qt::RightDockWidgetArea);
    report_panel_ = new ReportPanel(context_, scores_, motion_);
    report_ = addDock("dockReport", tr("Report"), report_panel_, Qt::RightDockWidgetArea);
    time_ = addDock("dockErgonomicsTime", tr("Ergonomics over time"), new TimePanel(context_, scores_, motion_),
                    Qt::BottomDockWidgetArea);
    auto* search = new WorkplacePanel(context_, scores_);
    workplace_ = addDock("dockWorkplace", tr("Workplace search"), scrolledPanel(search, 332), Qt::RightDockWidgetArea);
    for (QDockWidget* dock : {dock_, task_, report_, workplace_}) markAsTask(dock);
    connect(search, &WorkplacePanel::findingChanged, this,
            [this, search] { report_panel_->setWorkplace(search->finding()); });
    connect(panel_, &ErgonomicsPanel::taskWanted, this, [this] { bringToFront(task_); });
    connect(panel_, &ErgonomicsPanel::reportWanted, this, [this] { bringToFront(report_); });
    connect(panel_, &ErgonomicsPanel::searchWanted, this, [this] { bringToFront(workplace_); });
    connect(panel_, &ErgonomicsPanel::addWanted, this, [this] {
      if (auto* add = host_.window().findChild<QAction*>("actionAddMannequin")) add->trigger();
    });
    connect(panel_, &ErgonomicsPanel::methodChanged, this, [this] {
      colour();
      showMarks();
    });
    connect(panel_, &ErgonomicsPanel::bodyChosen, this, &ErgonomicsDocks::showBodies);
    connect(&scores_, &LiveScores::changed, this, &ErgonomicsDocks::showAll);
    connect(&scores_, &LiveScores::changed, this, [this] { motion_.follow(scores_.figure(), scores_.task()); });
    connect(&host_.holdChoice(), &HoldChoice::changed, this, &ErgonomicsDocks::showMarks);
    connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
      motion_.clear();
      scores_.clear();
      last_ = 0;
    });
    addMenu();
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, this, [this, timer] {
      const int wanted = look() ? kFrameMilliseconds : kUnseenMilliseconds;
      if (timer->interval() != wanted) timer->setInterval(wanted);
    });
    timer->start(kFrameMilliseconds);
  }

 private:
  QDockWidget* addDock(const char* name, const QString& title, QWidget* content, Qt::DockWidgetArea area) {
    QDockWidget* dock = makeDock(QLatin1String(name), title, content);
    auto* onto = area == Qt::BottomDockWidgetArea ? host_.window().findChild<QDockWidget*>("dockCollisions") : nullptr;
    host_.addDock(dock, area, onto);
    dock->hide();
    // Never the words for an empty cell until the timer comes round.
    connect(
        dock, &QDockWidget::visibilityChanged, this, [this] { look(); }, Qt::QueuedConnection);
    return dock;
  }

  void addMenu() {
    QMenu* menu = topMenu(host_.window(), "menuMannequin", QObject::tr("Mannequin"));
    menu->addSeparator();
    const auto entry = [&](const char* name, const QString& text, QDockWidget* dock) {
      QAction* action = makeAction(&host_.window(), {name, text, {}, {}, {}});
      host_.window().addAction(action);
      menu->addAction(action);
      connect(action, &QAction::triggered, this, [this, dock] { bringToFront(dock); });
    };
    entry("actionErgonomics", tr("Ergonomics, live"), dock_);
    QAction* open =
        makeAction(&host_.window(), {"actionOpenMotion", tr("Open a recorded motion (BVH, AMC, C3D)…"), {}, {}, {}});
    host_.window().addAction(open);
    menu->addAction(open);
    connect(open, &QAction::triggered, this, [this] {
      bringToFront(time_);
      if (auto* panel = time_->findChild<TimePanel*>()) panel->choose();
    });
    entry("actionErgonomicsTime", tr("Ergonomics over time"), time_);
    entry("actionWorkTask", tr("Task data…"), task_);
    entry("actionErgonomicsReport", tr("Ergonomics report…"), report_);
    entry("actionWorkplace", tr("Workplace search…"), workplace_);
  }

  bool isWanted() const { return isSeen(*panel_) || isSeen(*report_panel_) || isSeen(*task_->widget()); }

  /// Whether anything of it is seen.
  bool look() {
    const bool wanted = isWanted() || isSeen(*time_->widget()) || isSeen(*workplace_->widget());
    if (wanted) scores_.look();
    if (isWanted() != coloured_) {
      coloured_ = !coloured_;
      showAll();
    }
    return wanted;
  }

  void showAll() {
    colour();
    showBodies();
    showMarks();
  }

  void showMarks() {
    SceneMarks marks;
    if (coloured_) marks = sceneMarks(scores_, context_, panel_->labelledMethod());
    ViewportWidget& viewport = host_.viewport();
    viewport.setLabels("ergonomics", std::move(marks.labels));
    viewport.setCurves("ergonomics", std::move(marks.curves));
    viewport.setFigureStrip(std::move(marks.strip));
  }

  void colour() {
    const workcell::Entity* entity = context_.entity();
    SceneModel& scene = host_.viewport().scene();
    if (last_ != 0 && (!entity || entity->id != last_)) scene.setLinkLooks(last_, {});
    last_ = entity ? entity->id : 0;
    if (!entity || scores_.isEmpty()) return;
    std::map<int, LinkLook> looks;
    if (coloured_) {
      const Theme& theme = themeOf(panel_->palette());
      const auto bands = ergonomics::segmentBands(scores_.scores(), panel_->method());
      for (int link = 0; link < static_cast<int>(entity->robot()->links.size()); ++link) {
        int body = mannequin::bodyOfLink(*entity->robot(), link);
        if (body < 0) continue;
        auto segment = static_cast<std::size_t>(body);
        while (segment >= mannequin::kSegmentCount) segment = mannequin::parentBody(segment);
        looks[link] = lookOf(bands[segment], theme);
      }
    }
    scene.setLinkLooks(last_, std::move(looks));
    host_.viewport().refresh();
  }

  /// The chosen bodies of other sizes as ghosts at the same task.
  void showBodies() {
    std::vector<RenderItem> items;
    const int chosen = panel_->chosenBody();
    for (int body = 0; coloured_ && body < static_cast<int>(scores_.bodies().size()); ++body) {
      const bool other = panel_->showsAllBodies() && body != scores_.ownBody();
      if (body == chosen || other) addGhost(body, items);
    }
    host_.viewport().scene().setExtras("bodies", std::move(items));
    host_.viewport().refresh();
  }

  void addGhost(int body, std::vector<RenderItem>& items) {
    const auto& at = scores_.bodies()[static_cast<std::size_t>(body)];
    auto& model = models_[body];
    if (!model) model = mannequin::figureModel(at.figure);
    const auto stands = mannequin::toModel(at.figure, at.posture);
    std::vector<Pose> X_EL;
    kinematics::forwardKinematics(*model, stands.joints, X_EL);
    for (std::size_t i = 0; i < model->links.size(); ++i) {
      for (const auto& shape : model->links[i].visuals) {
        RenderItem item;
        item.mesh = shape.mesh;
        item.X_WM = stands.X_WE * X_EL[i] * shape.X_LS;
        item.ghost = at.is_reached ? Ghost::kFree : Ghost::kTouches;
        items.push_back(std::move(item));
      }
    }
  }

  void bringToFront(QDockWidget* dock) {
    if (!tellsStylusInUse(host_)) app::bringToFront(dock);
  }

  Host& host_;
  MannequinContext context_;
  LiveScores scores_;
  MotionScoresModel motion_;
  ErgonomicsPanel* panel_;
  ReportPanel* report_panel_;
  QDockWidget *dock_, *task_, *report_, *time_, *workplace_;
  std::map<int, std::shared_ptr<const kinematics::RobotModel>> models_;
  workcell::EntityId last_ = 0;
  bool coloured_ = false;
};

}  // namespace

void addErgonomicsDocks(Host& host) {
  new ErgonomicsDocks(host);
}

}  // namespace hapticell::app
