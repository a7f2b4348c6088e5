// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace hapticell::workcell {

/// Bytes as text, with '=' at the end to a multiple of four letters (RFC 4648, section 4).
std::string base64(const std::string& bytes);

}  // namespace hapticell::workcell
