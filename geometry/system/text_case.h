// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace hapticell {

/// Letters from A to Z small, whatever the locale; all else as it is.
std::string lowerCase(std::string_view text);
std::string upperCase(std::string_view text);

bool sameButForCase(std::string_view a, std::string_view b);

/// ".step" of "Cell.STEP"; empty without an extension.
std::string lowerExtension(const std::filesystem::path& file);

}  // namespace hapticell
