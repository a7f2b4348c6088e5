// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/motions/window_recorder.h"

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/recording_hub.h"
#include "app/host/selection.h"

namespace hapticell::app {
namespace {

// ms, 100 Hz: ten times what a hand's tremor has. Half: twice the frames; twice: five frames a period of tremor are
// left to smooth by.
constexpr int kPeriod = 10;

bool stands(const workcell::Entity& entity, const std::pair<Pose, std::vector<double>>& at) {
  return entity.joints() == at.second && entity.X_WE.p == at.first.p && entity.X_WE.q == at.first.q;
}

/// What the hand would draw: a robot's tool centre point, everything else as a whole.
Pose movedFrame(const workcell::Entity& entity, const Pose& X_WE, const std::vector<double>& joints) {
  if (!workcell::isMachine(entity)) return X_WE;
  int tip = entity.robot()->findLink(entity.jointed().tip_link);
  if (tip < 0) tip = entity.robot()->defaultTip();
  if (tip < 0) return X_WE;
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*entity.robot(), joints, X_BL);
  return X_WE * X_BL[static_cast<std::size_t>(tip)] * entity.jointed().X_LT;
}

}  // namespace

WindowRecorder::WindowRecorder(Host& host, QObject* parent) : QObject(parent), host_(host) {
  timer_.setInterval(kPeriod);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &WindowRecorder::look);
  RecordingHub& hub = host_.recording();
  connect(&hub, &RecordingHub::startWanted, this, [this, &hub](const auto& wanted) {
    if (!hub.isLive()) start(wanted);
  });
  connect(&hub, &RecordingHub::stopWanted, this, &WindowRecorder::stop);
  connect(&hub, &RecordingHub::markWanted, this, &WindowRecorder::mark);
}

WindowRecorder::~WindowRecorder() = default;

double WindowRecorder::seconds() const {
  return recorder_ ? 1e-9 * static_cast<double>(clock_.nsecsElapsed()) : 0.0;
}

void WindowRecorder::start(const manipulation::command::StartRecording& wanted) {
  recorder_ = std::make_unique<manipulation::TakeRecorder>(wanted.options, wanted.take);
  start_.clear();
  moves_.clear();
  for (const auto& entity : host_.documentModel().document().state().entities)
    start_[entity->id] = {entity->X_WE, entity->joints()};
  clock_.start();
  timer_.start();
}

void WindowRecorder::stop() {
  if (!recorder_) return;
  look();
  timer_.stop();
  const auto recorded = recorder_->finish();
  recorder_.reset();
  host_.recording().deliver(recorded);
}

void WindowRecorder::mark() {
  if (!recorder_) return;
  if (const auto* entity = host_.documentModel().document().find(host_.selection().current()))
    add(*entity, seconds(), true);
}

void WindowRecorder::look() {
  const double t = seconds();  // One for all that moves: their frames are of the same moment.
  for (const auto& entity : host_.documentModel().document().state().entities) {
    // What hangs on something goes with it and needs no motion of its own.
    if (!entity->attachment.to.empty()) continue;
    const auto before = start_.find(entity->id);
    if (before == start_.end()) {
      start_[entity->id] = {entity->X_WE, entity->joints()};
      continue;
    }
    bool& moves = moves_[entity->id];
    if (!moves && stands(*entity, before->second)) continue;
    if (!moves) {
      // Its first place is where it stood.
      workcell::Entity first = *entity;
      first.X_WE = before->second.first;
      first.setJoints(before->second.second);
      moves = true;
      add(first, t, false);
      continue;
    }
    add(*entity, t, false);
  }
}

void WindowRecorder::add(const workcell::Entity& entity, double t, bool by_hand) {
  manipulation::TakeRecorder::Sample sample;
  sample.t = t;
  sample.entity = &entity;
  const manipulation::EntityConfiguration at{entity.X_WE, entity.joints()};
  sample.at = &at;
  sample.X_WM = movedFrame(entity, entity.X_WE, entity.joints());
  by_hand ? recorder_->mark(sample) : recorder_->add(sample);
}

}  // namespace hapticell::app
