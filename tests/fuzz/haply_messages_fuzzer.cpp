// SPDX-License-Identifier: Apache-2.0
// Any bytes as a message of Haply's service: refused, or finite numbers and a turn; a force can be commanded to
// whatever name the device has.
#include <cmath>

#include "haptic/devices/drivers/haply/haply_messages.h"
#include "tests/fuzz/fuzz_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticell;
  const auto reports = driver::readHaplyMessage(std::string(reinterpret_cast<const char*>(data), size));
  if (!reports) return 0;
  for (const auto& report : *reports) {
    for (int i = 0; i < 3; ++i) fuzz::check(std::isfinite(report.cursor[i]));
    if (report.orientation) fuzz::check(std::abs(glm::length(*report.orientation) - 1.0) < 1e-9);
    fuzz::check(!driver::haplyForceCommand(report.device_id, {0.0, 0.0, 1.0}).empty());
  }
  return 0;
}
