// SPDX-License-Identifier: Apache-2.0
// Any bytes as reports of a 3-D mouse, each behind a byte with its length: the motion stays within full deflection, and
// what is garbled or not known changes nothing.
#include <cmath>

#include "haptic/devices/drivers/spacemouse/space_mouse_reports.h"
#include "tests/fuzz/fuzz_check.h"
#include "tests/support/same_bits.h"

namespace {

using namespace hapticell;

void takeReport(std::span<const std::uint8_t> report, driver::SpaceMouseState& state) {
  const driver::SpaceMouseState before = state;
  const driver::Status status = driver::takeSpaceMouseReport(report, state);
  for (const double axis : state.motion) fuzz::check(std::isfinite(axis) && std::abs(axis) <= 1.0);
  if (status == driver::Status::kOk) return;
  fuzz::check(!state.moved && state.buttons == before.buttons);
  fuzz::check(test::sameBits(state.motion, before.motion));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  driver::SpaceMouseState state;
  std::span<const std::uint8_t> rest(data, size);
  while (!rest.empty()) {
    const std::size_t length = std::min<std::size_t>(rest[0], rest.size() - 1);
    takeReport(rest.subspan(1, length), state);
    rest = rest.subspan(1 + length);
  }
  return 0;
}
