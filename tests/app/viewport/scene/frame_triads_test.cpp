// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/frame_triads.h"

#include <gtest/gtest.h>

#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {

constexpr ViewSize kView{1000, 800};

/// Two frames 1 m apart, looked at from the front.
struct TriadScene {
  TriadScene() {
    std::vector<workcell::Entity> entities{workcell::makeFrame("near", {}),
                                           workcell::makeFrame("far", Pose::translation({1.0, 0, 0}))};
    entities[0].id = 1;
    entities[1].id = 2;
    scene.setEntities(entities);
    camera.azimuth = camera.elevation = 0.0;
    camera.distance = 4.0;
  }
  glm::dvec2 pixel(const dvec3& p_W) const { return *camera.project(p_W, kView); }
  SceneModel scene;
  Camera camera;
};

TEST(FrameTriads, AreThreeAxesAndTheNameWhateverTheDistance) {
  TriadScene view;
  for (const double distance : {0.05, 1.0, 4.0, 500.0}) {
    view.camera.distance = distance;
    const double length = triadLength(dvec3(0.0), view.camera, kView);
    const double pixels = length / view.camera.metresPerPixel(dvec3(0.0), kView);
    EXPECT_GE(pixels, 27.9) << distance;
    EXPECT_LE(pixels, 64.1) << distance;
  }
  view.camera.distance = 4.0;
  const auto curves = frameTriads(view.scene, view.camera, kView);
  ASSERT_EQ(curves.size(), 8u);
  EXPECT_EQ(curves[3].text, "near");
  EXPECT_EQ(curves[3].role, SceneCurve::Role::kGuideOff);
  view.scene.setSelected({1});
  EXPECT_EQ(frameTriads(view.scene, view.camera, kView)[3].role, SceneCurve::Role::kSelection);
}

TEST(FrameTriads, ArePickedNearAnAxisAndOnlyThere) {
  TriadScene view;
  const double length = triadLength(dvec3(0.0), view.camera, kView);
  EXPECT_EQ(frameAt(view.scene, view.camera, kView, view.pixel({0, 0, 0.9 * length}) + glm::dvec2(4, 0)), 1u);
  EXPECT_EQ(frameAt(view.scene, view.camera, kView, view.pixel({1.0, 0, 0})), 2u);
  EXPECT_EQ(frameAt(view.scene, view.camera, kView, view.pixel({0, 0, 0.9 * length}) + glm::dvec2(12, 0)), 0u);
  EXPECT_EQ(framesIn(view.scene, view.camera, kView, {0, 0}, {kView.width, kView.height}).size(), 2u);
  EXPECT_EQ(framesIn(view.scene, view.camera, kView, view.pixel({0.5, 0, 0.5}), {kView.width, kView.height}),
            std::vector<workcell::EntityId>{2});
  std::vector<workcell::Entity> hidden = view.scene.entities();
  hidden[0].visible = false;
  view.scene.setEntities(hidden);
  EXPECT_EQ(frameAt(view.scene, view.camera, kView, view.pixel(dvec3(0.0))), 0u);
}

TEST(FrameTriads, AFrameIsFittedButDoesNotStretchTheLight) {
  TriadScene view;
  EXPECT_NEAR(view.scene.boundsOf_W(2).center().x, 1.0, 1e-12);
  EXPECT_FALSE(view.scene.boundsOf_W(2).isEmpty());
  EXPECT_TRUE(view.scene.bounds_W().isEmpty());
  EXPECT_EQ(view.scene.corners_W().size(), 2u);
}

}  // namespace
}  // namespace hapticell::app
