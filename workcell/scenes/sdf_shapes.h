// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>

#include "geometry/shapes/triangle_mesh.h"
#include "workcell/scenes/scene_batch.h"
#include "workcell/scenes/sdf_source.h"

namespace hapticell::workcell {

/// Options for Collada without its up axis, as in Gazebo.
ImportOptions asGazeboDoes();

/// Makes meshes of the shapes of an SDF file; each mesh file is read once for each way of using it.
class SdfShapes {
 public:
  /// `source` and `monitor` (may be null) must outlive this.
  SdfShapes(const SdfSource& source, const ImportOptions& options, ImportMonitor* monitor);

  /// The shape's mesh in its own frame, metres; null if it is left out, which is then reported. A mesh that is mirrored
  /// by its scale keeps its outside; of a <submesh> only that part is taken, by its name.
  std::shared_ptr<const geometry::TriangleMesh> meshOf(const SdfShape& shape, const std::string& owner);

  bool isCancelled() const { return scenes_.isCancelled(); }
  /// What was left out or assumed, reported once.
  const Diagnostics& notes() const { return notes_; }

 private:
  using MeshPointer = std::shared_ptr<const geometry::TriangleMesh>;

  const SdfSource& source_;
  SceneBatch scenes_;
  ImportMonitor* monitor_;
  std::map<std::string, MeshPointer> known_;
  Diagnostics notes_;

  MeshPointer meshOfFile(const SdfShape& mesh, const std::string& owner);
  Expected<geometry::TriangleMesh> wholeOrPart(const std::filesystem::path& file, const SdfShape& mesh);
};

}  // namespace hapticell::workcell
