// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/scene_model.h"

#include <numbers>

#include <gtest/gtest.h>

#include "app/viewport/scene/pen_look.h"
#include "geometry/shapes/shapes.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::app {
namespace {

std::shared_ptr<const geometry::TriangleMesh> box() {
  return std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(dvec3(0.2)));
}

workcell::Entity solid(workcell::EntityId id) {
  workcell::Entity entity;
  entity.id = id;
  entity.name = "solid " + std::to_string(id);
  entity.body = workcell::Solid{box()};
  entity.color = {1.0f, 0.0f, 0.0f};
  return entity;
}

/// One link that turns about z and carries a box half a metre away along x.
workcell::Entity turntable(workcell::EntityId id) {
  auto model = std::make_shared<kinematics::RobotModel>();
  model->links.resize(2);
  model->links[0].name = "base";
  model->links[1].name = "arm";
  model->links[1].parent_joint = 0;
  model->links[1].visuals.push_back({box(), Pose::translation({0.5, 0, 0}), {0.5f, 0.5f, 0.5f, 1.0f}, "box"});
  kinematics::Joint joint;
  joint.type = kinematics::JointType::kRevolute;
  joint.parent_link = 0;
  joint.child_link = 1;
  joint.variable = 0;
  joint.lower = -3.0;
  joint.upper = 3.0;
  model->joints.push_back(joint);
  model->moving = {0};
  workcell::Entity entity;
  entity.id = id;
  entity.name = "robot";
  entity.body = workcell::Robot{{.model = model, .joints = {0.0}}};
  return entity;
}

/// In motion the held body, what hangs on it and what is near them keep their shape, nothing else.
TEST(SceneModel, WhatIsHeldAndWhatIsNearKeepsItsShape) {
  const auto at = [](workcell::EntityId id, double x) {
    workcell::Entity entity = solid(id);
    entity.X_WE = Pose::translation({x, 0.0, 0.0});
    return entity;
  };
  SceneModel scene;
  std::vector<workcell::Entity> cell{at(1, 0.0), at(2, 0.49), at(3, 0.51), at(4, 5.0), at(5, 5.49), at(6, 9.0)};
  cell[3].attachment.to = "solid 1";  // A tool, far from what carries it.
  scene.setEntities(cell);
  const auto kept = [&scene] {
    std::vector<workcell::EntityId> ids;
    for (const RenderItem& item : scene.items({}))
      if (item.keeps_shape) ids.push_back(item.entity);
    return ids;
  };
  using Ids = std::vector<workcell::EntityId>;
  EXPECT_EQ(kept(), Ids{});
  manipulation::SceneSnapshot snapshot;
  snapshot.stylus.held = 1;
  scene.setSnapshot(snapshot);
  EXPECT_EQ(kept(), (Ids{1, 2, 4, 5})) << "the third is 0.31 m off";
  snapshot.entities.push_back({1, Pose::translation({0.1, 0, 0}), {}, false, false});
  scene.setSnapshot(snapshot);
  EXPECT_EQ(kept(), (Ids{1, 2, 3, 4, 5})) << "where it is now";
  scene.setSnapshot(std::nullopt);
  scene.setSelected({6});
  EXPECT_EQ(kept(), Ids{6}) << "what is chosen alone is what is looked at";
  scene.setSelected({5, 6});
  EXPECT_EQ(kept(), Ids{});
  cell[0].attachment.to = "solid 4";  // A loop that a file may have.
  scene.setEntities(cell);
  EXPECT_EQ(kept(), Ids{});
}

TEST(SceneModel, SnapshotMovesSolidsAndJoints) {
  SceneModel scene;
  scene.setEntities({solid(1), turntable(2)});
  manipulation::SceneSnapshot snapshot;
  snapshot.entities.push_back({1, Pose::translation({0, 0, 1}), {}, false, false});
  snapshot.entities.push_back({2, Pose::identity(), {0.5 * std::numbers::pi}, false, false});
  scene.setSnapshot(snapshot);
  const auto items = scene.items({});
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(items[0].X_WM.p, dvec3(0, 0, 1));
  EXPECT_LT(glm::length(items[1].X_WM.p - dvec3(0, 0.5, 0)), 1e-12) << "turned by a quarter";
  EXPECT_EQ(items[1].link, 1);
}

TEST(SceneModel, MarksAreOnWhatIsTouchedAndWhatIsHeld) {
  SceneModel scene;
  scene.setEntities({solid(1), turntable(2), solid(3)});
  manipulation::SceneSnapshot snapshot;
  snapshot.stylus.held = 1;
  manipulation::PairState touching;
  touching.moved = 1;
  touching.other = 2;
  touching.other_part = "arm";
  touching.contact = true;
  touching.near_miss = true;
  manipulation::PairState near = touching;
  near.other = 3;
  near.other_part.clear();
  near.contact = false;
  snapshot.pairs = {touching, near};
  scene.setSnapshot(snapshot);
  const auto items = scene.items({});
  EXPECT_EQ(items[0].state, kSelected);
  EXPECT_EQ(items[1].state, kContact);
  EXPECT_EQ(items[2].state, kNearMiss);
}

TEST(SceneModel, AFigureInItsSkinIsDrawnByLooksAndMarksWhereverItsJointsAre) {
  SceneModel scene;
  workcell::Entity figure;
  figure.id = 2;
  figure.name = "operator";
  const auto of_her =
      std::make_shared<const mannequin::Figure>(*mannequin::makeFigure({mannequin::Sex::kFemale, 1.62}));
  figure.body = workcell::Mannequin{{.model = mannequin::figureModel(*of_her)}, of_her};
  figure.setJoints(std::vector<double>(figure.robot()->dof(), 0.0));
  scene.setEntities({figure});
  const std::size_t links = scene.items({}).size();
  EXPECT_GT(links, 50u);
  const auto skin = std::make_shared<const mannequin::FigureSkin>(*figure.figure());
  scene.setSkin(figure, skin);
  ASSERT_EQ(scene.items({}).size(), 12u);
  EXPECT_TRUE(scene.hasSkin(figure));
  for (const RenderItem& item : scene.items({})) EXPECT_TRUE(item.smooth && item.entity == 2 && item.link == -1);
  EXPECT_EQ(scene.items({})[0].mesh, scene.items({})[0].mesh) << "made once while nothing changes";
  const int hand = figure.robot()->findLink("r_hand");
  scene.setLinkLooks(2, {{hand, LinkLook{{1.0f, 0.0f, 0.0f}, 2}}});
  const auto looked = scene.items({});
  ASSERT_EQ(looked.size(), 13u);
  EXPECT_EQ(std::count_if(looked.begin(), looked.end(), [](const RenderItem& item) { return item.pattern == 2; }), 1)
      << "colour and pattern are the link's own";
  scene.setLinkLooks(2, {});
  manipulation::SceneSnapshot snapshot;
  std::vector<double> joints(figure.robot()->dof(), 0.0);
  joints[mannequin::indexOf(mannequin::Dof::kRightShoulderFlexion)] = 1.5;
  snapshot.entities.push_back({2, Pose::translation({0, 0, 1}), joints, false, false});
  manipulation::PairState touching;
  touching.moved = 1;
  touching.other = 2;
  touching.other_part = "r_hand";
  touching.contact = true;
  snapshot.pairs = {touching};
  snapshot.stylus.held = 2;
  scene.setSnapshot(snapshot);
  const auto held = scene.items({});
  ASSERT_EQ(held.size(), 13u) << "held, it keeps its skin; what touches is marked";
  EXPECT_EQ(std::count_if(held.begin(), held.end(), [](const RenderItem& item) { return item.state & kContact; }), 1);
  EXPECT_EQ(held[0].X_WM.p, dvec3(0, 0, 1)) << "it goes along";
  EXPECT_GT(scene.boundsOf_W(2).max.x, 0.5) << "the hand ahead";
  workcell::Entity other = figure;
  std::get<workcell::Mannequin>(other.body).figure = std::make_shared<const mannequin::Figure>(*figure.figure());
  scene.setEntities({other});
  EXPECT_FALSE(scene.hasSkin(other)) << "another size wants another skin";
}

TEST(SceneModel, RevisionTellsWhetherAPictureWouldDiffer) {
  SceneModel scene;
  scene.setEntities({solid(1)});
  manipulation::SceneSnapshot snapshot;
  scene.setSnapshot(snapshot);
  const auto before = scene.revision();
  snapshot.time_s = 3.0;
  snapshot.stylus.X_WStylus.p.x = 1e-5;
  scene.setSnapshot(snapshot);
  EXPECT_EQ(scene.revision(), before) << "a tremble of the encoder is not seen";
  for (int i = 0; i < 20; ++i) {
    snapshot.stylus.X_WStylus.p.x += 1e-5;
    scene.setSnapshot(snapshot);
  }
  EXPECT_GT(scene.revision(), before) << "slow motion adds up";
}

TEST(SceneModel, HiddenEntitiesAreNeitherDrawnNorFitted) {
  SceneModel scene;
  workcell::Entity far_away = solid(2);
  far_away.X_WE = Pose::translation({100, 0, 0});
  far_away.visible = false;
  scene.setEntities({solid(1), far_away});
  EXPECT_EQ(scene.items({}).size(), 1u);
  EXPECT_LT(scene.bounds_W().max.x, 1.0);
}

TEST(SceneModel, GhostsStandBesideTheEntityAndCannotBePicked) {
  SceneModel scene;
  scene.setEntities({turntable(2)});
  const auto before = scene.revision();
  scene.setGhosts("one", {{2, Pose::identity(), {0.5 * std::numbers::pi}, true}});
  EXPECT_GT(scene.revision(), before);
  const auto items = scene.items({});
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(items[0].ghost, Ghost::kNone);
  EXPECT_EQ(items[0].X_WM.p, dvec3(0.5, 0, 0)) << "the entity itself stays where it is";
  EXPECT_EQ(items[1].ghost, Ghost::kTouches);
  EXPECT_EQ(items[1].entity, 0u);
  EXPECT_FALSE(items[1].casts_shadow);
  EXPECT_LT(glm::length(items[1].X_WM.p - dvec3(0, 0.5, 0)), 1e-12);
  const auto drawn = scene.revision();
  scene.setGhosts("one", {{2, Pose::identity(), {0.5 * std::numbers::pi}, true}});
  EXPECT_EQ(scene.revision(), drawn) << "the same ghost is the same picture";
  // Another owner neither takes them away nor is taken away with them.
  scene.setGhosts("other", {});
  EXPECT_EQ(scene.ghosts().size(), 1u);
  scene.setGhosts("other", {{2, Pose::identity(), {0.1}, false}, {2, Pose::identity(), {0.2}, false}});
  EXPECT_EQ(scene.items({}).size(), 4u);
  scene.setGhosts("one", {});
  EXPECT_EQ(scene.ghosts().size(), 2u);
}

TEST(SceneModel, AMotionThatIsPlayedGoesOverDocumentAndSnapshot) {
  SceneModel scene;
  scene.setEntities({turntable(2)});
  manipulation::SceneSnapshot snapshot;
  snapshot.entities.push_back({2, Pose::identity(), {0.3}, false, false});
  scene.setSnapshot(snapshot);
  scene.setPlayed({{2, Pose::translation({1, 0, 0}), {1.0}, false}});
  const workcell::Entity& robot = *scene.find(2);
  EXPECT_EQ(scene.joints(robot), std::vector<double>{1.0});
  EXPECT_EQ(scene.placement_W(robot).p, dvec3(1, 0, 0));
  scene.setPlayed({});
  EXPECT_EQ(scene.joints(robot), std::vector<double>{0.3});
}

TEST(SceneModel, ColoursAreQuietAndTheStylusIsDrawnOnlyWhileConnected) {
  SceneModel scene;
  scene.setEntities({solid(1)});
  const auto color = scene.items({})[0].color;
  EXPECT_NEAR(color[1] / color[0], 0.75f, 1e-5f) << "saturation 25 %";
  SceneModel::StylusLook look;
  look.length = 0.1;
  manipulation::SceneSnapshot snapshot;
  scene.setSnapshot(snapshot);
  EXPECT_EQ(scene.items(look).size(), 1u);
  snapshot.stylus.connected = true;
  scene.setSnapshot(snapshot);
  EXPECT_EQ(scene.items(look).size(), 3u);
}

TEST(SceneModel, ASecondStylusLooksOtherThanTheFirst) {
  SceneModel scene;
  SceneModel::StylusLook look;
  look.length = 0.1;
  look.body = penColor(false, true);
  manipulation::SceneSnapshot snapshot;
  snapshot.stylus.connected = true;
  snapshot.second.emplace().connected = true;
  scene.setSnapshot(snapshot);
  const auto items = scene.items(look);
  ASSERT_EQ(items.size(), 4u) << "a body and bands each";
  EXPECT_EQ(items[0].color, look.body);
  EXPECT_EQ(items[2].color, penColor(true, true));
  EXPECT_EQ(items[2].scale, look.length);
  EXPECT_EQ(items[3].color, look.band);
  EXPECT_EQ(items[3].mesh->triangles.size(), 2 * items[1].mesh->triangles.size()) << "two bands";
}

}  // namespace
}  // namespace hapticell::app
