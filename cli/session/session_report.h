// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "manipulation/session/session.h"

namespace hapticell::cli {

/// The result of the command `session` (docs/user/command-line.md). `options` are those of the session.
nlohmann::ordered_json sessionJson(const manipulation::SessionReport& report,
                                   const manipulation::SessionOptions& options);

}  // namespace hapticell::cli
