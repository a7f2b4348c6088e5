// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// The docks of the ergonomics: scores, task data, report and scores over time, with their entries in the Mannequin
/// menu. To be called after addMannequinDocks().
void addErgonomicsDocks(Host& host);

}  // namespace hapticell::app
