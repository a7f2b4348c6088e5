// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace hapticell::app {

class MainWindow;

/// True for files of the program other than workcells: *.htraj, *.mcap, *.hexercise, *.htrain, *.hstudy, *.hresults.
bool isOwnFile(const QString& path);

/// Opens a file that was double-clicked, dropped or named on the command line: a workcell replaces the present one, an
/// exercise, training results or a study open with their cell, motions of a file or a recording are added to
/// those of the cell, anything else is imported. Problems are reported in the messages.
void openAny(MainWindow& window, const QString& path);

}  // namespace hapticell::app
