// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace hapticell::trajectory {

/// The shortest decimal text that reads back as `value`, with `.` in any locale.
std::string shortestText(double value);
/// With `decimals` digits after the point; trailing zeros are kept, "-0.000" never occurs.
std::string fixedText(double value, int decimals);

}  // namespace hapticell::trajectory
