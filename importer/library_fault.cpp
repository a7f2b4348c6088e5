// SPDX-License-Identifier: Apache-2.0
#include "importer/library_fault.h"

namespace hapticell::importer {

namespace {

struct Meaning {
  const char* word;
  const char* found;
  const char* expected;
};

constexpr char kTooLarge[] =
    HAPTICELL_TRANSLATED("a count that is too large for the file or for the memory limit of an import");
constexpr char kNoNumber[] = HAPTICELL_TRANSLATED("text instead of a number, or a number that is too large");
constexpr char kBeyond[] = HAPTICELL_TRANSLATED("a reference or count beyond the end of the file's data");
constexpr char kNothing[] = HAPTICELL_TRANSLATED("a reference to something that is not in the file");
constexpr char kFlat[] = HAPTICELL_TRANSLATED("a direction of length zero, or parallel axes");
constexpr char kShape[] = HAPTICELL_TRANSLATED("numbers that define no valid shape");

constexpr char kCounts[] = HAPTICELL_TRANSLATED("counts that fit the file");
constexpr char kNumber[] = HAPTICELL_TRANSLATED("a number");
constexpr char kReference[] = HAPTICELL_TRANSLATED("references to existing elements");
constexpr char kDirections[] = HAPTICELL_TRANSLATED("directions of non-zero length that are not parallel");
constexpr char kSolid[] = HAPTICELL_TRANSLATED("valid curves and surfaces");

/// The first that stands in the words counts.
constexpr Meaning kMeanings[] = {
    {"bad_alloc", kTooLarge, kCounts},
    {"length_error", kTooLarge, kCounts},
    {"max_size", kTooLarge, kCounts},
    {"_M_create", kTooLarge, kCounts},
    {"_M_default_append", kTooLarge, kCounts},
    {"bad_array_new_length", kTooLarge, kCounts},
    {"Standard_OutOfMemory", kTooLarge, kCounts},
    {"stoi", kNoNumber, kNumber},
    {"stol", kNoNumber, kNumber},
    {"stoul", kNoNumber, kNumber},
    {"stof", kNoNumber, kNumber},
    {"stod", kNoNumber, kNumber},
    {"Standard_NumericError", kNoNumber, kNumber},
    {"_M_range_check", kBeyond, kReference},
    {"out_of_range", kBeyond, kReference},
    {"basic_string", kBeyond, kReference},
    {"::at", kBeyond, kReference},
    {"Standard_OutOfRange", kBeyond, kReference},
    {"Standard_RangeError", kBeyond, kReference},
    {"Standard_DimensionMismatch", kBeyond, kReference},
    {"Standard_DimensionError", kBeyond, kReference},
    {"Standard_NullObject", kNothing, kReference},
    {"Standard_NullValue", kNothing, kReference},
    {"Standard_NoSuchObject", kNothing, kReference},
    {"Standard_TypeMismatch", kNothing, kReference},
    {"gp_VectorWithNullMagnitude", kFlat, kDirections},
    {"Standard_DivideByZero", kFlat, kDirections},
    {"Standard_ConstructionError", kShape, kSolid},
    {"Standard_DomainError", kShape, kSolid},
    {"StdFail_NotDone", kShape, kSolid},
    {"StdFail_UndefinedDerivative", kShape, kSolid},
    {"Geom_UndefinedDerivative", kShape, kSolid},
    {"Geom_UndefinedValue", kShape, kSolid},
    {"TopoDS_", kShape, kSolid},
};

}  // namespace

Error libraryFault(const std::string& words) {
  for (const Meaning& meaning : kMeanings) {
    if (words.find(meaning.word) != std::string::npos)
      return {.found = Text(meaning.found),
              .expected = Text(meaning.expected),
              .fix = "Export it again, or in another format (STEP, glTF, STL)."};
  }
  const bool says_nothing = words.empty() || words.find("std::") != std::string::npos;
  return {.found = says_nothing ? Text("inconsistent content") : Text("inconsistent content (%1)", words),
          .expected = "an undamaged file",
          .fix = "Export it again, or in another format (STEP, glTF, STL)."};
}

}  // namespace hapticell::importer
