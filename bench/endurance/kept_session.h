// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "manipulation/session/session.h"
#include "workcell/document/document.h"

namespace hapticell::endurance {

/// Writes what is needed to run a session again by itself into `folder` (made where it is not there): `cell.hcell` with
/// the document as it is before the session, `hand.csv`, and `session.txt` with the words of `hapticell-cli` that run
/// it from there. What was there of an earlier one is replaced. Errors name the file that could not be written.
Expected<void> keepSession(const workcell::Document& document, const manipulation::SessionOptions& options,
                           const std::filesystem::path& folder);

}  // namespace hapticell::endurance
