// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/renderer_options.h"

#include <algorithm>
#include <cmath>

#include "haptic/rendering/coupling_gains.h"
#include "haptic/rendering/positive_or.h"

namespace hapticell::haptic {

namespace {

// N/m at 1 ms of delay: 0.65 of 2.3 N/mm (docs/dev/feel.md, Delay and stiffness); M10 finds 2.2 N/mm for a stylus let
// go. Half: contacts half as stiff; twice: above that, so it swings.
constexpr double kStablePerMillisecond = 0.65 * 2300.0;

}  // namespace

RendererOptions limitedByDelay(RendererOptions options) {
  const RendererOptions defaults;
  options.stiffness = positiveOr(options.stiffness, defaults.stiffness);
  options.damping = positiveOr(options.damping, defaults.damping);
  options.delay = positiveOr(options.delay, defaults.delay);
  options.peak_force = positiveOr(options.peak_force, defaults.peak_force);
  options.peak_torque = positiveOr(options.peak_torque, 0.0);
  options.tick = positiveOr(options.tick, defaults.tick);
  if (!options.adapt) return options;
  const double ticks = std::max(1.0, options.delay / 0.001);
  options.stiffness = std::min(options.stiffness, kStablePerMillisecond / ticks);
  options.damping = std::min(options.damping, kDampingLimit);
  if (ticks >= 1.999) options.damping = std::max(options.damping, 4.0);
  return options;
}

}  // namespace hapticell::haptic
