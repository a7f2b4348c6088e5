// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace hapticell::app {

class Host;
class KeyMap;

// Pages of the settings dock. Each shows the settings at the time when it is made, and writes every change at once.

QWidget* makeAppearancePage(Host& host);
QWidget* makeUnitsPage(Host& host);
QWidget* makeNavigationPage(Host& host);
QWidget* makeKeysPage(KeyMap& keys);
QWidget* makeConfigurationPage(Host& host);

}  // namespace hapticell::app
