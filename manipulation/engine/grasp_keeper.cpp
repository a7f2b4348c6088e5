// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/grasp_keeper.h"

#include <algorithm>
#include <map>

namespace hapticell::manipulation {

namespace {

/// rad that the fingers (their mean) or the thumb must open to let go: 11 deg, over the noise of a glove. Our choice.
/// Half: lets go by itself; twice: the hand must open wide.
constexpr double kOpened = 0.2;
/// rad: a flat hand that rests on something does not take it. Our choice. Half: a hand laid on a part takes it; twice:
/// thin parts are not taken.
constexpr double kClosing = 0.15;
constexpr unsigned kThumbOrPalm = (1u << 0) | (1u << 5), kFingers = 0b11110u;
constexpr std::array<const char*, 5> kNames{"thumb", "index", "middle", "ring", "pinky"};

}  // namespace

int fingerOfLink(const std::string& link, mannequin::Side side) {
  const char* const prefix = side == mannequin::Side::kLeft ? "l_" : "r_";
  if (link.rfind(prefix, 0) != 0) return -1;
  const std::string name = link.substr(2);
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (name.rfind(kNames[i], 0) == 0) return static_cast<int>(i);
  }
  return name == "wrist" || name == "hand" ? 5 : -1;
}

GraspKeeper::Change GraspKeeper::look(const Look& look, const std::function<bool(workcell::EntityId)>& may_take) {
  if (held_ != 0) {
    double fingers = 0.0, taken = 0.0;
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      taken_[i] = std::max(taken_[i], look.bend[i]);
      if (i > 0) fingers += 0.25 * look.bend[i], taken += 0.25 * taken_[i];
    }
    if (fingers > taken - kOpened && look.bend[0] > taken_[0] - kOpened) return {};
    return {.let_go = std::exchange(held_, 0)};
  }
  std::map<workcell::EntityId, unsigned> touching;
  for (const PairState& pair : look.pairs) {
    if (!pair.contact || (pair.moved != look.hand && pair.other != look.hand) || pair.moved == pair.other) continue;
    const bool moved = pair.moved == look.hand;
    const int finger = fingerOfLink(moved ? pair.moved_part : pair.other_part, look.side);
    if (finger >= 0) touching[moved ? pair.other : pair.moved] |= 1u << finger;
  }
  const double most = *std::max_element(look.bend.begin() + 1, look.bend.end());
  for (const auto& [entity, by] : touching) {
    if ((by & kThumbOrPalm) == 0 || (by & kFingers) == 0 || most < kClosing || !may_take(entity)) continue;
    held_ = entity;
    taken_ = look.bend;
    return {.taken = entity};
  }
  return {};
}

}  // namespace hapticell::manipulation
