// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "geometry/system/error.h"

namespace hapticell::app {

/// The user's own hapticell.toml: $XDG_CONFIG_HOME/hapticell/hapticell.toml.
QString userConfigurationFile();

/// Writes one setting into that file, keeps all other lines, and reads it back: if the value is refused, the file does
/// not change. `text` as it would be typed: slide, 0.5, true.
Expected<void> writeSetting(const QString& file, const QString& key, const QString& text);

}  // namespace hapticell::app
