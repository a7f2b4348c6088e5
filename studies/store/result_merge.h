// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "studies/store/result_store.h"

namespace hapticell::studies {

struct MergeSummary {
  std::int64_t rows = 0;
  std::int64_t missing_units = 0;  ///< Units that no part has.
};

/// Joins the results of chunks into a new file `target`. Errors: a part of another study, of changed files or of another
/// version of the program; a unit that two parts have (the same chunk twice); units that no part has, unless
/// `may_lack`; a target that exists. On error no target is left.
Expected<MergeSummary> mergeResults(const std::vector<std::filesystem::path>& parts,
                                    const std::filesystem::path& target, bool may_lack);

}  // namespace hapticell::studies
