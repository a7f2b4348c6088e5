// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/document/document.h"
#include "workcell/scenes/import_scene.h"
#include "xacro/expand.h"

namespace hapticell::workcell {

/// What an import did, for the user to read.
struct ImportReport {
  std::string format;                              ///< "step", "stl", "urdf", ...
  double metres_per_unit = 1.0;                    ///< As it was read.
  bool unit_is_stated = true;                      ///< False: the file names none.
  UpAxis up_axis = UpAxis::kZ;                     ///< The file's.
  double chord = 0.0;                              ///< Metres; 0 where nothing was cut into triangles.
  std::size_t parts = 0;                           ///< Solids and robots.
  std::size_t triangles = 0;                       ///< Of all parts, each use counted.
  std::size_t merged_vertices = 0;                 ///< Repaired: corners of neighbouring triangles made one.
  std::size_t degenerate_triangles = 0;            ///< Dropped: no area.
  std::size_t duplicate_triangles = 0;             ///< Dropped: there twice.
  std::vector<xacro::DeclaredArgument> arguments;  ///< Of a xacro: what it asks for, and with what it was read.
  std::vector<Text> warnings;               ///< All that was dropped, replaced or guessed, a sentence each.
};

/// What a file became: entities in the order of the tree, parents before children, with names unique among them, placed
/// in the file's frame (z up); and the report.
struct ImportResult {
  std::vector<Entity> entities;
  ImportReport report;
};

/// A robot as an entity at the origin, with the tip that a user most likely means; source and tools are left out.
Entity robotEntity(std::shared_ptr<const kinematics::RobotModel> robot, const std::string& name);

/// Makes entities of a scene: a solid of every node with a mesh, an assembly of every other one; `merge` makes one
/// solid named like the file. Empty nodes are left out and reported. `source` is the file; each entity's own source
/// names its part besides.
Expected<ImportResult> entitiesFromScene(ImportedScene scene, const SourceFile& source, const ImportOptions& options,
                                         Diagnostics& diagnostics);

/// Adds what was imported to the document as one step of undo, the file's frame F placed at X_WF. Names that are taken
/// get a number behind them, `parent`s follow. On error nothing has changed. Gives the ids in the order of the
/// entities.
Expected<std::vector<EntityId>> addImported(Document& document, std::vector<Entity> entities, const Pose& X_WF);

}  // namespace hapticell::workcell
