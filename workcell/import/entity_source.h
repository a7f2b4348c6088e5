// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "geometry/system/error.h"
#include "workcell/entity/entity.h"
#include "workcell/import/imported_entities.h"

namespace hapticell::workcell {

/// Makes entities from what users name: a mesh file (STL, OBJ, PLY, OFF), a CAD file (readScene), a robot file
/// (readRobot), a cell (SDF model or world), "library:NAME" (a built-in robot: see listLibraryRobots()), a built-in
/// solid such as "box:X,Y,Z" or "table:" (see builtInParts(); sizes in the given unit), or "frame:" (a frame of the
/// cell). Files that are named twice are read once. One thread.
class EntityLoader {
 public:
  /// File names are relative to `folder`. `unit_is_stated`: every scale was given explicitly (by a workcell document),
  /// so there is no warning if a size suggests another unit. `monitor` (may be null) gets the progress of load() and
  /// loadSource() and can cancel them.
  explicit EntityLoader(std::filesystem::path folder, bool unit_is_stated = false, ImportMonitor* monitor = nullptr)
      : folder_(std::move(folder)), unit_is_stated_(unit_is_stated), monitor_(monitor) {}

  /// One entity with shape, source and a suitable name (the robot's own, else the file's stem); other fields have their
  /// defaults, joints are empty. `scale` is metres per unit of the file (0: as the file states, else metres); a robot's
  /// file is always in metres, and another scale for it is an error. A file with a tree becomes one solid. Errors name
  /// what is missing, broken or unknown. A mannequin, "mannequin:SEX:PERCENTILE", has its feet on the floor of its own
  /// frame.
  Expected<Entity> load(const std::string& what, double scale, Diagnostics& diagnostics);

  /// The entity for a source in a document: like load(), but only the part of the file that `source.part` names, if it
  /// names one. The parts of one file are read together, once.
  Expected<Entity> loadSource(const SourceFile& source, Diagnostics& diagnostics);

  /// The whole content of a file, as a tree of entities (parents first) placed in the file's frame, with a report.
  /// `monitor` may be null. Robots, meshes and built-in shapes give one entity.
  Expected<ImportResult> loadTree(const std::string& what, const ImportOptions& options, Diagnostics& diagnostics,
                                  ImportMonitor* monitor = nullptr);

 private:
  using MeshPointer = std::shared_ptr<const geometry::TriangleMesh>;

  Expected<Entity> loadShapeOf(const SourceFile& source, Diagnostics& diagnostics);
  Expected<Entity> loadLibraryRobot(const std::string& what, Diagnostics& diagnostics);
  Expected<Entity> loadMannequin(const std::string& what);
  Expected<Entity> loadRobot(const std::filesystem::path& file, const xacro::Arguments& arguments,
                             Diagnostics& diagnostics);
  Expected<Entity> loadMesh(const std::filesystem::path& file, const SourceFile& source, Diagnostics& diagnostics);
  Expected<Entity> loadPart(const std::filesystem::path& file, const SourceFile& source, Diagnostics& diagnostics);
  Expected<ImportResult> loadMeshTree(const std::filesystem::path& file, const ImportOptions& options,
                                      Diagnostics& diagnostics) const;

  std::filesystem::path folder_;
  bool unit_is_stated_ = false;
  ImportMonitor* monitor_ = nullptr;
  struct KnownMesh {
    MeshPointer mesh;
    std::optional<std::array<float, 3>> color;
    double metres_per_unit = 1.0;
  };
  std::map<std::pair<std::string, double>, KnownMesh> meshes_;
  struct KnownRobot {
    std::shared_ptr<const kinematics::RobotModel> model;
    std::vector<ToolFrame> tools;
    Pose X_FB;
  };
  std::map<std::string, KnownRobot> robots_;                                             // By file and arguments.
  std::vector<xacro::DeclaredArgument> declared_;                                        // Of the last xacro.
  std::map<std::pair<MeshPointer, std::pair<bool, double>>, MeshPointer> cared_meshes_;  // By source mesh and options.
  std::map<std::string, ImportResult> trees_;                                            // By file and reading options.
};

/// A frame of the cell with that name, at X_WE.
Entity makeFrame(std::string name, const Pose& X_WE);

/// True for a source that is not a file: "library:", "mannequin:", "hand:", "frame:", or a built-in solid ("box:",
/// "table:", ...).
bool isBuiltIn(const std::string& what);

}  // namespace hapticell::workcell
