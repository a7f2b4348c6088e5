// SPDX-License-Identifier: Apache-2.0
// A stream of any bytes, in pieces, against the frame reader and the decoder; what is accepted must survive a round
// trip.
#include <algorithm>
#include <cstdlib>

#include "haptic/protocol/codec.h"

using namespace hapticell::haptic;

namespace {

void check(bool condition) {
  if (!condition) std::abort();
}

void roundTrip(const Message& message) {
  Encoder encoder;
  const auto frame = encoder.encode(message);
  Message again;
  check(decode(frame.subspan(kFrameHeaderBytes), again).has_value());
  check(again.index() == message.index());
  if (const auto* set = std::get_if<ConstraintSet>(&message)) check(isWellFormed(*set));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> bytes(data, size);
  Message message;
  if (decode(bytes, message)) roundTrip(message);
  FrameReader reader;
  const std::size_t piece = size > 0 ? 1 + data[0] : 1;
  for (std::size_t begin = 0; begin < size; begin += piece) {
    reader.append(bytes.subspan(begin, std::min(piece, size - begin)));
    for (auto frame = reader.next(); frame && !frame->empty(); frame = reader.next()) {
      if (decode(*frame, message)) roundTrip(message);
    }
  }
  return 0;
}
