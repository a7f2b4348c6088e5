// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace hapticell::app {

/// Whether parts are drawn in their own colours; else in quiet ones, so that the colours of states stand out. Belongs
/// to the application, like the units; any thread may ask.
bool fullColorsNow();
void setFullColorsNow(bool full);

/// The colour with which a part of this colour is drawn.
std::array<float, 3> partColor(const std::array<float, 3>& own);

}  // namespace hapticell::app
