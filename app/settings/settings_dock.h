// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace hapticell::app {

class Host;

/// Makes the window follow its settings from now on, and adds the dock that changes them (made when it is first
/// opened). `set_theme` gives the window the dark or the light theme.
void addSettings(Host& host, const std::function<void(bool dark)>& set_theme);

}  // namespace hapticell::app
