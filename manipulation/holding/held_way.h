// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "haptic/rendering/active_set_solver.h"
#include "manipulation/holding/held_state.h"

namespace hapticell::manipulation {

/// Half-spaces over small motions of the hand.
struct HalfSpaces {
  std::array<haptic::SolverRow, haptic::kMaxRows> rows{};
  std::size_t count = 0;
  /// Ignored if there is no space left.
  void add(const haptic::SolverRow& row) {
    if (count < rows.size()) rows[count++] = row;
  }
  std::span<const haptic::SolverRow> all() const { return {rows.data(), count}; }
  /// The hand has moved by `d`.
  void moveBy(const haptic::Vector6& d);
};

/// How a held entity moves: as far as the way is free, and along obstacles. Remembers recent obstacles. Manipulation
/// thread only.
class HeldWay {
 public:
  /// Result of following the hand.
  struct Followed {
    bool blocked = false;    ///< Something blocked the straight motion.
    bool stopped = false;    ///< By a pair in mode *Stop*.
    int hurried_joint = -1;  ///< A joint that moved at its greatest speed and has not arrived; -1: no such joint.
  };
  /// Result of a straight motion.
  struct Gone {
    double share = 1.0;  ///< Share of the motion that was made.
    bool blocked = false;
    std::uint32_t pair = 0;  ///< If blocked: the index of the blocking pair.
  };

  /// `state` outlives this.
  explicit HeldWay(HeldState& state) : state_(state) {}

  /// See the functions of HeldEntity with the same names.
  Followed follow(const Pose& X_DP, const MotionMapping& mapping, const BuiltConstraints* built, double duration_s);
  Gone goTo(const EntityConfiguration& target);
  double moveOther(workcell::EntityId other, const dvec3& way_W);
  void placeOther(workcell::EntityId other, const EntityConfiguration& at);

 private:
  /// Contacts that blocked the way, and how far (m of hand motion) the entity has moved since each was found.
  struct Contacts {
    HalfSpaces spaces;
    std::array<double, haptic::kMaxRows> moved{};
    void found(const haptic::SolverRow& row);
    void moveBy(const haptic::Vector6& d);
    void forgetOld();
  };
  void addSoftRows(const BuiltConstraints* built, const MotionMapping& mapping, HalfSpaces& spaces) const;
  haptic::SolverRow contactRow(const MotionAnswer& answer, const MotionMapping& mapping, double rest) const;
  haptic::Constraint contactOf(const MotionPair& pair, const collision::DistanceResult& found) const;
  bool recall(const MotionMapping& mapping, const Pose& X_WWanted);
  void forget();

  HeldState& state_;
  Contacts contacts_;
  dquat axes_{1.0, 0.0, 0.0, 0.0};              ///< The mapping's axes when the contacts were found.
  double scale_ = 0.0;                          ///< Its scale then.
  Pose X_WWanted_;                              ///< Target of the last step,
  Followed followed_;                           ///< and its result.
  bool known_ = false;                          ///< The same target gives the same result.
  std::vector<FreeMotion::PairDistance> near_;  // Scratch.
};

}  // namespace hapticell::manipulation
