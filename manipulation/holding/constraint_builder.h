// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "collision/contacts/contact_finder.h"
#include "collision/surfaces/surface_model.h"
#include "collision/contacts/zone_contacts.h"
#include "manipulation/holding/free_motion.h"
#include "manipulation/manipulators/manipulator.h"
#include "manipulation/holding/motion_mapping.h"
#include "manipulation/manipulators/part_differential.h"

namespace hapticell::manipulation {

/// How one pair (moved part against obstacle) is felt.
struct PairFeel {
  bool felt = true;        ///< False: not in the set (`pass`).
  double boundary = 0.0;   ///< m: the distance that is felt as contact.
  double stiffness = 0.0;  ///< N/m; 0: the device's own.
  double damping = 0.0;
  double friction = 0.0;
};

/// A pair that intersects and is let out one way only: gap + nhat_W . v for a motion v of the moved part at p_W.
struct FreeingPlane {
  std::uint32_t pair = 0;
  dvec3 p_W{0.0};
  dvec3 nhat_W{0.0, 0.0, 1.0};
  double gap = 0.0;  ///< m: how far it has come back from where it was freest.
};

/// What a constraint set is made of. Parts and obstacles are those of the motion check, `feel` is in the order of
/// `pairs`. All spans outlive the call.
struct ConstraintInputs {
  const Manipulator& manipulator;
  const EntityConfiguration& configuration;  ///< Accepted: the reference of the set.
  const MotionMapping& mapping;
  Pose X_DNear;  ///< The proxy: supplies what the mapping's filters hide of the reference.
  double zone_radius = haptic::kWantedZoneRadius;  ///< Hand space, m.
  double turn_ahead = 0.1;  ///< rad that the entity is expected to turn at most before the next set.
  std::span<const collision::ConvexPieces* const> parts;  ///< One a part.
  std::span<const collision::ZonePart> obstacles;
  std::span<const MotionPair> pairs;
  std::span<const PairFeel> feel;
  /// What the sets before have learnt; null: facets only, from scratch.
  collision::ContactFinder* finder = nullptr;
  std::span<const collision::SurfaceModel* const> surfaces{};  ///< One a part, or none at all: facets only.
  bool only_complete = false;                                  ///< See collision::ZoneOptions::only_complete.
  /// Nearest points of the pairs of moved parts (MotionPair::other_part): a tangent plane each.
  std::span<const FreeMotion::PairDistance> own{};
  std::span<const FreeingPlane> freeing{};  ///< Their pairs are not `felt` otherwise.
};

/// One entry's origin, in the order of ConstraintSet::constraints.
struct ConstraintOrigin {
  int pair = -1;   ///< Index of the pair; -1 for a limit of the entity itself.
  int limit = -1;  ///< Index into BuiltConstraints::limits.
};

struct BuiltConstraints {
  haptic::ConstraintSet set;
  std::vector<ConstraintOrigin> origins;
  std::vector<MotionLimit> limits;  ///< The entity's own limits within the zone.
  bool complete = true;             ///< False: see collision::ZoneContacts::complete.
  bool pending = false;             ///< See collision::ZoneContacts::pending.
  bool facets = false;              ///< See collision::ZoneContacts::facets.
  double turn = 0.0;                ///< rad that the entity may turn in it, where that is bounded: see dropTurnBound().
  double cost = 0.0;                ///< s that such a set takes to make, reckoned and not measured: repeats exactly.
};

/// A set before its contacts are known: what is to be looked for, and all that the answer is turned into rows with. It
/// refers to the shapes of the parts only.
struct ConstraintDraft {
  std::vector<collision::ZonePart> moving;
  std::vector<std::uint8_t> mask;  ///< What ZoneOptions::pair_mask is set to.
  collision::ZoneOptions options;
  Pose X_WM;  ///< The moved frame at the reference.
  Pose X_DR;
  MotionMapping mapping;
  double zone_radius = 0.0, turn_ahead = 0.0;
  std::vector<PartDifferential> differentials;
  std::vector<int> pair_of;  ///< part * obstacles + obstacle -> pair, -1 where unchecked.
  std::size_t obstacles = 0;
  std::vector<PairFeel> feel;
  std::vector<MotionLimit> limits;
  struct OwnRow {
    haptic::Constraint constraint;
    int pair = -1;
  };
  std::vector<OwnRow> own;
};

ConstraintDraft draftConstraints(const ConstraintInputs& inputs);

/// The set, from what a collision::ContactFinder answered to the draft. Obstacles have meanwhile gone by `gone_W` (m,
/// one each; empty: none has).
BuiltConstraints completed(const ConstraintDraft& draft, const collision::ZoneContacts& found,
                           std::span<const dvec3> gone_W = {});

/// The same set about another reference: what was found a moment ago, for where the entity is now. `X_DR` is where the
/// set's reference is meant to be by the mapping of now.
void moveReference(BuiltConstraints& built, const Pose& X_DR, const Pose& X_DNow);

/// Everything that the hand can feel from this configuration: contacts with their curvature, the entity's own limits,
/// all mapped to the hand's space about the device pose that means this configuration (gap less the pair's boundary).
BuiltConstraints buildConstraints(const ConstraintInputs& inputs);

/// A plainer set for shapes too crowded for a complete one: a plane at the nearest points of each near pair (the
/// paper's own way, several pairs at once), good for `zone_radius`. What it does not know the exact motion check still
/// stops.
BuiltConstraints buildPlainConstraints(const ConstraintInputs& inputs, std::span<const FreeMotion::PairDistance> near);

/// Takes out the row that keeps turning within `turn`: for an entity whose turn follows from its place, so that the
/// zone bounds both.
void dropTurnBound(BuiltConstraints& built);

/// Smallest value (hand space, m) of any of a pair's groups for the stylus (or proxy) at X_DP: the entry with the
/// largest value counts for its group. Infinite for pairs that are not in the set. One entry for each pair.
void pairGaps(const BuiltConstraints& built, const Pose& X_DP, std::span<double> gaps);

}  // namespace hapticell::manipulation
