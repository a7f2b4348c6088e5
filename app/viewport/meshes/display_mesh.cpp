// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/meshes/display_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>

namespace hapticell::app {
namespace {

/// Whether the mesh is still wanted, looked at now and then.
struct Given {
  const std::atomic<bool>* up = nullptr;
  bool now() const { return up && up->load(std::memory_order_relaxed); }
  bool at(std::size_t i) const { return i % 8192 == 0 && now(); }
};

struct PositionHash {
  std::size_t operator()(const dvec3& p) const {
    std::uint64_t h = 1469598103934665603ULL;
    for (int i = 0; i < 3; ++i) h = (h ^ std::bit_cast<std::uint64_t>(p[i] + 0.0)) * 1099511628211ULL ^ (h >> 29);
    return h;
  }
};

/// For each vertex, the lowest index that has the same position: files without shared vertices are smoothed all the
/// same.
std::vector<std::uint32_t> representatives(const geometry::TriangleMesh& mesh, const Given& given_up) {
  std::unordered_map<dvec3, std::uint32_t, PositionHash> first;
  first.reserve(mesh.vertices.size());
  std::vector<std::uint32_t> result(mesh.vertices.size());
  for (std::uint32_t i = 0; i < mesh.vertices.size() && !given_up.at(i); ++i)
    result[i] = first.try_emplace(mesh.vertices[i], i).first->second;
  return result;
}

struct Faces {
  std::vector<dvec3> normals;  // Unit; zero for a face without area.
  std::vector<double> areas;   // Twice the area.
};

Faces facesOf(const geometry::TriangleMesh& mesh) {
  Faces faces;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const dvec3 n = glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
    const double length = glm::length(n);
    faces.areas.push_back(length);
    faces.normals.push_back(length > 0.0 ? n / length : dvec3(0.0));
  }
  return faces;
}

/// Which triangles touch each vertex, as one flat list.
struct Stars {
  std::vector<std::uint32_t> start, triangles;
};

Stars starsOf(const geometry::TriangleMesh& mesh, const std::vector<std::uint32_t>& same) {
  Stars stars;
  stars.start.assign(mesh.vertices.size() + 1, 0);
  for (const auto& triangle : mesh.triangles)
    for (const auto v : triangle) ++stars.start[same[v] + 1];
  for (std::size_t i = 1; i < stars.start.size(); ++i) stars.start[i] += stars.start[i - 1];
  stars.triangles.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> next = stars.start;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (const auto v : mesh.triangles[t]) stars.triangles[next[same[v]]++] = t;
  return stars;
}

void addVertices(const geometry::TriangleMesh& mesh, const std::vector<std::uint32_t>& same, const Faces& faces,
                 double cosine, const Given& given_up, DisplayMesh& display) {
  const Stars stars = starsOf(mesh, same);
  const auto base = static_cast<std::int64_t>(display.vertices.size());
  // Display vertices already made for a place, as a chain: corners with the same normal share one.
  std::vector<std::int64_t> newest(mesh.vertices.size(), -1);
  std::vector<std::int64_t> previous;
  display.indices.reserve(display.indices.size() + 3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size() && !given_up.at(t); ++t) {
    for (const auto v : mesh.triangles[t]) {
      const std::uint32_t place = same[v];
      dvec3 sum(0.0);
      for (std::uint32_t i = stars.start[place]; i < stars.start[place + 1]; ++i) {
        const std::uint32_t other = stars.triangles[i];
        if (glm::dot(faces.normals[other], faces.normals[t]) > cosine) sum += faces.areas[other] * faces.normals[other];
      }
      const double length = glm::length(sum);
      const fvec3 normal(length > 0.0 ? sum / length : dvec3(0, 0, 1));
      std::int64_t found = newest[place];
      while (found >= 0 && glm::dot(display.vertices[static_cast<std::size_t>(found)].normal, normal) < 0.9999f)
        found = previous[static_cast<std::size_t>(found - base)];
      if (found < 0) {
        found = static_cast<std::int64_t>(display.vertices.size());
        display.vertices.push_back({fvec3(mesh.vertices[place] - display.center), normal});
        previous.push_back(newest[place]);
        newest[place] = found;
      }
      display.indices.push_back(static_cast<std::uint32_t>(found));
    }
  }
}

void addEdges(const geometry::TriangleMesh& mesh, const std::vector<std::uint32_t>& same, const Faces& faces,
              double cosine, DisplayMesh& display) {
  struct Half {
    std::uint64_t key;
    std::uint32_t triangle;
  };
  std::vector<Half> halves;
  halves.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = same[mesh.triangles[t][i]];
      const std::uint64_t b = same[mesh.triangles[t][(i + 1) % 3]];
      if (a != b) halves.push_back({std::min(a, b) << 32 | std::max(a, b), t});
    }
  }
  std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) { return a.key < b.key; });
  std::vector<DisplayEdge> smooth;
  for (std::size_t i = 0; i < halves.size();) {
    std::size_t end = i;
    while (end < halves.size() && halves[end].key == halves[i].key) ++end;
    const dvec3 na = faces.normals[halves[i].triangle];
    const dvec3 nb = end - i == 2 ? faces.normals[halves[i + 1].triangle] : -na;
    const dvec3 p = mesh.vertices[halves[i].key >> 32] - display.center;
    const dvec3 q = mesh.vertices[halves[i].key & 0xffffffffULL] - display.center;
    if (end - i != 2) display.closed = false;
    const bool crease = end - i != 2 || glm::dot(na, nb) < cosine;
    (crease ? display.edges : smooth).push_back({fvec3(p), fvec3(q), fvec3(na), fvec3(nb)});
    i = end;
  }
  display.creases = display.edges.size();
  display.edges.insert(display.edges.end(), smooth.begin(), smooth.end());
}

}  // namespace

DisplayMesh makeDisplayMesh(const geometry::TriangleMesh& mesh, double crease_angle, const std::atomic<bool>* stop) {
  const Given given_up{stop};
  DisplayMesh display;
  display.bounds = mesh.bounds();
  if (mesh.triangles.empty()) return display;
  display.center = display.bounds.center();
  const std::vector<std::uint32_t> same = representatives(mesh, given_up);
  if (given_up.now()) return display;
  const Faces faces = facesOf(mesh);
  const double cosine = std::cos(crease_angle);
  addVertices(mesh, same, faces, cosine, given_up, display);
  display.steps = {{0, display.indices.size(), 0.0}};
  if (!given_up.now()) addEdges(mesh, same, faces, cosine, display);
  return display;
}

void addSmoothed(const geometry::TriangleMesh& mesh, double crease_angle, DisplayMesh& display) {
  const std::vector<std::uint32_t> same = representatives(mesh, {});
  addVertices(mesh, same, facesOf(mesh), std::cos(crease_angle), {}, display);
}

}  // namespace hapticell::app
