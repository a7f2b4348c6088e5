// SPDX-License-Identifier: Apache-2.0
// Any bytes as what a Falcon sends, in pieces as long as the first says: what is taken for a packet is one, and neither
// it nor the count of garbage depends on the pieces.
#include "haptic/devices/drivers/falcon/falcon_packets.h"
#include "tests/fuzz/fuzz_check.h"

namespace {

using namespace hapticell;
using driver::FalconPacket;
using driver::FalconReader;

bool same(const FalconPacket& a, const FalconPacket& b) {
  return a.values == b.values && a.bits == b.bits;
}

void checkRoundTrip(const FalconPacket& packet) {
  FalconReader reader;
  const auto again = reader.take(driver::encodeFalcon(packet));
  fuzz::check(again.has_value() && same(*again, packet) && reader.garbled() == 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::span<const std::uint8_t> bytes(data + 1, size - 1);
  FalconReader by_piece, whole;
  std::optional<FalconPacket> newest;
  fuzz::inPieces(bytes, 1 + data[0], [&](auto piece) {
    if (const auto packet = by_piece.take(piece)) {
      newest = packet;
      checkRoundTrip(*packet);
    }
  });
  const auto newest_whole = whole.take(bytes);
  fuzz::check(newest.has_value() == newest_whole.has_value() && by_piece.garbled() == whole.garbled());
  if (newest) fuzz::check(same(*newest, *newest_whole));
  return 0;
}
