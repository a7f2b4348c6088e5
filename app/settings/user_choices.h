// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>

#include "app/style/units.h"
#include "app/viewport/tools/navigation.h"

namespace hapticell::app {

class Host;
class UserSettings;

/// The user's settings as values; missing ones have their defaults.
Units unitsFrom(const UserSettings& settings);
void storeUnits(const Units& units, UserSettings& settings);
Navigation navigationFrom(const UserSettings& settings);
/// "en" or "fr"; without a choice, the desktop's language if it is one of these.
QString languageFrom(const UserSettings& settings);

/// Makes the window follow its settings: units, navigation, theme (by `set_theme`), motion of the view. At once and at
/// every change; the window owns the connection.
void followSettings(Host& host, const std::function<void(bool dark)>& set_theme);

}  // namespace hapticell::app
