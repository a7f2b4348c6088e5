// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace hapticell {

/// Text as it may stand between the tags of XML and HTML, and in their attributes: &, <, > and " as entities.
std::string escapedMarkup(std::string_view text);

}  // namespace hapticell
