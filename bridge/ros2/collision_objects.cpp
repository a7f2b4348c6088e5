// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/collision_objects.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "geometry/system/atomic_file.h"
#include "trajectory/motion/number_text.h"
#include "workcell/document/command.h"
#include "workcell/import/entity_source.h"
#include "workcell/meshes/mesh_writer.h"

namespace hapticell::bridge {

namespace {

namespace fs = std::filesystem;
using trajectory::shortestText;

/// A pose that can be used; an all-zero quaternion, as some programs leave it, is no turn.
std::optional<Pose> usedPose(const geometry_msgs_msg_dds__Pose_& message) {
  const dvec3 p(message.position.x, message.position.y, message.position.z);
  dquat q(message.orientation.w, message.orientation.x, message.orientation.y, message.orientation.z);
  const double norm = glm::length(q);
  if (norm == 0.0) q = dquat(1.0, 0.0, 0.0, 0.0);
  const bool fits = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) &&
                    (norm == 0.0 || std::abs(norm - 1.0) <= 1e-3);
  if (!fits) return std::nullopt;
  return Pose{p, glm::normalize(q)};
}

/// "box:1,2,3" of a primitive; empty: another kind, or sizes that are no sizes.
std::string builtInOf(const shape_msgs_msg_dds__SolidPrimitive_& shape) {
  constexpr int kBox = 1, kSphere = 2, kCylinder = 3;
  const double* const sizes = shape.dimensions._buffer;
  const std::uint32_t count = shape.dimensions._length;
  for (std::uint32_t i = 0; i < count; ++i)
    if (!(sizes[i] > 0.0) || !std::isfinite(sizes[i])) return {};
  if (shape.type == kBox && count == 3)
    return "box:" + shortestText(sizes[0]) + "," + shortestText(sizes[1]) + "," + shortestText(sizes[2]);
  if (shape.type == kSphere && count == 1) return "sphere:" + shortestText(sizes[0]);
  if (shape.type == kCylinder && count == 2)  // ROS: height, radius.
    return "cylinder:" + shortestText(sizes[1]) + "," + shortestText(sizes[0]);
  return {};
}

/// A mesh whose numbers can be used; nothing: an index or a number that cannot.
std::optional<geometry::TriangleMesh> usedMesh(const shape_msgs_msg_dds__Mesh_& message) {
  geometry::TriangleMesh mesh;
  for (std::uint32_t i = 0; i < message.vertices._length; ++i) {
    const auto& v = message.vertices._buffer[i];
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return std::nullopt;
    mesh.vertices.push_back({v.x, v.y, v.z});
  }
  for (std::uint32_t i = 0; i < message.triangles._length; ++i) {
    geometry::Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = message.triangles._buffer[i].vertex_indices[k];
    if (std::ranges::any_of(triangle, [&](std::uint32_t index) { return index >= mesh.vertices.size(); })) return std::nullopt;
    mesh.triangles.push_back(triangle);
  }
  if (mesh.triangles.empty()) return std::nullopt;
  return mesh;
}

template <typename Sequence>
std::optional<Pose> poseAt(const Sequence& poses, std::uint32_t i) {
  return i < poses._length ? usedPose(poses._buffer[i]) : Pose::identity();
}

std::string fileStem(const std::string& id) {
  std::string stem;
  for (const char c : id) stem += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return stem.empty() ? "object" : stem;
}

}  // namespace

bool HeardObjects::addShapes(const moveit_msgs_msg_dds__CollisionObject_& message, Object& object) {
  bool any = false;
  const bool is_first = object.mesh.triangles.empty();
  for (std::uint32_t i = 0; i < message.primitives._length; ++i) {
    const std::string source = builtInOf(message.primitives._buffer[i]);
    const auto X_OP = poseAt(message.primitive_poses, i);
    if (source.empty() || !X_OP) continue;
    Diagnostics unheard;
    const auto part = workcell::EntityLoader({}).load(source, 1.0, unheard);
    if (!part) continue;
    geometry::append(object.mesh, *part->mesh(), *X_OP);
    const bool is_only = is_first && message.primitives._length == 1 && message.meshes._length == 0;
    if (is_only && X_OP->p == dvec3(0.0) && X_OP->q == dquat(1.0, 0.0, 0.0, 0.0)) object.built_in = source;
    any = true;
  }
  for (std::uint32_t i = 0; i < message.meshes._length; ++i) {
    const auto mesh = usedMesh(message.meshes._buffer[i]);
    const auto X_OM = poseAt(message.mesh_poses, i);
    if (!mesh || !X_OM) continue;
    geometry::append(object.mesh, *mesh, *X_OM);
    any = true;
  }
  return any;
}

void HeardObjects::take(const moveit_msgs_msg_dds__CollisionObject_& message) {
  constexpr int kRemove = 1, kAppend = 2, kMove = 3;
  const std::string id = message.id ? message.id : "", frame = message.header.frame_id ? message.header.frame_id : "";
  if (message.operation == kRemove) {
    objects_.erase(id);
    return;
  }
  const auto X_WO = usedPose(message.pose);
  if (id.empty() || !X_WO || (!frame.empty() && frame != "world")) {
    notes_.push_back(Text("object '%1' is left out: it has no name, no pose, or the frame '%2' instead of 'world'", id, frame));
    return;
  }
  const auto known = objects_.find(id);
  if (message.operation == kMove) {
    if (known != objects_.end()) known->second.X_WO = *X_WO;
    return;
  }
  Object object;
  if (message.operation == kAppend && known != objects_.end()) object = known->second;
  object.X_WO = *X_WO;
  if (message.operation == kAppend) object.built_in.clear();
  if (!addShapes(message, object)) {
    notes_.push_back(Text("object '%1' is left out: it has no box, sphere, cylinder or mesh", id));
    return;
  }
  objects_[id] = std::move(object);
}

void HeardObjects::take(const moveit_msgs_msg_dds__PlanningScene_& scene) {
  if (!scene.is_diff) objects_.clear();
  for (std::uint32_t i = 0; i < scene.world.collision_objects._length; ++i) take(scene.world.collision_objects._buffer[i]);
}

Expected<void> HeardObjects::addTo(workcell::Document& cell, const fs::path& file) const {
  const fs::path folder = fs::absolute(file).parent_path();
  workcell::EntityLoader loader(folder, true);
  Diagnostics unheard;
  std::map<std::string, int> stems;
  for (const auto& [id, object] : objects_) {
    if (const workcell::Entity* const known = cell.findByName(id)) {
      const auto placed = cell.execute(workcell::SetPlacement{known->id, object.X_WO});
      HAPTICELL_TRY(placed);
      continue;
    }
    std::string source = object.built_in;
    if (source.empty()) {
      std::string stem = fileStem(id);
      if (const int used = stems[stem]++; used > 0) stem += "_" + std::to_string(used + 1);
      const fs::path mesh_file = folder / (file.stem().string() + "_objects") / (stem + ".stl");
      std::error_code fault;
      fs::create_directories(mesh_file.parent_path(), fault);
      if (fault)
        return makeError(
            {.file = mesh_file.string(), .found = systemText(fault.value()), .expected = "a folder to write"});
      const workcell::NamedMesh part{id, object.mesh};
      HAPTICELL_TRY(writeFileAtomically(mesh_file, workcell::stlBytes({&part, 1}, 1.0)));
      source = mesh_file.string();
    }
    auto entity = loader.load(source, 1.0, unheard);
    HAPTICELL_TRY(entity);
    entity->name = id;
    entity->X_WE = object.X_WO;
    const auto added = cell.execute(workcell::AddEntity{std::move(*entity)});
    HAPTICELL_TRY(added);
  }
  return {};
}

}  // namespace hapticell::bridge
