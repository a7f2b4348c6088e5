// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/tools/feature_picker.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "app/viewport/meshes/edge_chains.h"
#include "collision/surfaces/surface_recognition.h"

namespace hapticell::app {
namespace {

// 40 degrees: the flood goes on over such an edge, more than coarse chords turn by. Half: coarse cylinders are not
// recognised; twice: it floods over corners.
constexpr double kSmoothCosine = 0.76604;
// Meshes whose neighbourhoods are kept: the hand goes between a few parts. Half: made again; twice: memory.
constexpr std::size_t kKeptMeshes = 4;

collision::Ray rayIn(const Pose& X_WM, const Ray& ray_W) {
  const Pose X_MW = X_WM.inverse();
  return {X_MW * ray_W.origin_W, X_MW.rotate(ray_W.direction_W)};
}

/// The nearest triangle that the ray meets; its number and how far along. `doubtful`: it goes right through an edge of
/// one, where neither neighbour is met, so that what is found may lie behind.
std::optional<std::pair<std::uint32_t, double>> firstTriangle(const geometry::TriangleMesh& mesh,
                                                              const collision::Ray& ray, bool* doubtful = nullptr) {
  std::optional<std::pair<std::uint32_t, double>> first;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto crossing = collision::meetTriangle(ray, mesh.corners(t));
    if (crossing.meets && crossing.along > 0.0 && (!first || crossing.along < first->second))
      first.emplace(t, crossing.along);
    const auto edge = [&](int i) { return mesh.corner(t, i) - mesh.corner(t, 0); };
    if (doubtful && crossing.grazes && glm::length(glm::cross(edge(1), edge(2))) > 0.0) *doubtful = true;
  }
  return first;
}

dvec3 normalOf(const geometry::TriangleMesh& mesh, std::uint32_t triangle) {
  const dvec3 a = mesh.corner(triangle, 0);
  const dvec3 n = glm::cross(mesh.corner(triangle, 1) - a, mesh.corner(triangle, 2) - a);
  const double length = glm::length(n);
  return length > 0.0 ? n / length : dvec3(0.0);
}

collision::SurfaceShape placed(const collision::SurfaceShape& shape_M, const Pose& X_WM) {
  collision::SurfaceShape shape_W = shape_M;
  shape_W.p_M = X_WM * shape_M.p_M;
  shape_W.axis_M = X_WM.rotate(shape_M.axis_M);
  return shape_W;
}

Ray sightThrough(const FeaturePicker::Question& question) {
  const Ray ray_W = question.camera.rayThrough(question.pixel, question.size);
  return question.section ? fromSection(*question.section, ray_W) : ray_W;
}

/// The point of the segment that is nearest to the pixel in the picture, and how far it is, pixels.
struct SeenPoint {
  dvec3 p_W{0.0};
  double pixels = 1e300;
};

SeenPoint nearestSeen(const dvec3& a_W, const dvec3& b_W, const FeaturePicker::Question& question) {
  const auto a = question.camera.project(a_W, question.size);
  const auto b = question.camera.project(b_W, question.size);
  if (!a || !b) return {};
  const glm::dvec2 along = *b - *a;
  const double length2 = glm::dot(along, along);
  const double s = length2 > 0.0 ? std::clamp(glm::dot(question.pixel - *a, along) / length2, 0.0, 1.0) : 0.0;
  // In perspective equal steps on the screen are not equal steps on the edge: divide by the depths.
  const double za = glm::dot(a_W - question.camera.eye_W(), question.camera.forward_W());
  const double zb = glm::dot(b_W - question.camera.eye_W(), question.camera.forward_W());
  const double t = question.camera.perspective && s > 0.0 && s < 1.0 ? s * za / (s * za + (1.0 - s) * zb) : s;
  return {a_W + t * (b_W - a_W), glm::distance(question.pixel, *a + s * along)};
}

}  // namespace

/// Which triangles meet at each vertex.
struct FeaturePicker::Incidence {
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  std::vector<std::uint32_t> start;  // Of vertex v in `triangles`; one more at the end.
  std::vector<std::uint32_t> triangles;
};

/// What surrounds a triangle, with its surfaces and their borders.
struct FeaturePicker::Patch {
  const geometry::TriangleMesh* of = nullptr;
  std::unordered_set<std::uint32_t> core;  // Hits on these are well inside.
  collision::RecognisedSurface surface;
  std::uint32_t region = 0;
  std::vector<EdgeChain> chains;  // Borders of the region.

  void findRegion(const collision::Ray& ray) {
    const auto hit = firstTriangle(surface.mesh, ray);
    const std::uint32_t next = hit ? surface.region_of[hit->first] : region;
    if (next == region && !chains.empty()) return;
    region = next;
    std::vector<EdgeEnds> edges;
    for (const std::uint32_t t : surface.regions[region].triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t beside = surface.neighbour[t][k];
        if (beside != collision::RecognisedSurface::kNone && surface.region_of[beside] == region) continue;
        edges.push_back({surface.mesh.triangles[t][k], surface.mesh.triangles[t][(k + 1) % 3]});
      }
    }
    chains = edgeChains(edges, surface.mesh.vertices);
  }
};

FeaturePicker::FeaturePicker() = default;
FeaturePicker::~FeaturePicker() = default;

std::optional<FeaturePicker::Hit> FeaturePicker::meet(const Question& question, const Ray& ray_W) {
  std::optional<Hit> best;
  for (const RenderItem& item : *question.items) {
    if (item.entity != question.entity || item.link != question.link || !item.mesh) continue;
    bool doubtful = false;
    const auto hit = firstTriangle(*item.mesh, rayIn(item.X_WM, ray_W), &doubtful);
    if (doubtful) return std::nullopt;
    if (hit && (!best || hit->second < best->along)) best = Hit{&item, hit->first, hit->second};
  }
  return best;
}

std::shared_ptr<const FeaturePicker::Incidence> FeaturePicker::incidenceOf(
    const std::shared_ptr<const geometry::TriangleMesh>& mesh) {
  const auto known =
      std::find_if(incidences_.begin(), incidences_.end(), [&](const auto& i) { return i->mesh == mesh; });
  if (known != incidences_.end()) {
    incidences_.splice(incidences_.begin(), incidences_, known);
    return incidences_.front();
  }
  auto made = std::make_shared<Incidence>();
  made->mesh = mesh;
  made->start.assign(mesh->vertices.size() + 1, 0);
  for (const geometry::Triangle& t : mesh->triangles)
    for (const std::uint32_t v : t) ++made->start[v + 1];
  for (std::size_t v = 1; v < made->start.size(); ++v) made->start[v] += made->start[v - 1];
  made->triangles.resize(3 * mesh->triangles.size());
  std::vector<std::uint32_t> next(made->start.begin(), made->start.end() - 1);
  for (std::uint32_t t = 0; t < mesh->triangles.size(); ++t)
    for (const std::uint32_t v : mesh->triangles[t]) made->triangles[next[v]++] = t;
  incidences_.push_front(std::move(made));
  if (incidences_.size() > kKeptMeshes) incidences_.pop_back();
  return incidences_.front();
}

const FeaturePicker::Patch& FeaturePicker::patchAbout(const Hit& hit, const collision::Ray& ray_M) {
  const geometry::TriangleMesh& mesh = *hit.item->mesh;
  if (patch_ && patch_->of == &mesh && patch_->core.contains(hit.triangle)) {
    patch_->findRegion(ray_M);
    return *patch_;
  }
  const auto incidence = incidenceOf(hit.item->mesh);
  std::vector<std::uint32_t> flood{hit.triangle};
  std::unordered_set<std::uint32_t> seen{hit.triangle};
  for (std::size_t i = 0; i < flood.size() && flood.size() < kFloodLimit; ++i) {
    const geometry::Triangle& t = mesh.triangles[flood[i]];
    const dvec3 n = normalOf(mesh, flood[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      for (std::uint32_t j = incidence->start[a]; j < incidence->start[a + 1]; ++j) {
        const std::uint32_t other = incidence->triangles[j];
        const geometry::Triangle& u = mesh.triangles[other];
        if (seen.contains(other) || (u[0] != b && u[1] != b && u[2] != b)) continue;
        if (glm::dot(n, normalOf(mesh, other)) < kSmoothCosine) continue;
        seen.insert(other);
        flood.push_back(other);
      }
    }
  }
  geometry::TriangleMesh part;
  std::unordered_map<std::uint32_t, std::uint32_t> renamed;
  for (const std::uint32_t t : flood) {
    geometry::Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [at, fresh] =
          renamed.try_emplace(mesh.triangles[t][k], static_cast<std::uint32_t>(part.vertices.size()));
      if (fresh) part.vertices.push_back(mesh.vertices[at->first]);
      triangle[k] = at->second;
    }
    part.triangles.push_back(triangle);
  }
  auto fresh = std::make_unique<Patch>();
  fresh->of = &mesh;
  // A flood that was cut off knows its middle only.
  const std::size_t known = flood.size() < kFloodLimit ? flood.size() : flood.size() / 8;
  fresh->core.insert(flood.begin(), flood.begin() + static_cast<std::ptrdiff_t>(known));
  fresh->surface = collision::recogniseSurfaces(part);
  patch_ = std::move(fresh);
  if (!patch_->surface.regions.empty()) patch_->findRegion(ray_M);
  return *patch_;
}

std::optional<FeaturePicker::Hit> FeaturePicker::hitOrNear(Question& question, Ray& ray_W) {
  ray_W = sightThrough(question);
  if (auto hit = meet(question, ray_W)) return hit;
  // Right through an edge of the mesh nothing is met: a little beside it.
  question.pixel += glm::dvec2(0.013, 0.007);
  ray_W = sightThrough(question);
  return meet(question, ray_W);
}

/// The border edge and the corner that are seen nearest to the pixel.
FeaturePicker::Snap FeaturePicker::snap(const Patch& patch, const Pose& X_WM, const Question& question) {
  Snap snap;
  const auto point = [&](std::uint32_t v) { return X_WM * patch.surface.mesh.vertices[v]; };
  for (const EdgeChain& chain : patch.chains) {
    for (std::size_t i = 1; i < chain.vertices.size(); ++i) {
      const SeenPoint seen = nearestSeen(point(chain.vertices[i - 1]), point(chain.vertices[i]), question);
      if (seen.pixels < snap.edge_pixels) snap.edge_pixels = seen.pixels, snap.p_WEdge = seen.p_W, snap.chain = &chain;
    }
    if (chain.vertices.front() == chain.vertices.back()) continue;
    for (const std::uint32_t v : {chain.vertices.front(), chain.vertices.back()}) {
      const SeenPoint seen = nearestSeen(point(v), point(v), question);
      if (seen.pixels < snap.corner_pixels) snap.corner_pixels = seen.pixels, snap.p_WCorner = seen.p_W;
    }
  }
  return snap;
}

std::optional<PickedFeature> FeaturePicker::pick(const Question& asked) {
  Question question = asked;
  Ray ray_W;
  const std::optional<Hit> hit = hitOrNear(question, ray_W);
  if (!hit) return std::nullopt;
  const Pose& X_WM = hit->item->X_WM;
  PickedFeature feature;
  feature.entity = question.entity;
  feature.link = question.link;
  feature.mesh = hit->item->mesh;
  feature.X_WM = X_WM;
  feature.triangle = hit->triangle;
  feature.p_WHit = feature.p_WQ = ray_W.origin_W + hit->along * ray_W.direction_W;
  feature.nhat_W = X_WM.rotate(normalOf(*hit->item->mesh, hit->triangle));
  if (glm::dot(feature.nhat_W, ray_W.direction_W) > 0.0) feature.nhat_W = -feature.nhat_W;
  const Patch& patch = patchAbout(*hit, rayIn(X_WM, ray_W));
  const Snap near = snap(patch, X_WM, question);
  const auto draw = [&](const EdgeChain& chain) {
    std::vector<dvec3>& line = feature.outline_W.emplace_back();
    for (const std::uint32_t v : chain.vertices) line.push_back(X_WM * patch.surface.mesh.vertices[v]);
  };
  if (question.filter.vertices && near.corner_pixels <= kVertexPixels) {
    feature.kind = FeatureKind::kVertex;
    feature.p_WQ = near.p_WCorner;
    return feature;
  }
  if (question.filter.edges && near.chain && (near.edge_pixels <= kEdgePixels || !question.filter.faces)) {
    feature.kind = FeatureKind::kEdge;
    feature.p_WQ = near.p_WEdge;
    feature.edge = near.chain->is_circle ? EdgeShape::kCircle
                   : near.chain->is_line ? EdgeShape::kLine
                                         : EdgeShape::kCurve;
    feature.center_W = X_WM * near.chain->center;
    feature.axis_W = X_WM.rotate(near.chain->axis);
    feature.radius = near.chain->radius;
    draw(*near.chain);
    return feature;
  }
  if (!question.filter.faces) return std::nullopt;
  for (const EdgeChain& chain : patch.chains) draw(chain);
  if (!patch.surface.regions.empty()) feature.surface_W = placed(patch.surface.regions[patch.region].shape, X_WM);
  return feature;
}

}  // namespace hapticell::app
