// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <functional>

namespace hapticell::app {

class Host;

/// Opens a dialog in the window's theme to choose any colour for a part, starting at `now`; `take` gets the choice. If
/// the scene shows that colour quieter, a message says so and how to change it. GUI thread; returns at once.
void choosePartColor(Host& host, const QColor& now, std::function<void(const QColor&)> take);

}  // namespace hapticell::app
