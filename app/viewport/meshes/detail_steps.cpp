// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/meshes/detail_steps.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <span>

#include "app/viewport/meshes/surface_tree.h"
#include "app/viewport/meshes/vertex_clusters.h"

namespace hapticell::app {
namespace {

// Nothing is won below. Half, twice: no effect on the time of a picture.
constexpr std::size_t kLeastTriangles = 60;
// Of the triangles of the step before: six steps to 0.2 %. Half: differences between levels are larger; twice: twice
// the steps and their time.
constexpr double kWanted = 0.35;
// A step must have at most this share of them, else no further one is made. Half: good steps are dropped; over 1: never
// ends.
constexpr double kWorthwhile = 0.7;
// Of the mesh's size: beyond it is another shape. Half: far parts keep more triangles; twice: they lose their arms.
constexpr double kMostError = 0.05;
// Of the mesh's size: nearer than that nothing is measured; under 0.2 pixels of a part of 1000. Half: twice the time;
// twice: 0.4 pixels.
constexpr double kUnseen = 2e-4;
// Triangles: where collapsing leaves more, clustering makes fewer. Half: clusters where collapsed ones do; twice: far
// scans are slow.
constexpr std::size_t kStillMany = 3000;
// Cells along the mesh: a far part of 100 pixels has one each. Half: it is seen; twice: four times the triangles.
constexpr int kClusterCells = 100;
// Triangles that are simplified in one go: some 0.2 s, until it can be given up. Half: more borders that stay; twice:
// closing waits for 0.4 s.
constexpr std::size_t kPiece = 200000;
constexpr std::uint32_t kNoPlace = ~std::uint32_t{0};

/// The largest side of the box of all vertices.
double extentOf(const DisplayMesh& mesh) {
  const dvec3 size = mesh.bounds.size();
  return std::max({size.x, size.y, size.z});
}

class Simplifier {
 public:
  Simplifier(DisplayMesh& mesh, double crease_angle, const std::atomic<bool>* given_up)
      : mesh_(mesh),
        crease_angle_(crease_angle),
        given_up_(given_up),
        extent_(extentOf(mesh)),
        whole_(mesh.vertices, std::span(mesh.indices).first(mesh.steps[0].count)),
        place_(mesh.vertices.size(), kNoPlace) {}

  void run() {
    std::vector<std::uint32_t> from = whole_.indices();
    std::size_t last = from.size();
    while (last / 3 > kLeastTriangles && !over()) {
      double error = 0.0;
      std::vector<std::uint32_t> step = collapsed(from, error);
      if (static_cast<double>(step.size()) > kWorthwhile * static_cast<double>(last) || over()) break;
      estimated_ += error;
      if (!append(meshOf(step))) return;
      last = step.size();
      from = std::move(step);
    }
    if (last / 3 <= kStillMany || over()) return;
    geometry::TriangleMesh gathered = clustered(meshOf(from), kClusterCells);
    if (2 * gathered.triangles.size() < last / 3) append(gathered);
  }

 private:
  bool over() const { return given_up_ && given_up_->load(std::memory_order_relaxed); }

  /// Piece by piece; what borders on another piece stays as it is.
  std::vector<std::uint32_t> collapsed(const std::vector<std::uint32_t>& from, double& error) {
    std::vector<std::uint32_t> result;
    for (std::size_t first = 0; first < from.size() && !over(); first += 3 * kPiece) {
      const std::span<const std::uint32_t> piece =
          std::span(from).subspan(first, std::min(3 * kPiece, from.size() - first));
      collapse(piece, result, error);
    }
    return result;
  }

  void collapse(std::span<const std::uint32_t> piece, std::vector<std::uint32_t>& result, double& error) {
    // Its own vertices only: the library's work grows with their number.
    std::vector<std::uint32_t> used, local, simpler(piece.size());
    std::vector<fvec3> positions;
    for (const std::uint32_t v : piece) {
      if (place_[v] == kNoPlace) {
        place_[v] = static_cast<std::uint32_t>(used.size());
        used.push_back(v);
        positions.push_back(mesh_.vertices[v].position);
      }
      local.push_back(place_[v]);
    }
    for (const std::uint32_t v : used) place_[v] = kNoPlace;
    const auto wanted = 3 * static_cast<std::size_t>(kWanted * static_cast<double>(piece.size()) / 3.0);
    // Errors are shares of the piece's own size.
    const double scale = static_cast<double>(meshopt_simplifyScale(&positions[0].x, positions.size(), sizeof(fvec3)));
    const auto most = static_cast<float>(scale > 0.0 ? kMostError * extent_ / scale : 0.0);
    float off = 0.0f;
    const std::size_t count =
        meshopt_simplify(simpler.data(), local.data(), local.size(), &positions[0].x, positions.size(), sizeof(fvec3),
                         wanted, most, meshopt_SimplifyLockBorder, &off);
    for (std::size_t i = 0; i < count; ++i) result.push_back(used[simpler[i]]);
    error = std::max(error, static_cast<double>(off) * scale);
  }

  /// Triangles between vertices of the whole mesh, in M.
  geometry::TriangleMesh meshOf(const std::vector<std::uint32_t>& indices) {
    geometry::TriangleMesh result;
    std::vector<std::uint32_t> used;
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const std::uint32_t v = indices[i];
      if (place_[v] == kNoPlace) {
        place_[v] = static_cast<std::uint32_t>(result.vertices.size());
        result.vertices.push_back(mesh_.center + dvec3(mesh_.vertices[v].position));
        used.push_back(v);
      }
      if (i % 3 == 0) result.triangles.emplace_back();
      result.triangles.back()[i % 3] = place_[v];
    }
    for (const std::uint32_t v : used) place_[v] = kNoPlace;
    return result;
  }

  /// As the next step; false where it is too far off.
  bool append(const geometry::TriangleMesh& step) {
    const std::size_t first = mesh_.indices.size(), first_vertex = mesh_.vertices.size();
    addSmoothed(step, crease_angle_, mesh_);
    const std::span<const std::uint32_t> all(mesh_.indices), drawn = all.subspan(first);
    const SurfaceTree surface(mesh_.vertices, drawn);
    const double least = std::max({estimated_, mesh_.steps.back().error, kUnseen * extent_});
    const double error = deviation(mesh_.vertices, drawn, whole_,
                                   deviation(mesh_.vertices, all.first(mesh_.steps[0].count), surface, least));
    if (!(error <= kMostError * extent_)) {
      mesh_.indices.resize(first);
      mesh_.vertices.resize(first_vertex);
      return false;
    }
    mesh_.steps.push_back({first, drawn.size(), error});
    return true;
  }

  DisplayMesh& mesh_;
  const double crease_angle_;
  const std::atomic<bool>* given_up_;
  const double extent_;
  const SurfaceTree whole_;
  std::vector<std::uint32_t> place_;  ///< Of vertices of the whole mesh among those in use; scratch.
  double estimated_ = 0.0;            ///< Metres, by the quadrics of all steps.
};

}  // namespace

void addDetailSteps(DisplayMesh& mesh, double crease_angle, const std::atomic<bool>* given_up) {
  if (mesh.steps.empty() || mesh.vertices.empty() || (given_up && given_up->load())) return;
  Simplifier(mesh, crease_angle, given_up).run();
}

std::size_t detailStepFor(const std::vector<DetailStep>& steps, double metres_per_pixel, double pixels) {
  std::size_t chosen = 0;
  while (chosen + 1 < steps.size() && steps[chosen + 1].error <= pixels * metres_per_pixel) ++chosen;
  return chosen;
}

}  // namespace hapticell::app
