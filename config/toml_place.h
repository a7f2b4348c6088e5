// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>
#include <string>

namespace hapticell::config {

/// "line 12": the place of the node in its file, for errors.
inline std::string lineOf(const toml::node& node) {
  return "line " + std::to_string(node.source().begin.line);
}

}  // namespace hapticell::config
