// SPDX-License-Identifier: Apache-2.0
#include "cli/files/entity_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "cli/files/file_commands.h"
#include "cli/files/import_arguments.h"
#include "geometry/shapes/shapes.h"
#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

using nlohmann::ordered_json;

workcell::Entity boxEntity(const std::string& name, const dvec3& size, const Pose& X_WE, const std::string& parent = {}) {
  workcell::Entity entity;
  entity.name = name;
  entity.parent = parent;
  entity.X_WE = X_WE;
  entity.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(size))};
  return entity;
}

TEST(EntityReport, BoundsAreOfTheTurnedShape) {
  const double turn = 0.3;
  const Pose X_WE{{1.0, 2.0, 3.0}, quaternionFromRotationVector({0.0, 0.0, turn})};
  const ordered_json report = entityReport(boxEntity("a", {0.4, 0.2, 0.1}, X_WE));
  EXPECT_EQ(report["kind"], "solid");
  EXPECT_EQ(report["triangles"], 12);
  EXPECT_EQ(report["closed"], true);
  EXPECT_NEAR(report["volume"], 0.4 * 0.2 * 0.1, 1e-15);
  EXPECT_NEAR(report["bounds"]["max"][0], 1.0 + 0.2 * std::cos(turn) + 0.1 * std::sin(turn), 1e-12);
  EXPECT_NEAR(report["bounds"]["min"][1], 2.0 - 0.2 * std::sin(turn) - 0.1 * std::cos(turn), 1e-12);
  EXPECT_NEAR(report["bounds"]["max"][2], 3.05, 1e-12);
}

TEST(EntityReport, FactsSayWhetherASurfaceIsClosed) {
  geometry::TriangleMesh ball = geometry::makeSphere(0.1, 64);
  EXPECT_TRUE(factsOf(ball).closed);
  EXPECT_NEAR(factsOf(ball).volume, 4.0 / 3.0 * std::numbers::pi * 1e-3, 4e-5) << "of its facets";
  // The same surface, each triangle with corners of its own, as in an STL.
  geometry::TriangleMesh soup;
  for (const auto& triangle : ball.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (const auto corner : triangle) soup.vertices.push_back(ball.vertices[corner]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(factsOf(soup).closed);
  EXPECT_NEAR(factsOf(soup).volume, factsOf(ball).volume, 1e-15);
  soup.triangles.pop_back();
  EXPECT_FALSE(factsOf(soup).closed);
}

TEST(EntityReport, ATreeHasFoldersAndParents) {
  const ordered_json tree = treeReport({boxEntity("a", dvec3(1.0), {}, "group"), boxEntity("b", dvec3(1.0), {}),
                                        boxEntity("c", dvec3(2.0), Pose::translation({9.0, 0.0, 0.0}), "group"),
                                        boxEntity("d", dvec3(1.0), {}, "b")});
  ASSERT_EQ(tree.size(), 2U);
  EXPECT_EQ(tree[0]["name"], "group");
  EXPECT_EQ(tree[0]["kind"], "assembly");
  EXPECT_EQ(tree[0]["children"].size(), 2U);
  EXPECT_NEAR(tree[0]["volume"], 9.0, 1e-12);
  EXPECT_NEAR(tree[0]["bounds"]["max"][0], 10.0, 1e-12);
  EXPECT_NEAR(tree[0]["bounds"]["min"][0], -0.5, 1e-12);
  EXPECT_EQ(tree[1]["name"], "b");
  EXPECT_EQ(tree[1]["children"][0]["name"], "d");
}

TEST(EntityReport, TwoUsesOfAPartHaveOneShapeAndTwoPlaces) {
  workcell::ImportedScene scene;
  scene.meshes.push_back(geometry::makeBox(dvec3(2.0)));
  workcell::SceneNode assembly, first, second;
  assembly.name = "assembly";
  assembly.X_PN = Pose::translation({10.0, 0.0, 0.0});
  first.name = second.name = "bolt";
  first.parent = second.parent = 0;
  first.mesh = second.mesh = 0;
  first.color = {1.0F, 0.5F, 0.0F};
  second.X_PN = Pose::translation({0.0, 5.0, 0.0});
  second.instance = "bolt:2";
  scene.nodes = {assembly, first, second};
  const ordered_json tree = sceneReport(scene);
  ASSERT_EQ(tree.size(), 1U);
  EXPECT_NEAR(tree[0]["volume"], 16.0, 1e-12);
  const ordered_json& uses = tree[0]["children"];
  ASSERT_EQ(uses.size(), 2U);
  EXPECT_FALSE(uses[0].contains("instance"));
  EXPECT_EQ(uses[0]["color"], ordered_json({1.0, 0.5, 0.0}));
  EXPECT_NEAR(uses[0]["bounds"]["max"][0], 11.0, 1e-12);
  EXPECT_EQ(uses[1]["instance"], "bolt:2");
  EXPECT_NEAR(uses[1]["bounds"]["min"][1], 4.0, 1e-12);
  const SolidFacts known{0.125, false};
  EXPECT_EQ(sceneReport(scene, {&known, 1})[0]["children"][1]["volume"], 0.125) << "what is known is not found out";
}

TEST(FileCommandWords, AreReadByTheParser) {
  test::expectRefusals({addConvertCommand, addDistanceCommand, addInspectCommand},
                       {{{"inspect"}, "file is required"},
                        {{"inspect", "a.step", "--chord", "0.001", "--angle", "0.1"}, ""},
                        {{"inspect", "a.step", "--chord", "0"}, "--chord"},
                        {{"inspect", "a.step", "--angle", "3.1"}, "--angle"},
                        {{"inspect", "a.xacro", "x:=1", "y:=2"}, ""},
                        {{"distance", "--moving", "a.stl", "--environment", "b.stl", "c.stl", "--poses", "p.csv"}, ""},
                        {{"distance", "--moving", "a.stl", "--poses", "p.csv"}, "--environment is required"},
                        {{"convert", "a.step", "--output", "b.glb", "--chord", "nan"}, "--chord"}});
}

TEST(ImportArguments, AreTheTessellation) {
  workcell::Tessellation tessellation;
  const double angle = tessellation.angle;
  CLI::App app;
  addTessellationOptions(Subcommand(app).add("do", ""), tessellation);
  app.parse(std::vector<std::string>{"1e-9", "--chord", "do"});
  EXPECT_EQ(tessellation.chord, 1e-9);
  EXPECT_EQ(tessellation.angle, angle) << "as it was";
}

}  // namespace
}  // namespace hapticell::cli
