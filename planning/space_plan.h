// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <vector>

#include "collision/trees/mesh_collider.h"
#include "geometry/shapes/bounds.h"
#include "manipulation/holding/held_pairs.h"
#include "planning/free_space.h"
#include "planning/standing_figure.h"

namespace hapticell::planning {

/// Values of a joint; at first none.
struct FreeRange {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  bool holds(double q) const { return lower <= q && q <= upper; }
};

/// A pair that is checked: parts of the space's scene, by index, and who they are.
struct CheckedPair : manipulation::Manipulator::OwnPair {
  bool own = false;
  bool is_lasting = false;  ///< They touch whatever the joints are.
  std::vector<std::size_t> joints =
      {};  ///< Of an own pair: those that move the two against each other; a robot's only.
  Blocker words = {};
};

/// What of the entity moves.
struct MovedChoice {
  std::optional<mannequin::Side> hand = {};  ///< Of a mannequin.
  bool with_axes = false;                    ///< The external axes of a robot too.
};

/// What a FreeSpace moves and checks, and what follows from it once for all: shared by all its copies, constant but for
/// what is found at the first question. Any thread.
class SpacePlan {
 public:
  /// As FreeSpace::create().
  static Expected<std::shared_ptr<const SpacePlan>> create(std::shared_ptr<const manipulation::PreparedScene> scene,
                                                           workcell::EntityId entity,
                                                           const config::Configuration& configuration,
                                                           const manipulation::Placements& placements,
                                                           const MovedChoice& choice);

  const manipulation::HeldModel& model() const { return model_; }
  const manipulation::Manipulator& manipulator() const { return *manipulator_; }
  /// Of a mannequin whose hand moves; null: a robot or a solid.
  const StandingFigure* figure() const { return figure_.get(); }
  /// Moved parts with the cell: CheckedPair::other counts on from the moved parts through obstacles().
  const std::vector<CheckedPair>& pairs() const { return pairs_; }
  const std::vector<CheckedPair>& ownPairs() const { return own_pairs_; }
  const std::vector<std::shared_ptr<const collision::MeshCollider>>& obstacles() const { return obstacles_; }
  const std::vector<Pose>& obstaclePoses() const { return X_WO_; }
  /// Around the moved parts.
  const std::vector<manipulation::PartSphere>& spheres() const { return spheres_; }
  const geometry::Bounds& obstacleBounds() const { return obstacle_bounds_; }
  const EntityConfiguration& present() const { return present_; }
  double radius() const { return radius_; }
  const Text& note() const { return note_; }

  /// Where the one joint between an own pair keeps it apart, whatever the other joints are: one for each of ownPairs().
  /// Proven once, from the present value to both limits, at the first question: links beside each other are so near
  /// that each motion's own proof takes hundreds of distances.
  const std::vector<FreeRange>& freeRanges() const;

 private:
  explicit SpacePlan(manipulation::HeldModel held) : model_(std::move(held)) {}
  FreeRange freeRangeOf(const CheckedPair& pair) const;
  void addPairs(const manipulation::HeldPairs& held);
  void addObstacles(const manipulation::HeldPairs& held);
  void leaveOutLasting();
  bool standsStill(int link) const;
  bool touches(const CheckedPair& pair, const std::vector<Pose>& X_WP) const;
  EntityConfiguration anywhere(std::mt19937_64& random) const;
  void addNote(const Text& more);

  manipulation::HeldModel model_;
  std::unique_ptr<manipulation::Manipulator> manipulator_;
  std::unique_ptr<const StandingFigure> figure_;
  std::vector<CheckedPair> pairs_, own_pairs_;
  std::vector<std::shared_ptr<const collision::MeshCollider>> obstacles_;
  std::vector<Pose> X_WO_;
  std::vector<manipulation::PartSphere> spheres_;
  geometry::Bounds obstacle_bounds_;
  EntityConfiguration present_;
  double radius_ = 0.0;
  Text note_;
  mutable std::once_flag ranges_known_;
  mutable std::vector<FreeRange> ranges_;  ///< Of own_pairs_.
};

}  // namespace hapticell::planning
