// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace hapticell::app {

class Host;

/// The dock that has the focus; if the window itself has it, the front dock on the right. Empty: the
/// scene.
QString dockInFocus(Host& host);

/// Adds the actions of the manual: F1 (actionHelp) opens it at the panel in focus, actionManual at its beginning,
/// actionSceneText at the scene in words. The manual's dock is made when it is first opened.
void addHelp(Host& host);

}  // namespace hapticell::app
