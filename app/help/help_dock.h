// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace hapticell::app {

class Host;

/// The help page of a dock ("dockMove") in a language ("en"), as Markdown; the page about the scene where it has none
/// of its own, the English one where it is not translated.
QString helpPage(const QString& dock, const QString& language);
/// The dock that holds what has the focus, or in which a tab is in front; empty: the scene.
QString dockInFocus(Host& host);

/// F1 (actionHelp), the scene in words and the pages' dock, made when it is first opened.
void addHelp(Host& host);

}  // namespace hapticell::app
