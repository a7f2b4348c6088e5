// SPDX-License-Identifier: Apache-2.0
#include "app/ros2/cell_copy.h"

#include <algorithm>

#include "geometry/system/atomic_file.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/format/document_io.h"

namespace hapticell::app {

namespace {

Expected<QString> written(const std::filesystem::path& path, const std::string& text) {
  HAPTICELL_TRY(writeFilesAtomically({{path, text}}));
  return QString::fromStdString(path.string());
}

}  // namespace

Expected<std::filesystem::path> CellCopy::folder() {
  if (!folder_) {
    auto made = ScratchFolder::make();
    HAPTICELL_TRY(made);
    folder_.emplace(std::move(*made));
  }
  return folder_->path();
}

Expected<QString> CellCopy::write(const workcell::Document& document) {
  const auto place = folder();
  HAPTICELL_TRY(place);
  return written(*place / "cell.hcell", workcell::documentText(document.state(), *place));
}

Expected<QString> CellCopy::writeMotion(const workcell::Document& document, const QString& name) {
  const workcell::TrajectoryReference* const kept = document.state().findTrajectory(name.toStdString());
  if (!kept) return makeError({.place = Text("motion '%1'", name.toStdString()), .found = "it was deleted"});
  if (!kept->motion) return QString::fromStdString(kept->path);
  const auto place = folder();
  HAPTICELL_TRY(place);
  return written(*place / "motion.htraj", trajectory::toJsonText(*kept->motion));
}

QStringList robotNames(const workcell::Document& document) {
  QStringList names;
  for (const auto& entity : document.state().entities)
    if (workcell::isMachine(*entity)) names << QString::fromStdString(entity->name);
  return names;
}

}  // namespace hapticell::app
