// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace hapticell::importer {

/// Bounds what this process may use: address space (bytes) and computing time (seconds), no core file; and lets it die
/// with its parent. What the system does not grant is left as it is.
void limitResources(std::uint64_t bytes, std::uint64_t seconds);

}  // namespace hapticell::importer
