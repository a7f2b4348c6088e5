// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace hapticell::cli {

/// What the word after an option names: help says it in a word, and a shell offers such files.
enum class ValueKind {
  kFile,
  kFolder,
  kWorkcell,
  kRobot,
  kModel,
  kMesh,
  kMotion,
  kExercise,
  kResults,
  kTable,
  kJson,
  kToml,
  kPicture
};

/// Of a ValueKind.
struct ValueWords {
  ValueKind kind;
  std::string_view word;                  ///< As help writes it: "WORKCELL".
  std::vector<std::string_view> endings;  ///< Of its files, without the dot; none: any file.
  bool from_library = false;              ///< "library:NAME" is one too.
};

/// All of them.
std::span<const ValueWords> valueKinds();
const ValueWords& wordsOf(ValueKind kind);

}  // namespace hapticell::cli
