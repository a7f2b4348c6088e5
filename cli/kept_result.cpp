// SPDX-License-Identifier: Apache-2.0
#include "cli/kept_result.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "cli/result_writer.h"

namespace hapticell::cli {

namespace fs = std::filesystem;

Expected<void> tellPromises(const Promises& promises, const std::string& path, bool allow_miss,
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
  missed.fix.clear();
  result["missed"] = missed.message();
  warn(missed.message());
  return {};
}

Expected<void> writeKept(const std::string& path, const std::string& content, const std::string& extension,
                         bool allow_miss, const MeasureFile& measure, nlohmann::ordered_json& result) {
  const auto check = [&](const fs::path& file) -> Expected<void> {
    const auto promises = measure(file);
    return promises ? tellPromises(*promises, path, allow_miss, result) : tl::unexpected(promises.error());
  };
  if (!path.empty()) return workcell::writeFileChecked(path, content, check);
  std::error_code ignored;
  std::string folder = (fs::temp_directory_path(ignored) / "hapticell-trial-XXXXXX").string();
  if (!::mkdtemp(folder.data()))
    return makeError({folder, "", std::strerror(errno), "a folder for temporary files that may be written", ""});
  auto written = workcell::writeFileChecked(fs::path(folder) / ("trial" + extension), content, check);
  fs::remove_all(folder, ignored);
  return written;
}

void addAllowMiss(Subcommand command, bool& allow_miss) {
  command.flag("--allow-miss", allow_miss, "Write the result also where it misses what was asked, and say so in it");
}

}  // namespace hapticell::cli
