// SPDX-License-Identifier: Apache-2.0
// The numbers are those that the data's own SOURCE.md states (taken with other programs). Triangles and sizes of all files:
// shared_files_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/test_data.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/import/imported_entities.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;

geometry::Bounds boundsOf(const ImportedScene& scene) {
  geometry::Bounds bounds;
  const std::vector<Pose> X_F = nodePoses(scene);
  for (std::size_t k = 0; k < X_F.size(); ++k) {
    if (scene.nodes[k].mesh < 0) continue;
    for (const dvec3& p : scene.meshes[static_cast<std::size_t>(scene.nodes[k].mesh)].vertices) bounds.add(X_F[k] * p);
  }
  return bounds;
}

std::size_t trianglesOf(const ImportedScene& scene) {
  std::size_t sum = 0;
  for (const SceneNode& node : scene.nodes) {
    if (node.mesh >= 0) sum += scene.meshes[static_cast<std::size_t>(node.mesh)].triangles.size();
  }
  return sum;
}

int depthOf(const ImportedScene& scene, int node) {
  const int parent = scene.nodes[static_cast<std::size_t>(node)].parent;
  return parent < 0 ? 0 : 1 + depthOf(scene, parent);
}

TEST(RealCad, As1HasItsTreeNamesAndColours) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "cad/step/as1-oc-214.stp");
  const auto scene = readScene(file, {}, nullptr);
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->format, "step");
  EXPECT_DOUBLE_EQ(scene->metres_per_unit, 0.001);
  EXPECT_EQ(scene->nodes.size(), 1u + 27u);  // The root and 27 uses.
  EXPECT_EQ(scene->meshes.size(), 5u);       // Instances share theirs.
  EXPECT_NEAR(static_cast<double>(trianglesOf(*scene)), 7512.0, 75.0);
  int deepest = 0, solids = 0;
  std::set<std::array<float, 3>> colors;
  for (std::size_t k = 0; k < scene->nodes.size(); ++k) {
    deepest = std::max(deepest, depthOf(*scene, static_cast<int>(k)));
    solids += scene->nodes[k].mesh >= 0 ? 1 : 0;
    if (scene->nodes[k].mesh >= 0 && scene->nodes[k].color) colors.insert(*scene->nodes[k].color);
  }
  EXPECT_EQ(deepest, 3);
  EXPECT_EQ(solids, 18);
  EXPECT_EQ(colors.size(), 5u);
  const auto count = [&](const std::string& name) {
    return std::count_if(scene->nodes.begin(), scene->nodes.end(), [&](const SceneNode& n) { return n.name == name; });
  };
  EXPECT_EQ(scene->nodes[0].name, "as1");
  EXPECT_EQ(count("l-bracket-assembly"), 2);
  EXPECT_EQ(count("nut-bolt-assembly"), 6);
  EXPECT_EQ(count("bolt"), 6);
  EXPECT_EQ(count("nut"), 8);
  EXPECT_EQ(count("plate"), 1);
  const dvec3 size = boundsOf(*scene).size();
  EXPECT_NEAR(size.x, 0.200, 1e-4);
  EXPECT_NEAR(size.y, 0.150, 1e-4);
  EXPECT_NEAR(size.z, 0.084, 1e-4);
}

TEST(RealCad, ARelativeChordFollowsTheSizeAndIsTold) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "cad/step/linkrods.step");
  ImportOptions coarse, fine, larger;
  coarse.relative_chord = 1e-3;
  fine.relative_chord = larger.relative_chord = 1e-4;
  larger.metres_per_unit = 1.0;
  const auto a = readScene(file, coarse, nullptr), b = readScene(file, fine, nullptr),
             c = readScene(file, larger, nullptr);
  ASSERT_TRUE(a && b && c);
  EXPECT_LT(trianglesOf(*a), trianglesOf(*b));
  EXPECT_EQ(trianglesOf(*b), trianglesOf(*c)) << "the size has no influence";
  EXPECT_NEAR(a->chord / b->chord, 10.0, 1e-9);
  EXPECT_NEAR(c->chord / b->chord, 1000.0, 1e-6);
  // BndLib's box is a little larger than the shape.
  EXPECT_NEAR(b->chord, 1e-4 * glm::length(boundsOf(*b).size()), 0.1 * b->chord);
}

TEST(RealCad, AnotherUnitRescalesAndTheChordStaysInMetres) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "cad/step/odri_transmission_pulley_at3_t10_motor.step");
  ImportOptions inches;
  inches.metres_per_unit = 0.0254;
  const auto plain = readScene(file, {}, nullptr), larger = readScene(file, inches, nullptr);
  ASSERT_TRUE(plain && larger);
  EXPECT_NEAR(boundsOf(*larger).size().x / boundsOf(*plain).size().x, 25.4, 1e-6);
  EXPECT_GT(trianglesOf(*larger), trianglesOf(*plain));
}

TEST(RealCad, TheEngineHasItsMeshesAndStandsUpright) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "cad/gltf/2CylinderEngine.glb");
  const auto scene = readScene(file, {}, nullptr);
  ASSERT_TRUE(scene) << scene.error().message();
  std::size_t triangles = 0;
  for (const geometry::TriangleMesh& mesh : scene->meshes) triangles += mesh.triangles.size();
  EXPECT_EQ(scene->up_axis, UpAxis::kY);
  EXPECT_GE(scene->meshes.size(), 34u);
  EXPECT_GE(triangles, 75730u);
  for (const SceneNode& node : scene->nodes) EXPECT_TRUE(node.X_PN.isValid());
}

TEST(RealCad, ADocumentKeepsTheTreeAndMovesItAsOne) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "cad/step/as1-oc-214.stp");
  Diagnostics notes;
  auto tree = EntityLoader(fs::current_path()).loadTree(file.string(), {}, notes);
  ASSERT_TRUE(tree) << tree.error().message();
  EXPECT_EQ(tree->report.parts, 18u);
  Document document;
  const auto ids = addImported(document, std::move(tree->entities), Pose::identity());
  ASSERT_TRUE(ids) << ids.error().message();
  EXPECT_EQ(document.undoTexts().size(), 1u);
  const Entity* nut = document.findByName("nut 3");
  ASSERT_NE(nut, nullptr);
  const Pose before = nut->X_WE;
  const Entity* root = document.findByName("as1");
  ASSERT_EQ(root->kind(), EntityKind::kAssembly);
  ASSERT_TRUE(document.execute(SetPlacement{root->id, Pose::translation({1, 2, 3})}));
  EXPECT_NEAR(glm::distance(document.findByName("nut 3")->X_WE.p, before.p + dvec3(1, 2, 3)), 0.0, 1e-12);
  const std::string text = documentText(document.state(), fs::current_path());
  const auto again = parseDocument(text, fs::current_path(), "again", notes);
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(documentText(again->state(), fs::current_path()), text);
  EXPECT_EQ(again->findByName("nut 3")->mesh(), again->findByName("nut")->mesh());
  ASSERT_TRUE(document.execute(RemoveEntity{root->id}));
  EXPECT_TRUE(document.state().entities.empty());
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(document.state().entities.size(), 28u);
}

}  // namespace
}  // namespace hapticell::workcell
