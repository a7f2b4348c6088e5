// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/force_renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "haptic/rendering/proxy_metric.h"

namespace hapticell::haptic {

namespace {

constexpr double kMillisecond = 0.001;
constexpr double kJumpAllowance = 0.01e-3;                   // m the proxy may outrun the stylus in a tick.
constexpr double kOffsetDecay = 0.05e-3;                     // m per millisecond.
constexpr double kFadeTime = 0.005;                          // s, of a small offset in contact.
constexpr double kOffsetGone = 1e-6;                         // m.
constexpr double kPull = 1e-3;                               // N.
constexpr double kTrustForce = 0.8;                          // N,
constexpr double kTrustShare = 0.3;                          // of the stiffness: the zone's edge is no thing to strike.
constexpr double kQuietFilter = 75.0, kQuickFilter = 100.0;  // Hz, at kSoft and below, and for stiff couplings.
constexpr double kControllerFilter = 40.0;                   // Hz: it damps more, so its noise must be less.
constexpr double kSoft = 1000.0;                             // N/m.
constexpr double kDampingLimit = 8.0;                        // N s/m that an entry or a client can ask for.
constexpr double kOldestAge = 1.0;                           // s that a moving obstacle is foreseen.
constexpr double kOrderLasts = 2.5;                          // s that a set's number shuts lower ones out.
constexpr double kDamperFade = 0.01;                         // s.
constexpr double kStiffnessTime = 0.1;                       // s for a whole change of stiffness in contact.
constexpr double kAtRest = 0.3e-3, kRested = 0.2;            // m that a hand at rest stays within, and for so many s,
constexpr double kRestDrifts = 5e-3;     // m/s: a hand that gives way to what comes back rests, too.
constexpr double kCreepPower = 0.25e-3;  // W, what the ration gives.
constexpr double kComesBack = 1.5;       // s for all that the motors bear, where the hand has paid.
constexpr double kMostMade = 0.36e-3;    // J within a second: then nothing unpaid up to kSoft.

/// Damping makes noise of the encoders' steps, a late velocity makes a stiff coupling unstable: the stiffer, the
/// quicker.
double filterFrequency(double stiffness) {
  return std::clamp(kQuietFilter * stiffness / kSoft, kQuietFilter, kQuickFilter);
}

double lowPassGain(double frequency, double dt) {
  return 1.0 - std::exp(-2.0 * std::numbers::pi * frequency * dt);
}

double saneOr(double value, double fallback) {
  return std::isfinite(value) && value > 0.0 ? value : fallback;
}

bool isSound(const ProxyStep& step) {
  return step.X_DP.isValid() &&
         std::isfinite(length(step.trust_D) + length(step.lag_D) + glm::length(step.v_DO) + step.outrun);
}

}  // namespace

RendererOptions limitedByDelay(RendererOptions options) {
  const RendererOptions defaults;
  options.stiffness = saneOr(options.stiffness, defaults.stiffness);
  options.damping = saneOr(options.damping, defaults.damping);
  options.delay = saneOr(options.delay, defaults.delay);
  options.peak_force = saneOr(options.peak_force, defaults.peak_force);
  options.peak_torque = saneOr(options.peak_torque, 0.0);
  options.tick = saneOr(options.tick, defaults.tick);
  if (!options.adapt) return options;
  const double ticks = std::max(1.0, options.delay / kMillisecond);
  options.stiffness = std::min(options.stiffness, 0.65 * 2300.0 / ticks);
  options.damping = std::min(options.damping, kDampingLimit);
  if (ticks >= 1.999) options.damping = std::max(options.damping, 4.0);
  return options;
}

void ForceRenderer::setOptions(const RendererOptions& options) {
  options_ = limitedByDelay(options);
  mover_.setTurning(options_.peak_torque > 0.0);
  passivity_.setDelay(static_cast<int>(std::lround(options_.delay / options_.tick)));
  if (contact_) return;
  stiffness_ = options_.stiffness;
  damping_ = options_.damping;
}

void ForceRenderer::noteApplied(const dvec3& force_D, const dvec3& torque_D) {
  const double wanted = glm::length(last_.wanted.linear + load_D_);
  const double share = wanted > 0.0 ? std::min(1.0, glm::length(force_D) / wanted) : 1.0;
  last_.applied = {force_D - share * load_D_, torque_D / kRotationLever};
  const double applied = length(last_.applied);
  if (applied < 0.999 * length(last_.wanted)) last_.limit = applied;
}

void ForceRenderer::reset(const Pose& X_DS) {
  has_set_ = offered_ = contact_ = late_ = arriving_ = jumped_ = false;
  damper_ = 0.0;
  load_.reset();
  load_D_ = dvec3(0.0);
  started_ = X_DS.isValid();
  if (started_) proxy_ = stylus_ = X_DS;
  offset_D_ = stretch_D_ = trust_D_ = v_stylus_D_ = v_slow_D_ = v_proxy_D_ = {};
  yield_ = yielded_ = resting_ = 0.0;
  stiffness_ = options_.stiffness;
  damping_ = options_.damping;
  last_ = {};
  last_.stiffness = stiffness_;
  last_.limit = kNoLimit;
  passivity_.reset();
  ration_.reset();
  since_adoption_ = 0.0;
  set_period_ = 0.1;
}

Adoption ForceRenderer::adopt(const ConstraintSet& set, double age) {
  if (!isWellFormed(set)) return Adoption::kMalformed;
  const bool counts = has_set_ && since_adoption_ < kOrderLasts;
  if (counts && set.sequence < sets_[current_].set.sequence) return Adoption::kOutdated;
  if (started_ && lengthOf(metricDifference(proxy_, set.X_DR)) >= kTrustedShare * set.zone_radius)
    return Adoption::kOutsideZone;
  sets_[1 - current_].take(set);
  sets_[1 - current_].age = std::isfinite(age) ? std::clamp(age, 0.0, kOldestAge) : 0.0;
  offered_ = true;
  return Adoption::kAdopted;
}

/// A proxy that comes after the stylus from far off may brush rows that are not in its way when it is there.
bool ForceRenderer::isLate(const ProxyStep& solved) const {
  return length(solved.lag_D) > 0.0 && (!contact_ || late_);
}

/// From the stylus to the proxy, m. A proxy that is only late pulls at nobody.
MetricVector ForceRenderer::stretchOf(const ProxyStep& solved, const Pose& X_DS) const {
  const MetricVector trusted_D = limited(kTrustShare * solved.trust_D, kTrustForce / stiffness_);
  if (isLate(solved)) return trusted_D;
  return mover_.way(solved.X_DP, X_DS) + solved.lag_D + trusted_D - solved.trust_D;
}

ProxyStep ForceRenderer::changeSet(const Pose& X_DS, double dt, SetJump& jump) {
  ProxyStep solved = mover_.move(sets_[1 - current_], proxy_, X_DS, dt);
  if (has_set_) {
    const ProxyStep before = mover_.move(sets_[current_], proxy_, X_DS, dt);
    const MetricVector stretch_before = stretchOf(before, X_DS), stretch_after = stretchOf(solved, X_DS);
    const MetricVector borne_before = borne(stretch_before);
    offset_D_ += borne_before - borne(stretch_after);
    jump = {mover_.way(solved.X_DP, before.X_DP), stretch_after - stretch_before, solved.trust_D - before.trust_D};
    set_period_ = std::clamp(since_adoption_, kMillisecond, 0.2);
  }
  current_ = 1 - current_;
  has_set_ = true;
  offered_ = false;
  since_adoption_ = 0.0;
  return solved;
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
  const MetricVector growth = stretch_D - stretch_D_ - jump.stretch_D + stylus_step;
  stretch_D_ = stretch_D;
  const MetricVector carried{dt * solved.v_DO, dvec3(0.0)};
  // Of a proxy that arrives at last nothing is the stylus's doing.
  const double own = late_ ? 0.0 : solved.outrun * length(stylus_step - carried);
  const double allowed = own + length(carried) + kJumpAllowance;
  if ((!contact_ && !late_) || !solved.contact) return limited(proxy_step, allowed);
  const MetricVector excess = growth - limited(growth, allowed);
  if (!(excess == MetricVector{})) {
    const MetricVector borne_before = borne(stretch_D - excess);
    offset_D_ += borne_before - borne(stretch_D);
  }
  return limited(proxy_step, allowed);
}

void ForceRenderer::filterVelocities(const MetricVector& stylus_step, const MetricVector& proxy_step, double dt) {
  const double gain = lowPassGain(filterFrequency(options_.stiffness), dt);
  v_stylus_D_ += gain * ((1.0 / dt) * stylus_step - v_stylus_D_);
  v_proxy_D_ += gain * ((1.0 / dt) * proxy_step - v_proxy_D_);
  v_slow_D_ += lowPassGain(kControllerFilter, dt) * ((1.0 / dt) * stylus_step - v_slow_D_);
}

void ForceRenderer::decayOffset(const ProxyStep& solved, const MetricVector& stylus_step, double dt) {
  const double size = length(offset_D_);
  if (size <= kOffsetGone) {
    offset_D_ = {};
    return;
  }
  double decay = kOffsetDecay * dt / kMillisecond;
  if (solved.contact) {
    decay = std::min(decay, size * dt / kFadeTime);
  } else {
    decay += std::max(0.0, dot(stylus_step, offset_D_)) / size;  // It is no push to be had for nothing.
  }
  offset_D_ *= 1.0 - std::min(1.0, decay / size);
}

void ForceRenderer::updateCoupling(const ProxyStep& solved, double dt) {
  const double wanted = solved.stiffness > 0.0 ? std::min(solved.stiffness, options_.stiffness) : options_.stiffness;
  const double step = options_.stiffness * dt / kStiffnessTime;
  stiffness_ = contact_ ? stiffness_ + std::clamp(wanted - stiffness_, -step, step) : wanted;
  const double damping = std::clamp(solved.damping, options_.damping, std::max(options_.damping, kDampingLimit));
  const double damping_step = damping * dt / kStiffnessTime;
  damping_ = contact_ ? damping_ + std::clamp(damping - damping_, -damping_step, damping_step) : damping;
}

/// What still presses when a contact ends (the zone's edge, an offset) must not lose its damping in one step, nor get
/// it in one when a proxy that caught up has arrived. A hand that strikes is damped at once.
void ForceRenderer::updateDamper(bool catches_up, double dt) {
  arriving_ = catches_up || (arriving_ && contact_ && damper_ < 1.0);
  const double step = dt / kDamperFade;
  if (!contact_ || catches_up)
    damper_ = std::max(0.0, damper_ - step);
  else
    damper_ = arriving_ ? std::min(1.0, damper_ + step) : 1.0;
}

/// Of the set in use, as far as the stylus is inside its zone.
dvec3 ForceRenderer::pullOf(const Pose& X_DS) const {
  if (!has_set_) return dvec3(0.0);
  const GroupedSet& grouped = sets_[current_];
  const bool inside = lengthOf(metricDifference(X_DS, grouped.set.X_DR)) < grouped.set.zone_radius;
  return inside ? grouped.pullAt(X_DS) : dvec3(0.0);
}

MetricVector ForceRenderer::couplingForce(const ProxyStep& solved) const {
  const double pull = length(last_.spring);
  if (pull <= 0.0) return {};
  // The coupling damps the stylus against the proxy; the controller damps the stylus itself, since on a convex surface
  // the proxy outruns the stylus and more of the coupling's damping would make energy instead of taking it.
  // Without a contact the proxy only catches up with the stylus: no motion to damp.
  const double damping = damper_ * damping_;
  const MetricVector outward = (1.0 / pull) * last_.spring;
  const MetricVector v_rel = v_stylus_D_ - v_proxy_D_;
  MetricVector controlled = -passivity_.damping() * (v_slow_D_ - MetricVector{solved.v_DO, dvec3(0.0)});
  // It takes on the way out; on the way in it would only press harder and so hold more.
  controlled -= std::max(0.0, dot(controlled, outward)) * outward;
  // Like friction it ends with what presses, not with a step.
  controlled = limited(controlled, pull);
  MetricVector damper = controlled - damping * v_rel;
  damper -= std::min(0.0, pull + dot(damper, outward)) * outward;
  return last_.spring + unpulling(damper);
}

/// What damps, without what would pull at a hand that lifts from what holds the proxy: while an offset fades the spring
/// may point anywhere.
MetricVector ForceRenderer::unpulling(const MetricVector& damper_D) const {
  const double stretch2 = dot(stretch_D_, stretch_D_);
  if (stretch2 <= 0.0) return damper_D;
  const double spring = dot(last_.spring, stretch_D_), pulled = dot(damper_D, stretch_D_) + std::max(0.0, spring);
  return pulled < 0.0 ? damper_D - (pulled / stretch2) * stretch_D_ : damper_D;
}

/// A hand that lifts faster than the offset fades must not be pulled back by it: a spring that pushed ends at nothing.
MetricVector ForceRenderer::pushing(const MetricVector& spring_D, const MetricVector& left_D) const {
  const double along = dot(spring_D, left_D);
  const bool pulled = dot(last_.spring, left_D) < -kPull * length(left_D);
  if (along >= 0.0 || pulled) return spring_D;
  return spring_D - (along / dot(left_D, left_D)) * left_D;
}

/// The largest force, N in the metric, that the motors bear in this direction.
double ForceRenderer::forceLimit(const MetricVector& direction_D) const {
  const double force = std::min(force_limit_, options_.peak_force);
  if (!mover_.turning()) return force;
  const double size = length(direction_D), turn = glm::length(direction_D.angular);
  const double torque = options_.peak_torque / kRotationLever * (force / options_.peak_force);
  return size * std::min(force / std::max(glm::length(direction_D.linear), 1e-12 * size + 1e-300),
                         torque / std::max(turn, 1e-12 * size + 1e-300));
}

/// What is left of a stretch to a spring that yields like a ductile metal at the force limit: beyond it the rest point
/// follows, and back it unloads along the full stiffness to nothing, never to a pull. It shortens the stretch but never
/// turns it, so that what holds the proxy decides the direction of the force.
MetricVector ForceRenderer::borne(const MetricVector& stretch_D) {
  const double size = length(stretch_D);
  if (size <= 0.0) {
    yield_ = 0.0;
    return stretch_D;
  }
  yield_ = std::clamp(yield_, std::max(0.0, size - forceLimit(stretch_D) / stiffness_), size);
  return (1.0 - yield_ / size) * stretch_D;
}

/// After a jump: the spring has not been stretched, it is made anew where the stylus is now. Its force goes on from
/// what it was, and comes to the new one by the offset's decay. Returns the proxy's step.
MetricVector ForceRenderer::beginAnew(const ProxyStep& solved, const MetricVector& stretch_D) {
  trust_D_ = solved.trust_D;
  stretch_D_ = stretch_D;
  yield_ = 0.0;
  const MetricVector new_D = borne(stretch_D);
  offset_D_ = solved.contact ? (1.0 / stiffness_) * last_.spring - new_D : MetricVector{};
  ration_.grant(0.5 * stiffness_ * dot(new_D, new_D));
  return {};
}

/// The place that the stylus rests about follows it slowly, so that a hand that gives way to what comes back still
/// rests.
bool ForceRenderer::restsFor(double seconds, double dt) {
  const MetricVector away = mover_.way(stylus_, rest_);
  if (length(away) < kAtRest) {
    resting_ += dt;
    rest_ = displacedInMetric(rest_, asVector6(limited(away, kRestDrifts * dt)));
  } else {
    resting_ = 0.0;
    rest_ = stylus_;
  }
  return resting_ >= seconds;
}

/// A spring that has yielded is not what it should be for ever: under a hand that rests it comes back, by way of the
/// offset. What the hand itself has put into the yielding pays for that: all that the motors bear is there in
/// kComesBack. What yielded otherwise comes no faster than the ration allows.
void ForceRenderer::creepBack(const ProxyStep& solved, const MetricVector& stretch_D, double dt) {
  const bool rests = restsFor(kRested, dt);
  const double size = length(stretch_D);
  if (yield_ <= 0.0 || !solved.contact || size <= 0.0) yielded_ = 0.0;
  if (yield_ <= 0.0 || !solved.contact || size <= 0.0 || !rests) return;
  const double limit = forceLimit(stretch_D);
  const double least = std::max(0.0, size - limit / stiffness_);
  const double pull = std::max(stiffness_ * (size - yield_), kPull);
  const double rationed = std::min(kOffsetDecay * dt / kMillisecond, kCreepPower * dt / pull);
  const double paid = std::min(limit / stiffness_ * dt / kComesBack, yielded_ / pull);
  const double back = std::clamp(yield_ - least, 0.0, std::max(rationed, paid));
  const double energy = std::min(yielded_, (pull + 0.5 * stiffness_ * back) * back);
  yielded_ -= energy;
  ration_.grant(energy);
  passivity_.prepay(energy);
  yield_ -= back;
  offset_D_ -= (back / size) * stretch_D;
}

void ForceRenderer::updateSpring(const ProxyStep& solved, const MetricVector& stretch_D,
                                 const MetricVector& relative_step, double dt) {
  const bool free = solved.active_rows == 0 && offset_D_ == MetricVector{};
  const MetricVector left_D = borne(free ? MetricVector{} : stretch_D);
  const MetricVector pushing_D = pushing(left_D + offset_D_, left_D);
  const MetricVector wanted_D = limited(pushing_D, forceLimit(pushing_D) / stiffness_);
  const MetricVector spring_D = ration_.apply(wanted_D, stiffness_, last_, relative_step, dt);
  offset_D_ = spring_D - left_D;
  last_.spring = stiffness_ * spring_D;
  last_.stiffness = stiffness_;
}

RenderResult ForceRenderer::tick(const Pose& X_DS_measured, double dt) {
  dt = std::isfinite(dt) ? std::clamp(dt, 1e-5, 0.1) : kMillisecond;
  if (!started_) reset(X_DS_measured);
  const Pose X_DS = X_DS_measured.isValid() ? X_DS_measured : stylus_;
  const bool jumped = std::exchange(jumped_, false);
  const MetricVector stylus_step = jumped ? MetricVector{} : mover_.way(X_DS, stylus_);
  since_adoption_ += dt;
  sets_[current_].age = std::min(sets_[current_].age + dt, kOldestAge);

  SetJump jump;
  ProxyStep solved;
  solved.X_DP = X_DS;
  if (offered_)
    solved = changeSet(X_DS, dt, jump);
  else if (has_set_)
    solved = mover_.move(sets_[current_], proxy_, X_DS, dt);

  if (!isSound(solved)) return endWithoutSet(proxy_, X_DS);
  const Pose X_DPLast = proxy_;

  const MetricVector stretch_D = stretchOf(solved, X_DS);
  const bool late = isLate(solved);
  if (late) solved.contact = false;
  const MetricVector proxy_step =
      jumped ? beginAnew(solved, stretch_D) : takeOutJump(solved, stretch_D, jump, stylus_step, dt);
  // A proxy that needs several ticks to come goes by itself: what it drags along by the damper nobody has paid for.
  const bool catches_up = length(solved.lag_D) > 0.0;
  filterVelocities(stylus_step, catches_up ? stylus_step : proxy_step, dt);
  decayOffset(solved, stylus_step, dt);
  updateCoupling(solved, dt);
  // What moves the obstacle pays as well as the hand does.
  const MetricVector relative_step = stylus_step - MetricVector{dt * solved.v_DO, dvec3(0.0)};
  passivity_.add(relative_step, last_.applied, last_.stiffness);
  passivity_.step(solved.contact, dt);
  // A stiffer one trembles, and what that makes is its own.
  const double room = kMostMade - passivity_.recentLoss();
  const double yield_before = yield_;
  creepBack(solved, stretch_D, dt);
  ration_.limit(options_.stiffness > kSoft ? kMostMade : std::max(0.0, room));
  updateSpring(solved, stretch_D, relative_step, dt);
  if (yield_ > yield_before) yielded_ += std::min(ration_.lost(), length(last_.spring) * (yield_ - yield_before));
  proxy_ = solved.X_DP;
  stylus_ = X_DS;
  contact_ = solved.contact;
  late_ = late;
  updateDamper(catches_up, dt);

  last_.applied = last_.wanted = couplingForce(solved);
  last_.limit = kNoLimit;
  load_D_ = load_.tick(X_DS.p, v_stylus_D_.linear, dt) + pullOf(X_DS);
  const double all = length(last_.wanted) + length(last_.spring) + length(offset_D_) + glm::length(load_D_) +
                     length(v_proxy_D_) + passivity_.balance() + yielded_;
  return std::isfinite(all) ? resultOf(solved) : endWithoutSet(X_DPLast, X_DS);
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
  result.force_D = last_.wanted.linear + load_D_;
  result.torque_D = kRotationLever * last_.wanted.angular;
  result.spring_D = last_.spring.linear;
  result.spring_torque_D = kRotationLever * last_.spring.angular;
  result.load_D = load_D_;
  result.v_DS = v_stylus_D_.linear;
  result.v_DO = solved.v_DO;
  result.offset_D = offset_D_.linear;
  result.active_rows = solved.active_rows;
  result.contact = solved.contact;
  result.at_zone_edge = solved.trust;
  result.energy = passivity_.balance();
  result.stiffness = stiffness_;
  result.controller_damping = passivity_.damping();
  result.adopted_set = has_set_ ? sets_[current_].set.sequence : 0;
  return result;
}

}  // namespace hapticell::haptic
