// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/scenes/import_monitor.h"
#include "workcell/scenes/sdf_content.h"

namespace hapticell::workcell {

/// A mesh file that an SDF file names.
struct SdfMeshFile {
  std::string uri;             ///< Unchanged.
  std::filesystem::path file;  ///< Where it was found.
};

/// An SDF file with all models that it takes in, as libsdformat understands it: its frames define all poses. The library
/// is in the importer's process, which is started for each file.
///
/// The text is cleaned up before the library gets it, because the library rejects a whole file for one wrong word in
/// content that does not matter here: content without effect on pose, shape or motion is removed (ContentReport),
/// duplicate names get a number, poses that are too short are filled with 0, populations become models, missing models
/// and meshes are left out. All but the first of these are listed in warnings(). Several models at the top, or an
/// <include> there, are put into a world.
class SdfSource {
 public:
  /// Errors: no XML, nested deeper than 200, not SDF, no model in it, a version that the library does not know, those of
  /// callImporter(). `monitor` may be null; a cancelled one ends it. Any thread.
  static Expected<SdfSource> load(const std::filesystem::path& file, ImportMonitor* monitor);

  /// All models at the top: those of the (first) world, or one without a world.
  const std::vector<SdfModel>& models() const { return content_.models; }
  /// The file behind a mesh of models().
  const SdfMeshFile& meshFile(const SdfShape& mesh) const;
  const std::vector<SdfMeshFile>& meshFiles() const { return meshes_; }
  /// Sentences without the file's name.
  const std::vector<Text>& warnings() const { return warnings_; }

 private:
  SdfContent content_;
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

}  // namespace hapticell::workcell
