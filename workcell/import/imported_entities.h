// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/document/document.h"
#include "workcell/scenes/import_scene.h"
#include "xacro/expand.h"

namespace hapticell::workcell {

/// The result of an import, for the user.
struct ImportReport {
  std::string format;                              ///< "step", "stl", "urdf", ...
  double metres_per_unit = 1.0;                    ///< As used for reading.
  bool unit_is_stated = true;                      ///< False: the file states no unit.
  UpAxis up_axis = UpAxis::kZ;                     ///< Of the file.
  double chord = 0.0;                              ///< Chord error, metres; 0 if nothing was meshed.
  std::size_t parts = 0;                           ///< Solids and robots.
  std::size_t triangles = 0;                       ///< Of all parts; shared meshes count once per use.
  std::size_t merged_vertices = 0;                 ///< Repaired: corners of neighbouring triangles were merged.
  std::size_t degenerate_triangles = 0;            ///< Dropped: zero area.
  std::size_t duplicate_triangles = 0;             ///< Dropped: duplicates.
  std::vector<xacro::DeclaredArgument> arguments;  ///< Of a xacro: what it declares, and the values used for reading.
  std::vector<Text> warnings;               ///< What was dropped, replaced or guessed, one sentence each.
};

/// The entities made from a file, in tree order, parents before children, with names unique among them, placed in the
/// file's frame (z up); and the report.
struct ImportResult {
  std::vector<Entity> entities;
  ImportReport report;
};

/// A robot as an entity at the origin, with the tip link that a user most likely means; source and tools are not set.
Entity robotEntity(std::shared_ptr<const kinematics::RobotModel> robot, const std::string& name);

/// Makes entities from a scene: a solid for every node with a mesh, an assembly for every other node; `merge` makes one
/// solid named after the file. Leaves out empty nodes and reports them. `source` is the file; the source of each entity
/// also names its part.
Expected<ImportResult> entitiesFromScene(ImportedScene scene, const SourceFile& source, const ImportOptions& options,
                                         Diagnostics& diagnostics);

/// Adds imported entities to the document as one undo step, with the file's frame F at X_WF. Names that are taken
/// get a number, and `parent`s are adapted. On error nothing has changed. Returns the ids in the order of the
/// entities.
Expected<std::vector<EntityId>> addImported(Document& document, std::vector<Entity> entities, const Pose& X_WF);

}  // namespace hapticell::workcell
