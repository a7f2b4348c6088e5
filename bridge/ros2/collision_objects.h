// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros2_messages.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"
#include "geometry/system/error.h"
#include "workcell/document/document.h"

namespace hapticell::bridge {

/// Collision objects of MoveIt as they were heard: the newest of each id.
class HeardObjects {
 public:
  /// ADD replaces, APPEND adds shapes, MOVE changes the pose, REMOVE forgets. Boxes, spheres, cylinders and meshes in the
  /// frame "world" (or without a frame) are taken; what is left out is in notes().
  void take(const moveit_msgs_msg_dds__CollisionObject_& object);
  void take(const moveit_msgs_msg_dds__PlanningScene_& scene);

  std::size_t size() const { return objects_.size(); }
  const std::vector<Text>& notes() const { return notes_; }

  /// Adds the objects to a cell that is about to be saved as `file`: a box, a sphere or a cylinder as a built-in solid,
  /// all else as an STL file in the folder STEM_objects beside it. An entity with the name of an object is placed
  /// instead. Errors: files that cannot be written or read.
  Expected<void> addTo(workcell::Document& cell, const std::filesystem::path& file) const;

 private:
  struct Object {
    Pose X_WO;
    std::string built_in;         ///< "box:1,2,3" if it is just one of these, at its origin.
    geometry::TriangleMesh mesh;  ///< Everything, in O.
  };
  bool addShapes(const moveit_msgs_msg_dds__CollisionObject_& message, Object& object);

  std::map<std::string, Object> objects_;
  std::vector<Text> notes_;
};

}  // namespace hapticell::bridge
