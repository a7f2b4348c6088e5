// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/kept_result.h"

#include "cli/kit/result_writer.h"
#include "geometry/system/scratch_folder.h"

namespace hapticell::cli {

namespace fs = std::filesystem;

Expected<void> reportPromises(const Promises& promises, const std::string& path, bool allow_miss,
                              nlohmann::ordered_json& result) {
  result["promised"] = nlohmann::ordered_json::object();
  result["measured"] = nlohmann::ordered_json::object();
  for (const Promise& promise : promises.list) {
    result["promised"][promise.name] = promise.asked;
    result["measured"][promise.name] = promise.measured;
  }
  if (promises.areKept()) return {};
  Error missed = promises.missed(path);
  if (!allow_miss) return makeError(missed);
  missed.fix = {};
  result["missed"] = missed.message();
  warn(missed.message());
  return {};
}

Expected<void> writeKept(const std::string& path, const std::string& content, const std::string& extension,
                         bool allow_miss, const MeasureFile& measure, nlohmann::ordered_json& result) {
  const auto check = [&](const fs::path& file) -> Expected<void> {
    const auto promises = measure(file);
    return promises ? reportPromises(*promises, path, allow_miss, result) : tl::unexpected(promises.error());
  };
  if (!path.empty()) return workcell::writeFileChecked(path, content, check);
  const auto folder = ScratchFolder::make();
  HAPTICELL_TRY(folder);
  return workcell::writeFileChecked(folder->path() / ("trial" + extension), content, check);
}

void addAllowMiss(Subcommand command, bool& allow_miss) {
  command.flag("--allow-miss", allow_miss,
               "Write the result even if it misses the request; the output says so in `missed`");
}

}  // namespace hapticell::cli
