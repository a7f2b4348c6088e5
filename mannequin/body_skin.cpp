// SPDX-License-Identifier: Apache-2.0
#include "mannequin/body_skin.h"

#include <algorithm>
#include <utility>

#include "geometry/hollows.h"
#include "mannequin/face_shape.h"
#include "mannequin/hair_shape.h"
#include "mannequin/rotations.h"
#include "mannequin/skin_cutter.h"
#include "mannequin/surface_nets.h"

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
  constexpr double kArmpit = 0.035, kArmpitReach = 0.28, kThighs = 0.030, kThighsReach = 0.24;  // m
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
  static constexpr double kLeastBlend = 1e-4;  // m

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

/// Rounds off what is as fine as the cells without shrinking: G. Taubin, "A
/// signal processing approach to fair surface design" (1995), its pair of steps
/// a few times.
void smooth(geometry::TriangleMesh& mesh) {
  constexpr int kPasses = 6;
  constexpr double kInward = 0.55, kOutward = -0.58;
  std::vector<dvec3> sum(mesh.vertices.size());
  std::vector<double> count(mesh.vertices.size());
  for (int pass = 0; pass < 2 * kPasses; ++pass) {
    std::fill(sum.begin(), sum.end(), dvec3(0.0));
    std::fill(count.begin(), count.end(), 0.0);
    for (const geometry::Triangle& t : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        sum[t[i]] += mesh.vertices[t[(i + 1) % 3]] + mesh.vertices[t[(i + 2) % 3]];
        count[t[i]] += 2.0;
      }
    }
    const double share = pass % 2 == 0 ? kInward : kOutward;
    for (std::size_t v = 0; v < sum.size(); ++v) {
      if (count[v] > 0.0) mesh.vertices[v] += share * (sum[v] / count[v] - mesh.vertices[v]);
    }
  }
}

/// A figure placed in a posture, as a field and what it is made of.
class PlacedSkin {
 public:
  PlacedSkin(const Figure& figure, const Posture& posture)
      : flesh_(fleshOf(figure)), bodies_(placeBodies(figure, posture, flesh_)), field_(flesh_, bodies_) {}

  /// The whole; what closes in upon itself within the body (between thighs and belly) is left out.
  geometry::TriangleMesh surface(double cell) {
    return geometry::withoutHollows(surface(cell, [](std::size_t) { return true; }));
  }

  /// The surface about some of the bodies.
  template <typename Wanted>
  geometry::TriangleMesh surface(double cell, const Wanted& wanted) {
    GridField grid{{}, cell, {}};
    for (std::size_t i = 0; i < kBodies; ++i) {
      if (wanted(i)) grid.bounds.add(geometry::transformed(bodies_[i].place.pose(), flesh_[i].bounds()));
    }
    grid.evaluate = [this](const dvec3& centre, double radius, const std::vector<dvec3>& points,
                           std::vector<double>& values) {
      field_.choose(centre, points.size() == 1 ? 2.0 * radius : radius);
      values.resize(points.size());
      for (std::size_t i = 0; i < points.size(); ++i) values[i] = field_.value(points[i]);
    };
    geometry::TriangleMesh mesh = surfaceOf(grid);
    for (dvec3& vertex : mesh.vertices) settle(vertex, cell);
    smooth(mesh);
    return mesh;
  }

  /// Distances of all bodies to a point on the surface.
  const std::array<double, kBodies>& distancesAt(const dvec3& p, double cell) {
    field_.choose(p, cell);
    field_.measure(p);
    return field_.distances();
  }

  /// How far (m) a point lies over the floor that a body's flesh ends at, along the body's own z.
  double overFloor(std::size_t body, const dvec3& p) const {
    const SegmentPlace& place = bodies_[body].place;
    return glm::dot(place.R_WS[2], p - place.p_WS) - flesh_[body].floor;
  }

  const std::vector<Flesh>& flesh() const { return flesh_; }

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

constexpr double kOverlap = 0.004;  ///< m that hands and head reach under cuffs and collar.

/// Sinks what reaches under the neighbour, so that its edge lies over it: two surfaces in one place would show a ragged
/// line. `beyond`: m beyond the border, by vertex.
void sink(geometry::TriangleMesh& mesh, const std::vector<double>& beyond) {
  constexpr double kSlope = 2.5, kEdge = 0.0006, kMost = 0.003;  // The latter two in m.
  std::vector<dvec3> normals(mesh.vertices.size(), dvec3(0.0));
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const dvec3 normal = glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
    for (const std::uint32_t v : mesh.triangles[t]) normals[v] += normal;
  }
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const double length = glm::length(normals[v]);
    if (beyond[v] <= -kEdge || length < 1e-15) continue;
    mesh.vertices[v] -= std::min(kMost, kSlope * (beyond[v] + kEdge)) / length * normals[v];
  }
}

bool isOfHand(std::size_t body, Side side) {
  // From the cuff on: where what has one colour is of two meshes, a line is seen between them.
  if (body < kSegmentCount)
    return body == indexOf(armSegment(side, S::kLeftHand)) || body == indexOf(armSegment(side, S::kLeftWrist));
  return (body - kSegmentCount) / (kDigits * kPhalanges) == static_cast<std::size_t>(side);
}
bool isOfHand(std::size_t body) {
  return isOfHand(body, Side::kLeft) || isOfHand(body, Side::kRight);
}

/// From the collar on.
bool isOfHead(std::size_t body) {
  return body == indexOf(S::kHead) || body == indexOf(S::kUpperNeck) || body == indexOf(S::kLowerNeck);
}

SkinRegion regionOf(std::size_t body) {
  if (isOfHand(body)) return SkinRegion::kHands;
  return isOfHead(body) ? SkinRegion::kHead : SkinRegion::kBody;
}

/// Which colour each body has, those of other regions apart; the colours in the order of their first body.
struct Wardrobe {
  Wardrobe(const std::vector<std::array<float, 3>>& worn, SkinRegion region) {
    for (std::size_t i = 0; i < kBodies; ++i) {
      if (region != SkinRegion::kWhole && regionOf(i) != region) {
        group[i] = kLeftOut;
        continue;
      }
      const auto known = std::find(colors.begin(), colors.end(), worn[i]);
      group[i] = static_cast<std::size_t>(known - colors.begin());
      if (known == colors.end()) colors.push_back(worn[i]);
    }
  }
  static constexpr std::size_t kLeftOut = kMostGroups - 1;
  std::vector<std::array<float, 3>> colors;
  std::array<std::size_t, kBodies> group{};
};

constexpr std::array<float, 3> kSoles{0.34f, 0.33f, 0.32f};
constexpr double kSoleThickness = 0.016;  // m
constexpr std::array kShod = {S::kLeftFoot, S::kLeftToes, S::kRightFoot, S::kRightToes};

/// Whether shoes are worn in their own colour, and in this region.
bool hasSoles(const std::vector<std::array<float, 3>>& worn, const std::vector<Flesh>& flesh, SkinRegion region) {
  if (region != SkinRegion::kWhole && region != SkinRegion::kBody) return false;
  return std::all_of(kShod.begin(), kShod.end(), [&](S s) { return worn[indexOf(s)] == flesh[indexOf(s)].color; });
}

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

std::vector<SkinPart> skinParts(const Figure& figure, const Posture& posture, double cell, SkinRegion region,
                                std::span<const std::array<float, 3>> colors) {
  PlacedSkin placed(figure, posture);
  geometry::TriangleMesh whole;
  if (region == SkinRegion::kHead) {
    whole = placed.surface(cell, isOfHead);
  } else if (region == SkinRegion::kHands) {
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const auto hand = placed.surface(cell, [side](std::size_t body) { return isOfHand(body, side); });
      geometry::append(whole, hand, Pose::identity());
    }
  } else {
    whole = placed.surface(cell);
  }
  std::vector<std::array<float, 3>> worn(colors.begin(), colors.end());
  for (std::size_t i = worn.size(); i < kBodies; ++i) worn.push_back(placed.flesh()[i].color);
  Wardrobe wardrobe(worn, region);
  const std::size_t soles = wardrobe.colors.size();
  const bool has_soles = soles < Wardrobe::kLeftOut && hasSoles(worn, placed.flesh(), region);
  if (has_soles) wardrobe.colors.push_back(kSoles);
  std::vector<GroupDistances> distances(whole.vertices.size());
  const bool reaches_under = region == SkinRegion::kHands || region == SkinRegion::kHead;
  const double overlap = reaches_under ? kOverlap : 0.0;
  std::vector<double> beyond(whole.vertices.size(), 0.0);
  for (std::size_t v = 0; v < whole.vertices.size(); ++v) {
    distances[v].fill(1e9);
    const auto& of_bodies = placed.distancesAt(whole.vertices[v], cell);
    for (std::size_t i = 0; i < kBodies; ++i) {
      double& least = distances[v][wardrobe.group[i]];
      least = std::min(least, of_bodies[i] + (wardrobe.group[i] == Wardrobe::kLeftOut ? overlap : 0.0));
    }
    if (has_soles) {
      for (const S shod : kShod)
        distances[v][soles] = std::min(distances[v][soles], of_bodies[indexOf(shod)] - kSoleThickness +
                                                                placed.overFloor(indexOf(shod), whole.vertices[v]));
    }
    const double others = distances[v][Wardrobe::kLeftOut] - overlap;
    beyond[v] = *std::min_element(distances[v].begin(), distances[v].end() - 1) - others;
  }
  if (reaches_under) sink(whole, beyond);
  std::vector<geometry::TriangleMesh> cut = cutByGroups(whole, distances);
  std::vector<SkinPart> parts;
  for (std::size_t g = 0; g < wardrobe.colors.size(); ++g)
    if (!cut[g].triangles.empty()) parts.push_back({wardrobe.colors[g], std::move(cut[g])});
  return parts;
}

std::vector<SkinPart> faceParts(const Figure& figure, const Posture& posture) {
  constexpr double kCell = 0.006;  // m
  std::vector<SkinPart> parts{{kHairColor, hairMesh(figure, kCell)}};
  smooth(parts.front().mesh);
  const SegmentPlace head = forwardKinematics(figure, posture)[S::kHead];
  for (dvec3& vertex : parts.front().mesh.vertices) vertex = head.point(vertex);
  const auto add = [&](const FacePiece& piece, const dmat3& R_HeadPiece, const dvec3& p_HeadPiece) {
    geometry::TriangleMesh mesh = piece.mesh;
    for (dvec3& vertex : mesh.vertices) vertex = head.point(p_HeadPiece + R_HeadPiece * vertex);
    for (SkinPart& known : parts) {
      if (known.color == piece.color) return geometry::append(known.mesh, mesh, Pose::identity());
    }
    parts.push_back({piece.color, std::move(mesh)});
  };
  for (const FacePiece& piece : facePieces(figure)) add(piece, dmat3(1.0), dvec3(0.0));
  for (const Side side : {Side::kLeft, Side::kRight})
    for (const FacePiece& piece : eyePieces(figure)) add(piece, eyeRotation(posture.gaze), eyeCentre(figure, side));
  return parts;
}

}  // namespace hapticell::mannequin
