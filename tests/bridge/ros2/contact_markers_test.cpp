// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/contact_markers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "geometry/shapes/shapes.h"

namespace hapticell::bridge {
namespace {

using Message = visualization_msgs_msg_dds__MarkerArray_;

workcell::Entity block(workcell::EntityId id, const char* name, const dvec3& size, const dvec3& p_WE) {
  workcell::Entity entity;
  entity.id = id;
  entity.name = name;
  entity.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(size))};
  entity.X_WE = Pose::translation(p_WE);
  return entity;
}

/// A box of 60 mm that goes down from 20 mm above a table to 4 mm inside its top at 1 s, and up again until 2 s.
struct Descent {
  explicit Descent(bool is_listed = false, double force_n = 0.0) {
    workcell::DocumentState state;
    state.entities = {std::make_shared<const workcell::Entity>(block(1, "table", {1.0, 1.0, 0.1}, {0.0, 0.0, -0.05})),
                      std::make_shared<const workcell::Entity>(block(2, "box", dvec3(0.06), {0.2, 0.1, 0.05}))};
    cell = workcell::Document(state);
    auto motion = std::make_shared<trajectory::Trajectory>();
    motion->entity = "box";
    motion->moved = "self_origin";
    motion->channel_names = {"force_x", "force_y", "force_z"};
    if (is_listed) motion->touches = {{0.0, 0.7, "box", "table", force_n}};
    const double force[] = {0.0, 0.0, force_n};
    for (const auto& [t, gap] : {std::pair(0.0, 0.020), {1.0, -0.004}, {2.0, 0.020}})
      EXPECT_TRUE(motion->addFrame({t, Pose::translation({0.2, 0.1, 0.03 + gap})}, {}, force));
    auto made = manipulation::MotionReplay::create(state.entities, "box", motion);
    EXPECT_TRUE(made) << (made ? "" : made.error().message());
    if (made) replay = std::move(*made);
  }
  std::unique_ptr<ContactMarkers> markers(double rate_hz) const {
    auto made = ContactMarkers::create(cell, "box", *replay, rate_hz);
    EXPECT_TRUE(made) << (made ? "" : made.error().message());
    return made ? std::move(*made) : nullptr;
  }
  workcell::Document cell;
  std::optional<manipulation::MotionReplay> replay;
};

/// The markers of a message by id; each belongs to the contact of box and table.
std::map<int, visualization_msgs_msg_dds__Marker_> markersOf(const Message* message) {
  std::map<int, visualization_msgs_msg_dds__Marker_> markers;
  for (std::uint32_t i = 0; message != nullptr && i < message->markers._length; ++i) {
    const auto& marker = message->markers._buffer[i];
    EXPECT_STREQ(marker.ns, "box / table");
    EXPECT_STREQ(marker.header.frame_id, "world");
    EXPECT_TRUE(markers.try_emplace(marker.id, marker).second) << "each once";
  }
  return markers;
}

/// The x axis turned by a quaternion.
dvec3 arrowOf(const visualization_msgs_msg_dds__Marker_& marker) {
  const auto& q = marker.pose.orientation;
  return glm::dmat3(glm::dquat(q.w, q.x, q.y, q.z))[0];
}

TEST(ContactMarkers, APartThatEntersIsMarkedAsDeepAsItIs) {
  const Descent descent;
  const auto markers = descent.markers(100.0);
  ASSERT_NE(markers, nullptr);
  EXPECT_EQ(markers->update(1'500'000'000, 0.0), nullptr) << "20 mm apart";
  const auto pressed = markersOf(markers->update(2'500'000'000, 1.0));
  ASSERT_EQ(pressed.size(), 2u);
  const auto& arrow = pressed.at(ContactMarkers::kArrow);
  const auto& ball = pressed.at(ContactMarkers::kBall);
  EXPECT_EQ(arrow.type, 0);
  EXPECT_EQ(ball.type, 2);
  EXPECT_EQ(arrow.action, 0);
  EXPECT_EQ(arrow.header.stamp.sec, 2);
  EXPECT_EQ(arrow.header.stamp.nanosec, 500'000'000u);
  EXPECT_NEAR(ball.scale.x, 0.010 + 2.0 * 0.004, 1e-4);
  EXPECT_NEAR(arrow.scale.x, 0.010, 1e-9) << "no force was recorded";
  EXPECT_GT(arrowOf(arrow).z, 0.99) << "from the table to the box";
  EXPECT_NEAR(arrow.pose.position.z, 0.0, 0.005) << "at the table's top";
  EXPECT_NEAR(arrow.pose.position.x, 0.2, 0.031);
  EXPECT_NEAR(arrow.pose.position.y, 0.1, 0.031);
  EXPECT_EQ(arrow.lifetime.nanosec, 500'000'000u);
  const auto gone = markersOf(markers->update(3'000'000'000, 2.0));
  ASSERT_EQ(gone.size(), 2u);
  for (const auto& [id, marker] : gone) EXPECT_EQ(marker.action, 2) << "deleted";
  EXPECT_EQ(markers->update(3'100'000'000, 2.0), nullptr) << "once";
}

TEST(ContactMarkers, AContactOfTheSessionIsMarkedWithItsForceAlthoughThePartsAreApart) {
  const Descent descent(true, 5.0);
  const auto markers = descent.markers(1.0);
  ASSERT_NE(markers, nullptr);
  // At 0.6 s the gap is 20 - 0.6 x 24 = 5.6 mm: within the distance in which a listed contact is looked for.
  const auto listed = markersOf(markers->update(0, 0.6));
  ASSERT_EQ(listed.size(), 2u);
  EXPECT_NEAR(listed.at(ContactMarkers::kArrow).scale.x, 0.010 + 5.0 * 0.010, 1e-6);
  EXPECT_NEAR(listed.at(ContactMarkers::kBall).scale.x, 0.010, 1e-9) << "not in each other";
  EXPECT_NEAR(listed.at(ContactMarkers::kArrow).pose.position.z, 0.5 * 0.0056, 1e-6) << "midway";
  EXPECT_EQ(listed.at(ContactMarkers::kArrow).lifetime.sec, 2) << "two periods of a slow publisher";
  const auto deleted = markersOf(markers->clear(0));
  ASSERT_EQ(deleted.size(), 2u);
  EXPECT_EQ(deleted.at(ContactMarkers::kBall).action, 2);
  EXPECT_EQ(markers->clear(0), nullptr);
  EXPECT_EQ(markers->update(0, 0.75), nullptr) << "the contact has ended, and the parts do not touch";
}

TEST(ContactMarkers, AnEntityThatIsNotThereIsSaid) {
  const Descent descent;
  const auto made = ContactMarkers::create(descent.cell, "crate", *descent.replay, 100.0);
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().message().find("crate"), std::string::npos);
}

}  // namespace
}  // namespace hapticell::bridge
