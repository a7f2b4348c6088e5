// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace hapticell::app {

/// Opens a file or folder with the desktop's own program for it (xdg-open). It is started by its absolute path, found
/// by config::systemProgram(), with the absolute path as its only argument and no shell. False if there is no such
/// program.
bool openWithSystem(const QString& path);

}  // namespace hapticell::app
