// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "trajectory/programs/reading/program_readers.h"
#include "trajectory/programs/writing/program_export.h"

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
    const bool is_name = !base.empty() && base.find_first_of("[(") == std::string::npos;
    const std::string known = is_name ? base + " = p[0,0,0,0,0,0]\n" : "";
    return readUrScript(known + files.front().content, options);
  }
  ProgramText text;
  if (const std::string* source = contentWith(files, ".src")) text.source = *source;
  if (const std::string* data = contentWith(files, ".dat")) text.data = *data;
  return readKrl(text, options);
}

/// A base by numbers is the user's own text: in the program's own base targets are those of the frames.
std::vector<ProgramFile> inOwnBase(std::vector<ProgramFile> files, ProgramFormat format, const std::string& base) {
  const char* numbers = format == ProgramFormat::kUrScript ? "[(" : "";
  if (format == ProgramFormat::kKrl) numbers = "{";
  if (base.find_first_of(numbers) == std::string::npos) return files;
  const std::string own = format == ProgramFormat::kKrl ? "{X 0,Y 0,Z 0,A 0,B 0,C 0}" : "p[0,0,0,0,0,0]";
  for (ProgramFile& file : files) {
    for (std::size_t at = file.content.find(base); at != std::string::npos; at = file.content.find(base, at)) {
      file.content.replace(at, base.size(), own);
      at += own.size();
    }
  }
  return files;
}

}  // namespace

Expected<ProgramMeasure> measureProgram(const std::vector<ProgramFile>& files, ProgramFormat format,
                                        const ProgramOptions& options, const Trajectory& trajectory) {
  const auto read = readFiles(inOwnBase(files, format, options.base), format, options.base);
  HAPTICELL_TRY(read);
  if (read->trajectory.size() != trajectory.size()) {
    return makeError({.place = "check of the written program",
                      .found = Text("%1 targets", read->trajectory.size()),
                      .expected = std::to_string(trajectory.size()),
                      .fix = "Nothing was written."});
  }
  ProgramMeasure most;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const PoseDistance off = distanceBetween(read->trajectory[i].X_WT, trajectory[i].X_WT);
    if (off.position > most.largest.position) {
      most.largest.position = off.position;
      most.frame_of_position = i;
    }
    if (off.angle > most.largest.angle) {
      most.largest.angle = off.angle;
      most.frame_of_angle = i;
    }
  }
  return most;
}

}  // namespace hapticell::trajectory
