// SPDX-License-Identifier: Apache-2.0
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "mannequin/shape/face_shape.h"
#include "mannequin/shape/figure_skin.h"
#include "mannequin/shape/hair_shape.h"
#include "mannequin/shape/head_flesh.h"
#include "mannequin/shape/surface_nets.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

constexpr std::array<float, 3> kSoleColor{0.34f, 0.33f, 0.32f};
constexpr double kSoleHeight = 0.015;                       // m
constexpr double kMostErrors[] = {0.0003, 0.0014, 0.0060};  ///< m that a step may be off; hands and head less.

/// How a layer is made: its colour, its cells (m), and how much finer its steps are than those of a trunk.
struct Cloth {
  std::array<float, 3> color{};
  double cell = 0.008, finer = 1.0;
};
constexpr std::array<Cloth, kLayers> kClothes = {{{{0.32f, 0.45f, 0.60f}, 0.0085, 1.0},
                                                  {{0.23f, 0.25f, 0.30f}, 0.0085, 1.0},
                                                  {{0.12f, 0.12f, 0.13f}, 0.0110, 0.7},
                                                  {{0.16f, 0.15f, 0.15f}, 0.0060, 0.7},
                                                  {kSkinColor, 0.0030, 0.55},
                                                  {kSkinColor, 0.0042, 0.45}}};

/// From the middle of its cell's crossings onto the surface itself, or facets would show: one Newton step.
template <typename Field>
void settle(dvec3& p, double cell, const Field& field) {
  const double value = field(p), h = 0.1 * cell;
  dvec3 slope(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    dvec3 step(0.0);
    step[axis] = h;
    slope[axis] = (field(p + step) - field(p - step)) / (2.0 * h);
  }
  const double square = glm::dot(slope, slope);
  if (square > 0.04) p -= std::clamp(value, -0.5 * cell, 0.5 * cell) / square * slope;
}

std::vector<dvec3> vertexNormals(const geometry::TriangleMesh& mesh) {
  std::vector<dvec3> normals(mesh.vertices.size(), dvec3(0.0));
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const dvec3 normal = glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
    for (const std::uint32_t v : mesh.triangles[t]) normals[v] += normal;
  }
  for (dvec3& normal : normals) {
    const double length = glm::length(normal);
    normal = length > 1e-18 ? normal / length : dvec3(0.0, 0.0, 1.0);
  }
  return normals;
}

}  // namespace

class SkinTailor {
 public:
  SkinTailor(const Figure& figure, FigureSkin& skin)
      : figure_(figure), skin_(skin), shape_(figure), weighing_(figure, shape_) {}

  void make() {
    skin_.step_errors_.assign(std::begin(kMostErrors), std::end(kMostErrors));
    bindBones();
    for (std::size_t i = 0; i < kLayers; ++i) sew(static_cast<Layer>(i));
    for (const Part& part : parts_) finish(part);
    face();
  }

 private:
  using Vertex = FigureSkin::Vertex;
  /// A patch as it is cut out, not yet with its coarser steps.
  struct Part {
    std::size_t body = 0;
    std::array<float, 3> color{};
    bool face = false;
    double finer = 1.0;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
  };

  void bindBones() {
    skin_.bind_ = shape_.places();
    skin_.bind_.resize(kSkinBones);
    const SegmentPlace& head = skin_.bind_[indexOf(S::kHead)];
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const std::size_t i = static_cast<std::size_t>(side);
      skin_.bind_[kEyeBones + i] = {head.R_WS, head.point(eyeCentre(figure_, side))};
      skin_.bind_[kSwungArms + i] = skin_.bind_[indexOf(armSegment(side, S::kLeftUpperArm))];
    }
  }

  geometry::TriangleMesh surface(Layer layer) const {
    const double cell = kClothes[static_cast<std::size_t>(layer)].cell;
    const auto field = [&](const dvec3& p) { return shape_.layer(layer, p); };
    GridField grid{shape_.bounds(layer), cell, {}};
    grid.evaluate = [&](const dvec3&, double, const std::vector<dvec3>& points, std::vector<double>& values) {
      values.resize(points.size());
      std::transform(points.begin(), points.end(), values.begin(), field);
    };
    geometry::TriangleMesh mesh = surfaceOf(grid);
    for (dvec3& vertex : mesh.vertices) settle(vertex, cell, field);
    smoothSkin(mesh);
    return mesh;
  }

  /// Makes a layer's surface and cuts it where the bodies that carry it most change, soles off the shoes.
  void sew(Layer layer) {
    mesh_ = surface(layer);
    std::vector<dvec3> normals = vertexNormals(mesh_);
    hem(layer, normals);
    sewn_.clear();
    over_sole_.clear();
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
      const dvec3& p = mesh_.vertices[v];
      sewn_.push_back({fvec3(p), fvec3(normals[v]), weighing_.at(p), 0.0f});
      over_sole_.push_back(layer == Layer::kShoes ? overSole(p) : 1.0);
    }
    layer_ = layer;
    known_.clear();
    for (const geometry::Triangle& triangle : mesh_.triangles) cut(triangle);
  }

  /// Cuts a layer off at its hems, and turns their edges in so that the cloth has a thickness.
  void hem(Layer layer, std::vector<dvec3>& normals) {
    std::vector<double> within;
    for (const dvec3& p : mesh_.vertices) within.push_back(shape_.withinHems(layer, p));
    if (std::all_of(within.begin(), within.end(), [](double w) { return w >= 0.0; })) return;
    std::vector<geometry::Triangle> kept;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings;
    const auto crossing = [&](std::uint32_t a, std::uint32_t b) {
      const auto [place, is_new] =
          crossings.try_emplace({std::min(a, b), std::max(a, b)}, std::uint32_t(normals.size()));
      if (!is_new) return place->second;
      const double t = within[a] / (within[a] - within[b]);
      mesh_.vertices.push_back(mesh_.vertices[a] + t * (mesh_.vertices[b] - mesh_.vertices[a]));
      normals.push_back(glm::normalize(normals[a] + t * (normals[b] - normals[a])));
      return place->second;
    };
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const geometry::Triangle t : mesh_.triangles) {
      const int inside = int(within[t[0]] >= 0.0) + int(within[t[1]] >= 0.0) + int(within[t[2]] >= 0.0);
      if (inside == 3) kept.push_back(t);
      for (std::size_t i = 0; i < 3 && inside > 0 && inside < 3; ++i) {
        const std::uint32_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
        if ((within[a] >= 0.0) != (inside == 1) || (within[b] >= 0.0) == (within[a] >= 0.0) ||
            (within[c] >= 0.0) == (within[a] >= 0.0))
          continue;  // a stands alone.
        const std::uint32_t ab = crossing(a, b), ac = crossing(a, c);
        if (inside == 1) {
          kept.push_back({a, ab, ac});
          edges.push_back({ab, ac});
        } else {
          kept.push_back({ab, b, c});
          kept.push_back({ab, c, ac});
          edges.push_back({ac, ab});
        }
      }
    }
    mesh_.triangles = std::move(kept);
    turnIn(layer, edges, normals);
  }

  /// From each edge of a hem a strip inwards; `edges` as the triangles beside them have them.
  void turnIn(Layer layer, const std::vector<std::array<std::uint32_t, 2>>& edges, std::vector<dvec3>& normals) {
    const double wide = layer == Layer::kTrousers ? 0.016 : 0.005;  // m
    // m of the differences that tell which way a hem looks; and m between hem and cloth. Half, twice of 20 um:
    // simplifying takes both for one, or a gap is seen.
    constexpr double kStep = 0.001, kApart = 2e-5;
    std::map<std::uint32_t, std::array<std::uint32_t, 2>> strip;  // Of each vertex: its edge, and inside.
    const auto turned = [&](std::uint32_t v) {
      const auto [place, is_new] = strip.try_emplace(v, std::array<std::uint32_t, 2>{});
      if (!is_new) return place->second;
      const dvec3 p = mesh_.vertices[v];
      dvec3 out(0.0);
      for (int axis = 0; axis < 3; ++axis) {
        dvec3 step(0.0);
        step[axis] = kStep;
        out[axis] = shape_.withinHems(layer, p - step) - shape_.withinHems(layer, p + step);
      }
      out = glm::normalize(out);
      const dvec3 normal = normals[v], in = glm::normalize(normal - glm::dot(normal, out) * out);
      for (std::size_t i = 0; i < 2; ++i) {
        place->second[i] = std::uint32_t(normals.size());
        mesh_.vertices.push_back(p + kApart * out - (i == 0 ? 0.0 : wide) * in);
        normals.push_back(out);
      }
      return place->second;
    };
    for (const auto& [a, b] : edges) {
      const auto at_a = turned(a), at_b = turned(b);
      mesh_.triangles.push_back({at_b[0], at_a[0], at_a[1]});
      mesh_.triangles.push_back({at_b[0], at_a[1], at_b[1]});
    }
  }

  double overSole(const dvec3& p) const {
    const Side side = p.y > 0.0 ? Side::kLeft : Side::kRight;
    const SegmentPlace& foot = shape_.places()[indexOf(legSegment(side, S::kLeftFoot))];
    return glm::dot(foot.R_WS[2], p - foot.p_WS) - figure_.sole.z - kSoleHeight;
  }

  // Cutting: a corner of the mesh (`b` as `a`), or the place between two where both owners have equal shares.
  using Key = std::pair<std::uint32_t, std::uint32_t>;
  using Owner = std::pair<std::size_t, bool>;  ///< Body, and whether it is a sole.
  Owner ownerOf(std::uint32_t v) const { return {sewn_[v].weights.owner(), over_sole_[v] < 0.0}; }

  void cut(const geometry::Triangle& t) {
    std::array<Owner, 3> own;
    for (std::size_t i = 0; i < 3; ++i) own[i] = ownerOf(t[i]);
    const auto at = [](std::uint32_t v) { return Key{v, v}; };
    const auto between = [](std::uint32_t a, std::uint32_t b) { return Key{std::min(a, b), std::max(a, b)}; };
    if (own[0] == own[1] && own[1] == own[2]) return take(own[0], {at(t[0]), at(t[1]), at(t[2])});
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      if (own[j] != own[k] || own[i] == own[j]) continue;  // i stands alone.
      const Key ij = between(t[i], t[j]), ik = between(t[i], t[k]);
      take(own[i], {at(t[i]), ij, ik});
      take(own[j], {ij, at(t[j]), at(t[k])});
      take(own[j], {ij, at(t[k]), ik});
      return;
    }
    // Three meet: each corner keeps what is about it.
    sewn_.push_back(mixed({{t[0], 1.0f / 3.0f}, {t[1], 1.0f / 3.0f}, {t[2], 1.0f / 3.0f}}));
    const Key centre = at(static_cast<std::uint32_t>(sewn_.size() - 1));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      take(own[i], {at(t[i]), between(t[i], t[j]), centre});
      take(own[i], {at(t[i]), centre, between(t[i], t[k])});
    }
  }

  void take(const Owner& owner, const std::array<Key, 3>& corners) {
    const Cloth& cloth = kClothes[static_cast<std::size_t>(layer_)];
    auto& known = known_[owner];
    if (known.part == kNone) {
      known.part = parts_.size();
      parts_.push_back({owner.first, owner.second ? kSoleColor : cloth.color, false, cloth.finer, {}, {}});
    }
    Part& part = parts_[known.part];
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [place, is_new] = known.vertices.try_emplace(corners[i], std::uint32_t(part.vertices.size()));
      if (is_new) part.vertices.push_back(vertexOf(corners[i]));
      triangle[i] = place->second;
    }
    part.indices.insert(part.indices.end(), triangle.begin(), triangle.end());
  }

  Vertex vertexOf(const Key& key) const {
    const auto [a, b] = key;
    if (a == b) return sewn_[a];
    const Owner of_a = ownerOf(a), of_b = ownerOf(b);
    double at_a = 0.0, at_b = 0.0;
    if (of_a.first != of_b.first) {
      at_a = shareOf(a, of_a.first) - shareOf(a, of_b.first);
      at_b = shareOf(b, of_a.first) - shareOf(b, of_b.first);
    } else {
      at_a = over_sole_[a];
      at_b = over_sole_[b];
    }
    const double apart = at_a - at_b;
    const float t = std::abs(apart) > 1e-9 ? float(std::clamp(at_a / apart, 0.02, 0.98)) : 0.5f;
    return mixed({{a, 1.0f - t}, {b, t}});
  }

  double shareOf(std::uint32_t v, std::size_t body) const { return static_cast<double>(sewn_[v].weights.of(body)); }

  Vertex mixed(std::initializer_list<std::pair<std::uint32_t, float>> of) const {
    Vertex result;
    std::map<std::uint8_t, float> shares;
    for (const auto& [v, share] : of) {
      result.place += share * sewn_[v].place;
      result.normal += share * sewn_[v].normal;
      for (std::size_t i = 0; i < SkinWeights::kMost; ++i)
        shares[sewn_[v].weights.bone[i]] += share * sewn_[v].weights.share[i];
    }
    result.normal = glm::normalize(result.normal);
    std::vector<std::pair<float, std::uint8_t>> order;
    for (const auto& [body, share] : shares) order.emplace_back(share, body);
    std::sort(order.rbegin(), order.rend());
    float sum = 0.0f;
    for (std::size_t i = 0; i < std::min(order.size(), SkinWeights::kMost); ++i) sum += order[i].first;
    for (std::size_t i = 0; i < std::min(order.size(), SkinWeights::kMost); ++i) {
      result.weights.bone[i] = order[i].second;
      result.weights.share[i] = order[i].first / sum;
    }
    return result;
  }

  /// Adds the coarser steps, all over vertices that the first one keeps, with borders locked.
  void finish(const Part& part) {
    std::vector<std::vector<std::uint32_t>> steps;
    std::vector<std::uint32_t> from = part.indices;
    const double scale = double(meshopt_simplifyScale(&part.vertices[0].place.x, part.vertices.size(), sizeof(Vertex)));
    for (const double error : kMostErrors) {
      std::vector<std::uint32_t> step(from.size());
      step.resize(meshopt_simplify(step.data(), from.data(), from.size(), &part.vertices[0].place.x,
                                   part.vertices.size(), sizeof(Vertex), 0, float(part.finer * error / scale),
                                   meshopt_SimplifyLockBorder, nullptr));
      steps.push_back(step);
      from = std::move(step);
    }
    constexpr std::uint32_t kUnused = ~std::uint32_t{0};
    std::vector<std::uint32_t> kept(part.vertices.size(), kUnused);
    FigureSkin::Patch patch{part.body, part.color, part.face, skin_.vertices_.size(), 0, {}};
    for (const std::uint32_t v : steps[0]) {
      if (kept[v] != kUnused) continue;
      kept[v] = static_cast<std::uint32_t>(patch.count++);
      skin_.vertices_.push_back(part.vertices[v]);
      skin_.vertices_.back().straight = std::min(1.0f, 1.6f * part.vertices[v].weights.straight());
    }
    for (const auto& step : steps) {
      auto& triangles = patch.steps.emplace_back();
      for (std::size_t i = 0; i < step.size(); i += 3)
        triangles.push_back({kept[step[i]], kept[step[i + 1]], kept[step[i + 2]]});
    }
    if (patch.count > 0) skin_.patches_.push_back(std::move(patch));
  }

  /// What a head has beside its skin, and the eyes.
  void face() {
    // m of the grid of the hair; locks are 1 mm high. Half: four times the triangles; twice: locks are lost.
    constexpr double kHairCell = 0.0038;
    const auto add = [&](const FacePiece& piece, std::size_t bone) {
      Part part{indexOf(S::kHead), piece.color, true, 0.6, {}, {}};
      const std::vector<dvec3> normals = vertexNormals(piece.mesh);
      const SegmentPlace& place = skin_.bind_[bone];
      SkinWeights weights;
      weights.bone[0] = static_cast<std::uint8_t>(bone);
      weights.share[0] = 1.0f;
      for (std::size_t v = 0; v < piece.mesh.vertices.size(); ++v)
        part.vertices.push_back(
            {fvec3(place.point(piece.mesh.vertices[v])), fvec3(place.R_WS * normals[v]), weights, 0.0f});
      for (const geometry::Triangle& t : piece.mesh.triangles)
        part.indices.insert(part.indices.end(), t.begin(), t.end());
      finish(part);
    };
    FacePiece hair{kHairColor, hairMesh(figure_, kHairCell)};
    smoothSkin(hair.mesh);
    add(hair, indexOf(S::kHead));
    for (const FacePiece& piece : facePieces(figure_)) add(piece, indexOf(S::kHead));
    for (const Side side : {Side::kLeft, Side::kRight})
      for (const FacePiece& piece : eyePieces(figure_)) add(piece, kEyeBones + static_cast<std::size_t>(side));
  }

  static constexpr std::size_t kNone = ~std::size_t{0};
  struct Known {
    std::size_t part = kNone;
    std::map<Key, std::uint32_t> vertices;
  };

  const Figure& figure_;
  FigureSkin& skin_;
  const SkinShape shape_;
  const SkinWeighing weighing_;
  Layer layer_ = Layer::kShirt;  ///< That is being sewn.
  geometry::TriangleMesh mesh_;
  std::vector<Vertex> sewn_;  ///< Its vertices, then the centres of triangles in which three owners meet.
  std::vector<double> over_sole_;
  std::map<Owner, Known> known_;
  std::vector<Part> parts_;
};

FigureSkin::FigureSkin(const Figure& figure) : figure_(std::make_shared<const Figure>(figure)) {
  SkinTailor(*figure_, *this).make();
}

}  // namespace hapticell::mannequin
