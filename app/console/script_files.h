// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <string>

#include "geometry/system/error.h"

namespace hapticell::app {

/// The folder of the user's scripts: scripts in the user's data folder ($XDG_DATA_HOME/hapticell). It may not exist.
QString scriptFolder();

/// Names of the scripts there, sorted.
QStringList scriptNames();

/// Writes a script there under the first free name of NAME and NAME-2, NAME-3 ... with the ending of
/// Python; returns its path. Error: it cannot be written.
Expected<QString> writeScript(const QString& name, const std::string& text);

}  // namespace hapticell::app
