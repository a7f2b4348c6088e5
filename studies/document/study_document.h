// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::studies {

struct StudySection;

/// How the variants of a study are chosen.
enum class Sampling {
  kGrid,    ///< Every combination of the values.
  kList,    ///< The first values of all together, then the second ...
  kHalton,  ///< Low-discrepancy samples (Halton 1960), shifted by the seed.
  kSobol,   ///< Low-discrepancy samples (Sobol 1967), shifted by the seed.
  kSearch,  ///< A search for the least objective; see SearchSettings.
};

/// A search instead of fixed samples.
struct SearchSettings {
  std::string method = "nelder-mead";
  std::size_t evaluations = 200;  ///< Of one start, at most.
  std::size_t starts = 1;         ///< Independent searches from different places, for each choice of the lists.
  double tolerance = 1e-4;        ///< Share of the ranges; the search ends when its steps are smaller.
};

/// What a variant must meet: a value of its row within bounds.
struct Requirement {
  std::string value;  ///< Name of a result: "reach.share".
  std::optional<double> at_least, at_most;
};

/// What is to be small (or large).
struct Objective {
  std::string value;  ///< Name of a result.
  bool is_greatest = false;
  double weight = 1.0;  ///< In the sum over all objectives by which variants are ordered and a search goes.
};

/// A study as its document says it (*.hstudy, docs/user/studies.md). A value; copies share the parsed text. What varies
/// and what is asked are sections, read by their kinds (variants/, questions/).
class StudyDocument {
 public:
  /// Reads a document. Errors name file, line and key; unknown keys are refused.
  static Expected<StudyDocument> read(const std::filesystem::path& file);
  /// The same from text. Files that it names are looked for relative to the folder of `file`.
  static Expected<StudyDocument> parse(std::string text, const std::filesystem::path& file);

  std::string name;               ///< For people; the file's stem where it says none.
  std::string note;               ///< Free text.
  std::filesystem::path file;     ///< Absolute.
  std::filesystem::path cell;     ///< Absolute.
  std::string text;               ///< All of the document.
  std::uint64_t seed = 1;         ///< Of samples and searches.
  Sampling sampling = Sampling::kGrid;
  std::size_t samples = 0;  ///< For kHalton and kSobol.
  SearchSettings search;
  std::vector<StudySection> variations, questions;
  std::vector<Requirement> requirements;
  std::vector<Objective> objectives;

  StudyDocument();
  StudyDocument(const StudyDocument&);
  StudyDocument(StudyDocument&&) noexcept;
  StudyDocument& operator=(const StudyDocument&);
  StudyDocument& operator=(StudyDocument&&) noexcept;
  ~StudyDocument();

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;  ///< What the sections point into.
  friend class StudyReader;
};

}  // namespace hapticell::studies
