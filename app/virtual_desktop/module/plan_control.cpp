// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/plan_control.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/style/library_text.h"
#include "app/style/units.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"

namespace hapticell::app {

namespace {

/// Checks of one search: about 2 s on a core. Half: narrow passages are given up sooner; twice: a way from where the
/// hand was 4 s ago.
constexpr std::size_t kMostChecks = 100'000;

}  // namespace

PlanControl::PlanControl(VirtualDesktopController& owner)
    : owner_(owner), authority_(owner.host().configuration().manipulation.plan_authority) {}

PlanControl::~PlanControl() = default;

void PlanControl::setTarget(std::optional<Target> target) {
  const bool was_on = isOn();
  stop();
  target_ = std::move(target);
  if (was_on && target_) start();
}

void PlanControl::start() {
  if (!target_ || planner_) return;
  const config::Configuration& configuration = owner_.host().configuration();
  planning::LiveOptions options;
  options.goal = target_->goal;
  options.clearance = clearance_ = configuration.manipulation.plan_clearance;
  options.most_checks = kMostChecks;
  planner_ = std::make_shared<planning::LivePlanner>(std::move(options), configuration);
  post();
}

void PlanControl::stop() {
  if (!planner_) return;
  planner_.reset();
  post();
}

void PlanControl::setAuthority(double authority) {
  authority_ = std::isfinite(authority) ? std::clamp(authority, 0.0, 1.0) : 0.0;
  post();
}

void PlanControl::post() {
  if (!owner_.loop()) return;
  const workcell::EntityId held = owner_.snapshot().stylus.held;
  const bool rests = target_ && held != 0 && held != target_->entity;
  owner_.loop()->post(manipulation::command::SetPlan{rests ? nullptr : planner_, authority_});
}

QString PlanControl::sentence() const {
  const manipulation::SceneSnapshot& now = owner_.snapshot();
  PlanFacts facts;
  facts.on = isOn();
  facts.has_target = target_.has_value();
  facts.held = target_ && now.stylus.held == target_->entity;
  facts.forces_on = now.stylus.forces_on;
  facts.clearance = clearance_;
  facts.felt = now.plan;
  if (target_) {
    const workcell::Entity* entity = owner_.host().documentModel().document().find(target_->entity);
    facts.entity = entity ? QString::fromStdString(entity->name) : QString();
    facts.target = target_->name;
  }
  if (planner_) {
    const auto failure = planner_->figures().failure;
    if (failure) facts.failure = failure->reason;
  }
  return planSentence(facts);
}

QString planSentence(const PlanFacts& facts) {
  if (!facts.has_target) return QObject::tr("No goal yet. Choose where the entity should go.");
  if (!facts.on) return QObject::tr("%1 should go to: %2. Press Start planner.").arg(facts.entity, facts.target);
  if (!facts.held) return QObject::tr("Hold %1: the planner works while you hold it.").arg(facts.entity);
  if (facts.felt.reached) return QObject::tr("%1 is at the goal.").arg(facts.entity);
  if (facts.felt.insists) return QObject::tr("Following your hand: the planner looks for a way on from there.");
  if (facts.felt.way) {
    const QString found = QObject::tr("Way found, %1 clearance.").arg(lengthText(facts.clearance));
    return facts.forces_on ? found : found + QLatin1Char(' ') + QObject::tr("Turn forces on to feel it.");
  }
  if (facts.failure && !facts.failure->empty()) return QObject::tr("No way yet: %1.").arg(shownText(*facts.failure));
  return QObject::tr("The planner looks for a way.");
}

}  // namespace hapticell::app
