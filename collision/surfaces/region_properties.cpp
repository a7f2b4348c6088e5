// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/region_properties.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "collision/surfaces/surface_clusters.h"

namespace hapticell::collision {
namespace {

/// Sine of 2 deg (also kSmoothSine): analytic normals that agree so are tangent. Our choice. Half: blends with
/// tolerances become edges; twice: drafts of 2 to 4 deg are felt rounded.
constexpr double kSmooth = 0.0349;
/// Sectors of 5 deg round an axis, to see whether a surface goes all round: a gap must be as wide. Half: slots under 10
/// deg are not ends; twice: finer, twice the time.
constexpr int kSectors = 72;

/// A mesh edge at which a region ends.
struct BorderEdge {
  dvec3 a, b;
  std::uint32_t triangle, other;
  BorderKind kind;
};

dvec3 normalAt(const RecognisedSurface& surface, std::uint32_t triangle, const dvec3& p) {
  const SurfaceRegion& region = surface.regions[surface.region_of[triangle]];
  if (region.shape.type == SurfaceType::kFreeForm) return surface.normals[triangle];
  return viewFrom(region.shape, p).nhat_M;
}

BorderKind kindOf(const RecognisedSurface& surface, const BorderEdge& edge) {
  if (edge.other == kNoIndex) return BorderKind::kOpen;
  const dvec3 n1 = normalAt(surface, edge.triangle, edge.a), n2 = normalAt(surface, edge.other, edge.a);
  if (glm::length(glm::cross(n1, n2)) < kSmooth && glm::dot(n1, n2) > 0.0) return BorderKind::kSmooth;
  const dvec3 way = middleOf(surface.mesh, edge.other) - 0.5 * (edge.a + edge.b);
  return glm::dot(surface.normals[edge.triangle], way) < 0.0 ? BorderKind::kConvex : BorderKind::kConcave;
}

std::vector<BorderEdge> borderEdges(const RecognisedSurface& surface, std::uint32_t name) {
  std::vector<BorderEdge> edges;
  for (const auto t : surface.regions[name].triangles) {
    for (int k = 0; k < 3; ++k) {
      const auto other = surface.neighbour[t][static_cast<std::size_t>(k)];
      if (other != kNoIndex && surface.region_of[other] == name) continue;
      BorderEdge edge{surface.mesh.corner(t, k), surface.mesh.corner(t, (k + 1) % 3), t, other, BorderKind::kOpen};
      edge.kind = kindOf(surface, edge);
      edges.push_back(edge);
    }
  }
  return edges;
}

void measure(const RecognisedSurface& surface, SurfaceRegion& region) {
  dvec3 sum(0.0);
  const bool known = region.shape.type != SurfaceType::kFreeForm;
  for (const auto t : region.triangles) {
    const double area = areaOf(surface.mesh, t);
    region.area += area;
    sum += area * surface.normals[t];
    if (!known) continue;
    for (int k = 0; k < 3; ++k) {
      const dvec3 a = surface.mesh.corner(t, k), b = surface.mesh.corner(t, (k + 1) % 3);
      region.residual = std::max(region.residual, std::abs(signedDistance(region.shape, a)));
      region.sagitta = std::max(region.sagitta, std::abs(signedDistance(region.shape, 0.5 * (a + b))));
    }
  }
  if (glm::length(sum) > 1e-6 * region.area) region.mean_nhat_M = glm::normalize(sum);
}

/// Sectors round the axis that the region covers, every edge with all sectors between its ends.
int coveredSectors(const RecognisedSurface& surface, const SurfaceRegion& region) {
  std::vector<std::uint8_t> seen(kSectors, 0);
  const dvec3& n = region.shape.axis_M;
  const dvec3 other = std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 e1 = glm::normalize(glm::cross(n, other)), e2 = glm::cross(n, e1);
  const auto angle = [&](const dvec3& p) {
    return std::atan2(glm::dot(p - region.shape.p_M, e2), glm::dot(p - region.shape.p_M, e1));
  };
  for (const auto t : region.triangles) {
    for (int k = 0; k < 3; ++k) {
      const double from = angle(surface.mesh.corner(t, k));
      const double by = std::remainder(angle(surface.mesh.corner(t, (k + 1) % 3)) - from, 2.0 * std::numbers::pi);
      const int steps = 1 + static_cast<int>(std::abs(by) / (std::numbers::pi / kSectors));
      for (int i = 0; i <= steps; ++i) {
        const double turn = (from + by * i / steps + 3.0 * std::numbers::pi) / (2.0 * std::numbers::pi);
        seen[static_cast<std::size_t>(turn * kSectors) % kSectors] = 1;
      }
    }
  }
  return static_cast<int>(std::count(seen.begin(), seen.end(), 1));
}

SurfaceShape planeTrim(const dvec3& nhat, double offset) {
  SurfaceShape trim;
  trim.axis_M = nhat;
  trim.p_M = offset * nhat;
  return trim;
}

/// Whether the surface beyond a smooth border bends the other way: then nothing is left of it in front of a convex one
/// that goes on, and this one needs no end there.
bool bendsAway(const RecognisedSurface& surface, const BorderEdge& edge) {
  if (edge.kind != BorderKind::kSmooth) return false;
  const SurfaceShape& shape = surface.regions[surface.region_of[edge.other]].shape;
  if (shape.type == SurfaceType::kFreeForm || shape.type == SurfaceType::kPlane) return false;
  const SurfaceView view = viewFrom(shape, 0.5 * (edge.a + edge.b));
  const dvec3 across = glm::normalize(glm::cross(view.nhat_M, edge.b - edge.a));
  const double along_t1 = glm::dot(across, view.t1_M);
  const double bend = view.k1 * along_t1 * along_t1 + view.k2 * (1.0 - along_t1 * along_t1);
  return bend < -1e-3 * std::max(std::abs(view.k1), std::abs(view.k2));
}

/// Unit, across the axis: half-way between the ends of what a cylinder or cone covers of its turn.
std::optional<dvec3> middleOfArc(const SurfaceRegion& region, const std::vector<BorderEdge>& border) {
  const SurfaceShape& s = region.shape;
  const dvec3 mean = region.mean_nhat_M - glm::dot(region.mean_nhat_M, s.axis_M) * s.axis_M;
  if (glm::length(mean) < 1e-6) return std::nullopt;
  const dvec3 e1 = glm::normalize(mean), e2 = glm::cross(s.axis_M, e1);
  double low = 0.0, high = 0.0;
  for (const BorderEdge& edge : border) {
    for (const dvec3& p : {edge.a, edge.b}) {
      const dvec3 n = viewFrom(s, p).nhat_M;
      const double turn = std::atan2(glm::dot(n, e2), glm::dot(n, e1));
      low = std::min(low, turn);
      high = std::max(high, turn);
    }
  }
  const double turn = 0.5 * (low + high);
  return std::cos(turn) * e1 + std::sin(turn) * e2;
}

/// The plane with the middle normal through the lowest vertex (convex) or the highest (concave) of the border.
std::optional<SurfaceShape> chordPlane(const SurfaceRegion& region, const std::vector<BorderEdge>& border) {
  if (region.mean_nhat_M == dvec3(0.0) || border.empty()) return std::nullopt;
  dvec3 n = region.mean_nhat_M;
  const bool along_axis = region.shape.type == SurfaceType::kCylinder || region.shape.type == SurfaceType::kCone;
  if (along_axis) {
    const auto middle = middleOfArc(region, border);
    if (!middle) return std::nullopt;
    // A cone's chord plane leans as its rulings do.
    const double lean = region.shape.type == SurfaceType::kCone ? glm::dot(n, region.shape.axis_M) : 0.0;
    n = *middle * std::sqrt(std::max(0.0, 1.0 - lean * lean)) + lean * region.shape.axis_M;
  }
  n = glm::normalize(n);
  double lowest = 1e300, highest = -1e300;
  for (const BorderEdge& edge : border) {
    for (const dvec3& p : {edge.a, edge.b}) {
      lowest = std::min(lowest, glm::dot(n, p));
      highest = std::max(highest, glm::dot(n, p));
    }
  }
  return planeTrim(n, region.shape.side > 0.0 ? lowest : highest);
}

/// Through the ends of the arc in the meridian, turned about the axis: a cone, a plane or a cylinder; positive where
/// the arc is if it is convex, where it is not if it is concave.
std::optional<SurfaceShape> ringTrim(const RecognisedSurface& surface, const SurfaceRegion& region,
                                     const std::vector<BorderEdge>& border) {
  const SurfaceShape& s = region.shape;
  const auto meridian = [&](const dvec3& p) {
    const dvec3 v = p - s.p_M;
    const double h = glm::dot(v, s.axis_M);
    return glm::dvec2(glm::length(v - h * s.axis_M) - s.major_radius, h);
  };
  double x = 0.0, y = 0.0;
  for (const auto t : region.triangles) {
    const glm::dvec2 m = meridian(middleOf(surface.mesh, t));
    const double area = areaOf(surface.mesh, t), length = std::max(1e-12, glm::length(m));
    x += area * m.x / length;
    y += area * m.y / length;
  }
  if (std::hypot(x, y) < 1e-3 * region.area) return std::nullopt;
  const double mean = std::atan2(y, x);
  double low = 0.0, high = 0.0;
  glm::dvec2 first, last;
  for (const BorderEdge& edge : border) {
    const glm::dvec2 m = meridian(edge.a);
    const double a = std::remainder(std::atan2(m.y, m.x) - mean, 2.0 * std::numbers::pi);
    if (a <= low) low = a, first = m;
    if (a >= high) high = a, last = m;
  }
  if (!(high > low) || high - low > 1.95 * std::numbers::pi) return std::nullopt;
  const glm::dvec2 way = glm::normalize(last - first), middle = s.radius * glm::dvec2(std::cos(mean), std::sin(mean));
  SurfaceShape trim;
  const double radius = first.x + s.major_radius;
  if (std::abs(way.y) < 1e-6) {  // level: a plane
    trim = planeTrim(s.axis_M, glm::dot(s.axis_M, s.p_M) + first.y);
  } else if (std::abs(way.x) < 1e-6) {
    trim.type = SurfaceType::kCylinder;
    trim.p_M = s.p_M;
    trim.axis_M = s.axis_M;
    trim.radius = radius;
  } else {
    const double apex = first.y - radius * way.y / way.x;  // where the line meets the axis
    trim.type = SurfaceType::kCone;
    trim.p_M = s.p_M + apex * s.axis_M;
    trim.axis_M = first.y + 0.5 * (last.y - first.y) > apex ? s.axis_M : -s.axis_M;
    trim.half_angle = std::atan2(std::abs(way.x), std::abs(way.y));
  }
  const dvec3 n = s.axis_M;
  const dvec3 e = glm::normalize(glm::cross(n, std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
  const dvec3 on_arc = s.p_M + (s.major_radius + middle.x) * e + middle.y * n;
  if ((signedDistance(trim, on_arc) < 0.0) == (s.side > 0.0)) {
    if (trim.type == SurfaceType::kPlane) {
      trim.axis_M = -trim.axis_M;
    } else {
      trim.side = -trim.side;
    }
  }
  return trim;
}

/// For spheres: a plane for each neighbour, through the border's vertices where these lie in one. Empty where some
/// border does not.
std::vector<SurfaceShape> borderPlanes(const RecognisedSurface& surface, const SurfaceRegion& region,
                                       const std::vector<BorderEdge>& border) {
  std::map<std::uint32_t, std::vector<dvec3>> by_neighbour;
  for (const BorderEdge& edge : border) {
    auto& points = by_neighbour[edge.other == kNoIndex ? kNoIndex : surface.region_of[edge.other]];
    points.push_back(edge.a);
    points.push_back(edge.b);
  }
  const dvec3 inside = region.shape.p_M + region.shape.radius * region.mean_nhat_M;
  std::vector<SurfaceShape> planes;
  for (const auto& [neighbour, points] : by_neighbour) {
    dvec3 normal(0.0);
    double widest = 0.0;  // of all triangles with the first vertex and the one farthest from it
    const auto far = std::max_element(points.begin(), points.end(), [&points = points](const dvec3& a, const dvec3& b) {
      return glm::length(a - points.front()) < glm::length(b - points.front());
    });
    for (const dvec3& p : points) {
      const dvec3 n = glm::cross(*far - points.front(), p - points.front());
      if (glm::length(n) > widest) widest = glm::length(n), normal = n;
    }
    if (widest < 1e-9 * region.shape.radius * region.shape.radius) return {};
    normal = glm::normalize(normal);
    if (glm::dot(normal, inside - points.front()) < 0.0) normal = -normal;
    const SurfaceShape plane = planeTrim(normal, glm::dot(normal, points.front()));
    const double allowed = std::max(10.0 * region.residual, 1e-4 * region.shape.radius);
    for (const dvec3& p : points) {
      if (std::abs(signedDistance(plane, p)) > allowed) return {};
    }
    planes.push_back(plane);
  }
  return planes;
}

void trim(const RecognisedSurface& surface, SurfaceRegion& region, const std::vector<BorderEdge>& border) {
  const bool smooth = std::any_of(border.begin(), border.end(), [&](const auto& e) {
    return e.kind == BorderKind::kSmooth && !bendsAway(surface, e);
  });
  const bool convex = region.shape.side > 0.0;
  std::optional<SurfaceShape> found;
  switch (region.shape.type) {
    case SurfaceType::kCylinder:
    case SurfaceType::kCone:
      if (coveredSectors(surface, region) == kSectors || (convex && !smooth)) return;
      found = chordPlane(region, border);
      break;
    case SurfaceType::kTorus:
      if (border.empty() || (convex && !smooth)) return;
      found = ringTrim(surface, region, border);
      break;
    case SurfaceType::kSphere:
      if (border.empty() || (convex && !smooth)) return;
      if (convex) region.trims = borderPlanes(surface, region, border);
      if (region.trims.empty()) found = chordPlane(region, border);
      break;
    default:
      return;
  }
  if (found) region.trims.push_back(*found);
}

}  // namespace

void measureRegions(RecognisedSurface& surface) {
  for (std::uint32_t i = 0; i < surface.regions.size(); ++i) measure(surface, surface.regions[i]);
  for (std::uint32_t i = 0; i < surface.regions.size(); ++i) {
    SurfaceRegion& region = surface.regions[i];
    const std::vector<BorderEdge> border = borderEdges(surface, i);
    std::map<std::pair<std::uint32_t, BorderKind>, std::uint32_t> counted;
    for (const BorderEdge& edge : border) {
      const auto neighbour = edge.other == kNoIndex ? kNoIndex : surface.region_of[edge.other];
      ++counted[{neighbour, edge.kind}];
    }
    for (const auto& [key, edges] : counted) region.borders.push_back({key.first, key.second, edges});
    trim(surface, region, border);
  }
}

}  // namespace hapticell::collision
