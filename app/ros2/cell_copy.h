// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <filesystem>
#include <optional>

#include "geometry/system/error.h"
#include "geometry/system/scratch_folder.h"
#include "workcell/document/document.h"

namespace hapticell::app {

/// Files of the open cell for another process, in a folder that is removed with this object.
class CellCopy {
 public:
  /// The cell as it is now, saved or not. Returns the path; error: it cannot be written.
  Expected<QString> write(const workcell::Document& document);
  /// A kept motion. Returns the path; errors: no such motion, it cannot be written.
  Expected<QString> writeMotion(const workcell::Document& document, const QString& name);

 private:
  Expected<std::filesystem::path> folder();

  std::optional<ScratchFolder> folder_;  ///< Made when it is needed first.
};

/// Names of the robots of a cell.
QStringList robotNames(const workcell::Document& document);

}  // namespace hapticell::app
