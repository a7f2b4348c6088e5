// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/model/robot_model.h"
#include "workcell/robots/urdf_elements.h"
#include "workcell/scenes/scene_batch.h"
#include "workcell/text/package_path.h"

namespace hapticell::workcell {

class UrdfLines;

/// Makes meshes of the shapes of URDF links; reads each mesh file once.
class UrdfShapes {
 public:
  /// `monitor` (may be null) gets the progress of reading Collada and other scene files and can cancel it.
  UrdfShapes(const UrdfLines& lines, Diagnostics& diagnostics, ImportMonitor* monitor = nullptr);

  /// Reads the scene files of all links together (see SceneBatch), so that fill() has them.
  void readAhead(const std::vector<UrdfLink>& links);

  /// Fills the link's visuals and collisions; readUrdf() describes the replacements. A shape that cannot be loaded is
  /// left out, reported, and counted in Link::lost_shapes. The only error: reading was cancelled.
  Expected<void> fill(const UrdfLink& source, kinematics::Link& link);

  /// Reports once, for the whole robot, which links are shown or checked differently from their file.
  void reportReplacements();

 private:
  using MeshKey = std::tuple<std::string, double, double, double>;

  const UrdfLines& lines_;
  std::filesystem::path folder_;
  Diagnostics& diagnostics_;
  SceneBatch scenes_;
  std::map<std::string, std::optional<FoundFile>> found_;  ///< By the name in the file.
  std::map<MeshKey, std::shared_ptr<const geometry::TriangleMesh>> meshes_;
  std::set<std::string> reported_, unreadable_formats_;
  bool package_missing_ = false;
  std::string link_;  ///< The link that is being filled.
  std::vector<std::string> shown_by_collision_, checked_by_visual_, partly_, without_shape_;

  /// A shape, or nothing if it cannot be loaded; then increments `lost`, unless it is an empty placeholder.
  std::optional<kinematics::LinkShape> shapeOf(const UrdfShape& source, int& lost);
  std::shared_ptr<const geometry::TriangleMesh> fileMesh(const UrdfShape& source, std::string& file);
  Expected<std::shared_ptr<const geometry::TriangleMesh>> scaledMesh(const UrdfShape& source,
                                                                     const std::filesystem::path& path);
  const std::optional<FoundFile>& find(const std::string& name);
  void reportOnce(int line, const std::string& what, const Text& sentence);
};

}  // namespace hapticell::workcell
