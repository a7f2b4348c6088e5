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
  /// Nothing where there is no room left.
  void add(const haptic::SolverRow& row) {
    if (count < rows.size()) rows[count++] = row;
  }
  std::span<const haptic::SolverRow> all() const { return {rows.data(), count}; }
  /// The hand has gone by `d`.
  void moveBy(const haptic::Vector6& d);
};

/// How a held entity moves: as far as it is free, and along what stands in the way. Remembers what stood there lately.
/// Manipulation thread only.
class HeldWay {
 public:
  /// How following the hand went.
  struct Followed {
    bool blocked = false;    ///< Something stood in the way of the straight motion.
    bool stopped = false;    ///< By a pair that stops.
    int hurried_joint = -1;  ///< One that went as fast as it may while there is way left; -1: none did.
  };
  /// How far a straight way was free.
  struct Gone {
    double share = 1.0;  ///< Of the way that was gone.
    bool blocked = false;
    std::uint32_t pair = 0;  ///< Where blocked: the index of what stood in the way.
  };

  /// `state` outlives this.
  explicit HeldWay(HeldState& state) : state_(state) {}

  /// See the functions of HeldEntity with the same names.
  Followed follow(const Pose& X_DP, const MotionMapping& mapping, const BuiltConstraints* built, double duration_s);
  Gone goTo(const EntityConfiguration& target);
  double moveOther(workcell::EntityId other, const dvec3& way_W);
  void placeOther(workcell::EntityId other, const EntityConfiguration& at);

 private:
  /// Contacts that stood in the way, and how far (m of hand) it has gone since each was found.
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
  dquat axes_{1.0, 0.0, 0.0, 0.0};              ///< The mapping's, when the contacts were found.
  double scale_ = 0.0;                          ///< The same.
  Pose X_WWanted_;                              ///< Of the last step,
  Followed followed_;                           ///< and what came of it.
  bool known_ = false;                          ///< The same wish has the same answer.
  std::vector<FreeMotion::PairDistance> near_;  // Scratch.
};

}  // namespace hapticell::manipulation
