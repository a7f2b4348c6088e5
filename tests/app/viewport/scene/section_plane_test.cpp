// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/section_plane.h"

#include <gtest/gtest.h>

#include "app/viewport/drawing/frame.h"

namespace hapticell::app {
namespace {

const ViewSize kSectionSize{800, 600};

geometry::Bounds cell() {
  geometry::Bounds bounds;
  bounds.add(dvec3(-1.0, 0.0, 0.2));
  bounds.add(dvec3(3.0, 2.0, 2.2));
  return bounds;
}

Camera cameraAlong(const dvec3& direction_W) {
  return Camera().turnedTo(direction_W).fitted(cell(), kSectionSize);
}

TEST(SectionPlane, CutsAwayTheEyesSideThroughTheMiddle) {
  for (const dvec3& look : {dvec3(0, 1, -0.3), dvec3(0, -1, -0.3), dvec3(1, 0.2, 0), dvec3(0.1, 0.1, -1)}) {
    const Camera camera = cameraAlong(look);
    const SectionPlane plane = sectionFacing(camera, cell());
    EXPECT_GT(glm::dot(plane.nhat_W, camera.eye_W()), plane.offset) << "the eye is on the side cut away";
    EXPECT_NEAR(glm::dot(plane.nhat_W, cell().center()), plane.offset, 1e-12);
  }
  EXPECT_EQ(axisOf(sectionFacing(cameraAlong({0, 1, -0.3}), cell())), 1);
  EXPECT_EQ(axisOf(sectionFacing(cameraAlong({1, 0.2, 0}), cell())), 0);
  EXPECT_EQ(axisOf(sectionFacing(cameraAlong({0.1, 0.1, -1}), cell())), 2);
}

TEST(SectionPlane, TheOtherSideIsTheSamePlaceTurnedRound) {
  const SectionPlane plane = sectionAcross(0, cameraAlong({1, 0, 0}), cell());
  const SectionPlane other = flipped(plane);
  EXPECT_EQ(other.nhat_W, -plane.nhat_W);
  EXPECT_EQ(flipped(other), plane);
  EXPECT_NEAR(other.offset * other.nhat_W.x, plane.offset * plane.nhat_W.x, 1e-12);
}

TEST(SectionPlane, TheHandleFollowsThePointer) {
  const Camera camera = cameraAlong({0.6, 1, -0.5});
  SectionPlane plane = sectionAcross(1, camera, cell());
  dvec3 on_axis = cell().center();
  const dvec3 wanted = on_axis + 0.35 * plane.nhat_W;
  const glm::dvec2 from = *camera.project(on_axis, kSectionSize), to = *camera.project(wanted, kSectionSize);
  EXPECT_TRUE(onSectionHandle(plane, cell(), camera, kSectionSize, from));
  EXPECT_FALSE(onSectionHandle(plane, cell(), camera, kSectionSize, from + glm::dvec2(60, 60)));
  plane = draggedSection(plane, cell(), camera, kSectionSize, from, to);
  EXPECT_NEAR(plane.offset, glm::dot(plane.nhat_W, wanted), 1e-9);
}

TEST(SectionPlane, StaysWithinTheCellAndWhereThePointerSaysNothing) {
  const Camera camera = cameraAlong({0.6, 1, -0.5});
  const SectionPlane plane = sectionAcross(1, camera, cell());
  const glm::dvec2 from = *camera.project(cell().center(), kSectionSize);
  const glm::dvec2 far = *camera.project(cell().center() + 1.6 * plane.nhat_W, kSectionSize);
  EXPECT_NEAR(draggedSection(plane, cell(), camera, kSectionSize, from, far).offset, 0.0, 1e-9) << "y = 0 is the border";
  const Camera along = cameraAlong({0, 1, 0});
  const SectionPlane across = sectionAcross(1, along, cell());
  EXPECT_EQ(draggedSection(across, cell(), along, kSectionSize, {400, 300}, {430, 300}), across);
}

TEST(SectionPlane, SightBeginsInThePlane) {
  const SectionPlane plane{dvec3(0, -1, 0), -1.0};  // Cuts away y < 1.
  const Ray ray = fromSection(plane, {dvec3(0, -4, 0), glm::normalize(dvec3(0.5, 1, 0))});
  EXPECT_NEAR(ray.origin_W.y, 1.0, 1e-12);
  EXPECT_NEAR(ray.origin_W.x, 2.5, 1e-12);
  const Ray behind = fromSection(plane, {dvec3(0, 4, 0), dvec3(0, -1, 0)});
  EXPECT_EQ(behind.origin_W, dvec3(0, 4, 0)) << "the eye is where things are drawn";
}

TEST(SectionPlane, IsTheSamePlaneInThePartsOwnCoordinates) {
  Frame frame;
  frame.section = SectionPlane{glm::normalize(dvec3(0.2, -0.9, 0.4)), 0.7};
  RenderItem item;
  item.X_WM.q = glm::normalize(dquat(0.8, 0.1, -0.4, 0.3));
  item.X_WM.p = dvec3(0.4, -1.2, 2.0);
  const dvec3 center(0.1, 0.2, 0.3);
  const glm::dmat4 world_from_model = worldFromDisplay(item, center);
  const glm::vec4 section = sectionInModel(frame, item, world_from_model);
  for (const dvec3& p : {dvec3(0.0), dvec3(1, 2, -0.5), dvec3(-3, 0.1, 0.9)}) {
    const dvec3 p_W(world_from_model * glm::dvec4(p, 1.0));
    const double in_world = frame.section->offset - glm::dot(frame.section->nhat_W, p_W);
    EXPECT_NEAR(section.w - glm::dot(fvec3(section), fvec3(p)), in_world, 1e-5);
  }
  item.over_scene = true;
  EXPECT_EQ(sectionInModel(frame, item, world_from_model), glm::vec4(0, 0, 0, 1));
}

}  // namespace
}  // namespace hapticell::app
