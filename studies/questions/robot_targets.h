// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "manipulation/checks/inverse_batch.h"
#include "studies/questions/question.h"

namespace hapticell::studies {

class SectionReader;

/// Poses that a robot's tool centre point shall reach, as a question names them.
struct TargetList {
  std::string robot;           ///< Name of the entity.
  std::filesystem::path file;  ///< CSV of poses; empty: `frames`.
  std::vector<std::string> frames;  ///< Frames of the cell, as they stand in the variant.
  std::string frame;           ///< An entity or a frame that the poses are in, and move with; empty: the cell.
  int turns = 1;               ///< The tool may be turned about its z axis by full turns / turns.
  double clearance = 0.0;      ///< m that solutions keep from the cell.
  std::vector<Pose> X_FT;  ///< Of the file.

  /// Equal for equal lists.
  std::string key() const;
};

/// Reads `entity`, `targets` or `frames`, `frame`, `turns` and `clearance`.
Expected<TargetList> readTargetList(SectionReader& reader, const StudySection& section, StudyInputs& inputs);

/// The solutions free of contact for a list of targets in one variant.
struct RobotTargets {
  workcell::EntityId robot = 0;
  int tip = -1;  ///< Link that carries the tool.
  manipulation::JointCheck check;
  std::vector<manipulation::FreeAnswer> targets;  ///< One a target; the solutions of all turns of the tool.

  bool allReached() const;
  std::size_t reached() const;
};

/// Solves them, or finds what another question of this variant solved. Errors: an entity that cannot be solved for.
Expected<std::shared_ptr<RobotTargets>> solvedTargets(VariantCell& cell, const TargetList& list);

}  // namespace hapticell::studies
