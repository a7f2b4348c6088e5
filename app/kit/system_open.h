// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace hapticell::app {

/// Opens a file or folder with the desktop's program for it (xdg-open). Starts it by its absolute path, found by
/// config::systemProgram(), with the absolute path as the only argument and without a shell. Returns false if there is
/// no such program.
bool openWithSystem(const QString& path);

}  // namespace hapticell::app
