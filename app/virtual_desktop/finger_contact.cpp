// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/finger_contact.h"

#include <algorithm>
#include <string>

namespace hapticell::app {
namespace {

constexpr double kTouch = 0.35;  ///< Of the full strength: felt through the glove's fabric.
constexpr const char* kFingers[]{"thumb", "index", "middle", "ring", "pinky"};

/// Which vibrator a link of the figure belongs to; -1: none of this hand's.
int vibratorOf(const std::string& link, mannequin::Side side) {
  const char* const prefix = side == mannequin::Side::kLeft ? "l_" : "r_";
  if (link.rfind(prefix, 0) != 0) return -1;
  for (int i = 0; i < 5; ++i) {
    if (link.compare(2, std::string(kFingers[i]).size(), kFingers[i]) == 0) return i;
  }
  return link == std::string(prefix) + "wrist" || link == std::string(prefix) + "hand" ? 5 : -1;
}

}  // namespace

FingerVibration fingerVibration(const manipulation::SceneSnapshot& snapshot, workcell::EntityId figure,
                                mannequin::Side side, double peak_n) {
  const double pressed = peak_n > 0.0 && snapshot.forces_on ? std::clamp(snapshot.force_n / peak_n, 0.0, 1.0) : 0.0;
  FingerVibration strength{};
  for (const manipulation::PairState& pair : snapshot.pairs) {
    if (!pair.contact) continue;
    const bool moved = pair.moved == figure;
    if (!moved && pair.other != figure) continue;
    const int vibrator = vibratorOf(moved ? pair.moved_part : pair.other_part, side);
    if (vibrator >= 0) strength[static_cast<std::size_t>(vibrator)] = kTouch + (1.0 - kTouch) * pressed;
  }
  return strength;
}

}  // namespace hapticell::app
