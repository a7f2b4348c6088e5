// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/training/training_docks.h"

#include <QDockWidget>
#include <QScrollArea>
#include <QTimer>

#include "app/controls/robot_ghosts.h"
#include "app/guides/guide_curves.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/stylus_use.h"
#include "app/kit/dock_front.h"
#include "app/host/recording_hub.h"
#include "app/style/dock_title_bar.h"
#include "app/trajectory/training/training_panel.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

// ms a picture of the ghost, 30 a second. Half: twice the work; twice: it jerks.
constexpr int kFollowMilliseconds = 33;
constexpr int kTrainingWidth = 332;
// s of the expert's time that the ghost is ahead: a hand's reaction takes about 0.2. Half: it seems to follow the hand;
// twice: corners are cut towards it.
constexpr double kAhead = 0.3;

}  // namespace

TrainingDocks::TrainingDocks(Host& host, MotionList& list, QObject* parent) : QObject(parent), host_(host) {
  panel_ = new TrainingPanel(host_, list);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(kTrainingWidth);
  scroll->setWidget(panel_);
  dock_ = makeDock("dockTraining", tr("Training"), scroll);
  host_.addDock(dock_, Qt::RightDockWidgetArea);
  dock_->hide();
  connect(panel_, &TrainingPanel::cellWanted, this, &TrainingDocks::openCell);
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
    expert_ = nullptr;
    timer_.stop();
    panel_->forgetCell();
  });
  connect(panel_, &TrainingPanel::guideChanged, this, &TrainingDocks::showGuide);
  connect(panel_, &TrainingPanel::runStarted, this, [this](const trajectory::Trajectory& expert) {
    auto replay = manipulation::MotionReplay::create(host_.documentModel().document().state().entities, expert.entity,
                                                     std::make_shared<const trajectory::Trajectory>(expert));
    expert_ = replay ? std::make_shared<const manipulation::MotionReplay>(std::move(*replay)) : nullptr;
    timer_.start();
  });
  connect(panel_, &TrainingPanel::runEnded, this, [this] {
    timer_.stop();
    host_.viewport().scene().setGhosts("expert", {});
    host_.viewport().refresh();
  });
  timer_.setInterval(kFollowMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &TrainingDocks::follow);
}

void TrainingDocks::open() {
  if (!tellsStylusInUse(host_)) bringToFront(dock_);
}

void TrainingDocks::openCell(const QString& path) {
  if (QString::fromStdString(host_.documentModel().origin().string()) == path) return panel_->cellCame();
  if (host_.documentModel().isDirty()) {
    panel_->cellCame(tr("Save this cell first, then choose the exercise again."));
    return;
  }
  // What is opened brings its own panel to the front; who trains goes on here.
  host_.openCell(path, this, [this] {
    panel_->cellCame();
    QTimer::singleShot(0, this, &TrainingDocks::open);
  });
}

void TrainingDocks::showGuide(const std::optional<workcell::Guide>& guide) {
  host_.recording().setGuide(guide);
  std::vector<SceneCurve> curves;
  if (guide && guide->enabled) curves = guideCurves(*guide, guide->path.front(), false);
  host_.viewport().setCurves("training", std::move(curves));
}

void TrainingDocks::follow() {
  if (!expert_) return;
  const SceneModel& scene = host_.viewport().scene();
  const workcell::Entity* entity = scene.find(expert_->entity());
  if (!entity) return;
  panel_->follow(expert_->movedFrame({scene.placement_W(*entity), scene.joints(*entity)}));
  if (!panel_->isLed()) return;
  const auto at = expert_->at(expert_->motion()[0].t + panel_->expertTime() + kAhead);
  host_.viewport().scene().setGhosts(
      "expert", entityGhosts(host_.documentModel().document().state(), expert_->entity(), at.X_WE, at.joints));
}

}  // namespace hapticell::app
