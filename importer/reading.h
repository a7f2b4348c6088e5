// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <set>

#include "importer/parent_link.h"
#include "workcell/scenes/import_scene.h"

namespace hapticell::importer {

/// The file to read, and the options.
struct Reading {
  std::filesystem::path file;                  ///< Absolute.
  std::optional<double> metres_per_unit = {};  ///< If a unit other than the file's was chosen.
  workcell::Tessellation tessellation = {};
  double relative_chord = 0.0;  ///< As in workcell::ImportOptions.
  std::set<int> skipped = {};   ///< Parts at which earlier runs crashed, by the number of beginPart().
};

}  // namespace hapticell::importer
