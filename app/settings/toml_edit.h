// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace hapticell::app {

/// The text of a TOML file with the key "section.name" (or "a.b.name": section [a.b]) set to `value`, which is written
/// as given. Comments, order and all other lines are kept; a missing key or section is added.
std::string withTomlValue(std::string_view text, std::string_view key, std::string_view value);

}  // namespace hapticell::app
