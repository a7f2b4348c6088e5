// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/contacts/zone_contacts.h"
#include "collision/surfaces/signature_groups.h"
#include "collision/surfaces/surface_model.h"

namespace hapticell::collision {

/// One alternative of a group: a point of one body against an element of the other, in the world.
struct ContactRow {
  double gap = 0.0;             ///< m.
  dvec3 nhat_W{0.0, 0.0, 1.0};  ///< Points out of the element.
  dmat3 M_W{0.0};               ///< As in ZoneContact.
  double bend = 0.0;            ///< 1/m: upper bound of the gap's curvature.
  bool has_trim = false;
  double trim_gap = 0.0;
  dvec3 trim_nhat_W{0.0, 0.0, 1.0};
  dvec3 p_W{0.0};  ///< The point.
  std::uint32_t element = 0;
  std::uint32_t kind = 0;  ///< 0: the surface; others: its ends.

  bool isPlane() const { return !has_trim && bend == 0.0; }
};

struct ContactGroup {
  std::uint32_t moving_part = 0;
  std::uint32_t environment_part = 0;
  bool of_moving_surface = false;  ///< The elements belong to the moving body, the point to the environment.
  std::uint64_t id = 0;
  std::vector<ContactRow> rows;
};

/// A query about one point or ball.
struct BallQuery {
  const SurfaceModel& model;
  Pose X_WM;
  dvec3 p_M;  ///< Position of the centre.
  double radius = 0.0;
  double boundary = 0.0;                ///< m: the distance that may be felt as contact.
  double reach = 0.0;                   ///< Rows deeper than this and groups farther away than this are left out.
  const SignatureCell* cell = nullptr;  ///< Cell whose own elements the lists may refer to; null: no such elements.
  bool rough = true;                    ///< Accept quadrics whatever their deviation within the reach.

  const SurfaceElement& element(std::uint32_t name) const {
    return cell != nullptr ? cell->element(model, name) : model.elements()[name];
  }
};

enum class GroupDecision : std::uint8_t {
  kDecided,
  kTooManyEnds,  ///< Surfaces with several ends would need too many groups.
  kRough,        ///< `rough` is not set, and within the reach a ring's quadric deviates by more than 0.05 mm, or the
                 ///< point is behind the apex of a hollow cone, where no quadric describes it.
};

/// Appends the groups of one list of elements: copies of `like` with rows. A list gives one group, or more if a surface
/// has several ends. If the result is not success, discard `groups` and try a smaller reach.
GroupDecision appendGroups(const BallQuery& ball, const std::vector<std::uint32_t>& elements, const ContactGroup& like,
                           std::vector<ContactGroup>& groups);

/// Removes rows that another row of the group makes unnecessary within the reach.
void dropDominated(std::vector<ContactRow>& rows, double reach);

/// Removes groups of one plane whose points lie in the hull of the other groups' points, for turns up to `rotation`
/// (rad).
void keepSupports(std::vector<ContactGroup>& groups, double rotation);

std::uint64_t mixedId(std::uint64_t hash, std::uint64_t value);

}  // namespace hapticell::collision
