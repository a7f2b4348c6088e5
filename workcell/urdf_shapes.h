// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <urdf_model/link.h>
#include <urdf_model/model.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "geometry/error.h"
#include "kinematics/robot_model.h"
#include "workcell/scene_batch.h"

namespace hapticell::workcell {

/// X_AB of a URDF origin.
Pose toPose(const urdf::Pose& origin);

/// Turns the shapes of URDF links into meshes; reads each mesh file once.
class UrdfShapes {
 public:
  /// Materials named in `undefined_materials` have no color of their own.
  /// `monitor` (may be null) is told of, and can end, the reading of Collada and other scene files.
  UrdfShapes(std::filesystem::path file, std::set<std::string> undefined_materials, Diagnostics& diagnostics,
             ImportMonitor* monitor = nullptr);

  /// Reads the scene files of all links together (see SceneBatch); fill() then finds them read.
  void readAhead(const urdf::ModelInterface& model);

  /// Fills the link's visuals and collisions; see readUrdf() for what replaces what.
  Expected<void> fill(const urdf::Link& source, kinematics::Link& link);

  /// Tells once, for the whole robot, which links are shown or checked otherwise than their file says.
  void reportReplacements();

 private:
  using MeshKey = std::tuple<std::string, double, double, double>;

  std::filesystem::path file_;
  std::set<std::string> undefined_materials_;
  Diagnostics& diagnostics_;
  SceneBatch scenes_;
  std::map<MeshKey, std::shared_ptr<const geometry::TriangleMesh>> meshes_;
  std::set<std::string> unreadable_formats_;
  std::vector<std::string> shown_by_collision_, checked_by_visual_, without_shape_;

  /// A shape, nothing (its format cannot be read yet), or an error.
  Expected<std::optional<kinematics::LinkShape>> shapeOf(const std::string& link,
                                                         const urdf::GeometrySharedPtr& geometry,
                                                         const urdf::Pose& origin);
  Expected<std::shared_ptr<const geometry::TriangleMesh>> meshOf(const std::string& link, const urdf::Mesh& mesh,
                                                                 const std::filesystem::path& path);
  Expected<std::shared_ptr<const geometry::TriangleMesh>> primitiveOf(const std::string& link,
                                                                      const urdf::Geometry& geometry) const;
  Error refusal(const std::string& link, std::string found, std::string expected, std::string fix) const;
};

}  // namespace hapticell::workcell
