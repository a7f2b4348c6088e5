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

/// A pair that intersects and may come apart in one direction only: gap + nhat_W . v for a motion v of the moved part
/// at p_W.
struct FreeingPlane {
  std::uint32_t pair = 0;
  dvec3 p_W{0.0};
  dvec3 nhat_W{0.0, 0.0, 1.0};
  double gap = 0.0;  ///< m: how far it has moved back from its freest pose.
};

/// Inputs of a constraint set. Parts and obstacles are those of the motion check, `feel` is in the order of `pairs`.
/// All spans outlive the call.
struct ConstraintInputs {
  const Manipulator& manipulator;
  const EntityConfiguration& configuration;  ///< The accepted one: the reference of the set.
  const MotionMapping& mapping;
  Pose X_DNear;  ///< The proxy; it supplies the components of the reference that the mapping's filters remove.
  double zone_radius = haptic::kWantedZoneRadius;  ///< Hand space, m.
  double turn_ahead = 0.1;  ///< Largest expected rotation of the entity before the next set, rad.
  std::span<const collision::ConvexPieces* const> parts;  ///< One per part.
  std::span<const collision::ZonePart> obstacles;
  std::span<const MotionPair> pairs;
  std::span<const PairFeel> feel;
  /// Keeps data from earlier sets; null: facets only, without earlier data.
  collision::ContactFinder* finder = nullptr;
  std::span<const collision::SurfaceModel* const> surfaces{};  ///< One per part; empty: facets only.
  bool only_complete = false;                                  ///< See collision::ZoneOptions::only_complete.
  /// Nearest points of the pairs of moved parts (MotionPair::other_part): each gives a tangent plane.
  std::span<const FreeMotion::PairDistance> own{};
  std::span<const FreeingPlane> freeing{};  ///< Their pairs are not `felt` in any other way.
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
  double turn = 0.0;                ///< Allowed rotation of the entity in the set, rad, if it is bounded: see
                                    ///< dropTurnBound().
  double eased = 1.0;               ///< Gaps above 0 were divided by this: see easeContacts().
  double cost = 0.0;                ///< Calculated (not measured) time to make such a set, s; the same in every run.
};

/// A set before its contacts are known: what to search for, and the data to convert the answer into rows. It refers
/// only to the shapes of the parts.
struct ConstraintDraft {
  std::vector<collision::ZonePart> moving;
  std::vector<std::uint8_t> mask;  ///< Value for ZoneOptions::pair_mask.
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

/// Makes the set from a collision::ContactFinder's answer to the draft. The obstacles have moved by `gone_W` since (m,
/// one each; empty: no motion).
BuiltConstraints completed(const ConstraintDraft& draft, const collision::ZoneContacts& found,
                           std::span<const dvec3> gone_W = {});

/// Moves a recent set to another reference, where the entity is now. `X_DR` is the set's reference by the present
/// mapping.
void moveReference(BuiltConstraints& built, const Pose& X_DR, const Pose& X_DNow);

/// Everything that the hand can feel from this configuration: contacts with their curvature, the entity's own limits,
/// all mapped to the hand's space around the device pose that corresponds to this configuration (gap minus the pair's
/// boundary).
BuiltConstraints buildConstraints(const ConstraintInputs& inputs);

/// A simpler set if the shapes are too crowded for a complete one: a plane at the nearest points of each near pair (the
/// paper's method, for several pairs), valid for `zone_radius`. The exact motion check stops at contacts that are
/// missing in it.
BuiltConstraints buildPlainConstraints(const ConstraintInputs& inputs, std::span<const FreeMotion::PairDistance> near);

/// Removes the row that limits rotation to `turn`: for an entity whose rotation follows from its position, so that the
/// zone bounds both.
void dropTurnBound(BuiltConstraints& built);

/// Smallest value (hand space, m) of any of a pair's groups for the stylus (or proxy) at X_DP: in a group, the entry
/// with the largest value counts. Infinite for pairs that are not in the set. `gaps` has one number per pair.
void pairGaps(const BuiltConstraints& built, const Pose& X_DP, std::span<double> gaps);

}  // namespace hapticell::manipulation
