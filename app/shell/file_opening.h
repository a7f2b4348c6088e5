// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace hapticell::app {

class MainWindow;

/// True for files that are more than a part of a cell: *.htraj, *.hexercise, *.htrain.
bool isOwnFile(const QString& path);

/// Opens what a user double-clicked or named on the command line: a workcell in place of the present one, an exercise
/// or a trainee's results with their cell, a motion among those of the cell; what else can be read is imported.
/// Problems stand in the messages.
void openAny(MainWindow& window, const QString& path);

}  // namespace hapticell::app
