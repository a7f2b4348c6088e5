// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geometry/shapes/mass_properties.h"
#include "geometry/shapes/shapes.h"
#include "tests/support/test_data.h"
#include "workcell/files/scene_export.h"
#include "workcell/meshes/mesh_reader.h"
#include "workcell/scenes/gltf_writer.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// An assembly of two uses of one part and a part of another colour, all placed askew.
ImportedScene smallScene() {
  ImportedScene scene;
  scene.meshes = {geometry::makeBox({0.1, 0.2, 0.3}), geometry::makeCylinder(0.05, 0.2, 16)};
  const auto node = [&](const char* name, int parent, int mesh, const Pose& X, std::array<float, 3> color) {
    SceneNode result;
    result.name = name;
    result.parent = parent;
    result.mesh = mesh;
    result.X_PN = X;
    if (mesh >= 0) result.color = color;
    scene.nodes.push_back(result);
  };
  const dquat askew = glm::normalize(dquat(0.8, 0.3, -0.4, 0.2));
  node("cell", -1, -1, {{1.0, -2.0, 0.5}, askew}, {});
  node("block", 0, 0, {{0.3, 0.0, 0.0}, glm::normalize(dquat(0.1, 0.9, 0.2, -0.3))}, {1.0f, 0.25f, 0.0f});
  node("block", 0, 0, {{-0.3, 0.1, 0.0}, dquat(1, 0, 0, 0)}, {1.0f, 0.25f, 0.0f});
  node("Bolzen Ø5", 0, 1, {{0.0, 0.0, 0.7}, askew}, {0.0f, 0.5f, 1.0f});
  return scene;
}

/// Same tree, names, colours, placements and sizes; STEP says placements to 1e-6 m, glTF in 32 bits.
void expectSame(const ImportedScene& got, const ImportedScene& wanted, double tolerance) {
  ASSERT_EQ(got.nodes.size(), wanted.nodes.size());
  const std::vector<Pose> X_got = nodePoses(got), X_wanted = nodePoses(wanted);
  for (std::size_t k = 0; k < got.nodes.size(); ++k) {
    EXPECT_EQ(got.nodes[k].name, wanted.nodes[k].name);
    EXPECT_EQ(got.nodes[k].parent, wanted.nodes[k].parent);
    const Twist off = difference(X_got[k], X_wanted[k]);
    EXPECT_LT(glm::length(off.linear), tolerance) << wanted.nodes[k].name;
    EXPECT_LT(glm::length(off.angular), 10.0 * tolerance) << wanted.nodes[k].name;
    if (wanted.nodes[k].mesh < 0) continue;
    ASSERT_GE(got.nodes[k].mesh, 0);
    ASSERT_TRUE(got.nodes[k].color);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR((*got.nodes[k].color)[c], (*wanted.nodes[k].color)[c], 2e-3);
    const auto mesh = [](const ImportedScene& scene, std::size_t node) {
      return scene.meshes[static_cast<std::size_t>(scene.nodes[node].mesh)];
    };
    EXPECT_NEAR(geometry::massProperties(mesh(got, k)).volume, geometry::massProperties(mesh(wanted, k)).volume, 1e-7);
    EXPECT_LT(glm::distance(mesh(got, k).bounds().max, mesh(wanted, k).bounds().max), tolerance);
  }
}

class Export : public ::testing::Test {
 protected:
  Expected<void> write(const ImportedScene& scene, const std::string& name) {
    return exportScene(scene, folder_.path() / name, {}, notes_);
  }
  test::TemporaryFolder folder_;
  Diagnostics notes_;
};

TEST_F(Export, StepComesBackAsItWent) {
  const ImportedScene scene = smallScene();
  const auto written = write(scene, "a.step");
  ASSERT_TRUE(written) << written.error().message();
  const auto again = readScene(folder_.path() / "a.step", {}, nullptr);
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(again->meshes.size(), 2u);  // One part is used twice.
  expectSame(*again, scene, 1e-6);
  EXPECT_EQ(again->meshes[0].triangles.size(), 12u);
}

/// How often a STEP file holds an entity.
std::size_t countIn(const std::string& step, const std::string& entity) {
  std::size_t count = 0;
  for (std::size_t at = step.find(entity); at != std::string::npos; at = step.find(entity, at + 1)) ++count;
  return count;
}

/// `uses` spheres of one mesh with names of their own, in two colours, each placed askew.
ImportedScene manyUses(int uses) {
  ImportedScene scene;
  scene.meshes = {geometry::makeSphere(0.02, 16)};
  for (int k = 0; k < uses; ++k) {
    SceneNode node;
    node.name = "ball at place " + std::to_string(k);
    node.mesh = 0;
    node.color = k % 2 == 0 ? std::array<float, 3>{1.0f, 0.25f, 0.0f} : std::array<float, 3>{0.0f, 0.5f, 1.0f};
    node.X_PN = {{0.1 * k, -0.05 * k, 0.01 * k}, glm::normalize(dquat(1.0, 0.01 * k, 0.3, -0.2))};
    scene.nodes.push_back(node);
  }
  return scene;
}

TEST_F(Export, StepHoldsTheShapeOfManyUsesOnceForEachColour) {
  const ImportedScene one = manyUses(2), many = manyUses(40);
  ASSERT_TRUE(write(one, "one.step"));
  ASSERT_TRUE(write(many, "many.step"));
  const std::string few = *readFileContent(folder_.path() / "one.step"),
                    all = *readFileContent(folder_.path() / "many.step");
  EXPECT_EQ(countIn(all, "ADVANCED_FACE"), 2 * many.meshes[0].triangles.size());
  EXPECT_EQ(countIn(all, "MANIFOLD_SOLID_BREP"), 2u);
  EXPECT_EQ(countIn(all, "NEXT_ASSEMBLY_USAGE_OCCURRENCE"), 40u);
  EXPECT_LT(static_cast<double>(all.size()), 1.5 * static_cast<double>(few.size()));
  const auto again = readScene(folder_.path() / "many.step", {}, nullptr);
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(again->meshes.size(), 2u);
  expectSame(*again, many, 1e-6);
}

TEST_F(Export, StepKeepsTheNamesOfPartsBesideThoseOfTheirUses) {
  ImportedScene scene = manyUses(4);
  for (SceneNode& node : scene.nodes) node.color = {1.0f, 0.25f, 0.0f};
  scene.nodes[0].name = scene.nodes[1].name = "left";
  scene.nodes[2].name = scene.nodes[3].name = "right";
  scene.nodes[1].instance = "left, the second";
  ASSERT_TRUE(write(scene, "a.step"));
  const auto again = readScene(folder_.path() / "a.step", {}, nullptr);
  ASSERT_TRUE(again) << again.error().message();
  expectSame(*again, scene, 1e-6);
  EXPECT_EQ(again->nodes[1].instance, "left, the second");
}

TEST_F(Export, GltfComesBackAsItWent) {
  const ImportedScene scene = smallScene();
  for (const char* name : {"a.glb", "a.gltf"}) {
    ASSERT_TRUE(write(scene, name));
    const auto again = readScene(folder_.path() / name, {}, nullptr);
    ASSERT_TRUE(again) << again.error().message();
    EXPECT_EQ(again->up_axis, UpAxis::kY);
    expectSame(*again, scene, 2e-6);
  }
}

TEST_F(Export, GltfIsWhatTheStandardAsks) {
  const std::string bytes = gltfBytes(smallScene(), true);
  std::uint32_t words[5];
  std::memcpy(words, bytes.data(), sizeof words);
  EXPECT_EQ(words[0], 0x46546C67u);
  EXPECT_EQ(words[2], bytes.size());
  const auto json = nlohmann::json::parse(bytes.substr(20, words[3]));
  EXPECT_EQ(json["asset"]["version"], "2.0");
  EXPECT_EQ(json["meshes"].size(), 2u);
  EXPECT_EQ(json["materials"].size(), 2u);
  std::size_t end = 0;
  for (const auto& view : json["bufferViews"]) {
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
    end = std::max(end, view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>());
  }
  EXPECT_EQ(json["buffers"][0]["byteLength"], end);
}

TEST_F(Export, MeshFilesHoldAllTrianglesInTheWorld) {
  const ImportedScene scene = smallScene();
  const std::vector<Pose> X_W = nodePoses(scene);
  geometry::Bounds bounds;
  for (std::size_t k = 1; k < 4; ++k) {
    for (const dvec3& p : scene.meshes[static_cast<std::size_t>(scene.nodes[k].mesh)].vertices) bounds.add(X_W[k] * p);
  }
  for (const char* name : {"a.stl", "a.obj", "a.ply", "a.off"}) {
    ASSERT_TRUE(write(scene, name));
    const auto again = readMesh(folder_.path() / name, {}, notes_);
    ASSERT_TRUE(again) << again.error().message();
    EXPECT_EQ(again->triangles.size(), 12u + 12u + 64u) << name;
    EXPECT_LT(glm::distance(again->bounds().min, bounds.min), 1e-6) << name;
    EXPECT_LT(glm::distance(again->bounds().max, bounds.max), 1e-6) << name;
  }
  EXPECT_THAT(*readFileContent(folder_.path() / "a.mtl"), HasSubstr("Kd 1 0.25 0"));
  EXPECT_THAT(*readFileContent(folder_.path() / "a.obj"), HasSubstr("o Bolzen_"));
}

TEST_F(Export, RefusesWhatItCannotWriteAndLeavesTheOldFile) {
  EXPECT_THAT(write(smallScene(), "a.dwg").error().message(), HasSubstr(".step"));
  EXPECT_FALSE(write({}, "a.stl"));
  folder_.write("old.step", "old");
  ImportedScene gone = smallScene();
  gone.nodes[1].origin = SceneOrigin{(folder_.path() / "gone.step").string(), "x"};
  EXPECT_FALSE(write(gone, "old.step"));
  EXPECT_EQ(*readFileContent(folder_.path() / "old.step"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

TEST_F(Export, MovedPartsOfARealAssemblyKeepTheirExactShapes) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "cad/step/as1-oc-214.stp");
  auto scene = sceneOfFile(file, {}, notes_);
  ASSERT_TRUE(scene) << scene.error().message();
  scene->nodes[4].X_PN.p += dvec3(0.01, 0.02, 0.03);
  scene->nodes[16].X_PN = Pose{{0.5, 0, 0}, glm::normalize(dquat(0.9, 0.1, 0.3, 0))} * scene->nodes[16].X_PN;
  ASSERT_TRUE(write(*scene, "moved.step"));
  const auto again = readScene(folder_.path() / "moved.step", {}, nullptr);
  ASSERT_TRUE(again) << again.error().message();
  expectSame(*again, *scene, 1e-6);
  // The curved faces are still those of the source, not facets.
  const std::string text = *readFileContent(folder_.path() / "moved.step"), source = *readFileContent(file);
  EXPECT_EQ(countIn(text, "ADVANCED_FACE"), countIn(source, "ADVANCED_FACE"));
}

}  // namespace
}  // namespace hapticell::workcell
