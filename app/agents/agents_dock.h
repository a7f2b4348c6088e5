// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// Adds the dock Agents with its entry in the menu Applications.
void addAgentsDock(Host& host);

}  // namespace hapticell::app
