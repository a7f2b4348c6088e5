// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/force_renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptic/rendering/active_set_solver.h"
#include "haptic/rendering/proxy_metric.h"

namespace hapticell::haptic {

namespace {

constexpr double kMillisecond = 0.001;
constexpr double kLongestMove = 0.002;  // m of one iteration of the proxy.
constexpr int kIterations = 2;
constexpr double kJumpAllowance = 0.01e-3;  // m the proxy may outrun the stylus in a tick.
constexpr double kLargestOutrun = 3.0;
constexpr double kOffsetDecay = 0.05e-3;                     // m per millisecond.
constexpr double kUnpaidPower = 3e-4;                        // W that the spring may gain without the hand's work,
constexpr double kUnpaidBudget = 2e-4;                       // J at once.
constexpr double kFadeTime = 0.005;                          // s, of a small offset in contact.
constexpr double kOffsetGone = 1e-6;                         // m.
constexpr double kPull = 1e-3;                               // N.
constexpr double kTrustForce = 0.8;                          // N.
constexpr double kQuietFilter = 75.0, kQuickFilter = 100.0;  // Hz, at kSoft and below, and for stiff couplings.
constexpr double kSoft = 1000.0;                             // N/m.
constexpr double kEnergyAllowance = 0.2e-3;                  // J made before the controller acts.
constexpr double kControllerStep = 0.1;                      // N s/m per millisecond.
constexpr double kControllerLimit = 5.0;                     // N s/m.
constexpr double kDampingLimit = 8.0;                        // N s/m an entry can ask for.
constexpr double kOldestAge = 1.0;                           // s that a moving obstacle is foreseen.
constexpr double kStiffnessTime = 0.1;                       // s for a whole change of stiffness in contact.

dvec3 limited(const dvec3& v, double limit) {
  const double length = glm::length(v);
  return length > limit ? v * (limit / length) : v;
}

/// Damping makes noise of the encoders' steps, a late velocity makes a stiff coupling unstable: the stiffer, the
/// quicker.
double lowPassGain(double stiffness, double dt) {
  const double frequency = std::clamp(kQuietFilter * stiffness / kSoft, kQuietFilter, kQuickFilter);
  return 1.0 - std::exp(-2.0 * std::numbers::pi * frequency * dt);
}

double saneOr(double value, double fallback) {
  return std::isfinite(value) && value > 0.0 ? value : fallback;
}

}  // namespace

RendererOptions limitedByDelay(RendererOptions options) {
  const RendererOptions defaults;
  options.stiffness = saneOr(options.stiffness, defaults.stiffness);
  options.damping = saneOr(options.damping, defaults.damping);
  options.delay = saneOr(options.delay, defaults.delay);
  options.peak_force = saneOr(options.peak_force, defaults.peak_force);
  if (!options.adapt) return options;
  const double ticks = std::max(1.0, options.delay / kMillisecond);
  options.stiffness = std::min(options.stiffness, 0.65 * 2300.0 / ticks);
  if (ticks >= 1.999) options.damping = std::max(options.damping, 4.0);
  return options;
}

double storedEnergy(double spring, double stiffness, double limit) {
  const double acting = std::min(spring, limit);
  return acting * (spring - 0.5 * acting) / stiffness;
}

namespace {

/// The pull, N, at which storedEnergy() is so much.
double springThatStores(double energy, double stiffness, double limit) {
  const double free = std::sqrt(2.0 * stiffness * std::max(0.0, energy));
  return free <= limit ? free : stiffness * energy / limit + 0.5 * limit;
}

}  // namespace

/// Where one set lets the proxy go, and what holds it there.
struct ForceRenderer::Solved {
  Pose X_DP;
  std::size_t active_rows = 0;
  bool contact = false;
  bool trust = false;
  dvec3 trust_D{0.0};      ///< The trust row's part of proxy less stylus, m.
  double friction = 0.0;   ///< Of the active rows, weighted by how hard they press.
  dvec3 lag_D{0.0};        ///< What the proxy could go besides, but for its longest move in a tick, m.
  dvec3 goal_D{0.0};       ///< Where the rows would let the proxy go, m; it may need several ticks.
  double depth = 0.0;      ///< What then is left to the stylus, m.
  double stiffness = 0.0;  ///< Least that an active row asks for, 0: none does.
  double damping = 0.0;    ///< Most that an active row asks for.
  double outrun = 1.0;     ///< How much faster than the stylus the proxy goes along what bulges towards it.
  dvec3 v_DO{0.0};         ///< Of what is touched, weighted by how hard it presses, m/s.

  void note(const GroupedSet& grouped, const ProxyRows& rows, const SolverResult& result);
  void noteOutrun(const Constraint& constraint, double press);
};

void ForceRenderer::Solved::note(const GroupedSet& grouped, const ProxyRows& rows, const SolverResult& result) {
  active_rows = result.active_count;
  const std::size_t last = rows.count - 1;
  trust = result.multiplier[last] != 0.0;
  trust_D = result.multiplier[last] * linearPart(rows.row[last].normal);
  contact = false;
  friction = stiffness = damping = 0.0;
  v_DO = dvec3(0.0);
  outrun = 1.0;
  double pressed = 0.0;
  for (std::size_t i = 0; i < last; ++i) {
    const double press = std::abs(result.multiplier[i]);
    if (press <= 0.0) continue;
    const Constraint& constraint = grouped.set.constraints[rows.entry[i]];
    contact = true;
    noteOutrun(constraint, press);
    pressed += press;
    friction += press * constraint.friction;
    v_DO += press * constraint.velocity_D;
    damping = std::max(damping, constraint.damping);
    if (constraint.stiffness > 0.0)
      stiffness = stiffness > 0.0 ? std::min(stiffness, constraint.stiffness) : constraint.stiffness;
  }
  if (pressed <= 0.0) return;
  friction /= pressed;
  v_DO /= pressed;
}

/// On a convex surface of radius R a stylus that is d deep goes R - d while the proxy goes R.
void ForceRenderer::Solved::noteOutrun(const Constraint& constraint, double press) {
  const SymmetricMatrix6& B = constraint.curvature;
  const double length = std::max(glm::length(linearPart(constraint.gradient)), 1e-9);
  const double bulge = std::max({0.0, B[0], B[6], B[11]}) / length;
  outrun = std::max(outrun, 1.0 / std::max(1.0 - bulge * press, 1.0 / kLargestOutrun));
}

void ForceRenderer::setOptions(const RendererOptions& options) {
  options_ = limitedByDelay(options);
  if (contact_) return;
  stiffness_ = options_.stiffness;
  damping_ = options_.damping;
}

void ForceRenderer::noteApplied(const dvec3& force_D) {
  const double wanted = glm::length(wanted_D_ + load_D_);
  const double share = wanted > 0.0 ? std::min(1.0, glm::length(force_D) / wanted) : 1.0;
  applied_D_ = force_D - share * load_D_;
  const double applied = glm::length(applied_D_);
  if (applied < 0.999 * glm::length(wanted_D_)) limit_ = applied;
}

void ForceRenderer::reset(const Pose& X_DS) {
  has_set_ = offered_ = contact_ = false;
  load_.reset();
  load_D_ = dvec3(0.0);
  started_ = X_DS.isValid();
  if (started_) proxy_ = stylus_ = X_DS;
  offset_D_ = stretch_D_ = v_stylus_D_ = v_proxy_D_ = spring_D_ = applied_D_ = wanted_D_ = dvec3(0.0);
  yield_ = 0.0;
  limit_ = std::numeric_limits<double>::infinity();
  energy_ = balance_ = controller_damping_ = 0.0;
  unpaid_budget_ = kUnpaidBudget;
  stiffness_ = options_.stiffness;
  damping_ = options_.damping;
  since_adoption_ = 0.0;
  set_period_ = 0.1;
}

Adoption ForceRenderer::adopt(const ConstraintSet& set, double age) {
  if (!isWellFormed(set)) return Adoption::kMalformed;
  if (has_set_ && set.sequence < sets_[current_].set.sequence) return Adoption::kOutdated;
  if (started_ && lengthOf(metricDifference(proxy_, set.X_DR)) >= set.zone_radius) return Adoption::kOutsideZone;
  sets_[1 - current_].take(set);
  sets_[1 - current_].age = std::isfinite(age) ? std::clamp(age, 0.0, kOldestAge) : 0.0;
  offered_ = true;
  return Adoption::kAdopted;
}

ForceRenderer::Solved ForceRenderer::moveProxy(const GroupedSet& grouped, const Pose& X_DS, double dt) const {
  Solved solved;
  solved.X_DP = proxy_;
  ProxyRows rows;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    rows.gather(grouped, solved.X_DP);
    const Vector6 wanted = metricDifference(X_DS, solved.X_DP);
    const SolverResult result = nearestFeasible(rows.all(), wanted);
    Vector6 d = result.d;
    solved.goal_D = solved.X_DP.p + linearPart(d);
    solved.depth = glm::distance(linearPart(wanted), linearPart(d));
    const double length = lengthOf(d);
    solved.note(grouped, rows, result);
    solved.lag_D = dvec3(0.0);
    if (result.active_count == 0 && length <= kLongestMove) {
      solved.X_DP = X_DS;  // To the last bit, so that free motion costs exactly nothing.
      continue;
    }
    if (length > kLongestMove) {
      solved.lag_D = linearPart(d) * (1.0 - kLongestMove / length);
      for (double& number : d) number *= kLongestMove / length;
    }
    solved.X_DP = displacedInMetric(solved.X_DP, d);
  }
  applyFriction(grouped, solved, dt);
  return solved;
}

void ForceRenderer::applyFriction(const GroupedSet& grouped, Solved& solved, double dt) const {
  if (!solved.contact || solved.friction <= 0.0) return;
  const dvec3 carried = proxy_.p + dt * solved.v_DO;  // What is touched takes the proxy along.
  const dvec3 way = solved.X_DP.p - carried;
  const double length = glm::length(way);
  const double held = solved.friction * solved.depth;
  if (length <= 0.0 || held <= 0.0) return;
  // Of the whole way, not of what a tick can do of it: else a proxy that is left behind would stick for ever.
  const double whole = glm::distance(solved.goal_D, carried);
  solved.X_DP.p = carried + way * std::clamp((whole - held) / length, 0.0, 1.0);
  ProxyRows rows;
  rows.gather(grouped, solved.X_DP);
  const SolverResult back = nearestFeasible(rows.all(), Vector6{});
  if (back.active_count > 0) solved.X_DP = displacedInMetric(solved.X_DP, back.d);
}

/// From the stylus to the proxy, m. A proxy that is only late pulls at nobody.
dvec3 ForceRenderer::stretchOf(const Solved& solved, const Pose& X_DS) const {
  const dvec3 trusted_D = limited(solved.trust_D, kTrustForce / stiffness_);
  return solved.X_DP.p - X_DS.p + solved.lag_D + trusted_D - solved.trust_D;
}

ForceRenderer::Solved ForceRenderer::changeSet(const Pose& X_DS, double dt, SetJump& jump) {
  Solved solved = moveProxy(sets_[1 - current_], X_DS, dt);
  if (has_set_) {
    const Solved before = moveProxy(sets_[current_], X_DS, dt);
    const dvec3 stretch_before = stretchOf(before, X_DS), stretch_after = stretchOf(solved, X_DS);
    const dvec3 borne_before = borne(stretch_before);
    offset_D_ += borne_before - borne(stretch_after);
    jump = {solved.X_DP.p - before.X_DP.p, stretch_after - stretch_before};
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
dvec3 ForceRenderer::takeOutJump(const Solved& solved, const dvec3& stretch_D, const SetJump& jump,
                                 const dvec3& stylus_step, double dt) {
  const dvec3 proxy_step = solved.X_DP.p - proxy_.p - jump.proxy_D;
  const dvec3 growth = stretch_D - stretch_D_ - jump.stretch_D + stylus_step;
  stretch_D_ = stretch_D;
  if (!contact_ || !solved.contact) return proxy_step;
  const double relative = glm::length(stylus_step - dt * solved.v_DO);
  const double allowed = solved.outrun * relative + dt * glm::length(solved.v_DO) + kJumpAllowance;
  const dvec3 excess = growth - limited(growth, allowed);
  if (excess != dvec3(0.0)) {
    const dvec3 borne_before = borne(stretch_D - excess);
    offset_D_ += borne_before - borne(stretch_D);
  }
  return limited(proxy_step, allowed);
}

void ForceRenderer::filterVelocities(const dvec3& stylus_step, const dvec3& proxy_step, double dt) {
  const double gain = lowPassGain(options_.stiffness, dt);
  v_stylus_D_ += gain * (stylus_step / dt - v_stylus_D_);
  v_proxy_D_ += gain * (proxy_step / dt - v_proxy_D_);
}

void ForceRenderer::decayOffset(const Solved& solved, const dvec3& stylus_step, double dt) {
  const double length = glm::length(offset_D_);
  if (length <= kOffsetGone) {
    offset_D_ = dvec3(0.0);
    return;
  }
  double decay = kOffsetDecay * dt / kMillisecond;
  if (solved.contact) {
    decay = std::min(decay, length * dt / kFadeTime);
  } else {
    decay += std::abs(glm::dot(stylus_step, offset_D_)) / length;
  }
  offset_D_ *= 1.0 - std::min(1.0, decay / length);
}

/// Shortens a spring that would hold more than the hand has paid for: a set that lies deeper than the one before, a
/// turn of the wrist, which no device of three driven axes feels, a proxy that catches up. Beside the hand's own work
/// it may gain kUnpaidPower. What is cut off stays in the offset, the direction is free.
dvec3 ForceRenderer::rationed(const dvec3& spring_D, const dvec3& stylus_step, double dt) {
  unpaid_budget_ = std::min(unpaid_budget_ + kUnpaidPower * dt, kUnpaidBudget);
  const double pull = stiffness_ * glm::length(spring_D);
  const double held = storedEnergy(glm::length(spring_D_), held_stiffness_, limit_);
  // What the damper gives where the proxy outruns the stylus is the controller's business.
  const double damped = -glm::dot(wanted_D_ - spring_D_, stylus_step);
  const double paid = held - glm::dot(applied_D_, stylus_step) - std::min(0.0, damped);
  const double unpaid = storedEnergy(pull, stiffness_, limit_) - paid;
  if (unpaid <= unpaid_budget_) {
    unpaid_budget_ -= std::max(0.0, unpaid);
    return spring_D;
  }
  const double allowed = springThatStores(paid + unpaid_budget_, stiffness_, limit_);
  unpaid_budget_ = 0.0;
  return spring_D * std::min(1.0, allowed / pull);
}

void ForceRenderer::updateCoupling(const Solved& solved, double dt) {
  const double wanted = solved.stiffness > 0.0 ? std::min(solved.stiffness, options_.stiffness) : options_.stiffness;
  const double step = options_.stiffness * dt / kStiffnessTime;
  stiffness_ = contact_ ? stiffness_ + std::clamp(wanted - stiffness_, -step, step) : wanted;
  const double damping = std::clamp(solved.damping, options_.damping, std::max(options_.damping, kDampingLimit));
  const double damping_step = damping * dt / kStiffnessTime;
  damping_ = contact_ ? damping_ + std::clamp(damping - damping_, -damping_step, damping_step) : damping;
}

/// Of the set in use, as far as the stylus is inside its zone.
dvec3 ForceRenderer::pullOf(const Pose& X_DS) const {
  if (!has_set_) return dvec3(0.0);
  const GroupedSet& grouped = sets_[current_];
  const bool inside = lengthOf(metricDifference(X_DS, grouped.set.X_DR)) < grouped.set.zone_radius;
  return inside ? grouped.pullAt(X_DS) : dvec3(0.0);
}

dvec3 ForceRenderer::couplingForce(const Solved& solved) const {
  const double pull = glm::length(spring_D_);
  if (pull <= 0.0) return dvec3(0.0);
  // The coupling damps the stylus against the proxy; the controller damps the stylus itself, since on a convex surface
  // the proxy outruns the stylus and more of the coupling's damping would make energy instead of taking it.
  // Without a contact the proxy only catches up with the stylus: no motion to damp.
  const double damping = solved.contact ? damping_ : 0.0;
  const dvec3 force =
      spring_D_ - damping * (v_stylus_D_ - v_proxy_D_) - controller_damping_ * (v_stylus_D_ - solved.v_DO);
  const dvec3 outward = spring_D_ / pull;
  const double along = glm::dot(force, outward);
  return along < 0.0 ? force - along * outward : force;
}

/// A hand that lifts faster than the offset fades must not be pulled back by it: a spring that pushed ends at nothing.
dvec3 ForceRenderer::pushing(const dvec3& spring_D, const dvec3& left_D) const {
  const double along = glm::dot(spring_D, left_D);
  const bool pulled = glm::dot(spring_D_, left_D) < -kPull * glm::length(left_D);
  if (along >= 0.0 || pulled) return spring_D;
  return spring_D - left_D * (along / glm::dot(left_D, left_D));
}

/// What is left of a stretch to a spring that yields like a ductile metal at the force limit: beyond it the rest point
/// follows, and back it unloads along the full stiffness to nothing, never to a pull. It shortens the stretch but never
/// turns it, so that what holds the proxy decides the direction of the force.
dvec3 ForceRenderer::borne(const dvec3& stretch_D) {
  const double length = glm::length(stretch_D);
  yield_ = std::clamp(yield_, std::max(0.0, length - forceLimit() / stiffness_), length);
  return length > 0.0 ? stretch_D * (1.0 - yield_ / length) : stretch_D;
}

/// The account of what the hand put in by force, less what the coupling holds.
void ForceRenderer::observeEnergy(const dvec3& stylus_step, bool contact, double dt) {
  energy_ -= glm::dot(applied_D_, stylus_step);
  const double stored = storedEnergy(glm::length(spring_D_), stiffness_, limit_);
  balance_ = std::min(0.0, energy_ - stored);
  energy_ = stored + balance_;
  const double step = kControllerStep * dt / kMillisecond;
  const bool act = contact && balance_ < -kEnergyAllowance;
  controller_damping_ = std::clamp(controller_damping_ + (act ? step : -step), 0.0, kControllerLimit);
}

RenderResult ForceRenderer::tick(const Pose& X_DS_measured, double dt) {
  dt = std::isfinite(dt) ? std::clamp(dt, 1e-5, 0.1) : kMillisecond;
  if (!started_) reset(X_DS_measured);
  const Pose X_DS = X_DS_measured.isValid() ? X_DS_measured : stylus_;
  const dvec3 stylus_step = X_DS.p - stylus_.p;
  since_adoption_ += dt;
  sets_[current_].age = std::min(sets_[current_].age + dt, kOldestAge);

  SetJump jump;
  Solved solved;
  solved.X_DP = X_DS;
  if (offered_)
    solved = changeSet(X_DS, dt, jump);
  else if (has_set_)
    solved = moveProxy(sets_[current_], X_DS, dt);

  const dvec3 stretch_D = stretchOf(solved, X_DS);
  const dvec3 proxy_step = takeOutJump(solved, stretch_D, jump, stylus_step, dt);
  filterVelocities(stylus_step, proxy_step, dt);
  decayOffset(solved, stylus_step, dt);
  held_stiffness_ = stiffness_;
  updateCoupling(solved, dt);

  const bool free = solved.active_rows == 0 && offset_D_ == dvec3(0.0);
  const dvec3 left_D = borne(free ? dvec3(0.0) : stretch_D);
  const dvec3 wanted_D = limited(pushing(left_D + offset_D_, left_D), forceLimit() / stiffness_);
  // What moves the obstacle pays as well as the hand does.
  const dvec3 relative_step = stylus_step - dt * solved.v_DO;
  const dvec3 spring_D = rationed(wanted_D, relative_step, dt);
  offset_D_ = spring_D - left_D;
  spring_D_ = stiffness_ * spring_D;
  observeEnergy(relative_step, solved.contact, dt);
  proxy_ = solved.X_DP;
  stylus_ = X_DS;
  contact_ = solved.contact;

  RenderResult result;
  result.X_DP = proxy_;
  result.spring_D = spring_D_;
  result.force_D = couplingForce(solved);
  result.v_DS = v_stylus_D_;
  result.v_DO = solved.v_DO;
  result.offset_D = offset_D_;
  result.active_rows = solved.active_rows;
  result.contact = solved.contact;
  result.at_zone_edge = solved.trust;
  result.energy = balance_;
  result.stiffness = stiffness_;
  result.controller_damping = controller_damping_;
  result.adopted_set = has_set_ ? sets_[current_].set.sequence : 0;
  applied_D_ = wanted_D_ = result.force_D;
  load_D_ = result.load_D = load_.tick(X_DS.p, v_stylus_D_, dt) + pullOf(X_DS);
  result.force_D += load_D_;
  limit_ = std::numeric_limits<double>::infinity();
  return result;
}

}  // namespace hapticell::haptic
