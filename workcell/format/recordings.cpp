// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/recordings.h"

#include <algorithm>
#include <utility>

#include "trajectory/files/trajectory_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

/// In `folder` or below, and not in a hidden folder there: of a document in the home folder, programs' own data are not
/// next to it.
bool standsBelow(const fs::path& file, const fs::path& folder) {
  const fs::path relative = file.lexically_normal().lexically_relative(folder);
  const auto isHidden = [](const fs::path& part) { return part.native().starts_with('.'); };  // ".." too.
  return !relative.empty() && std::none_of(relative.begin(), relative.end(), isHidden);
}

fs::path freeNameIn(const fs::path& folder, const fs::path& name, const std::vector<FileToWrite>& taken) {
  std::error_code ignored;
  fs::path place = folder / name;
  const auto isTaken = [&] {
    return fs::exists(place, ignored) ||
           std::any_of(taken.begin(), taken.end(), [&](const FileToWrite& each) { return each.path == place; });
  };
  for (int number = 2; isTaken(); ++number)
    place = folder / (name.stem().string() + "-" + std::to_string(number) + name.extension().string());
  return place;
}

}  // namespace

fs::path recordingsFolder(const fs::path& document) {
  return document.parent_path() / (document.stem().string() + "-trajectories");
}

GatheredRecordings gatherRecordings(const DocumentState& state, const fs::path& document) {
  GatheredRecordings gathered;
  const fs::path folder = recordingsFolder(document);
  for (const TrajectoryReference& reference : state.trajectories) {
    if (standsBelow(reference.path, document.parent_path()) || gathered.moved.contains(reference.path)) continue;
    // A stranger's document may name any file of this machine as one: what is no recording stays where it is.
    if (!reference.motion && !trajectory::readTrajectory(reference.path)) continue;
    // Its file may not be written yet.
    auto content = reference.motion ? Expected<std::string>(trajectory::toJsonText(*reference.motion))
                                    : readFileContent(reference.path);
    if (!content) continue;
    const fs::path place = freeNameIn(folder, fs::path(reference.path).filename(), gathered.files);
    gathered.files.push_back({place, std::move(*content)});
    gathered.moved[reference.path] = place.string();
  }
  return gathered;
}

}  // namespace hapticell::workcell
