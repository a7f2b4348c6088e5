// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/training/training_play.h"

#include <algorithm>

#include "app/controls/robot_ghosts.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

// ms a picture, as kFollowMilliseconds of training_docks.cpp.
constexpr int kTrainingPlayMilliseconds = 33;
// s that the end stays to be looked at. Half: it is missed; twice: one waits.
constexpr double kRestAtEnd = 0.7;

}  // namespace

TrainingPlay::TrainingPlay(Host& host, QObject* parent) : QObject(parent), host_(host) {
  timer_.setInterval(kTrainingPlayMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &TrainingPlay::show);
  connect(&host_.documentModel(), &DocumentModel::closing, this, &TrainingPlay::stop);
  // What was shown may be gone, or stand elsewhere.
  connect(&host_.documentModel(), &DocumentModel::changed, this, &TrainingPlay::stop);
}

Expected<void> TrainingPlay::play(const trajectory::Trajectory& expert, const trajectory::Trajectory& run) {
  stop();
  const auto replayOf =
      [&](const trajectory::Trajectory& motion) -> Expected<std::unique_ptr<const manipulation::MotionReplay>> {
    auto replay = manipulation::MotionReplay::create(host_.documentModel().document().state().entities, expert.entity,
                                                     std::make_shared<const trajectory::Trajectory>(motion));
    HAPTICELL_TRY(replay);
    return std::make_unique<const manipulation::MotionReplay>(std::move(*replay));
  };
  auto theirs = replayOf(expert);
  HAPTICELL_TRY(theirs);
  std::unique_ptr<const manipulation::MotionReplay> mine;
  if (!run.empty()) {
    auto made = replayOf(run);
    HAPTICELL_TRY(made);
    mine = std::move(*made);
  }
  seconds_ = std::max(expert.duration(), run.empty() ? 0.0 : run.duration());
  expert_ = std::move(*theirs);
  run_ = std::move(mine);
  clock_.start();
  timer_.start();
  show();
  return {};
}

void TrainingPlay::stop() {
  if (!expert_) return;
  timer_.stop();
  expert_.reset();
  run_.reset();
  host_.viewport().scene().setPlayed({});
  host_.viewport().scene().setGhosts("expert", {});
  host_.viewport().refresh();
  emit ended();
}

void TrainingPlay::show() {
  const double t = 1e-9 * static_cast<double>(clock_.nsecsElapsed());
  if (t > seconds_ + kRestAtEnd) return stop();
  const auto posesOf = [&](const manipulation::MotionReplay& replay) {
    const auto at = replay.at(replay.motion()[0].t + t);
    return entityGhosts(host_.documentModel().document().state(), replay.entity(), at.X_WE, at.joints);
  };
  SceneModel& scene = host_.viewport().scene();
  scene.setPlayed(posesOf(run_ ? *run_ : *expert_));
  scene.setGhosts("expert", run_ ? posesOf(*expert_) : std::vector<GhostPose>{});
  host_.viewport().refresh();
}

}  // namespace hapticell::app
