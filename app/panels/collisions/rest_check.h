// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "manipulation/engine/scene_snapshot.h"
#include "manipulation/scene/rest_pairs.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {
class PreparedScene;
}

namespace hapticell::app {

/// Measures the present cell in a thread of the pool while nothing is held: distances of the chosen entity, and what
/// touches. Its owner polls it (GUI thread); it never blocks, and never outlives what it needs.
class RestCheck {
 public:
  /// m; pairs farther apart are not listed; our choice. Half: parts a hand's length away are missing; twice: more
  /// pairs, and more time to measure them.
  static constexpr double kMeasured = 0.3;

  /// Starts the measurements that are due: distances of `moved` (0: none) if the scene or the entity changed; touching
  /// pairs if other entities are in the scene, one is attached to something else, or askAgain() was called.
  void watch(const std::shared_ptr<const manipulation::PreparedScene>& scene, workcell::EntityId moved);
  /// Takes the finished results; true if there were any.
  bool takeResults();
  /// Distances of the entity that was asked for last; empty until they are measured.
  const std::vector<manipulation::PairState>& distances() const { return distances_; }
  /// Pair rules that exclude what touches at rest, and what overlaps deeply.
  struct Touching {
    std::vector<workcell::PairRule> pairs;
    std::vector<manipulation::DeepOverlap> deep;
  };
  /// Once for each finding; empty if there is nothing to ask about.
  std::optional<Touching> takeTouching();
  /// Makes the next watch() look for touching pairs again.
  void askAgain() { asked_entities_.reset(); }
  /// `scene` is not the one that was looked at last.
  bool isOutdated(const std::shared_ptr<const manipulation::PreparedScene>& scene) const {
    return scene && measured_scene_.lock() != scene;
  }
  bool isBusy() const { return job_ != nullptr; }

 private:
  /// An entity and what it is attached to: if one of these changes, touching pairs are asked about again.
  struct Standing {
    workcell::EntityId entity;
    std::string to, link;
    auto operator<=>(const Standing&) const = default;
  };
  struct Job;
  std::shared_ptr<Job> job_;
  std::weak_ptr<const manipulation::PreparedScene> measured_scene_;
  workcell::EntityId measured_ = 0;
  std::vector<manipulation::PairState> distances_;
  std::optional<std::set<Standing>> asked_entities_;
  std::optional<Touching> touching_;
};

}  // namespace hapticell::app
