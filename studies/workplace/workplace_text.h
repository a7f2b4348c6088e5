// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/shapes/vector.h"
#include "studies/document/study_text.h"

namespace hapticell::studies {

/// The keys of a range of numbers: `values`, or `from`, `to` and `steps`.
using RangeKeys = std::vector<std::pair<std::string, StudyValue>>;

/// What a search for a workplace says as tables of a study.
struct WorkplaceTables {
  std::string mannequin;             ///< Shows the work.
  std::vector<std::string> station;  ///< Entities that move with the targets of its hands; not empty.
  dvec3 ahead_W{1.0, 0.0, 0.0};      ///< Horizontal: where "farther" is.
  RangeKeys height, distance;        ///< m
  bool may_stand = true, may_sit = false;
  std::string task = {};  ///< A work task by name; empty: none.
  std::vector<std::string> methods = {"rula"};
  bool each_body = false, postures = false;  ///< Further columns; see the question `posture`.
  bool all_pairs = false;                    ///< As the key of the question.
};

/// What its tables are called; each must be free.
struct WorkplaceNames {
  std::string stance = "stance", height = "height", distance = "distance", asked = "posture";
};

/// The four bodies of the question, in the order of mannequin::boundaryFigures().
const std::vector<std::string>& workplaceBodies();

/// Adds the tables: the station moves up and down, and nearer to the mannequin and farther from it; the work is done by
/// small women to large men, all must do it, and the worst RULA score should be small. Errors: those of StudyText; the
/// text may be changed in part then. @pre the station is not empty
Expected<void> addWorkplaceTables(StudyText& text, const WorkplaceTables& tables, const WorkplaceNames& names);

}  // namespace hapticell::studies
