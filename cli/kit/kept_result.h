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

/// Reads a written file and measures whether it meets what was asked.
using MeasureFile = std::function<Expected<Promises>(const std::filesystem::path& written)>;

/// Writes `content` to `path`, after reading it back from a temporary file and measuring it. `result` gets `promised{}`
/// and `measured{}` by name. If a promise is missed, nothing is written or left behind, and the error says where and by
/// how much; with `allow_miss`, it is written and `missed` has the sentence. With an empty path, the content is only
/// measured, from a temporary file with `extension`.
Expected<void> writeKept(const std::string& path, const std::string& content, const std::string& extension,
                         bool allow_miss, const MeasureFile& measure, nlohmann::ordered_json& result);

/// Adds `promised{}` and `measured{}` to `result`. A missed promise is an error about `path`; with `allow_miss`, it is
/// a warning and the sentence in `missed`.
Expected<void> reportPromises(const Promises& promises, const std::string& path, bool allow_miss,
                              nlohmann::ordered_json& result);

/// Adds the flag --allow-miss.
void addAllowMiss(Subcommand command, bool& allow_miss);

}  // namespace hapticell::cli
