// SPDX-License-Identifier: Apache-2.0
// Welding, closedness and connection of random meshes, by the tables of this folder and by plain maps and OpenMesh.
#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "geometry/shapes/edge_uses.h"
#include "geometry/shapes/half_edge_counts.h"
#include "geometry/shapes/mass_properties.h"
#include "geometry/shapes/shapes.h"
#include "geometry/shapes/topology.h"
#include "geometry/shapes/triangle_mesh.h"
#include "geometry/shapes/vertex_merge.h"

namespace hapticell::geometry {
namespace {

/// Each vertex against all kept ones.
std::vector<std::uint32_t> mergedByAllPairs(const std::vector<dvec3>& vertices, double tolerance) {
  std::vector<std::uint32_t> result, kept;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const auto near = std::find_if(kept.begin(), kept.end(), [&](std::uint32_t j) {
      return glm::distance(vertices[i], vertices[j]) <= tolerance;
    });
    result.push_back(near == kept.end() ? i : *near);
    if (near == kept.end()) kept.push_back(i);
  }
  return result;
}

/// The same for many: each vertex against the kept ones of the 27 cells around it, which are as large as the tolerance.
std::vector<std::uint32_t> mergedByCells(const std::vector<dvec3>& vertices, double tolerance) {
  const double size = std::max(1.0001 * tolerance, 1e-9);
  std::map<std::array<std::int64_t, 3>, std::vector<std::uint32_t>> kept;
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    std::array<std::int64_t, 3> cell;
    for (int k = 0; k < 3; ++k) cell[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(vertices[i][k] / size));
    std::uint32_t found = i;
    for (std::int64_t n = 0; n < 27; ++n) {
      const auto near = kept.find({cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1});
      if (near == kept.end()) continue;
      for (const std::uint32_t j : near->second) {
        if (glm::distance(vertices[i], vertices[j]) <= tolerance) found = std::min(found, j);
      }
    }
    if (found == i) kept[cell].push_back(i);
    result.push_back(found);
  }
  return result;
}

/// weld() as it was with sets.
WeldReport weldedBySets(TriangleMesh& mesh, double tolerance) {
  WeldReport report;
  const std::vector<std::uint32_t> same =
      mesh.vertices.size() < 5000 ? mergedByAllPairs(mesh.vertices, tolerance) : mergedByCells(mesh.vertices, tolerance);
  for (std::uint32_t i = 0; i < same.size(); ++i) report.merged_vertices += same[i] != i ? 1u : 0u;
  std::set<Triangle> seen;
  TriangleMesh result;
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (Triangle t : mesh.triangles) {
    for (std::uint32_t& index : t) index = same[index];
    const auto at = [&](std::size_t k) { return mesh.vertices[t[k]]; };
    const bool flat = glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) == 0.0;
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || flat) {
      ++report.degenerate_triangles;
      continue;
    }
    Triangle key = t;
    std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
    if (!seen.insert(key).second) {
      ++report.duplicate_triangles;
      continue;
    }
    for (std::uint32_t& index : t) {
      const auto [known, is_new] = numbers.try_emplace(index, static_cast<std::uint32_t>(result.vertices.size()));
      if (is_new) result.vertices.push_back(mesh.vertices[index]);
      index = known->second;
    }
    result.triangles.push_back(t);
  }
  mesh = std::move(result);
  return report;
}

bool closedByMap(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  for (const auto& [edge, sum] : balance) {
    if (sum != 0 && edge.first != edge.second) return false;
  }
  return !mesh.triangles.empty();
}

TriangleMesh soupOf(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const dvec3& p : mesh.corners(t)) soup.vertices.push_back(p);
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return soup;
}

/// Bodies and loose triangles with gaps, doubles, fins and turned triangles.
TriangleMesh randomMesh(std::mt19937& random) {
  const auto number = [&](std::uint32_t below) { return static_cast<std::uint32_t>(random() % below); };
  TriangleMesh mesh;
  const std::uint32_t bodies = 1 + number(3);
  for (std::uint32_t k = 0; k < bodies; ++k) {
    const std::array<TriangleMesh, 4> shapes = {makeBox(dvec3(1.0)), makeSphere(0.7, 8), makeTorus(0.6, 0.2, 8, 6),
                                                makePipe(0.6, 0.3, 1.0, 8)};
    append(mesh, shapes[number(4)], Pose::translation({0.5 * number(8), 0.5 * number(3), 0.0}));
  }
  const std::uint32_t changes = number(4) == 0 ? 0 : number(12);
  for (std::uint32_t k = 0; k < changes; ++k) {
    const std::uint32_t t = number(static_cast<std::uint32_t>(mesh.triangles.size()));
    const auto any = [&] { return number(static_cast<std::uint32_t>(mesh.vertices.size())); };
    switch (number(6)) {
      case 0:
        mesh.triangles.erase(mesh.triangles.begin() + t);
        break;
      case 1:
        std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
        break;
      case 2:
        mesh.triangles.push_back(mesh.triangles[t]);
        break;
      case 3:
        mesh.triangles.push_back({any(), any(), any()});
        break;
      case 4:
        mesh.vertices[any()] = mesh.vertices[any()];
        break;
      default:
        mesh.triangles[t][number(3)] = any();
    }
  }
  return mesh;
}

TEST(MeshStructure, WeldingEqualsSetsAndAllPairs) {
  std::mt19937 random(7);
  for (int k = 0; k < 300; ++k) {
    TriangleMesh mesh = soupOf(randomMesh(random)), wanted = mesh;
    const double tolerance = k % 3 == 0 ? 0.0 : std::pow(10.0, -static_cast<double>(random() % 7));
    const WeldReport report = weld(mesh, tolerance), wanted_report = weldedBySets(wanted, tolerance);
    EXPECT_EQ(report.merged_vertices, wanted_report.merged_vertices);
    EXPECT_EQ(report.degenerate_triangles, wanted_report.degenerate_triangles);
    EXPECT_EQ(report.duplicate_triangles, wanted_report.duplicate_triangles);
    ASSERT_EQ(mesh.triangles, wanted.triangles) << k;
    ASSERT_EQ(mesh.vertices, wanted.vertices) << k;
  }
}

TEST(MeshStructure, MergedVerticesEqualAllPairsWhereTheyCrowd) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  for (int k = 0; k < 20; ++k) {
    std::vector<dvec3> vertices(800);
    for (dvec3& p : vertices) p = std::pow(10.0, k % 5) * dvec3(place(random), place(random), place(random));
    const double tolerance = 0.02 * k * std::pow(10.0, k % 5);
    EXPECT_EQ(mergedVertices(vertices, tolerance), mergedByAllPairs(vertices, tolerance)) << k;
  }
}

/// Loose points, with some near another one, and some in clumps of one place.
std::vector<dvec3> manyPoints(std::mt19937& random, double tolerance, double away) {
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::vector<dvec3> vertices(25'000);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const dvec3 p(place(random), place(random), place(random));
    const std::size_t other = k == 0 ? 0 : random() % k;
    vertices[k] = dvec3(away, 0.0, 0.0) + p;
    if (k > 0 && k % 5 == 0) vertices[k] = vertices[other] + tolerance * p;
    if (k > 0 && k % 50 == 0) vertices[k] = vertices[0] + 3.0 * tolerance * p;
    if (k > 0 && k % 70 == 0) vertices[k] = vertices[other];
  }
  return vertices;
}

TEST(MeshStructure, MergedVerticesOfManyEqualThoseByCells) {
  std::mt19937 random(13);
  for (const double tolerance : {0.0, 1e-9, 1e-6, 1e-3, 0.02}) {
    for (const double away : {0.0, 1000.0}) {
      const std::vector<dvec3> vertices = manyPoints(random, tolerance, away);
      std::uint32_t merged = 0;
      const std::vector<std::uint32_t> same = mergedVertices(vertices, tolerance, &merged);
      EXPECT_EQ(same, mergedByCells(vertices, tolerance)) << tolerance << ", " << away;
      std::uint32_t wanted = 0;
      for (std::uint32_t k = 0; k < same.size(); ++k) wanted += same[k] != k ? 1u : 0u;
      EXPECT_EQ(merged, wanted);
      EXPECT_GT(merged, 300u);
    }
  }
}

TEST(MeshStructure, ManyTrianglesAtOneVertexAreSorted) {
  TriangleMesh fan;
  fan.vertices.push_back(dvec3(0.0));
  for (std::uint32_t k = 0; k < 200; ++k) fan.vertices.push_back({std::cos(0.03 * k), std::sin(0.03 * k), 0.0});
  for (std::uint32_t k = 1; k < 200; ++k) fan.triangles.push_back({0, k, k + 1});
  fan.triangles.push_back({5, 6, 0});
  TriangleMesh wanted = fan;
  EXPECT_EQ(weld(fan, 0.0).duplicate_triangles, 1u);
  weldedBySets(wanted, 0.0);
  EXPECT_EQ(fan.triangles, wanted.triangles);
}

TEST(MeshStructure, TopologyEqualsTheHalfEdgesOfOpenMesh) {
  std::mt19937 random(3);
  int plain = 0, odd = 0;
  for (int k = 0; k < 600; ++k) {
    TriangleMesh mesh = randomMesh(random);
    if (k % 2 == 0) weld(mesh, weldTolerance(mesh));
    const Topology got = topologyOf(mesh), wanted = halfEdgeCounts(mesh, mesh.triangles);
    EXPECT_EQ(got.shells, wanted.shells) << k;
    EXPECT_EQ(got.holes, wanted.holes) << k;
    EXPECT_EQ(got.border_edges, wanted.border_edges) << k;
    EXPECT_EQ(got.rejected_triangles, wanted.rejected_triangles) << k;
    EXPECT_EQ(got.euler_characteristic, wanted.euler_characteristic) << k;
    EXPECT_EQ(got.closed, closedByMap(mesh)) << k;
    EXPECT_EQ(isClosed(mesh), closedByMap(mesh)) << k;
    (wanted.rejected_triangles == 0 ? plain : odd) += 1;
  }
  EXPECT_GT(plain, 100);
  EXPECT_GT(odd, 100);
}

TEST(MeshStructure, VolumesOfShellsSayWhichWayTheyFace) {
  TriangleMesh two = makeSphere(1.0, 16);
  append(two, makeBox(dvec3(0.01)), Pose::translation({3.0, 0.0, 0.0}));
  EXPECT_GT(topologyOf(two).least_volume_share, 0.3);
  for (std::size_t k = two.triangles.size() - 12; k < two.triangles.size(); ++k) {
    std::swap(two.triangles[k][0], two.triangles[k][1]);
  }
  EXPECT_LT(topologyOf(two).least_volume_share, -0.3);
  two.triangles.pop_back();
  EXPECT_EQ(topologyOf(two).least_volume_share, 0.0);
}

TEST(MeshStructure, EnclosedVolumeIsThatOfMassProperties) {
  std::mt19937 random(5);
  for (int k = 0; k < 20; ++k) {
    const TriangleMesh mesh = randomMesh(random);
    EXPECT_EQ(enclosedVolume(mesh), massProperties(mesh).volume);
  }
  EXPECT_EQ(enclosedVolume({}), 0.0);
}

TEST(MeshStructure, LargeMeshesOnSeveralThreadsToo) {
  TriangleMesh mesh = soupOf(makeSphere(1.0, 400));
  const std::size_t triangles = mesh.triangles.size();
  weld(mesh, weldTolerance(mesh));
  const Topology topology = topologyOf(mesh);
  EXPECT_EQ(mesh.triangles.size(), triangles);
  EXPECT_EQ(topology.euler_characteristic, 2);
  EXPECT_EQ(topology.holes, 0u);
  EXPECT_TRUE(topology.closed);
}

/// Lets this thread, and those that it starts, run on one core only.
class OneCore {
 public:
  OneCore() {
    sched_getaffinity(0, sizeof all_, &all_);
    cpu_set_t one;
    CPU_ZERO(&one);
    for (std::size_t k = 0; k < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++k) {
      if (CPU_ISSET(k, &all_)) CPU_SET(k, &one);
    }
    sched_setaffinity(0, sizeof one, &one);
  }
  ~OneCore() { sched_setaffinity(0, sizeof all_, &all_); }
  OneCore(const OneCore&) = delete;
  OneCore& operator=(const OneCore&) = delete;

 private:
  cpu_set_t all_;
};

TEST(MeshStructure, DamagedLargeMeshesAreTheSameOnAnyNumberOfThreads) {
  std::mt19937 random(17);
  for (const bool damaged : {false, true}) {
    TriangleMesh mesh = makeSphere(1.0, damaged ? 300 : 150);
    const std::size_t count = mesh.triangles.size();
    for (std::size_t k = 0; damaged && k < 1000; ++k) {
      Triangle& t = mesh.triangles[random() % count];
      if (k % 3 == 0) t[0] = t[1];
      if (k % 3 == 1) mesh.triangles.push_back({t[1], t[2], t[0]});
      if (k % 3 == 2) mesh.vertices[t[0]] = mesh.vertices[t[1]];
    }
    TriangleMesh on_one = damaged ? mesh : soupOf(mesh), wanted = on_one, on_all = on_one;
    ASSERT_GT(on_one.vertices.size(), 40'000u);
    const double tolerance = weldTolerance(mesh);
    const WeldReport report = weld(on_all, tolerance), wanted_report = weldedBySets(wanted, tolerance);
    const Topology topology = topologyOf(on_all);
    const OneCore one_core;
    EXPECT_EQ(weld(on_one, tolerance).degenerate_triangles, wanted_report.degenerate_triangles);
    EXPECT_EQ(report.merged_vertices, wanted_report.merged_vertices);
    EXPECT_EQ(report.degenerate_triangles, wanted_report.degenerate_triangles);
    EXPECT_EQ(report.duplicate_triangles, wanted_report.duplicate_triangles);
    EXPECT_EQ(report.duplicate_triangles > 0, damaged);
    EXPECT_TRUE(on_all.triangles == wanted.triangles && on_all.vertices == wanted.vertices);
    EXPECT_TRUE(on_one.triangles == wanted.triangles && on_one.vertices == wanted.vertices);
    const Topology again = topologyOf(on_one);
    EXPECT_EQ(again.euler_characteristic, topology.euler_characteristic);
    EXPECT_EQ(again.holes, topology.holes);
    EXPECT_EQ(again.shells, topology.shells);
    EXPECT_EQ(again.least_volume_share, topology.least_volume_share);
    EXPECT_EQ(topology.closed, closedByMap(wanted));
  }
}

}  // namespace
}  // namespace hapticell::geometry
