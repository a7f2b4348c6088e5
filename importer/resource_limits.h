// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace hapticell::importer {

/// Limits the resources of this process: address space (bytes) and processor time (seconds), no core file; and makes it
/// end with its parent. Limits that the system does not grant are not changed.
void limitResources(std::uint64_t bytes, std::uint64_t seconds);

}  // namespace hapticell::importer
