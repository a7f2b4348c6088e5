// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "geometry/shapes/triangle_mesh.h"
#include "kinematics/model/robot_model.h"
#include "workcell/scenes/import_monitor.h"
#include "workcell/entity/import_options.h"

namespace hapticell::workcell {

/// Where the exact shape (B-rep) of a node can be read again, so that an export need not use its triangles.
struct SceneOrigin {
  std::string file;              ///< Absolute.
  std::string part;              ///< partPaths() of that file.
  double metres_per_unit = 0.0;  ///< As used for reading; 0: as the file states.
};

/// A node of an imported tree. With a mesh it is a solid, with a robot that robot, otherwise an assembly.
struct SceneNode {
  std::string name;                           ///< The part's name; not unique.
  std::string instance;                       ///< The name of this use of the part, if the file has one; else empty.
  int parent = -1;                            ///< Index of an earlier node; -1 for the top level.
  Pose X_PN;                                  ///< In the parent node's frame; for the top level, in the file's frame.
  int mesh = -1;                              ///< Index into the scene's meshes; several nodes may share one.
  std::optional<std::array<float, 3>> color;  ///< sRGB, 0 to 1.
  std::optional<SceneOrigin> origin;          ///< For exports.
  std::shared_ptr<const kinematics::RobotModel> robot;  ///< Only from SDF worlds; its root is the node.
};

/// The content of a CAD file: a tree of placed parts. Metres, z up, every mesh in the frame of its nodes.
struct ImportedScene {
  std::string format;            ///< "step", "iges", "gltf", "dae", "3mf", "fbx", "3ds", "obj", ...
  double metres_per_unit = 1.0;  ///< As in the file (or in the import options).
  bool unit_is_stated = false;   ///< The file states its unit.
  UpAxis up_axis = UpAxis::kZ;   ///< As in the file; the scene itself is z up.
  double chord = 0.0;            ///< Chord error, metres; 0 if the file contains triangles.
  std::vector<SceneNode> nodes;  ///< Parents before children.
  std::vector<geometry::TriangleMesh> meshes;
  std::vector<Text> warnings;  ///< What was dropped, repaired or guessed, and why.
};

/// True for files with a tree of parts: those that the importer's process reads (STEP, IGES, glTF, GLB, Collada, 3MF,
/// FBX, 3DS), recognised by content (STEP, glTF, FBX, Collada) or name, and SDF cells (isSdfCell).
bool holdsScene(const std::filesystem::path& file);

/// Reads such a file (with `options.merge` robots of an SDF world as solids) in a process of its own
/// (`hapticell-importer`), so that a crash, a hang or a blow-up there is an error here. Whatever that process sends is
/// checked: sizes, indices, finite numbers, unit quaternions, a tree. `monitor` may be null; a cancelled one ends the
/// process within 0.2 s. Blocks; any thread.
///
/// Errors: the program is missing, no such file, not readable as its format, no shape in it, time or memory exceeded,
/// cancelled.
Expected<ImportedScene> readScene(const std::filesystem::path& file, const ImportOptions& options,
                                  ImportMonitor* monitor);

/// Poses X_FN of all nodes in the file's frame, in the order of the nodes.
std::vector<Pose> nodePoses(const ImportedScene& scene);

/// A unique name for each node: names from the top joined by '/', with "#2", "#3" ... for the second and third node
/// with the same name among its siblings. The same file gives the same paths. ('/' and '#' in a name become '_'.)
std::vector<std::string> partPaths(const ImportedScene& scene);

}  // namespace hapticell::workcell
