// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>

#include "geometry/system/text.h"

namespace hapticell::config {

/// "line 12": the place of the node in its file, for errors.
inline Text lineOf(const toml::node& node) {
  return Text("line %1", node.source().begin.line);
}

}  // namespace hapticell::config
