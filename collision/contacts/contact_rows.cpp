// SPDX-License-Identifier: Apache-2.0
#include "collision/contacts/contact_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

#include "collision/contacts/ring_fit.h"

namespace hapticell::collision {
namespace {

/// Copies of a group, for surfaces with several ends: 3 x 3, or three surfaces of two. They are at most a seventh of a
/// set. Half: rings with ends make the zone shrink; twice: a few such places fill the set.
constexpr std::size_t kMostCopies = 9;
/// m below a surface (a skin of 0.02 mm, rounding and a sagitta), or above its boundary: near enough to a corner to
/// need its bisector. Half: chamfers rest on the mitre; twice: more entries at each edge.
constexpr double kCorner = 1e-4;
constexpr double kJustAbove = 2e-5;
/// m that a ring's quadric may be off within the zone (Contacts): what may be entered (0.05 mm of M2). Half: zones at
/// rings shrink by 0.8 (off by the third power); twice: over the limit.
constexpr double kRoughRing = 5e-5;
/// Of the reach: so near to the apex a cone has no foot, and a plane of the apex stands for it. Half: gradients twice
/// as steep; twice: the tip is felt blunt over 2 % of the zone.
constexpr double kAtApex = 0.01;
/// m: which of two equals is kept must not hang on rounding (1e-12 at a metre). A thousand times that; half and twice
/// choose the same.
constexpr double kTie = 1e-9;

/// Curvature of the surface that a ball's centre runs on.
double offsetCurvature(double k, double radius) {
  const double scale = 1.0 + k * radius;
  return scale > 1e-6 ? k / scale : 0.0;
}

/// A ball's centre runs on the same cone with its apex moved along the axis.
dvec3 apexOf(const SurfaceShape& cone, double offset) {
  return cone.p_M - cone.side * offset / std::sin(cone.half_angle) * cone.axis_M;
}

/// How far from the apex the foot of the ball's centre lies, m; nothing where it is at the apex or beyond.
std::optional<double> footAlong(const BallQuery& ball, const SurfaceShape& cone, double offset) {
  const dvec3 v = ball.p_M - apexOf(cone, offset);
  const double h = glm::dot(v, cone.axis_M);
  const double along = glm::length(v - h * cone.axis_M) * std::sin(cone.half_angle) + h * std::cos(cone.half_angle);
  if (along < kAtApex * ball.reach) return std::nullopt;
  return along;
}

/// The cone's own quadric, exact on its side of the apex: (rho^2 cos^2 - h^2 sin^2) / (2 rho cos) at the foot's rho.
dmat3 coneQuadric(const SurfaceShape& cone, double along) {
  const double sine = std::sin(cone.half_angle), cosine = std::cos(cone.half_angle);
  const dmat3 axis = glm::outerProduct(cone.axis_M, cone.axis_M);
  return cone.side / (along * sine * cosine) * (cosine * cosine * (dmat3(1.0) - axis) - sine * sine * axis);
}

ContactRow rowOf(const BallQuery& ball, const SurfaceShape& shape, double offset) {
  const SurfaceView view = viewFrom(shape, ball.p_M);
  ContactRow row;
  row.gap = view.value - offset;
  row.nhat_W = ball.X_WM.rotate(view.nhat_M);
  row.p_W = ball.X_WM * ball.p_M;
  if (view.k1 == 0.0 && view.k2 == 0.0) return row;
  const double k1 = offsetCurvature(view.k1, offset), k2 = offsetCurvature(view.k2, offset);
  const double kn = std::abs(k1) > std::abs(k2) ? k1 : k2;
  const dvec3 t2 = glm::cross(view.nhat_M, view.t1_M);
  dmat3 M = k1 * glm::outerProduct(view.t1_M, view.t1_M) + k2 * glm::outerProduct(t2, t2) +
            kn * glm::outerProduct(view.nhat_M, view.nhat_M);
  if (shape.type == SurfaceType::kCone) {
    if (const auto along = footAlong(ball, shape, offset)) M = coneQuadric(shape, *along);
  }
  const dmat3 R = ball.X_WM.R();
  row.M_W = R * M * glm::transpose(R);
  row.bend = std::max(std::abs(k1), std::abs(k2));
  return row;
}

/// Beyond a cone's apex its quadric goes on: outside is free there, inside is not. The plane through the apex says so:
/// as an alternative of a convex cone, as the trim of one around its hollow.
void endAtApex(const BallQuery& ball, const SurfaceShape& cone, double offset, std::vector<ContactRow>& rows) {
  const dvec3 apex = apexOf(cone, offset);
  const double beyond = glm::dot(cone.axis_M, apex - ball.p_M);
  if (beyond < -ball.reach) return;
  const dvec3 axis_W = ball.X_WM.rotate(cone.axis_M);
  if (cone.side < 0.0) {
    rows.back().has_trim = true;
    rows.back().trim_gap = -beyond;
    rows.back().trim_nhat_W = axis_W;
    return;
  }
  ContactRow row;
  row.gap = beyond;
  row.nhat_W = -axis_W;
  row.p_W = rows.back().p_W;
  row.element = rows.back().element;
  row.kind = 100;
  row.has_trim = rows.back().has_trim;
  row.trim_gap = rows.back().trim_gap;
  row.trim_nhat_W = rows.back().trim_nhat_W;
  rows.push_back(row);
}

void setTrim(const BallQuery& ball, const ElementTrim& trim, ContactRow& row) {
  const SurfaceView view = viewFrom(trim.surface, ball.p_M);
  row.has_trim = true;
  row.trim_gap = view.value - ball.radius * trim.per_radius;
  row.trim_nhat_W = ball.X_WM.rotate(view.nhat_M);
}

/// A convex element with the ends that matter here, nearest first.
struct Ended {
  std::size_t row;
  std::vector<std::size_t> trims;
};

}  // namespace

std::uint64_t mixedId(std::uint64_t hash, std::uint64_t value) {
  hash ^= value + 0x9e3779b97f4a7c15ull + (hash << 6) + (hash >> 2);
  hash *= 0xff51afd7ed558ccdull;
  return hash ^ (hash >> 33);
}

void dropDominated(std::vector<ContactRow>& rows, double reach) {
  const auto dominates = [&](const ContactRow& b, const ContactRow& a) {
    if (b.has_trim) return false;
    const double bend = a.bend + b.bend;
    return b.gap - a.gap >= reach * glm::length(b.nhat_W - a.nhat_W) + 0.5 * bend * reach * reach - 1e-12;
  };
  std::vector<ContactRow> kept;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bool needless = false;
    for (std::size_t j = 0; j < rows.size() && !needless; ++j)
      needless = j != i && dominates(rows[j], rows[i]) && (j < i || !dominates(rows[i], rows[j]));
    if (!needless) kept.push_back(rows[i]);
  }
  rows = std::move(kept);
}

/// Near a corner of two surfaces their bisecting plane is an alternative too: it is in front of the corner only where
/// one of them is, and without it a body would rest on the mitre of the boundary, which sticks out of a sharp corner.
void addBisector(const BallQuery& ball, std::vector<ContactRow>& rows) {
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].has_trim && rows[i].gap > -kCorner && rows[i].gap < ball.boundary + kJustAbove) near.push_back(i);
  }
  if (near.size() != 2) return;
  const ContactRow &a = rows[near[0]], &b = rows[near[1]];
  const double length = glm::length(a.nhat_W + b.nhat_W);
  if (length < 0.2) return;
  ContactRow row = a;
  row.nhat_W = (a.nhat_W + b.nhat_W) / length;
  row.gap = (a.gap + b.gap) / length;
  row.bend = (a.bend + b.bend) / length;
  row.kind = 200;
  if (row.bend > 0.0) row.M_W = (a.M_W + b.M_W) / length;
  rows.push_back(row);
}

/// A cone has no quadric where it is seen from behind its apex.
static bool isRough(const BallQuery& ball, const SurfaceShape& cone, double offset) {
  return !ball.rough && cone.type == SurfaceType::kCone && !footAlong(ball, cone, offset);
}

/// Nor does that of a ring hold for all of the reach.
static bool isRough(const BallQuery& ball, const SurfaceElement& element, const ContactRow& row) {
  if (ball.rough || row.bend == 0.0) return false;
  if (element.shape.side < 0.0 && isRough(ball, element.shape, ball.radius)) return true;
  if (element.shape.type != SurfaceType::kTorus) return false;
  const dmat3 R = ball.X_WM.R();
  return ringDeviation(ball, element, glm::transpose(R) * row.M_W * R) > kRoughRing;
}

/// The rows of a hollow element: its own, and those of its ends as alternatives.
static GroupDecision appendHollow(const BallQuery& ball, std::uint32_t name, const ContactRow& row,
                                  ContactGroup& group) {
  const SurfaceElement& element = ball.element(name);
  if (row.gap >= -ball.reach || element.trims.empty()) {
    group.rows.push_back(row);
    if (element.shape.type == SurfaceType::kCone) endAtApex(ball, element.shape, ball.radius, group.rows);
  }
  for (std::size_t k = 0; k < element.trims.size(); ++k) {
    const ElementTrim& trim = element.trims[k];
    const double offset = ball.radius * trim.per_radius;
    ContactRow end = rowOf(ball, trim.surface, offset);
    end.element = name;
    end.kind = static_cast<std::uint32_t>(k + 1);
    if (end.gap < -ball.reach) continue;
    if (isRough(ball, trim.surface, offset)) return GroupDecision::kRough;
    group.rows.push_back(end);
    if (trim.surface.type == SurfaceType::kCone) endAtApex(ball, trim.surface, offset, group.rows);
  }
  return GroupDecision::kDecided;
}

/// The row of an element that is not hollow, with its only end; several ends are left to copyForEnds().
static void appendConvex(const BallQuery& ball, std::uint32_t name, ContactRow row, ContactGroup& group,
                         std::vector<Ended>& ended) {
  const SurfaceElement& element = ball.element(name);
  Ended ends{group.rows.size(), {}};
  for (std::size_t k = 0; k < element.trims.size(); ++k) {
    const ElementTrim& trim = element.trims[k];
    if (signedDistance(trim.surface, ball.p_M) - ball.radius * trim.per_radius <= ball.reach) ends.trims.push_back(k);
  }
  const bool ring = element.shape.type == SurfaceType::kTorus;
  if (ends.trims.size() == 1 && !ring) setTrim(ball, element.trims[ends.trims.front()], row);
  if (ends.trims.size() > 1 || (ring && !ends.trims.empty())) ended.push_back(ends);
  group.rows.push_back(row);
  if (element.shape.type == SurfaceType::kCone) endAtApex(ball, element.shape, ball.radius, group.rows);
}

/// A ring's end is a surface itself: A or (f and t) is (A or f) and (A or t). This is the second of them.
static ContactGroup endOfRing(const BallQuery& ball, const Ended& ends, const ContactGroup& group) {
  const SurfaceElement& element = ball.element(group.rows[ends.row].element);
  const ElementTrim& trim = element.trims[ends.trims.front()];
  const double offset = ball.radius * trim.per_radius;
  ContactRow end = rowOf(ball, trim.surface, offset);
  end.element = group.rows[ends.row].element;
  end.kind = 1;
  ContactGroup result = group;
  result.rows[ends.row] = end;
  result.id = mixedId(group.id, 50);
  if (trim.surface.type == SurfaceType::kCone) {
    std::vector<ContactRow> ending{end};
    endAtApex(ball, trim.surface, offset, ending);
    result.rows[ends.row] = ending.front();
    result.rows.insert(result.rows.end(), ending.begin() + 1, ending.end());
  }
  return result;
}

/// A or (f and t1 and t2) is (A or (f and t1)) and (A or (f and t2)).
static std::vector<ContactGroup> copyForEnds(const BallQuery& ball, const Ended& ends,
                                             std::vector<ContactGroup> copies) {
  std::vector<ContactGroup> next;
  const SurfaceElement& element = ball.element(copies.front().rows[ends.row].element);
  for (ContactGroup& copy : copies) {
    if (element.shape.type == SurfaceType::kTorus) {
      next.push_back(endOfRing(ball, ends, copy));
      next.push_back(std::move(copy));
      continue;
    }
    for (const std::size_t k : ends.trims) {
      next.push_back(copy);
      ContactRow& row = next.back().rows[ends.row];
      setTrim(ball, ball.element(row.element).trims[k], row);
      row.kind = static_cast<std::uint32_t>(k + 1);
      next.back().id = mixedId(copy.id, k);
    }
  }
  return next;
}

GroupDecision appendGroups(const BallQuery& ball, const std::vector<std::uint32_t>& elements, const ContactGroup& like,
                           std::vector<ContactGroup>& groups) {
  ContactGroup group = like;
  std::vector<Ended> ended;
  double deepest = -1e300;
  std::uint32_t best = elements.front();
  for (const auto name : elements) {
    const double value = elementValue(ball.element(name), ball.p_M, ball.radius);
    if (value > ball.reach) return GroupDecision::kDecided;
    if (value > deepest) deepest = value, best = name;
  }
  for (const auto name : elements) {
    const SurfaceElement& element = ball.element(name);
    const double value = elementValue(element, ball.p_M, ball.radius);
    if (value < -ball.reach && !(deepest < -ball.reach && name == best)) continue;
    ContactRow row = rowOf(ball, element.shape, ball.radius);
    if (isRough(ball, element, row)) return GroupDecision::kRough;
    row.element = name;
    // Where facets stand in front of a hollow, what the exact check of the motion allows ends there.
    row.gap -= element.raised;
    if (element.shape.side >= 0.0)
      appendConvex(ball, name, row, group, ended);
    else if (const GroupDecision told = appendHollow(ball, name, row, group); told != GroupDecision::kDecided)
      return told;
  }
  std::vector<ContactGroup> copies{std::move(group)};
  for (const Ended& ends : ended) {
    if (copies.size() * std::max<std::size_t>(2, ends.trims.size()) > kMostCopies) return GroupDecision::kTooManyEnds;
    copies = copyForEnds(ball, ends, std::move(copies));
  }
  for (ContactGroup& copy : copies) {
    dropDominated(copy.rows, ball.reach);
    addBisector(ball, copy.rows);
    if (!copy.rows.empty()) groups.push_back(std::move(copy));
  }
  return GroupDecision::kDecided;
}

void keepSupports(std::vector<ContactGroup>& groups, double rotation) {
  using Key = std::tuple<std::uint32_t, std::uint32_t, bool, std::uint32_t, std::uint32_t>;
  std::map<Key, std::vector<std::size_t>> planes;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const ContactGroup& group = groups[i];
    if (group.rows.size() != 1 || !group.rows.front().isPlane()) continue;
    const ContactRow& row = group.rows.front();
    planes[{group.moving_part, group.environment_part, group.of_moving_surface, row.element, row.kind}].push_back(i);
  }
  std::vector<std::uint8_t> dropped(groups.size(), 0);
  for (const auto& [key, members] : planes) {
    if (members.size() <= 3) continue;
    for (const auto i : members) dropped[i] = 1;
    const dvec3 n = groups[members.front()].rows.front().nhat_W;
    const dvec3 e1 = glm::normalize(glm::cross(n, std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    const dvec3 e2 = glm::cross(n, e1);
    const auto keepLowest = [&, &members = members](const dvec3& way) {
      double least = 1e300;
      for (const auto i : members) least = std::min(least, glm::dot(way, groups[i].rows.front().p_W));
      for (const auto i : members) {
        if (glm::dot(way, groups[i].rows.front().p_W) > least + kTie) continue;
        dropped[i] = 0;
        return;
      }
    };
    keepLowest(n);
    for (const double share : {0.02, 0.3, 1.0}) {
      for (int k = 0; k < 12; ++k) {
        const double turn = 2.0 * std::numbers::pi * (k + 0.25) / 12.0;
        keepLowest(n + std::tan(share * rotation) * (std::cos(turn) * e1 + std::sin(turn) * e2));
      }
    }
  }
  std::vector<ContactGroup> kept;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (dropped[i] == 0) kept.push_back(std::move(groups[i]));
  }
  groups = std::move(kept);
}

}  // namespace hapticell::collision
