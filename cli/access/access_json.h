// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "access/access_answer.h"

namespace hapticell::cli {

/// The answer as the command prints it, without `path`.
nlohmann::ordered_json accessJson(const access::AccessQuestion& question, const access::AccessAnswer& answer);

}  // namespace hapticell::cli
