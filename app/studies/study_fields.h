// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <span>
#include <string>
#include <vector>

namespace hapticell::app {

/// How a key of a study's table is edited.
enum class StudyEdit {
  kName,        ///< A word of the user's.
  kEntity,      ///< An entity of the cell.
  kRobot,       ///< A robot or mechanism of the cell.
  kMannequin,   ///< A mannequin of the cell.
  kAxis,        ///< x, y, z.
  kRange,       ///< The keys of a range of numbers; see RangeFields.
  kWords,       ///< A list of words.
  kMethods,     ///< Posture methods.
  kFile,        ///< A table; relative to the study.
  kFrames,      ///< Frames of the cell.
  kLength,      ///< m
  kSeconds,
  kWhole,
  kYes,
};

/// One key of a table.
struct StudyField {
  const char* key;
  const char* label;  ///< Translated by studyFieldLabel().
  StudyEdit edit;
  double otherwise = 0.0;  ///< What counts while the key is not there, of numbers and of kYes.
};

/// What a table [[vary]] or [[ask]] may say, by its key `what`.
struct StudyKind {
  const char* name;
  const char* label;
  std::vector<StudyField> fields;
  std::vector<const char*> columns = {};  ///< Numbers that a question answers with.
};

/// Kinds in the order of the documentation (docs/user/studies.md). Keys that are not listed are kept in the document and
/// named by the panel.
std::span<const StudyKind> varyKinds();
std::span<const StudyKind> askKinds();
/// Null for a kind that this program does not know.
const StudyKind* studyKind(const std::string& table, const std::string& what);

QString studyFieldLabel(const char* label);

/// Keys of a range, which StudyEdit::kRange stands for.
std::span<const char* const> rangeKeys();
/// Posture methods, as the document names them.
std::span<const char* const> postureMethods();

}  // namespace hapticell::app
