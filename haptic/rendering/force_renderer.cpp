// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/force_renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "haptic/rendering/proxy_metric.h"

namespace hapticell::haptic {

namespace {

constexpr double kNominalTick = 0.001;  // s.
/// m the proxy may outrun the stylus in a tick (docs/dev/feel.md, 5). Half and twice pass the tests of this folder.
constexpr double kJumpAllowance = 0.01e-3;
/// The zone's edge is no thing to strike (docs/dev/feel.md, 7). N: half and twice fail
/// ProxyMover.HoldsTheProxyInTheZoneWithLittleForce.
constexpr double kTrustForce = 0.8;
/// Of the stiffness. Half passes, twice fails ForceRenderer.MeetsTheEdgeOfAZoneWithoutAStep.
constexpr double kTrustShare = 0.3;
constexpr double kStiff = 1000.0;  // N/m, above which a spring trembles. Half and twice pass the tests of this folder.
/// J within a second: then nothing unpaid up to kStiff (docs/dev/feel.md, 7: a gear's teeth had made 0.56 mJ). Half
/// fails ForceRendererEnergy.IsTrueAgainAfterTheHandLiftedByWhatWasHeldBack, twice passes the tests of this folder.
constexpr double kMostMade = 0.36e-3;

bool isFiniteStep(const ProxyStep& step) {
  return step.X_DP.isValid() &&
         std::isfinite(length(step.trust_D) + length(step.lag_D) + glm::length(step.v_DO) + step.outrun);
}

}  // namespace

void ForceRenderer::setOptions(const RendererOptions& options) {
  options_ = limitedByDelay(options);
  const bool turning = options_.peak_torque > 0.0;
  mover_.setTurning(turning);
  spring_.motors().setPeaks(options_.peak_force, options_.peak_torque, turning);
  passivity_.setDelay(static_cast<int>(std::lround(options_.delay / options_.tick)));
  if (contact_) return;
  gains_.take(options_);
  spring_.setStiffness(gains_.stiffness());
}

void ForceRenderer::noteApplied(const dvec3& force_D, const dvec3& torque_D) {
  const double wanted = glm::length(spring_.last().wanted.linear + load_D_);
  const double share = wanted > 0.0 ? std::min(1.0, glm::length(force_D) / wanted) : 1.0;
  spring_.noteApplied({force_D - share * load_D_, torque_D / kRotationLever});
}

void ForceRenderer::reset(const Pose& X_DS) {
  contact_ = late_ = jumped_ = false;
  sets_.reset();
  load_.reset();
  pulls_.reset();
  pulls_inside_ = false;
  load_D_ = dvec3(0.0);
  started_ = X_DS.isValid();
  if (started_) proxy_ = stylus_ = X_DS;
  held_by_ = {};
  trust_D_ = {};
  velocities_.reset();
  gains_.reset(options_);
  rest_.reset();
  spring_.setStiffness(gains_.stiffness());
  spring_.reset();
  passivity_.reset();
}

Adoption ForceRenderer::adopt(const ConstraintSet& set, double age) {
  return isWellFormed(set) ? offer(set, age) : Adoption::kMalformed;
}

Adoption ForceRenderer::adopt(const GroupedSet& set, double age) {
  return set.well_formed ? offer(set, age) : Adoption::kMalformed;
}

template <typename Set>
Adoption ForceRenderer::offer(const Set& set, double age) {
  if (sets_.isOutdated(set.sequence)) return Adoption::kOutdated;
  if (started_ && lengthOf(metricDifference(proxy_, set.X_DR)) >= kTrustedShare * set.zone_radius)
    return Adoption::kOutsideZone;
  sets_.offer(set, age);
  return Adoption::kAdopted;
}

/// A proxy that comes after the stylus from far off may brush rows that are not in its way when it is there.
bool ForceRenderer::isLate(const ProxyStep& solved) const {
  return length(solved.lag_D) > 0.0 && (!contact_ || late_);
}

/// From the stylus to the proxy, m. A proxy that is only late pulls at nobody.
MetricVector ForceRenderer::stretchOf(const ProxyStep& solved, const Pose& X_DS) const {
  const MetricVector trusted_D = limited(kTrustShare * solved.trust_D, kTrustForce / gains_.stiffness());
  if (isLate(solved)) return trusted_D;
  return mover_.way(solved.X_DP, X_DS) + solved.lag_D + trusted_D - solved.trust_D;
}

ProxyStep ForceRenderer::changeSet(const Pose& X_DS, double dt, SetJump& jump) {
  ProxyStep solved = mover_.move(sets_.next(), proxy_, X_DS, dt);
  if (sets_.holds()) {
    const ProxyStep before = mover_.move(sets_.current(), proxy_, X_DS, dt, held_by_);
    const MetricVector stretch_before = stretchOf(before, X_DS), stretch_after = stretchOf(solved, X_DS);
    spring_.changeStretch(stretch_before, stretch_after);
    jump = {mover_.way(solved.X_DP, before.X_DP), stretch_after - stretch_before, solved.trust_D - before.trust_D};
  }
  sets_.change();
  return solved;
}

/// After a jump of the stylus: returns the proxy's step, which is zero.
MetricVector ForceRenderer::restartStretch(const ProxyStep& solved, const MetricVector& stretch_D) {
  trust_D_ = solved.trust_D;
  spring_.restartStretch(stretch_D, solved.contact);
  return {};
}

/// Moves what the stretch grew by more than the stylus moved (another facet, a step of the surface) into the offset, so
/// that the force goes on from where it was. It is the stretch that counts: of a proxy that catches up from the zone's
/// edge only a capped part was felt. Returns the proxy's step without the jump.
MetricVector ForceRenderer::takeOutJump(const ProxyStep& solved, const MetricVector& stretch_D, const SetJump& jump,
                                        const MetricVector& stylus_step, double dt) {
  // The zone's edge is no thing that could be struck: what it holds back counts as gone, so that nothing damps it.
  const MetricVector held_back = solved.trust_D - trust_D_ - jump.trust_D;
  const MetricVector proxy_step = mover_.way(solved.X_DP, proxy_) - jump.proxy_D - held_back;
  trust_D_ = solved.trust_D;
  const MetricVector growth = spring_.stretchTo(stretch_D, jump.stretch_D, stylus_step);
  const MetricVector carried{dt * solved.v_DO, dvec3(0.0)};
  // Of a proxy that arrives at last nothing is the stylus's doing.
  const double own = late_ ? 0.0 : solved.outrun * length(stylus_step - carried);
  const double allowed = own + length(carried) + kJumpAllowance;
  if ((contact_ || late_) && solved.contact) spring_.absorb(growth - limited(growth, allowed));
  return limited(proxy_step, allowed);
}

/// Of the set in use, as far as the stylus is inside its zone; without a step where sets change. `rest_step_D`: of the
/// rest of the force.
dvec3 ForceRenderer::pullOf(const Pose& X_DS, bool changed, double dt, const dvec3& rest_step_D) {
  bool inside = false;
  dvec3 pull_D(0.0);
  if (sets_.holds()) {
    const GroupedSet& grouped = sets_.current();
    inside = lengthOf(metricDifference(X_DS, grouped.X_DR)) < grouped.zone_radius;
    if (inside) pull_D = grouped.pullAt(X_DS);
  }
  const bool crossed = std::exchange(pulls_inside_, inside) != inside;
  return pulls_.tick(pull_D, changed || crossed, dt, rest_step_D);
}

MetricVector ForceRenderer::couplingForce(const ProxyStep& solved) const {
  const MetricVector& spring_D = spring_.last().spring;
  const double pull = length(spring_D);
  if (pull <= 0.0) return {};
  // The coupling damps the stylus against the proxy; the controller damps the stylus itself, since on a convex surface
  // the proxy outruns the stylus and more of the coupling's damping would make energy instead of taking it.
  // Without a contact the proxy only catches up with the stylus: no motion to damp.
  const double damping = gains_.damping();
  const MetricVector outward = (1.0 / pull) * spring_D;
  const MetricVector v_rel = velocities_.stylus_D() - velocities_.proxy_D();
  MetricVector controlled =
      -passivity_.damping() * (velocities_.slowStylus_D() - MetricVector{solved.v_DO, dvec3(0.0)});
  // It takes on the way out; on the way in it would only press harder and so hold more.
  controlled -= std::max(0.0, dot(controlled, outward)) * outward;
  // Like friction it ends with what presses, not with a step.
  controlled = limited(controlled, pull);
  MetricVector damper = controlled - damping * v_rel;
  damper -= std::min(0.0, pull + dot(damper, outward)) * outward;
  return spring_D + spring_.withoutPull(damper);
}

void ForceRenderer::updateSpring(const ProxyStep& solved, const MetricVector& stylus_step, double dt) {
  spring_.decayOffset(solved.contact, stylus_step, dt);
  gains_.approach(solved, options_, contact_, dt);
  spring_.setStiffness(gains_.stiffness());
  // What moves the obstacle pays as well as the hand does.
  const MetricVector relative_step = stylus_step - MetricVector{dt * solved.v_DO, dvec3(0.0)};
  passivity_.add(relative_step, spring_.last().applied, spring_.last().stiffness);
  passivity_.step(solved.contact, dt);
  const double room = kMostMade - passivity_.recentLoss();
  passivity_.prepay(spring_.creepBack(rest_.rests(mover_, stylus_, dt), solved.contact, dt));
  // A stiff spring trembles, and what that makes is its own.
  spring_.update(solved.active_rows > 0, options_.stiffness > kStiff ? kMostMade : std::max(0.0, room), relative_step,
                 dt);
}

RenderResult ForceRenderer::tick(const Pose& X_DS_measured, double dt) {
  dt = std::isfinite(dt) ? std::clamp(dt, 1e-5, 0.1) : kNominalTick;
  if (!started_) reset(X_DS_measured);
  const Pose X_DS = X_DS_measured.isValid() ? X_DS_measured : stylus_;
  const bool jumped = std::exchange(jumped_, false);
  const MetricVector stylus_step = jumped ? MetricVector{} : mover_.way(X_DS, stylus_);
  sets_.advance(dt);

  SetJump jump;
  ProxyStep solved;
  solved.X_DP = X_DS;
  const bool changed = sets_.offered();
  if (changed)
    solved = changeSet(X_DS, dt, jump);
  else if (sets_.holds())
    solved = mover_.move(sets_.current(), proxy_, X_DS, dt, held_by_);

  if (!isFiniteStep(solved)) return endWithoutSet(proxy_, X_DS);
  const Pose X_DPLast = proxy_;

  const MetricVector stretch_D = stretchOf(solved, X_DS);
  const bool late = isLate(solved);
  if (late) solved.contact = false;
  const MetricVector proxy_step =
      jumped ? restartStretch(solved, stretch_D) : takeOutJump(solved, stretch_D, jump, stylus_step, dt);
  // A proxy that needs several ticks to come goes by itself: what it drags along by the damper nobody has paid for.
  const bool catches_up = length(solved.lag_D) > 0.0;
  velocities_.add(stylus_step, catches_up ? stylus_step : proxy_step, options_.stiffness, dt);
  updateSpring(solved, stylus_step, dt);
  proxy_ = solved.X_DP;
  held_by_ = solved.held_by;
  stylus_ = X_DS;
  contact_ = solved.contact;
  late_ = late;
  gains_.updateDamper(contact_, catches_up, dt);

  const dvec3 coupling_before_D = spring_.last().wanted.linear;
  spring_.noteWanted(couplingForce(solved));
  load_D_ = load_.tick(X_DS.p, velocities_.stylus_D().linear, dt) +
            pullOf(X_DS, changed || jumped, dt, spring_.last().wanted.linear - coupling_before_D);
  return isFinite() ? resultOf(solved) : endWithoutSet(X_DPLast, X_DS);
}

bool ForceRenderer::isFinite() const {
  return std::isfinite(length(spring_.last().wanted) + length(spring_.last().spring) + length(spring_.offset_D()) +
                       glm::length(load_D_) + length(velocities_.proxy_D()) + passivity_.balance() + spring_.yielded());
}

RenderResult ForceRenderer::endWithoutSet(const Pose& X_DP, const Pose& X_DS) {
  reset(X_DS);
  proxy_ = X_DP;
  RenderResult result = resultOf({});
  result.dropped = true;
  return result;
}

RenderResult ForceRenderer::resultOf(const ProxyStep& solved) const {
  RenderResult result;
  result.X_DP = proxy_;
  result.force_D = spring_.last().wanted.linear + load_D_;
  result.torque_D = kRotationLever * spring_.last().wanted.angular;
  result.spring_D = spring_.last().spring.linear;
  result.spring_torque_D = kRotationLever * spring_.last().spring.angular;
  result.load_D = load_D_;
  result.v_DS = velocities_.stylus_D().linear;
  result.v_DO = solved.v_DO;
  result.offset_D = spring_.offset_D().linear;
  result.active_rows = solved.active_rows;
  result.contact = solved.contact;
  result.at_zone_edge = solved.trust;
  result.energy = passivity_.balance();
  result.stiffness = gains_.stiffness();
  result.controller_damping = passivity_.damping();
  result.adopted_set = sets_.sequence();
  return result;
}

}  // namespace hapticell::haptic
