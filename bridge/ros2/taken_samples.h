// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dds/dds.h>

#include <cstdint>

namespace hapticell::bridge {

/// Calls `take` with every message that a reader of `Message` has, oldest first; they are lent by DDS for the call. A
/// reader is always asked for as many at once: Cyclone DDS 0.10 may write as many addresses as it ever lent before.
template <typename Message, typename Take>
void takeAll(dds_entity_t reader, const Take& take) {
  constexpr std::uint32_t kAtOnce = 64;
  for (;;) {
    void* samples[kAtOnce] = {nullptr};
    dds_sample_info_t infos[kAtOnce];
    const dds_return_t count = dds_take(reader, samples, infos, kAtOnce, kAtOnce);
    if (count <= 0) return;
    for (dds_return_t i = 0; i < count; ++i)
      if (infos[i].valid_data) take(*static_cast<const Message*>(samples[i]));
    dds_return_loan(reader, samples, count);
  }
}

}  // namespace hapticell::bridge
