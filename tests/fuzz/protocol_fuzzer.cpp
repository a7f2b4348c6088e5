// SPDX-License-Identifier: Apache-2.0
// A stream of any bytes, in pieces, against the frame reader and the decoder; what is accepted must survive a round
// trip.
#include "haptic/protocol/codec.h"
#include "tests/fuzz/fuzz_check.h"

using namespace hapticell::haptic;
using hapticell::fuzz::check;

namespace {

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
  hapticell::fuzz::inPieces(bytes, piece, [&](auto next) {
    reader.append(next);
    for (auto frame = reader.next(); frame && !frame->empty(); frame = reader.next()) {
      if (decode(*frame, message)) roundTrip(message);
    }
  });
  return 0;
}
