// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// Adds the docks of the ergonomics: scores, task data, report and scores over time, with their entries in the
/// Mannequin menu. Call it after addMannequinDocks().
void addErgonomicsDocks(Host& host);

}  // namespace hapticell::app
