// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/finger_contact.h"

#include <algorithm>

#include "manipulation/engine/grasp_keeper.h"

namespace hapticell::app {
namespace {

/// Of the full strength: felt through the glove's fabric; by trial. Half: light contacts are not felt; twice: pressing
/// makes little difference.
constexpr double kTouch = 0.35;

}  // namespace

FingerVibration fingerVibration(const manipulation::SceneSnapshot& snapshot, workcell::EntityId figure,
                                mannequin::Side side, double peak_n) {
  const double pressed =
      peak_n > 0.0 && snapshot.stylus.forces_on ? std::clamp(snapshot.stylus.force_n / peak_n, 0.0, 1.0) : 0.0;
  FingerVibration strength{};
  for (const manipulation::PairState& pair : snapshot.pairs) {
    if (!pair.contact) continue;
    const bool moved = pair.moved == figure;
    if (!moved && pair.other != figure) continue;
    const int vibrator = manipulation::fingerOfLink(moved ? pair.moved_part : pair.other_part, side);
    if (vibrator >= 0) strength[static_cast<std::size_t>(vibrator)] = kTouch + (1.0 - kTouch) * pressed;
  }
  return strength;
}

}  // namespace hapticell::app
