// SPDX-License-Identifier: Apache-2.0
#include "collision/surfaces/surface_model.h"

#include <algorithm>
#include <cmath>

#include "collision/surfaces/hollow_relief.h"
#include "collision/surfaces/surface_model_builder.h"
#include "collision/surfaces/surface_recognition.h"

namespace hapticell::collision {

dvec3 BodyCircle::at(double angle) const {
  return center_M + ring * (std::cos(angle) * e1_M + std::sin(angle) * e2_M);
}

double elementValue(const SurfaceElement& element, const dvec3& p, double radius) {
  double value = signedDistance(element.shape, p) - radius;
  for (const ElementTrim& trim : element.trims) {
    const double t = signedDistance(trim.surface, p) - radius * trim.per_radius;
    value = element.shape.side > 0.0 ? std::min(value, t) : std::max(value, t);
  }
  return value;
}

namespace {

std::shared_ptr<const MeshCollider> linesOf(std::span<const BodyRod> rods) {
  if (rods.empty()) return nullptr;
  geometry::TriangleMesh lines;
  for (const BodyRod& rod : rods) {
    const auto first = static_cast<std::uint32_t>(lines.vertices.size());
    lines.vertices.insert(lines.vertices.end(), {rod.a_M, rod.b_M});
    lines.triangles.push_back({first, first + 1, first + 1});
  }
  return MeshCollider::build(lines);
}

}  // namespace

std::shared_ptr<const SurfaceModel> SurfaceModel::build(const geometry::TriangleMesh& mesh, const ColliderBuild& how) {
  RecognitionOptions options;
  options.cache_folder = how.cache_folder;
  if (how.progress != nullptr) options.cancelled = &how.progress->cancelled;
  RecognisedSurface surface = recogniseSurfaces(mesh, options);
  return options.cancelled != nullptr && *options.cancelled ? nullptr : build(std::move(surface), how);
}

std::shared_ptr<const SurfaceModel> SurfaceModel::build(RecognisedSurface surface, const ColliderBuild& how) {
  std::shared_ptr<SurfaceModel> model(new SurfaceModel);
  model->surface_ = std::move(surface);
  model->collider_ = MeshCollider::build(relievedMesh(model->surface_), how);
  if (!model->collider_) return nullptr;
  ModelBuilder(*model).run();
  for (std::size_t kind = 0; kind < model->rods_.size(); ++kind) {
    model->rod_lines_[kind] = linesOf(model->rods_[kind]);
    for (const BodyRod& rod : model->rods_[kind]) model->thickest_rod_ = std::max(model->thickest_rod_, rod.radius);
  }
  return model;
}

}  // namespace hapticell::collision
