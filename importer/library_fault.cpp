// SPDX-License-Identifier: Apache-2.0
#include "importer/library_fault.h"

namespace hapticell::importer {

namespace {

struct Meaning {
  const char* word;
  const char* found;
  const char* expected;
};

constexpr const char* kTooLarge = "a count that is larger than what the file holds, or more than an import may use";
constexpr const char* kNoNumber = "a text where a number belongs, or a number that no computer holds";
constexpr const char* kBeyond = "a reference or a count that points beyond what the file holds";
constexpr const char* kNothing = "a reference to something that is not in the file";
constexpr const char* kFlat = "a direction of no length, or axes that fall together";
constexpr const char* kShape = "numbers that make no shape";

constexpr const char* kCounts = "counts that fit the file";
constexpr const char* kNumber = "a number";
constexpr const char* kReference = "references to what is there";
constexpr const char* kSolid = "curves and surfaces that exist";

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
    {"gp_VectorWithNullMagnitude", kFlat, "directions that differ"},
    {"Standard_DivideByZero", kFlat, "directions that differ"},
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
      return {.found = meaning.found,
              .expected = meaning.expected,
              .fix = "Export it again, or in another format (STEP, glTF, STL)."};
  }
  const bool says_nothing = words.empty() || words.find("std::") != std::string::npos;
  return {.found = "content that contradicts itself" + (says_nothing ? "" : " (" + words + ")"),
          .expected = "a sound file",
          .fix = "Export it again, or in another format (STEP, glTF, STL)."};
}

}  // namespace hapticell::importer
