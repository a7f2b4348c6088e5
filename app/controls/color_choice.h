// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <functional>

namespace hapticell::app {

class Host;

/// Asks for any colour of a part, beginning at `now`, in a dialog of the window's theme; `take` gets what was chosen.
/// Where the scene shows it quieter than it is, a message says so and how to change that. GUI thread; returns at once.
void choosePartColor(Host& host, const QColor& now, std::function<void(const QColor&)> take);

}  // namespace hapticell::app
