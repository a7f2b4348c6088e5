// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "geometry/system/error.h"
#include "geometry/system/text.h"
#include "manipulation/manipulators/manipulator.h"
#include "manipulation/scene/prepared_scene.h"

namespace hapticell::agents {

/// A pair that is near, with its exact distance.
struct NearPair {
  std::size_t index = 0;  ///< The pair's number; the same in all answers.
  int link = 0;           ///< Of the moved entity, its part A.
  int other_link = -1;    ///< Another link of it; -1: an obstacle.
  double distance = 0.0;  ///< m
  dvec3 p_WA{0.0}, p_WB{0.0};
  dvec3 nhat_W{0.0, 0.0, 1.0};  ///< Unit, from B to A.
};

/// The exact distances between the moved entity (with all that it carries) and the cell, and between its own parts, and
/// which steps surely enter no contact. It checks the pairs that a hold of the entity checks. One thread.
///
/// A step is proven by the ways of its parts: no point of a part goes farther than the bound that the joints' turns and
/// its lever give (conservative advancement, Mirtich 1996), and that is less than the distance. Checks of written
/// motions use code of their own (manipulation/checks/path_check.h).
class Clearances {
 public:
  /// Pairs that touch at `start` are left out; see note(). Errors: no such entity.
  static Expected<Clearances> create(std::shared_ptr<const manipulation::PreparedScene> scene,
                                     workcell::EntityId entity, const manipulation::EntityConfiguration& start,
                                     const config::Configuration& configuration);
  Clearances(Clearances&&) noexcept;
  Clearances& operator=(Clearances&&) noexcept;
  ~Clearances();
  /// The same pairs without any answers known, for another thread or a run that must not depend on earlier ones.
  Clearances fresh() const;

  /// All pairs nearer than `within` (m) at a configuration, nearest first.
  const std::vector<NearPair>& look(const manipulation::EntityConfiguration& at, double within);
  /// Of the last look().
  const std::vector<NearPair>& near() const;

  /// The share (0 to 1) of a step from the last look()'s configuration that certainly brings no pair into contact.
  double safeShare(const manipulation::EntityConfiguration& to) const;

  /// "link_4 and post 2"
  Text wordsOf(const NearPair& pair) const;
  /// The pairs that touch at the start.
  const std::vector<NearPair>& touchingAtStart() const;
  /// What touches at the start and is therefore not checked; empty: nothing.
  const Text& note() const;

  /// A placed part of the cell that the entity is checked against.
  struct Obstacle {
    std::shared_ptr<const collision::MeshCollider> collider;
    Pose X_WO;
    workcell::EntityId entity = 0;
  };
  std::span<const Obstacle> obstacles() const;

 private:
  struct Plan;
  struct State;
  Clearances(std::shared_ptr<const Plan> plan, std::unique_ptr<State> state);

  std::shared_ptr<const Plan> plan_;
  std::unique_ptr<State> state_;
};

}  // namespace hapticell::agents
