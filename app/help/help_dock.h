// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace hapticell::app {

class Host;

/// The dock that holds what has the focus; where the window itself has it, the dock that is in front at the right.
/// Empty: the scene.
QString dockInFocus(Host& host);

/// F1 (actionHelp) opens the manual at the panel in focus, actionManual at its beginning, actionSceneText at the scene
/// in words; the manual's dock is made when it is first opened.
void addHelp(Host& host);

}  // namespace hapticell::app
