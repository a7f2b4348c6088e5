// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/kit/subcommand.h"
#include "geometry/system/error.h"
#include "geometry/system/promise.h"

namespace hapticell::cli {

/// Reads a written file and measures on it what was asked.
using MeasureFile = std::function<Expected<Promises>(const std::filesystem::path& written)>;

/// Writes `content` under `path` after it was read back from a file beside it and measured. `result` gets
/// `promised{}` and `measured{}` by name. Where a promise is missed nothing is written and nothing is left, and the
/// error says where and by how much; with `allow_miss` it is written and `missed` has the sentence. An empty path: the
/// content is measured all the same, from a file that does not stay, called something with `extension`.
Expected<void> writeKept(const std::string& path, const std::string& content, const std::string& extension,
                         bool allow_miss, const MeasureFile& measure, nlohmann::ordered_json& result);

/// Puts `promised{}` and `measured{}` into `result`. Where a promise is missed that is the error, about `path`; with
/// `allow_miss` a warning and the sentence in `missed`.
Expected<void> reportPromises(const Promises& promises, const std::string& path, bool allow_miss,
                              nlohmann::ordered_json& result);

/// The flag --allow-miss.
void addAllowMiss(Subcommand command, bool& allow_miss);

}  // namespace hapticell::cli
