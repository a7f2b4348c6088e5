// SPDX-License-Identifier: Apache-2.0
#include "app/robot/joint_mover.h"

#include <algorithm>

#include "app/controls/robot_ghosts.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/robot/motion_worker.h"
#include "app/robot/robot_context.h"
#include "app/style/library_text.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

// ms a picture, that of a screen at 60 Hz. Half: pictures that nobody sees; twice: it moves less smoothly.
constexpr int kFrameMilliseconds = 16;
// Seconds that a played motion takes, between seen and tedious; the robot's own time between. Half: jumps; twice: one
// waits.
constexpr double kShortest = 0.25, kLongest = 1.0;

}  // namespace

JointMover::JointMover(RobotContext& context, MotionWorker& worker, QObject* parent)
    : QObject(parent), context_(context), worker_(worker) {
  playing_.setInterval(kFrameMilliseconds);
  playing_.setTimerType(Qt::PreciseTimer);
  connect(&playing_, &QTimer::timeout, this, &JointMover::playFrame);
  connect(&context_.host().documentModel(), &DocumentModel::closing, this, &JointMover::forgetCell);
}

JointMover::~JointMover() = default;

void JointMover::begin(const QString& text) {
  if (!context_.isFree()) return;
  if (playing_.isActive()) finishTravel();
  if (open_) {
    // The step before still waits for its check: it ends here.
    context_.host().documentModel().endStep();
    pending_.reset();
  }
  robot_ = context_.robot()->id;
  open_ = true;
  ending_ = false;
  context_.host().documentModel().beginStep(text);
}

void JointMover::moveTo(const std::vector<double>& joints) {
  if (!open_) return;
  pending_ = target_ = joints;
  pump();
}

std::vector<double> JointMover::target() const {
  if (checking_ && open_) return target_;
  return context_.robot() ? context_.robot()->joints() : std::vector<double>{};
}

void JointMover::end(bool keep) {
  if (!open_) return;
  ending_ = true;
  keep_ = keep;
  if (!keep) pending_.reset();
  pump();
}

void JointMover::step(const QString& text, const std::vector<double>& joints) {
  begin(text);
  moveTo(joints);
  end();
}

void JointMover::pump() {
  if (checking_) return;
  if (pending_) {
    checking_ = true;
    const std::vector<double> target = *pending_;
    pending_.reset();
    worker_.checkMotion(robot_, target, [this](const auto& motion) {
      checking_ = false;
      accept(motion);
      pump();
    });
    return;
  }
  if (!open_ || !ending_) return;
  open_ = ending_ = false;
  DocumentModel& document = context_.host().documentModel();
  keep_ ? document.endStep() : document.cancelStep();
}

void JointMover::accept(const Expected<manipulation::JointMotion>& motion) {
  if (!open_) return;
  if (motion && !pending_) target_ = motion->joints;
  if (!motion) {
    emit stopped(shownText(motion.error()), {});
    return;
  }
  const workcell::Entity* robot = context_.host().documentModel().document().find(robot_);
  if (robot && robot->joints() != motion->joints && !(ending_ && !keep_))
    context_.host().documentModel().execute(motion->command);
  emit stopped(shownText(motion->reason), QString::fromStdString(motion->obstacle));
}

void JointMover::travel(const QString& text, const std::vector<double>& joints) {
  if (!context_.isFree() || open_) return;
  if (playing_.isActive()) finishTravel();
  robot_ = context_.robot()->id;
  checking_ = true;
  worker_.checkMotion(robot_, joints, [this, text](const Expected<manipulation::JointMotion>& motion) {
    checking_ = false;
    if (robot_ == 0) return;  // Its cell is closed.
    if (!motion) return emit stopped(shownText(motion.error()), {});
    if (!motion->complete) return emit stopped(shownText(motion->reason), QString::fromStdString(motion->obstacle));
    travel_.text = text;
    play(*motion);
  });
}

void JointMover::play(const manipulation::JointMotion& motion) {
  const workcell::Entity* robot = context_.host().documentModel().document().find(robot_);
  if (!robot) return;
  travel_.from = robot->joints();
  travel_.motion = motion;
  travel_.seconds = std::clamp(motion.time_s, kShortest, kLongest);
  clock_.start();
  const auto& snapshot = context_.host().snapshot();
  if (!context_.host().configuration().gui.motion || (snapshot && snapshot->stylus.held != 0)) return finishTravel();
  playing_.start();
}

void JointMover::playFrame() {
  const double s = static_cast<double>(clock_.elapsed()) / 1000.0 / travel_.seconds;
  if (s >= 1.0) return finishTravel();
  ViewportWidget& viewport = context_.host().viewport();
  viewport.scene().setPlayed(robotGhosts(context_.host().documentModel().document().state(), robot_,
                                         jointsBetween(travel_.from, travel_.motion.joints, eased(s))));
  viewport.refresh();
}

void JointMover::forgetCell() {
  playing_.stop();
  open_ = ending_ = false;
  pending_.reset();
  robot_ = 0;
}

void JointMover::finishTravel() {
  playing_.stop();
  ViewportWidget& viewport = context_.host().viewport();
  viewport.scene().setPlayed({});
  DocumentModel& document = context_.host().documentModel();
  document.beginStep(travel_.text);
  document.execute(travel_.motion.command);
  document.endStep();
  viewport.refresh();
  emit stopped({}, {});
}

}  // namespace hapticell::app
