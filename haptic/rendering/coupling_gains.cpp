// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/coupling_gains.h"

#include <algorithm>

namespace hapticell::haptic {

namespace {

/// s (docs/dev/feel.md, 7). Half passes the tests of this folder and of tests/feel, twice fails
/// ForceRendererEnergy.AProxyThatCatchesUpDragsNobodyAlong.
constexpr double kDamperFade = 0.01;
/// s for a whole change of stiffness in contact. Half and twice pass the tests of this folder and of tests/feel.
constexpr double kStiffnessTime = 0.1;

}  // namespace

void CouplingGains::take(const RendererOptions& options) {
  stiffness_ = options.stiffness;
  damping_ = options.damping;
}

void CouplingGains::reset(const RendererOptions& options) {
  take(options);
  damper_ = 0.0;
  arriving_ = false;
}

void CouplingGains::approach(const ProxyStep& solved, const RendererOptions& options, bool contact, double dt) {
  const double wanted = solved.stiffness > 0.0 ? std::min(solved.stiffness, options.stiffness) : options.stiffness;
  const double step = options.stiffness * dt / kStiffnessTime;
  stiffness_ = contact ? stiffness_ + std::clamp(wanted - stiffness_, -step, step) : wanted;
  const double damping = std::clamp(solved.damping, options.damping, std::max(options.damping, kDampingLimit));
  const double damping_step = damping * dt / kStiffnessTime;
  damping_ = contact ? damping_ + std::clamp(damping - damping_, -damping_step, damping_step) : damping;
}

void CouplingGains::updateDamper(bool contact, bool catches_up, double dt) {
  arriving_ = catches_up || (arriving_ && contact && damper_ < 1.0);
  const double step = dt / kDamperFade;
  if (!contact || catches_up)
    damper_ = std::max(0.0, damper_ - step);
  else
    damper_ = arriving_ ? std::min(1.0, damper_ + step) : 1.0;
}

}  // namespace hapticell::haptic
