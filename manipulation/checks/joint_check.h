// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "collision/queries/scene.h"
#include "config/configuration.h"
#include "geometry/system/error.h"
#include "geometry/system/text.h"
#include "manipulation/scene/prepared_scene.h"

namespace hapticell::manipulation {

/// What becomes of pairs that touch while the robot is as in the scene.
enum class RestContacts {
  kCount,            ///< They count like all others.
  kLeaveOut,         ///< They are left out, as collisionAt() does (a robot on its table).
  kLeaveOutLasting,  ///< Those are left out that touch at joint positions all over the robot's ranges too.
};

/// A part of the robot and something of the cell near it.
struct NearPair {
  std::uint32_t pair = 0;  ///< For JointCheck::placed().
  double distance = 0.0;   ///< m; 0 in contact.
};

/// Two shapes where they are, and who they are: "robot/link_4" and "fixture".
struct PlacedPair {
  std::shared_ptr<const collision::MeshCollider> a, b;
  Pose X_WA, X_WB;
  std::string first, second;
};

/// Exact contact checks of one robot (or mechanism) at many joint positions, each by itself: no motion between them is
/// checked. It checks what a hold of the entity checks (HeldEntity): its parts and what it carries against the cell, and
/// against each other. Pairs whose contact mode is pass are left out.
///
/// One object belongs to one thread; fresh() makes one for another thread. Answers of isFree() do not depend on what was
/// asked before.
class JointCheck {
 public:
  /// Everything else stays at its place in the scene; external axes of the robot too, unless `with_axes`: then joints
  /// are those of HeldModel, the axes' first. Errors: no such entity, not a robot or mechanism. A locked one may be
  /// checked.
  static Expected<JointCheck> create(std::shared_ptr<const PreparedScene> scene, workcell::EntityId entity,
                                     const config::Configuration& configuration,
                                     RestContacts at_rest = RestContacts::kCount, bool with_axes = false);
  /// The same checks for another thread.
  JointCheck fresh() const;

  /// True if nothing touches or intersects at these joints (one number a variable, rad or m), and no pair is nearer than
  /// `clearance` (m) where that is above 0.
  bool isFree(const std::vector<double>& joints, double clearance = 0.0);
  /// The least distance (m) between the entity's parts and the cell, up to `limit`; 0 in contact. Its links against each
  /// other do not count.
  double clearance(const std::vector<double>& joints, double limit);
  /// All such pairs nearer than `limit`, with their distances, in no order; `near` is emptied first. What no joint moves
  /// is not among them.
  void nearer(const std::vector<double>& joints, double limit, std::vector<NearPair>& near);
  /// One of these pairs at any joints.
  PlacedPair placed(const std::vector<double>& joints, std::uint32_t pair);
  /// The first contact in words, "link_4 would touch Fixture"; empty if it is free.
  Text contactAt(const std::vector<double>& joints);

  /// A contact of a part that no joint moves (the base), whatever the joints are: isFree() is then false. Empty: none.
  const Text& baseContact() const;
  const workcell::Entity& entity() const;
  /// The note about what touches at rest and is therefore not checked; empty: nothing.
  const Text& note() const;

 private:
  struct Plan;
  explicit JointCheck(std::shared_ptr<const Plan> plan);
  void leaveOutTouching(Plan& plan, RestContacts which);
  bool touchesEverywhere(collision::PairIndex pair);
  void place(const std::vector<double>& joints, collision::Scene& scene);
  Text wordsOf(collision::PairIndex pair) const;

  std::shared_ptr<const Plan> plan_;
  collision::Scene scene_;      ///< Parts of the robot first, then the obstacles; all pairs.
  collision::Scene obstacles_;  ///< The same parts, without the pairs of two own parts.
  std::vector<Pose> X_BL_;      ///< Scratch.
};

}  // namespace hapticell::manipulation
