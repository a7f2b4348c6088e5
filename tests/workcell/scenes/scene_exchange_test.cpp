// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/scene_exchange.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "geometry/shapes/shapes.h"

namespace hapticell::workcell {
namespace {

ImportedScene twoParts() {
  ImportedScene scene;
  scene.format = "step";
  scene.metres_per_unit = 0.0254;
  scene.unit_is_stated = true;
  scene.up_axis = UpAxis::kY;
  scene.warnings = {"one", Text("two of %1", 3)};
  scene.meshes = {geometry::makeBox({1, 2, 3}), geometry::makeSphere(0.5, 8)};
  SceneNode root, part;
  root.name = "Gehäuse";
  part.name = "part";
  part.instance = "part_1";
  part.parent = 0;
  part.mesh = 1;
  part.X_PN = {{1, 2, 3}, glm::normalize(dquat(0.5, 0.1, -0.7, 0.2))};
  part.color = {0.25f, 0.5f, 1.0f};
  part.origin = SceneOrigin{"/a/b.step", "x/y#2", 0.001};
  scene.nodes = {root, part};
  return scene;
}

TEST(SceneExchange, BringsBackWhatWasSent) {
  const ImportedScene sent = twoParts();
  const auto got = sceneFromBytes(sceneBytes(sent));
  ASSERT_TRUE(got) << got.error().message();
  EXPECT_EQ(got->format, sent.format);
  EXPECT_EQ(got->metres_per_unit, sent.metres_per_unit);
  EXPECT_EQ(got->up_axis, sent.up_axis);
  EXPECT_EQ(got->warnings, sent.warnings);
  ASSERT_EQ(got->meshes.size(), 2u);
  EXPECT_EQ(got->meshes[1].vertices, sent.meshes[1].vertices);
  EXPECT_EQ(got->meshes[1].triangles, sent.meshes[1].triangles);
  ASSERT_EQ(got->nodes.size(), 2u);
  EXPECT_EQ(got->nodes[1].instance, "part_1");
  EXPECT_EQ(got->nodes[1].X_PN.p, sent.nodes[1].X_PN.p);
  EXPECT_EQ(got->nodes[1].color, sent.nodes[1].color);
  ASSERT_TRUE(got->nodes[1].origin);
  EXPECT_EQ(got->nodes[1].origin->part, "x/y#2");
  EXPECT_FALSE(got->nodes[0].color);
}

TEST(SceneExchange, RefusesEveryCutAndWhatIsBehindTheEnd) {
  const std::string bytes = sceneBytes(twoParts());
  for (std::size_t length = 0; length < bytes.size(); length += 7) {
    EXPECT_FALSE(sceneFromBytes(std::string_view(bytes).substr(0, length))) << length;
  }
  EXPECT_FALSE(sceneFromBytes(bytes + "x"));
}

TEST(SceneExchange, RefusesWhatIsNotAScene) {
  ImportedScene bad = twoParts();
  bad.meshes[0].vertices[3].y = std::nan("");
  EXPECT_FALSE(sceneFromBytes(sceneBytes(bad)));
  bad = twoParts();
  bad.meshes[0].triangles[3][1] = 8;
  EXPECT_FALSE(sceneFromBytes(sceneBytes(bad)));
  bad = twoParts();
  bad.nodes[0].parent = 1;  // Behind itself.
  EXPECT_FALSE(sceneFromBytes(sceneBytes(bad)));
  bad = twoParts();
  bad.nodes[1].mesh = 2;
  EXPECT_FALSE(sceneFromBytes(sceneBytes(bad)));
  bad = twoParts();
  bad.nodes[1].X_PN.q = dquat(2, 0, 0, 0);
  EXPECT_FALSE(sceneFromBytes(sceneBytes(bad)));
  bad = twoParts();
  bad.nodes[1].color = {2.0f, 0.0f, 0.0f};
  EXPECT_FALSE(sceneFromBytes(sceneBytes(bad)));
}

TEST(SceneExchange, SurvivesAnyChangedByte) {
  const std::string bytes = sceneBytes(twoParts());
  std::mt19937 random(7);
  for (int round = 0; round < 3000; ++round) {
    std::string changed = bytes;
    for (int k = 0; k < 3; ++k) changed[random() % changed.size()] = static_cast<char>(random());
    const auto got = sceneFromBytes(changed);
    if (!got) continue;
    for (const SceneNode& node : got->nodes) EXPECT_LT(node.mesh, static_cast<int>(got->meshes.size()));
  }
}

TEST(PartPaths, TellEqualNamesApart) {
  ImportedScene scene;
  for (const auto& [name, parent] : {std::pair{"as/1", -1}, {"nut", 0}, {"nut", 0}, {"", 0}, {"nut", 2}}) {
    SceneNode node;
    node.name = name;
    node.parent = parent;
    scene.nodes.push_back(node);
  }
  const std::vector<std::string> paths = partPaths(scene);
  const std::vector<std::string> expected = {"as_1", "as_1/nut", "as_1/nut#2", "as_1/_", "as_1/nut#2/nut"};
  EXPECT_EQ(paths, expected);
}

TEST(UpAxis, TurnsIntoZ) {
  EXPECT_NEAR(glm::distance(turnedUp(UpAxis::kY) * dvec3(0, 1, 0), dvec3(0, 0, 1)), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(turnedUp(UpAxis::kX) * dvec3(1, 0, 0), dvec3(0, 0, 1)), 0.0, 1e-12);
  EXPECT_EQ(turnedUp(UpAxis::kZ).q, dquat(1, 0, 0, 0));
}

}  // namespace
}  // namespace hapticell::workcell
