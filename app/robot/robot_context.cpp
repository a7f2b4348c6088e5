// SPDX-License-Identifier: Apache-2.0
#include "app/robot/robot_context.h"

#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/controls/joint_row.h"
#include "app/controls/pose_text.h"
#include "app/viewport/widget/viewport_widget.h"
#include "kinematics/closed_form/inverse_factory.h"

namespace hapticell::app {
namespace {

bool isJointed(const workcell::Entity* entity) {
  return entity && workcell::isMachine(*entity);
}

bool samePose(const Pose& a, const Pose& b) {
  return a.p == b.p && a.q == b.q;
}

bool sameTools(const workcell::Entity& a, const workcell::Entity& b) {
  return a.jointed().tool == b.jointed().tool && a.jointed().tip_link == b.jointed().tip_link &&
         samePose(a.jointed().X_LT, b.jointed().X_LT) &&
         std::equal(a.jointed().tools.begin(), a.jointed().tools.end(), b.jointed().tools.begin(),
                    b.jointed().tools.end(), [](const auto& x, const auto& y) {
                      return x.name == y.name && x.tip_link == y.tip_link && samePose(x.X_LT, y.X_LT);
                    });
}

}  // namespace

RobotContext::RobotContext(Host& host, QObject* parent) : QObject(parent), host_(host) {
  connect(&host_.selection(), &Selection::changed, this, &RobotContext::follow);
  connect(&host_.documentModel(), &DocumentModel::changed, this, [this] {
    follow();
    emit documentChanged();
  });
  follow();
}

void RobotContext::follow() {
  const workcell::Document& document = host_.documentModel().document();
  if (isJointed(document.find(host_.selection().current()))) robot_ = host_.selection().current();
  if (!isJointed(document.find(robot_))) robot_ = 0;
  lookAgain();
}

void RobotContext::lookAgain() {
  const workcell::Entity* now = robot();
  const bool same = now && seen_ && now->id == seen_->id && now->robot() == seen_->robot() &&
                    now->name == seen_->name && now->locked == seen_->locked && sameTools(*now, *seen_);
  if (same || (!now && !seen_)) return;
  seen_ = now ? std::make_shared<const workcell::Entity>(*now) : nullptr;
  inverse_.reset();
  inverse_made_ = false;
  emit robotChanged();
}

const workcell::Entity* RobotContext::robot() const {
  return robot_ ? host_.documentModel().document().find(robot_) : nullptr;
}

bool RobotContext::isMechanism() const {
  return robot() && robot()->kind() == workcell::EntityKind::kMechanism;
}

std::vector<double> RobotContext::joints() const {
  return robot() ? host_.viewport().scene().joints(*robot()) : std::vector<double>{};
}

Pose RobotContext::base_W() const {
  return robot() ? host_.viewport().scene().placement_W(*robot()) : Pose::identity();
}

Pose RobotContext::tool_W() const {
  return robot() ? tcpPose_W(*robot(), base_W(), joints()) : Pose::identity();
}

bool RobotContext::isHeld() const {
  return robot() && host_.snapshot() && host_.snapshot()->stylus.held == robot_;
}

bool RobotContext::isFree() const {
  return robot() && !robot()->locked && !isHeld();
}

const kinematics::InverseModel* RobotContext::inverse() const {
  const workcell::Entity* now = robot();
  if (!now || isMechanism()) return nullptr;
  if (!inverse_made_) {
    inverse_made_ = true;
    auto made =
        kinematics::createInverse(*now->robot(), now->robot()->findLink(now->jointed().tip_link), now->jointed().X_LT);
    if (made) inverse_ = std::move(*made);
  }
  return inverse_.get();
}

QString RobotContext::jointName(std::size_t variable) const {
  const workcell::Entity* now = robot();
  if (!now || variable >= now->robot()->dof()) return {};
  return scaleOf(now->robot()->joints[static_cast<std::size_t>(now->robot()->moving[variable])], variable).name;
}

}  // namespace hapticell::app
