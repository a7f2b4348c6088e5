// SPDX-License-Identifier: Apache-2.0
// Any bytes as a Phantom Omni's packet: refused, or a reading in its range.
#include "haptic/devices/drivers/omni_firewire/omni_packets.h"
#include "tests/fuzz/fuzz_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticell;
  if (const auto reading = driver::readOmniPacket({data, size})) {
    for (const int count : reading->encoders) fuzz::check(count >= -32768 && count <= 32767);
    for (const double ratio : reading->gimbal_ratios) fuzz::check(ratio >= 0.0 && ratio <= 1.0);
  }
  return 0;
}
