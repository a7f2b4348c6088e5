// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/body_skin.h"

#include <algorithm>
#include <utility>

#include "geometry/shapes/hollows.h"
#include "mannequin/body/rotations.h"
#include "mannequin/shape/surface_nets.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

/// All bodies placed, each with a sphere about it.
struct PlacedBody {
  SegmentPlace place;
  dvec3 centre{0.0};
  double radius = 0.0;
};

std::vector<PlacedBody> placeBodies(const Figure& figure, const Posture& posture, const std::vector<Flesh>& flesh) {
  const FigurePose pose = forwardKinematics(figure, posture);
  std::vector<PlacedBody> bodies(kBodies);
  for (std::size_t i = 0; i < kSegmentCount; ++i) bodies[i].place = pose.segments[i];
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto places = phalanxPlaces(figure, posture, side, pose[armSegment(side, S::kLeftHand)]);
    for (std::size_t d = 0; d < kDigits; ++d) {
      for (std::size_t k = 0; k < kPhalanges; ++k) bodies[phalanxBody(side, d, k)].place = places[d][k];
    }
  }
  for (std::size_t i = 0; i < kBodies; ++i) {
    const geometry::Bounds bounds = flesh[i].bounds();
    bodies[i].centre = bodies[i].place.point(bounds.center());
    bodies[i].radius = bounds.radius();
  }
  return bodies;
}

/// Two bodies that no joint joins but that lie on each other by a joint: the crease between them is rounded there.
struct Crease {
  std::size_t a = 0, b = 0;
  double blend = 0.0;  ///< m, at the joint; none at `reach` from it.
  dvec3 p_W{0.0};
  double reach = 0.0;

  double blendAt(const dvec3& p) const {
    const dvec3 off = p - p_W;
    return blend * std::max(0.0, 1.0 - glm::dot(off, off) / (reach * reach));
  }
};

/// Armpits, and between the thighs.
std::vector<Crease> creasesOf(const std::vector<PlacedBody>& bodies) {
  // m over which limbs flow together, and how far from the joint; our choice, drawn and written only. Half: sharp
  // creases; twice: webs between arm and trunk.
  constexpr double kArmpit = 0.035, kArmpitReach = 0.28, kThighs = 0.030, kThighsReach = 0.24;
  const auto at = [&](S segment) { return bodies[indexOf(segment)].place.p_WS; };
  std::vector<Crease> creases{{indexOf(S::kLeftThigh), indexOf(S::kRightThigh), kThighs,
                               0.5 * (at(S::kLeftThigh) + at(S::kRightThigh)), kThighsReach}};
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const S arm = armSegment(side, S::kLeftUpperArm);
    for (const S trunk : {S::kThorax, S::kUpperBack})
      creases.push_back({indexOf(arm), indexOf(trunk), kArmpit, at(arm), kArmpitReach});
  }
  return creases;
}

/// The figure's skin as a field: bodies blend with the one that carries them.
class SkinField {
 public:
  SkinField(const std::vector<Flesh>& flesh, const std::vector<PlacedBody>& bodies)
      : flesh_(flesh), bodies_(bodies), creases_(creasesOf(bodies)) {}

  /// Bodies that matter within `radius` of a point.
  void choose(const dvec3& centre, double radius) {
    chosen_.clear();
    double nearest = 1e9;
    for (const PlacedBody& body : bodies_) nearest = std::min(nearest, glm::length(centre - body.centre) + body.radius);
    for (std::size_t i = 0; i < kBodies; ++i) {
      const double gap = glm::length(centre - bodies_[i].centre) - bodies_[i].radius;
      if (gap < radius + 0.10 || gap < 0.0) chosen_.push_back(i);
    }
    fallback_ = chosen_.empty() ? nearest : 0.0;
  }

  double value(const dvec3& p) {
    if (chosen_.empty()) return fallback_;
    double result = measure(p);
    for (const std::size_t i : chosen_) {
      const std::size_t parent = parentBody(i);
      if (i == 0 || distances_[parent] > 1e8) continue;
      const double k = 0.8 * std::min(flesh_[i].blend, flesh_[parent].blend) * share(outward_[i], outward_[parent]);
      if (k > kLeastBlend) result = std::min(result, blended(distances_[i], distances_[parent], k));
    }
    for (const Crease& crease : creases_) {
      if (std::max(distances_[crease.a], distances_[crease.b]) > 1e8) continue;
      const double k = crease.blendAt(p) * share(outward_[crease.a], outward_[crease.b]);
      if (k > kLeastBlend) result = std::min(result, blended(distances_[crease.a], distances_[crease.b], k));
    }
    return result;
  }

  /// Distances of all bodies to a point (1e9: not chosen) in distancesAt(); the
  /// least of them.
  double measure(const dvec3& p) {
    distances_.fill(1e9);
    double least = 1e9;
    for (const std::size_t i : chosen_) {
      const SegmentPlace& place = bodies_[i].place;
      distances_[i] = flesh_[i].distance(glm::transpose(place.R_WS) * (p - place.p_WS), outward_[i]);
      outward_[i] = place.R_WS * outward_[i];
      least = std::min(least, distances_[i]);
    }
    return least;
  }
  const std::array<double, kBodies>& distances() const { return distances_; }

 private:
  // m: less is no blend, for speed. Half, twice: no effect seen.
  static constexpr double kLeastBlend = 1e-4;

  /// How much two bodies flow together where they face these ways: not at all
  /// where they face alike, or a straight limb would swell at its joints (after
  /// O. Gourmel et al., "A gradient-based implicit blend", 2013).
  static double share(const dvec3& a, const dvec3& b) {
    const double alike = std::max(0.0, glm::dot(a, b));
    return 1.0 - alike * alike;
  }

  const std::vector<Flesh>& flesh_;
  const std::vector<PlacedBody>& bodies_;
  const std::vector<Crease> creases_;
  std::array<double, kBodies> distances_{};
  std::array<dvec3, kBodies> outward_{};
  std::vector<std::size_t> chosen_;
  double fallback_ = 0.0;
};

/// A figure placed in a posture, as a field and what it is made of.
class PlacedSkin {
 public:
  PlacedSkin(const Figure& figure, const Posture& posture)
      : flesh_(fleshOf(figure)), bodies_(placeBodies(figure, posture, flesh_)), field_(flesh_, bodies_) {}

  /// What closes in upon itself within the body (between thighs and belly) is left out.
  geometry::TriangleMesh surface(double cell) {
    GridField grid{{}, cell, {}};
    for (std::size_t i = 0; i < kBodies; ++i)
      grid.bounds.add(geometry::transformed(bodies_[i].place.pose(), flesh_[i].bounds()));
    grid.evaluate = [this](const dvec3& centre, double radius, const std::vector<dvec3>& points,
                           std::vector<double>& values) {
      field_.choose(centre, points.size() == 1 ? 2.0 * radius : radius);
      values.resize(points.size());
      for (std::size_t i = 0; i < points.size(); ++i) values[i] = field_.value(points[i]);
    };
    geometry::TriangleMesh mesh = surfaceOf(grid);
    for (dvec3& vertex : mesh.vertices) settle(vertex, cell);
    smoothSkin(mesh);
    return geometry::withoutHollows(mesh);
  }

  /// Distances of all bodies to a point on the surface.
  const std::array<double, kBodies>& distancesAt(const dvec3& p, double cell) {
    field_.choose(p, cell);
    field_.measure(p);
    return field_.distances();
  }

 private:
  /// From the middle of its cell's crossings onto the surface itself, or facets
  /// would show: one Newton step.
  void settle(dvec3& p, double cell) {
    field_.choose(p, cell);
    const double value = field_.value(p), h = 0.1 * cell;
    dvec3 slope(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      dvec3 step(0.0);
      step[axis] = h;
      slope[axis] = (field_.value(p + step) - field_.value(p - step)) / (2.0 * h);
    }
    const double square = glm::dot(slope, slope);
    if (square > 0.04) p -= std::clamp(value, -0.5 * cell, 0.5 * cell) / square * slope;
  }

  std::vector<Flesh> flesh_;
  std::vector<PlacedBody> bodies_;
  SkinField field_;
};

}  // namespace

Skin skinOf(const Figure& figure, const Posture& posture, double cell) {
  PlacedSkin placed(figure, posture);
  Skin result;
  result.mesh = placed.surface(cell);
  for (const dvec3& vertex : result.mesh.vertices) {
    const auto& distances = placed.distancesAt(vertex, cell);
    const auto nearest = std::min_element(distances.begin(), distances.end()) - distances.begin();
    result.body_of_vertex.push_back(static_cast<std::uint8_t>(nearest));
  }
  return result;
}

}  // namespace hapticell::mannequin
