// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "manipulation/scene/prepared_scene.h"
#include "studies/document/study_document.h"
#include "trajectory/motion/trajectory.h"
#include "workcell/document/document.h"

namespace hapticell::studies {

/// What all variants of a study share: the cell as it stands, and every shape and file that a variant may need, read
/// once. Filled by Study::load(), then immutable and read by all threads.
struct StudyInputs {
  StudyDocument document;
  workcell::Document cell;
  std::map<std::string, workcell::Entity> shapes;  ///< Robots and bodies by their source: "library:ur5e".
  std::map<std::string, std::shared_ptr<const trajectory::Trajectory>> motions;  ///< By absolute path.
  std::shared_ptr<const manipulation::PreparedScene> scene;  ///< The meshes of cell and shapes, ready for queries.
  std::vector<std::filesystem::path> files;  ///< What results depend on besides the document: absolute paths.
  config::Configuration configuration;
  std::vector<Text> notes;  ///< Of the readers, and what is not checked.

  /// Reads a robot or a body once, or finds it. Errors of EntityLoader.
  Expected<const workcell::Entity*> shapeOf(const std::string& source);
  /// Reads a motion once, or finds it.
  Expected<std::shared_ptr<const trajectory::Trajectory>> motionOf(const std::filesystem::path& file);
  /// The entity of the cell, or an error about this section that lists the names.
  Expected<const workcell::Entity*> entityNamed(const StudySection& section, const std::string& name) const;
};

}  // namespace hapticell::studies
