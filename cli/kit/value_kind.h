// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace hapticell::cli {

/// Kind of value that an option takes: shown in the help, and used by shells to complete file names.
enum class ValueKind {
  kFile,
  kFolder,
  kWorkcell,
  kRobot,
  kModel,
  kMesh,
  kMotion,
  kMcap,
  kExercise,
  kTrainingResults,
  kStudy,
  kStudyResults,
  kTable,
  kJson,
  kToml,
  kPicture
};

/// Properties of a ValueKind.
struct ValueWords {
  ValueKind kind;
  std::string_view word;                  ///< As shown in the help, unique: "WORKCELL".
  std::vector<std::string_view> endings;  ///< File extensions without the dot; empty: any file.
  bool from_library = false;              ///< Also accepts "library:NAME".
};

/// All kinds of values.
std::span<const ValueWords> valueKinds();
const ValueWords& wordsOf(ValueKind kind);

}  // namespace hapticell::cli
