// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>

#include "app/style/units.h"
#include "app/viewport/tools/navigation.h"

namespace hapticell::app {

class Host;
class UserSettings;

/// What the settings say, as values; what they do not say is as shipped.
Units unitsFrom(const UserSettings& settings);
void storeUnits(const Units& units, UserSettings& settings);
Navigation navigationFrom(const UserSettings& settings);
/// "en" or "fr"; without a choice what the desktop speaks, where that is one of them.
QString languageFrom(const UserSettings& settings);

/// Lets the window follow its settings: units, navigation, theme (by `set_theme`), motion of the view. At once and at
/// every change; owned by the window.
void followSettings(Host& host, const std::function<void(bool dark)>& set_theme);

}  // namespace hapticell::app
