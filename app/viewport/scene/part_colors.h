// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace hapticell::app {

/// Whether parts are drawn in their own colours; else in quiet ones, so that the colours of states are loud. Belongs to
/// the application as the units do; may be asked by any thread.
bool fullColorsNow();
void setFullColorsNow(bool full);

/// What a part of this colour is drawn with.
std::array<float, 3> partColor(const std::array<float, 3>& own);

}  // namespace hapticell::app
