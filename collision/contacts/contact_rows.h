// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/surfaces/signature_groups.h"
#include "collision/surfaces/surface_model.h"
#include "collision/contacts/zone_contacts.h"

namespace hapticell::collision {

/// One alternative of a group, as a point of one body sees an element of the other, in the world.
struct ContactRow {
  double gap = 0.0;             ///< m.
  dvec3 nhat_W{0.0, 0.0, 1.0};  ///< Out of the element.
  dmat3 M_W{0.0};               ///< As ZoneContact's.
  double bend = 0.0;            ///< 1/m: no curvature of the gap is larger.
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
  bool of_moving_surface = false;  ///< The elements are the moving body's, the point the environment's.
  std::uint64_t id = 0;
  std::vector<ContactRow> rows;
};

/// What one point or ball is asked about.
struct BallQuery {
  const SurfaceModel& model;
  Pose X_WM;
  dvec3 p_M;  ///< Of the centre.
  double radius = 0.0;
  double boundary = 0.0;                ///< m: the distance that may be felt as contact.
  double reach = 0.0;                   ///< Rows deeper than that and groups freer than that are left out.
  const SignatureCell* cell = nullptr;  ///< Whose own elements the lists may name; null: none.
  bool rough = true;                    ///< Quadrics will do however far they are off within the reach.

  const SurfaceElement& element(std::uint32_t name) const {
    return cell != nullptr ? cell->element(model, name) : model.elements()[name];
  }
};

enum class Telling : std::uint8_t {
  kTold,
  kTooManyEnds,  ///< Surfaces with several ends would take too many groups.
  kRough,        ///< `rough` is not set, and within the reach a ring's quadric is off by more than 0.05 mm, or a hollow
                 ///< cone is seen from behind its apex, whence no quadric tells it.
};

/// Appends the groups of one list of elements (one or, where a surface has several ends, more), `like` with rows. What
/// cannot be told within this reach can be within a smaller one; `groups` is then of no use.
Telling appendGroups(const BallQuery& ball, const std::vector<std::uint32_t>& elements, const ContactGroup& like,
                     std::vector<ContactGroup>& groups);

/// Leaves out rows that another row of the group makes needless within the reach.
void dropDominated(std::vector<ContactRow>& rows, double reach);

/// Leaves out groups of one plane whose points the others' hull holds, as far as turns up to `rotation` (rad) go.
void keepSupports(std::vector<ContactGroup>& groups, double rotation);

std::uint64_t mixedId(std::uint64_t hash, std::uint64_t value);

}  // namespace hapticell::collision
