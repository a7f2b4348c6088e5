// SPDX-License-Identifier: Apache-2.0
#include "workcell/recordings.h"

#include "trajectory/trajectory_io.h"
#include "workcell/file_content.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

bool standsBelow(const fs::path& file, const fs::path& folder) {
  const fs::path relative = file.lexically_normal().lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

fs::path freeNameIn(const fs::path& folder, const fs::path& name) {
  std::error_code ignored;
  fs::path place = folder / name;
  for (int number = 2; fs::exists(place, ignored); ++number)
    place = folder / (name.stem().string() + "-" + std::to_string(number) + name.extension().string());
  return place;
}

}  // namespace

fs::path recordingsFolder(const fs::path& document) {
  return document.parent_path() / (document.stem().string() + "-trajectories");
}

Expected<MovedRecordings> gatherRecordings(const DocumentState& state, const fs::path& document) {
  MovedRecordings moved;
  const fs::path folder = recordingsFolder(document);
  for (const TrajectoryReference& reference : state.trajectories) {
    if (standsBelow(reference.path, document.parent_path()) || moved.contains(reference.path)) continue;
    // Its file may not be written yet.
    auto content = reference.motion ? Expected<std::string>(trajectory::toJsonText(*reference.motion))
                                    : readFileContent(reference.path);
    if (!content) continue;
    std::error_code fault;
    fs::create_directories(folder, fault);
    const fs::path place = freeNameIn(folder, fs::path(reference.path).filename());
    if (auto written = writeFileAtomically(place, *content); !written) return makeError(written.error());
    moved[reference.path] = place.string();
  }
  return moved;
}

}  // namespace hapticell::workcell
