// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/detail_steps.h"

#include <meshoptimizer.h>

#include <algorithm>

namespace hapticell::app {
namespace {

// Nothing is won below; what is large keeps its shape.
constexpr std::size_t kFewTriangles = 100, kFewOfLarge = 600, kLeastShare = 24;
constexpr std::size_t kQuarter = 4;
constexpr float kMostError = 0.1f;       // Of the mesh's size, for collapsing.
constexpr double kWorthwhile = 0.6;      // A step must have at most this share of the one before.
constexpr std::size_t kCoarsest = 3000;  // Triangles; where collapsing leaves more, clustering makes fewer.
constexpr float kClusterError = 0.05f;

/// The largest side of the box of all vertices: what meshoptimizer's errors are shares of.
double extentOf(const DisplayMesh& mesh) {
  const dvec3 size = mesh.bounds.size();
  return std::max({size.x, size.y, size.z});
}

struct Coarser {
  std::vector<std::uint32_t> indices;
  float error = 0.0f;
};

using Simplifier = std::size_t (*)(unsigned int*, const unsigned int*, std::size_t, const float*, std::size_t,
                                   std::size_t, std::size_t, float, float*);

Coarser coarser(const DisplayMesh& mesh, const std::vector<std::uint32_t>& from, std::size_t triangles,
                float most_error, Simplifier simplify) {
  Coarser result;
  result.indices.resize(from.size());
  const std::size_t count =
      simplify(result.indices.data(), from.data(), from.size(), &mesh.vertices.front().position.x, mesh.vertices.size(),
               sizeof(DisplayVertex), 3 * triangles, most_error, &result.error);
  result.indices.resize(count);
  return result;
}

std::size_t collapse(unsigned int* to, const unsigned int* from, std::size_t count, const float* positions,
                     std::size_t vertices, std::size_t stride, std::size_t wanted, float most_error, float* error) {
  return meshopt_simplify(to, from, count, positions, vertices, stride, wanted, most_error, 0, error);
}

void append(DisplayMesh& mesh, const Coarser& step, double extent, std::size_t& last_count) {
  const double before = mesh.steps.back().error;
  mesh.steps.push_back({mesh.indices.size(), step.indices.size(), before + static_cast<double>(step.error) * extent});
  mesh.indices.insert(mesh.indices.end(), step.indices.begin(), step.indices.end());
  last_count = step.indices.size();
}

}  // namespace

void addDetailSteps(DisplayMesh& mesh) {
  if (mesh.steps.empty() || mesh.vertices.empty()) return;
  const double extent = extentOf(mesh);
  std::vector<std::uint32_t> from = mesh.indices;
  std::size_t last_count = from.size();
  const std::size_t few = std::clamp(last_count / 3 / kLeastShare, kFewTriangles, kFewOfLarge);
  while (last_count / 3 > few) {
    Coarser step = coarser(mesh, from, last_count / 3 / kQuarter, kMostError, collapse);
    if (static_cast<double>(step.indices.size()) > kWorthwhile * static_cast<double>(last_count)) break;
    append(mesh, step, extent, last_count);
    from = std::move(step.indices);
  }
  if (last_count / 3 <= kCoarsest) return;
  Coarser last = coarser(mesh, from, kCoarsest, kClusterError, meshopt_simplifySloppy);
  if (last.indices.empty())  // So fine that all of it falls together within that error.
    last = coarser(mesh, from, kCoarsest, 1.0f, meshopt_simplifySloppy);
  if (!last.indices.empty() && last.indices.size() < last_count) append(mesh, last, extent, last_count);
}

std::size_t detailStepFor(const std::vector<DetailStep>& steps, double metres_per_pixel, double pixels) {
  std::size_t chosen = 0;
  while (chosen + 1 < steps.size() && steps[chosen + 1].error <= pixels * metres_per_pixel) ++chosen;
  return chosen;
}

}  // namespace hapticell::app
