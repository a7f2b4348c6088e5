// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/collision_objects.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "workcell/format/document_io.h"

namespace hapticell::bridge {
namespace {

/// A collision object with one primitive or one triangle, whose lists live as long as it does.
struct SampleObject {
  SampleObject(std::string name, std::uint8_t type, std::vector<double> sizes) : id(std::move(name)), dimensions(std::move(sizes)) {
    message.id = id.data();
    message.header.frame_id = frame.data();
    message.pose.position = {1.0, 2.0, 3.0};
    message.pose.orientation.w = 1.0;
    primitive.type = type;
    primitive.dimensions._buffer = dimensions.data();
    primitive.dimensions._length = static_cast<std::uint32_t>(dimensions.size());
    message.primitives._buffer = &primitive;
    message.primitives._length = 1;
  }
  SampleObject(const SampleObject&) = delete;
  void makeMesh() {
    mesh.vertices._buffer = vertices;
    mesh.vertices._length = 3;
    mesh.triangles._buffer = &triangle;
    mesh.triangles._length = 1;
    message.primitives._length = 0;
    message.meshes._buffer = &mesh;
    message.meshes._length = 1;
  }
  std::string id, frame = "world";
  std::vector<double> dimensions;
  shape_msgs_msg_dds__SolidPrimitive_ primitive{};
  geometry_msgs_msg_dds__Point_ vertices[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  shape_msgs_msg_dds__MeshTriangle_ triangle{{0, 1, 2}};
  shape_msgs_msg_dds__Mesh_ mesh{};
  moveit_msgs_msg_dds__CollisionObject_ message{};
};

TEST(CollisionObjects, BecomeSolidsOfTheCell) {
  const auto folder = std::filesystem::temp_directory_path() / ("hobjects-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  HeardObjects heard;
  SampleObject box("crate", 1, {0.5, 0.25, 2.0}), can("can", 3, {0.4, 0.1}), plate("plate 1", 1, {1, 1, 1});
  plate.makeMesh();
  for (const SampleObject* object : {&box, &can, &plate}) heard.take(object->message);
  EXPECT_EQ(heard.size(), 3u);
  workcell::Document cell;
  const auto added = heard.addTo(cell, folder / "new.hcell");
  ASSERT_TRUE(added) << added.error().message();
  ASSERT_TRUE(workcell::saveDocument(cell, folder / "new.hcell"));
  Diagnostics notes;
  const auto read = workcell::loadDocument(folder / "new.hcell", notes);
  ASSERT_TRUE(read) << read.error().message();
  const workcell::Entity* const crate = read->findByName("crate");
  ASSERT_TRUE(crate && crate->mesh());
  EXPECT_EQ(crate->X_WE.p, dvec3(1, 2, 3));
  EXPECT_NEAR(crate->mesh()->bounds().max.z, 1.0, 1e-12);
  const workcell::Entity* const cylinder = read->findByName("can");
  ASSERT_TRUE(cylinder && cylinder->mesh());
  EXPECT_NEAR(cylinder->mesh()->bounds().max.z, 0.2, 1e-9);  // Half of the height.
  EXPECT_NEAR(cylinder->mesh()->bounds().max.x, 0.1, 1e-3);
  ASSERT_TRUE(read->findByName("plate 1"));
  EXPECT_TRUE(std::filesystem::exists(folder / "new_objects/plate_1.stl"));
  // Heard again, it is moved and not doubled.
  heard.take(box.message);
  ASSERT_TRUE(heard.addTo(cell, folder / "new.hcell"));
  EXPECT_EQ(cell.state().entities.size(), 3u);
  std::filesystem::remove_all(folder);
}

TEST(CollisionObjects, OperationsAreThoseOfMoveIt) {
  HeardObjects heard;
  SampleObject box("crate", 1, {0.5, 0.25, 2.0});
  heard.take(box.message);
  box.message.operation = 1;
  heard.take(box.message);
  EXPECT_EQ(heard.size(), 0u);
  box.message.operation = 3;
  heard.take(box.message);  // Nothing to move.
  EXPECT_EQ(heard.size(), 0u);
}

TEST(CollisionObjects, OddOnesAreLeftOutWithANote) {
  HeardObjects heard;
  SampleObject cone("cone", 4, {1.0, 1.0}), negative("n", 1, {1.0, -1.0, 1.0}), elsewhere("e", 1, {1, 1, 1}), bent("b", 1, {1, 1, 1});
  elsewhere.frame = "map";
  elsewhere.message.header.frame_id = elsewhere.frame.data();
  bent.makeMesh();
  bent.triangle.vertex_indices[1] = 3;
  for (const SampleObject* object : {&cone, &negative, &elsewhere, &bent}) heard.take(object->message);
  EXPECT_EQ(heard.size(), 0u);
  EXPECT_EQ(heard.notes().size(), 4u);
}

}  // namespace
}  // namespace hapticell::bridge
