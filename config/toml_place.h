// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>
#include <string>

namespace hapticell::config {

/// "line 12": where the node stands in its file, as errors name it.
inline std::string lineOf(const toml::node& node) {
  return "line " + std::to_string(node.source().begin.line);
}

}  // namespace hapticell::config
