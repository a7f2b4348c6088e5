// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "trajectory/program_export.h"
#include "trajectory/program_readers.h"

namespace hapticell::trajectory {

namespace {

const std::string* contentWith(const std::vector<ProgramFile>& files, std::string_view ending) {
  const auto found =
      std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.name.ends_with(ending); });
  return found == files.end() ? nullptr : &found->content;
}

Expected<ReadProgram> readFiles(const std::vector<ProgramFile>& files, ProgramFormat format, const std::string& base) {
  const ProgramReadOptions options;
  if (format == ProgramFormat::kRapid) return readRapid(files.front().content, options);
  if (format == ProgramFormat::kInform) return readInform(files.front().content, options);
  if (format == ProgramFormat::kVal3) {
    const std::string *data = contentWith(files, ".dtx"), *code = contentWith(files, "start.pgx");
    return readVal3(data ? *data : "", code ? *code : "");
  }
  if (format == ProgramFormat::kFanuc) return readFanuc(files.front().content, options);
  if (format == ProgramFormat::kUrScript) {
    // The targets are in the base, so it may be anything.
    const std::string known = base.empty() ? "" : base + " = p[0,0,0,0,0,0]\n";
    return readUrScript(known + files.front().content, options);
  }
  ProgramText text;
  if (const std::string* source = contentWith(files, ".src")) text.source = *source;
  if (const std::string* data = contentWith(files, ".dat")) text.data = *data;
  return readKrl(text, options);
}

}  // namespace

Expected<std::optional<PoseDistance>> measureProgram(const std::vector<ProgramFile>& files, ProgramFormat format,
                                                     const ProgramOptions& options, const Trajectory& trajectory) {
  const char* numbers = format == ProgramFormat::kKrl ? "{" : format == ProgramFormat::kUrScript ? "[(" : "";
  const bool is_named = options.base.find_first_of(numbers) == std::string::npos;
  if (!is_named) return std::nullopt;
  const auto read = readFiles(files, format, options.base);
  if (!read) return tl::unexpected(read.error());
  if (read->trajectory.size() != trajectory.size()) {
    return makeError({"", "read back", std::to_string(read->trajectory.size()) + " targets",
                      std::to_string(trajectory.size()), "Nothing was written."});
  }
  PoseDistance largest;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const PoseDistance off = distanceBetween(read->trajectory[i].X_WT, trajectory[i].X_WT);
    largest.position = std::max(largest.position, off.position);
    largest.angle = std::max(largest.angle, off.angle);
  }
  return std::optional<PoseDistance>(largest);
}

}  // namespace hapticell::trajectory
