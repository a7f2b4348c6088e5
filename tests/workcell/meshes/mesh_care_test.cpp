// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/mesh_care.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/shapes/mass_properties.h"
#include "geometry/shapes/shapes.h"
#include "tests/support/test_data.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/meshes/mesh_writer.h"

namespace hapticell::workcell {
namespace {

using geometry::TriangleMesh;

TEST(MeshCare, DeviationOfTwoBoxesIsTheGapBetweenTheirFaces) {
  const TriangleMesh inner = geometry::makeBox({0.1, 0.1, 0.1}), outer = geometry::makeBox({0.1, 0.1, 0.12});
  EXPECT_NEAR(deviation(inner, outer), 0.01, 1e-9);
  EXPECT_NEAR(deviation(inner, inner), 0.0, 1e-12);
}

TEST(MeshCare, ASphereGetsFewerTrianglesWithinTheTolerance) {
  TriangleMesh sphere = geometry::makeSphere(0.05);
  for (dvec3& vertex : sphere.vertices)
    vertex += dvec3(1000.0, 0.0, 0.0);  // Far out: floats would lose a tenth of a mm.
  for (const double tolerance : {1e-3, 3e-3}) {
    const auto made = simplify(sphere, tolerance);
    ASSERT_TRUE(made) << made.error().message();
    EXPECT_LT(made->mesh.triangles.size(), sphere.triangles.size());
    EXPECT_LE(made->deviation, tolerance);
    EXPECT_NEAR(deviation(sphere, made->mesh), made->deviation, 1e-12);
  }
  EXPECT_FALSE(simplify(sphere, 0.0));
  EXPECT_FALSE(simplify(sphere, std::nan("")));
}

TEST(MeshCare, TheHullOfAnAngleFillsItsHollow) {
  // Two bars of 100 x 20 x 20 mm in an L; the hull cuts the corner between their free ends.
  TriangleMesh angle = geometry::makeBox({0.1, 0.02, 0.02});
  geometry::append(angle, geometry::makeBox({0.02, 0.1, 0.02}), Pose::translation({-0.04, 0.04, 0.0}));
  const auto made = convexMesh(angle);
  ASSERT_TRUE(made) << made.error().message();
  const auto mass = geometry::massProperties(made->mesh);
  // A pentagon of corners (-50,-10) (50,-10) (50,10) (-30,90) (-50,90) mm by the shoelace formula: 6800 mm2, 20 high.
  EXPECT_NEAR(mass.volume, 6800e-6 * 0.02, 1e-9);
  // The middle (10, 50) of the face between the free ends is 40 mm from either bar.
  EXPECT_NEAR(made->deviation, 0.04, 1e-6);
  TriangleMesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  flat.triangles = {{0, 1, 2}};
  EXPECT_FALSE(convexMesh(flat));
}

TEST(MeshCare, TrianglesThatFaceAnyWayAreTurnedOutwards) {
  std::mt19937 random(7);
  for (const TriangleMesh& sound : {geometry::makeBox({0.1, 0.2, 0.3}), geometry::makeSphere(0.1)}) {
    TriangleMesh mixed = sound;
    for (auto& triangle : mixed.triangles) {
      if (random() % 2 == 0) std::swap(triangle[1], triangle[2]);
    }
    EXPECT_GT(healthOf(mixed).flipped_edges, 0u);
    EXPECT_GT(orient(mixed), 0u);
    EXPECT_EQ(healthOf(mixed).flipped_edges, 0u);
    EXPECT_TRUE(healthOf(mixed).isClosed());
    EXPECT_NEAR(geometry::massProperties(mixed).volume, geometry::massProperties(sound).volume, 1e-12);
    EXPECT_EQ(orient(mixed), 0u);
  }
}

TEST(MeshCare, HealthCountsWhatIsOdd) {
  TriangleMesh fan;  // Three triangles on one edge.
  fan.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
  fan.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  const MeshHealth health = healthOf(fan);
  EXPECT_EQ(health.non_manifold_edges, 1u);
  EXPECT_EQ(health.border_edges, 6u);
  EXPECT_FALSE(health.isClosed());
}

TEST(MeshCare, ADocumentKeepsHowAProxyAndAMeshWereMade) {
  test::TemporaryFolder folder;
  const NamedMesh sphere{"ball", geometry::makeSphere(0.05)};
  folder.write("ball.stl", stlBytes({&sphere, 1}, 1.0));
  Diagnostics notes;
  EntityLoader loader(folder.path());
  SourceFile source{(folder.path() / "ball.stl").string(), 1.0};
  source.simplified = 1e-3;
  source.oriented = true;
  auto entity = loader.loadSource(source, notes);
  ASSERT_TRUE(entity) << entity.error().message();
  EXPECT_LT(entity->mesh()->triangles.size(), sphere.mesh.triangles.size());
  Document document;
  const auto id = document.execute(AddEntity{*entity});
  ASSERT_TRUE(id);
  auto proxy = makeProxy(*entity->mesh(), CollisionProxy::Kind::kConvex, 0.0);
  ASSERT_TRUE(proxy);
  ASSERT_TRUE(document.execute(SetCollisionProxy{*id, *proxy}));
  EXPECT_EQ(checkedMesh(*document.find(*id)), proxy->mesh);
  const std::string text = documentText(document.state(), folder.path());
  const auto again = parseDocument(text, folder.path(), "again", notes);
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(documentText(again->state(), folder.path()), text);
  const Entity& read = *again->findByName("ball");
  EXPECT_EQ(read.mesh()->triangles.size(), entity->mesh()->triangles.size());
  ASSERT_EQ(read.proxy().kind, CollisionProxy::Kind::kConvex);
  EXPECT_EQ(read.proxy().mesh->triangles.size(), proxy->mesh->triangles.size());
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(checkedMesh(*document.find(*id)), entity->mesh());
}

}  // namespace
}  // namespace hapticell::workcell
