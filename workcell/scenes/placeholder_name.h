// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace hapticell::workcell {

/// True for the names that programs write where the user gave a product none ("Document", "Unnamed1", "the product
/// name", a dash), and for an empty one. A number alone may be that of a part.
bool saysNothing(std::string_view name);

}  // namespace hapticell::workcell
