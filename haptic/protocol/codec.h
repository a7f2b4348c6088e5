// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/system/error.h"
#include "haptic/protocol/messages.h"

namespace hapticell::haptic {

/// Bytes of the length that precedes each FlatBuffer.
inline constexpr std::size_t kFrameHeaderBytes = 4;

/// Largest FlatBuffer that is accepted, bytes; a full constraint set takes about 24 kB. Half: a larger set of a later
/// version is refused; twice: a hostile client makes the server hold twice as much.
inline constexpr std::size_t kMaxFrameBytes = 64 * 1024;

/// Longest text that is sent or accepted, bytes (names, sentences); a longer one is cut before it is sent. Half:
/// sentences with long paths are cut; twice: more to hold of a hostile peer.
inline constexpr std::size_t kMaxTextBytes = 1024;

/// Most steps of a calibration that are sent or accepted.
inline constexpr std::size_t kMaxCalibrationSteps = 16;

/// Turns messages into frames (length and FlatBuffer in one piece, so that it leaves in one send).
///
/// One object per thread; it keeps its memory, so encoding the same kind of message again does not allocate.
class Encoder {
 public:
  Encoder();
  ~Encoder();
  Encoder(Encoder&&) noexcept;
  Encoder& operator=(Encoder&&) noexcept;

  /// The frame of `message`; the bytes stay valid until the next call. A Message without content is a broken contract.
  std::span<const std::uint8_t> encode(const Message& message);
  std::span<const std::uint8_t> encode(const ConstraintSet& set);
  std::span<const std::uint8_t> encode(const HapticState& state);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Reads one FlatBuffer (without its length). Never throws and never reads outside `flatbuffer`.
///
/// The buffer is verified first (FlatBuffers' Verifier, with limits on depth and number of tables), then every number:
/// the returned values are finite, poses are valid and a set has at most kMaxConstraints entries. Anything else is an
/// Error that states what was found and what was expected.
Expected<void> decode(std::span<const std::uint8_t> flatbuffer, Message& message);

/// Cuts a stream of bytes, arriving in pieces of any size, into frames.
class FrameReader {
 public:
  /// Takes a piece of the stream.
  void append(std::span<const std::uint8_t> bytes);

  /// The next complete FlatBuffer; an empty span if it is not complete yet. Valid until the next call of either
  /// function. A length of zero or above kMaxFrameBytes is an Error for this and all later calls, because the stream
  /// can no longer be trusted.
  Expected<std::span<const std::uint8_t>> next();

  /// Bytes that wait for the rest of their frame.
  std::size_t pending() const { return buffer_.size() - begin_; }

 private:
  std::vector<std::uint8_t> buffer_;
  std::size_t begin_ = 0;
};

}  // namespace hapticell::haptic
