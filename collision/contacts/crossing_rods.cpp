// SPDX-License-Identifier: Apache-2.0
#include "collision/contacts/crossing_rods.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hapticell::collision {
namespace {

/// Of the angle between two edges: below 1.1 deg their normal is uncertain, and their ends and faces meet first. Half:
/// normals of half the accuracy; twice: edges that cross flatly (2 deg) are not met.
constexpr double kParallelSine = 0.02;
/// Sine: a normal on the border of an arc belongs to it, rounding included. Half and twice are far above rounding
/// (1e-15) and far below facets (1e-2).
constexpr double kInArc = -1e-6;
/// m: a pair that overlaps more while its bodies are free meets elsewhere. Twice kCorner. Half: edges that rest in each
/// other by 0.1 mm are lost; twice: edges behind thin parts make false walls.
constexpr double kDeepest = 2e-4;

/// `n` points out of the body between the rod's faces.
bool isOutward(const PlacedRod& rod, const dvec3& n) {
  if (rod.radius > 0.0) return rod.cosine < -0.999 || glm::dot(rod.n1_W, n) >= rod.cosine + kInArc;
  // n = x n1 + y n2 with x, y >= 0, in the plane across the edge.
  const dvec3 way = glm::cross(rod.n1_W, rod.n2_W);
  return glm::dot(glm::cross(rod.n1_W, n), way) >= kInArc && glm::dot(glm::cross(n, rod.n2_W), way) >= kInArc &&
         glm::dot(n, rod.n1_W + rod.n2_W) > 0.0;
}

ContactRow planeRow(const dvec3& nhat_W, double gap, const dvec3& p_W, std::uint32_t kind) {
  ContactRow row;
  row.nhat_W = nhat_W;
  row.gap = gap;
  row.p_W = p_W;
  row.kind = kind;
  return row;
}

void appendAlong(const PlacedRod& a, const PlacedRod& b, double reach, const ContactGroup& like,
                 std::vector<ContactGroup>& groups) {
  const dvec3 way = glm::normalize(b.b_W - b.a_W);
  const double length = glm::length(b.b_W - b.a_W);
  double u0 = glm::dot(a.a_W - b.a_W, way), u1 = glm::dot(a.b_W - b.a_W, way);
  const dvec3 low_end = u0 <= u1 ? a.a_W : a.b_W, high_end = u0 <= u1 ? a.b_W : a.a_W;
  if (u0 > u1) std::swap(u0, u1);
  if (u0 > length + reach || u1 < -reach) return;
  const double from = std::clamp(u0, 0.0, length), to = std::clamp(u1, 0.0, length);
  const int count = to - from > 1e-6 ? 2 : 1;
  for (int end = 0; end < count; ++end) {
    const double u = end == 0 ? from : to;
    const double share = u1 > u0 ? std::clamp((u - u0) / (u1 - u0), 0.0, 1.0) : 0.0;
    const dvec3 p = low_end + share * (high_end - low_end);
    dvec3 off = p - b.a_W;
    off -= glm::dot(off, way) * way;
    const double distance = glm::length(off);
    if (distance < 1e-9) return;
    const dvec3 n = off / distance;
    if (!isOutward(b, n) || !isOutward(a, -n)) return;
    const double gap = distance - a.radius - b.radius;
    if (gap > reach || gap < -kDeepest) return;
    ContactGroup group = like;
    group.id = mixedId(like.id, static_cast<std::uint64_t>(end) + 1);
    ContactRow row = planeRow(n, gap, p, 0);
    row.bend = 1.0 / (a.radius + b.radius);
    row.M_W = row.bend * (dmat3(1.0) - glm::outerProduct(way, way));
    group.rows.push_back(row);
    const double past_low = -u1, past_high = u0 - length;
    if (past_low > reach || past_high > reach) return;
    if (past_low > -reach) group.rows.push_back(planeRow(-way, past_low, high_end, 1));
    if (past_high > -reach) group.rows.push_back(planeRow(way, past_high, low_end, 2));
    groups.push_back(std::move(group));
  }
}

}  // namespace

PlacedRod placed(const BodyRod& rod, const Pose& X_W) {
  return {X_W * rod.a_M, X_W * rod.b_M, rod.radius, X_W.rotate(rod.n1_M), X_W.rotate(rod.n2_M), rod.cosine};
}

void appendCrossing(const PlacedRod& a, const PlacedRod& b, double reach, const ContactGroup& like,
                    std::vector<ContactGroup>& groups) {
  const dvec3 wa = a.b_W - a.a_W, wb = b.b_W - b.a_W;
  const double la = glm::length(wa), lb = glm::length(wb);
  const double radii = a.radius + b.radius;
  const double apart = glm::length(a.a_W + a.b_W - b.a_W - b.b_W) * 0.5;
  if (la < 1e-9 || lb < 1e-9 || apart > 0.5 * (la + lb) + radii + reach) return;
  const dvec3 da = wa / la, db = wb / lb;
  dvec3 n = glm::cross(da, db);
  const double sine = glm::length(n);
  if (sine < kParallelSine) {
    if (radii > 0.0) appendAlong(a, b, reach, like, groups);
    return;
  }
  n /= sine;
  const dvec3 between = a.a_W - b.a_W;
  const bool up = isOutward(b, n) && isOutward(a, -n), down = isOutward(b, -n) && isOutward(a, n);
  if (!up && !down) return;
  if (!up || (down && glm::dot(n, between) < 0.0)) n = -n;
  const double gap = glm::dot(n, between) - radii;
  if (gap > reach || gap < -reach) return;
  // Where they cross on the moving rod, seen along n.
  const dvec3 ms = glm::cross(n, db), mu = glm::cross(n, da);
  const double s = -glm::dot(ms, between) / glm::dot(ms, da);
  const dvec3 past_s = glm::dot(ms, da) > 0.0 ? ms : -ms, past_u = glm::dot(mu, db) > 0.0 ? mu : -mu;
  const dvec3 p = a.a_W + std::clamp(s, 0.0, la) * da;
  const std::array<ContactRow, 4> ends{planeRow(past_s, glm::dot(past_s, between), a.a_W, 1),
                                       planeRow(-past_s, -glm::dot(past_s, a.b_W - b.a_W), a.b_W, 2),
                                       planeRow(-past_u, -glm::dot(past_u, p - b.a_W), p, 3),
                                       planeRow(past_u, glm::dot(past_u, p - b.b_W), p, 4)};
  ContactGroup group = like;
  group.rows.push_back(planeRow(n, gap, p, 0));
  bool apart_somewhere = gap >= -kDeepest;
  for (const ContactRow& end : ends) {
    if (end.gap > reach) return;
    apart_somewhere = apart_somewhere || end.gap >= 0.0;
    if (end.gap >= -reach) group.rows.push_back(end);
  }
  if (apart_somewhere) groups.push_back(std::move(group));
}

}  // namespace hapticell::collision
