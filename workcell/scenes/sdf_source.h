// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <sdf/Mesh.hh>
#include <sdf/Root.hh>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/error.h"

namespace hapticell::workcell {

/// A mesh file that an SDF file names.
struct SdfMeshFile {
  std::string uri;             ///< Unchanged.
  std::filesystem::path file;  ///< Where it was found.
};

/// An SDF file with all models that it includes, as libsdformat understands it: its frames define all poses.
///
/// The text is cleaned up before the library gets it, because the library rejects a whole file for one wrong word in
/// content that does not matter here: content without effect on pose, shape or motion is removed (ContentReport),
/// duplicate names get a number, poses that are too short are filled with 0, populations become models, missing models
/// and meshes are left out. All but the first of these are listed in warnings(). Several models at the top, or an
/// <include> there, are put into a world.
class SdfSource {
 public:
  /// Errors: no XML, nested deeper than 200, not SDF, no model in it, a version that the library does not know. Also
  /// silences the library's console from then on. Any thread.
  static Expected<SdfSource> load(const std::filesystem::path& file);

  /// Models are in the (first) world, or there is one model without a world.
  const sdf::Root& root() const { return *root_; }
  /// Null if the file has no world.
  const sdf::World* world() const { return root_->WorldCount() > 0 ? root_->WorldByIndex(0) : nullptr; }
  /// All top-level models.
  std::vector<const sdf::Model*> models() const;
  /// The file behind a mesh of root().
  const SdfMeshFile& meshFile(const sdf::Mesh& mesh) const;
  const std::vector<SdfMeshFile>& meshFiles() const { return meshes_; }
  /// Sentences without the file's name.
  const std::vector<Text>& warnings() const { return warnings_; }

 private:
  std::shared_ptr<sdf::Root> root_;
  std::vector<SdfMeshFile> meshes_;
  std::vector<Text> warnings_;
};

/// The top level of an SDF file, read without the library: quick enough for isSdfCell().
struct SdfOutline {
  int models = 0;        ///< Top-level models with a shape that is not a plane.
  int jointed = 0;       ///< Those with a moving joint and their own links, at the top or alone in a wrapper.
  bool grouped = false;  ///< A moving joint connects models of a model that has no links.
  bool world = false;
};

/// Empty if the file is not SDF. Also looks into included models.
std::optional<SdfOutline> outlineOf(const std::filesystem::path& file);

/// X_AB from the library's type.
Pose toPose(const ignition::math::Pose3d& X_AB);

/// The first of the library's own messages, in one line of at most 400 bytes.
std::string firstOf(const sdf::Errors& errors);

}  // namespace hapticell::workcell
