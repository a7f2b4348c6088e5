// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace hapticell::ergonomics {

/// The French of the words of scores and reports; unknown words are returned unchanged.
std::string_view french(std::string_view english);

}  // namespace hapticell::ergonomics
