// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>

#include "manipulation/scene/pair_state.h"
#include "mannequin/body/skeleton.h"

namespace hapticell::manipulation {

/// Which finger of a hand a link belongs to: 0 thumb .. 4 little finger, 5 the hand itself; -1 for everything else.
int fingerOfLink(const std::string& link, mannequin::Side side);

/// What a gloved hand holds: it takes a thing that the thumb (or the palm) and a finger have closed on, and lets it go
/// when thumb or fingers open again. A value; no thread, no document.
class GraspKeeper {
 public:
  /// How far thumb and fingers are bent as the glove has them, rad, thumb first.
  using Bend = std::array<double, 5>;

  struct Look {
    std::span<const PairState> pairs;  ///< Of the newest snapshot.
    workcell::EntityId hand = 0;       ///< The mannequin or free hand.
    mannequin::Side side = mannequin::Side::kRight;
    Bend bend{};
  };
  /// What this look brought: at most one of both.
  struct Change {
    workcell::EntityId taken = 0;
    workcell::EntityId let_go = 0;
  };
  /// `may_take` says whether an entity may be carried off.
  Change look(const Look& look, const std::function<bool(workcell::EntityId)>& may_take);

  workcell::EntityId held() const { return held_; }
  /// What was held is gone, or somebody else took it.
  void forget() { held_ = 0; }

 private:
  workcell::EntityId held_ = 0;
  Bend taken_{};  ///< The most that each was bent since it was taken.
};

}  // namespace hapticell::manipulation
