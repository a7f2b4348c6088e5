// SPDX-License-Identifier: Apache-2.0
#include "app/robot/robot_stop.h"

#include "app/host/host.h"
#include "app/robot/robot_context.h"
#include "app/robot/stop_line.h"
#include "app/style/library_text.h"
#include "kinematics/model/jog.h"

namespace hapticell::app {
namespace {

// 2 degrees, 35 mm of a slide: so near to its limit a joint is named. Our choice. Half: said when it is there; twice:
// said where there is way left.
constexpr double kSoonLimit = 0.0349065850398866;

}  // namespace

RobotStop::RobotStop(RobotContext& context, QObject* parent)
    : QObject(parent), context_(context), line_(new StopLine) {}

void RobotStop::setStopped(const QString& why, const QString& obstacle) {
  stopped_ = why;
  obstacle_ = obstacle;
}

void RobotStop::forget() {
  stopped_.clear();
  obstacle_.clear();
  held_back_.clear();
}

void RobotStop::show() {
  const workcell::Entity* robot = context_.robot();
  if (!robot) return;
  const auto& snapshot = context_.host().snapshot();
  if (context_.isHeld() && snapshot && !snapshot->limits.empty()) {
    const manipulation::LimitState& limit = snapshot->limits.front();
    const bool pushes = limit.holds && snapshot->stylus.forces_on;
    return line_->show(Mark::kLimit, shownText(limit.text) +
                                         (pushes ? QObject::tr(" and pushes back on the stylus.") : QObject::tr(".")));
  }
  if (context_.isHeld() && snapshot && !snapshot->pairs.empty() && snapshot->pairs.front().contact)
    return line_->show(Mark::kContact, shownText(snapshot->status));
  if (!context_.isHeld() && !stopped_.isEmpty())
    return line_->show(obstacle_.isEmpty() ? Mark::kLimit : Mark::kContact, stopped_);
  if (!context_.isHeld() && !held_back_.isEmpty()) return line_->show(Mark::kLimit, held_back_ + QLatin1Char('.'));
  const Text near = kinematics::nearestLimitText(*robot->robot(), context_.joints(), kSoonLimit);
  line_->show(near.empty() ? Mark::kNone : Mark::kLimit, near.empty() ? QString() : shownText(near) + QLatin1Char('.'));
}

}  // namespace hapticell::app
