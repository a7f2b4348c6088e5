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

/// What a gloved hand holds: it takes an entity when the thumb (or the palm) and a finger close on it, and releases it
/// when thumb or fingers open again. A value; no thread, no document.
class GraspKeeper {
 public:
  /// Bending of thumb and fingers measured by the glove, rad, thumb first.
  using Bend = std::array<double, 5>;

  struct Look {
    std::span<const PairState> pairs;  ///< Of the newest snapshot.
    workcell::EntityId hand = 0;       ///< The mannequin or free hand.
    mannequin::Side side = mannequin::Side::kRight;
    Bend bend{};
  };
  /// The change of this call: at most one of both.
  struct Change {
    workcell::EntityId taken = 0;
    workcell::EntityId let_go = 0;
  };
  /// `may_take` decides whether an entity may be taken.
  Change look(const Look& look, const std::function<bool(workcell::EntityId)>& may_take);

  workcell::EntityId held() const { return held_; }
  /// The held entity no longer exists, or another hand took it.
  void forget() { held_ = 0; }

 private:
  workcell::EntityId held_ = 0;
  Bend taken_{};  ///< Largest bending of each since the entity was taken.
};

}  // namespace hapticell::manipulation
