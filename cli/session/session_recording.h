// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "exchange/recordings/recording.h"
#include "manipulation/session/session.h"

namespace hapticell::cli {

/// One tick of a session, for a recording.
exchange::StylusSample stylusSampleOf(const manipulation::TraceRow& row);

/// Adds what a session leaves at its end: motions, contacts, and its result as the file session.json. The samples of
/// the stylus are there already, with the moved frame.
void addSession(exchange::Recording& recording, const manipulation::SessionReport& report,
                const manipulation::SessionOptions& options, const nlohmann::ordered_json& result);

}  // namespace hapticell::cli
