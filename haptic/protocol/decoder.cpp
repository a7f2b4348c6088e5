// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "geometry/system/plain_text.h"
#include "haptic/protocol/codec.h"
#include "haptic/protocol/wire_fields.h"

namespace hapticell::haptic {

namespace {

/// A frame nests Envelope, body, constraint: more is another format. Tables: a full set has 64 and some. Half of the
/// first: too few for a later version; twice: hostile frames cost more to check.
constexpr flatbuffers::uoffset_t kMaxDepth = 8;
constexpr flatbuffers::uoffset_t kMaxTables = 256;

tl::unexpected<Error> refuse(Text place, Text found, Text expected) {
  return makeError({.file = "haptic message",
                    .place = std::move(place),
                    .found = std::move(found),
                    .expected = std::move(expected),
                    .fix = ""});
}

template <typename T>
Expected<void> read(const wireType<T>& from, T& to);

/// Reads the fields of a table up to the first fault.
template <typename Table>
class FieldReader {
 public:
  explicit FieldReader(const Table& from) : from_(from) {}
  const std::optional<Error>& fault() const { return fault_; }

  template <typename T>
  void operator()(T& to, const auto& field) {
    if (fault_) return;
    const auto got = (from_.*field.get)();
    if constexpr (std::is_pointer_v<decltype(got)>) {
      to = got != nullptr ? fromWire(*got) : T{};
    } else if constexpr (std::is_enum_v<T>) {
      const std::optional<T> known = fromWire(got);
      if (known) to = *known;
      if (!known) fail(field.name, Text("the unknown number %1", static_cast<int>(got)), Text("one of hapticell.fbs"));
    } else {
      to = got;
    }
  }
  void required(auto& to, const auto& field) {
    if (fault_) return;
    const auto* got = (from_.*field.get)();
    if (got == nullptr) return fail(field.name, Text("the field is missing"), Text("a value"));
    to = fromWire(*got);
  }
  void trim(Constraint& to, const auto& field) {
    const wire::Trim* got = (from_.*field.get)();
    to.has_trim = got != nullptr;
    to.trim_gap = got != nullptr ? got->gap() : 0.0;
    to.trim_gradient = got != nullptr ? fromWire(got->gradient()) : Vector6{};
  }
  void known(auto& to, const auto& is_known, const auto& number) {
    to.reset();
    if ((from_.*is_known.get)()) to = (from_.*number.get)();
  }
  void text(std::string& to, const auto& field) { take((from_.*field.get)(), to, field.name); }
  void texts(std::vector<std::string>& to, const auto& field) {
    const auto* got = (from_.*field.get)();
    const std::size_t count = got != nullptr ? got->size() : 0;
    to.clear();
    if (count > kMaxCalibrationSteps)
      return fail(field.name, Text("%1 steps", count), Text("at most %1", kMaxCalibrationSteps));
    to.resize(count);
    for (std::size_t i = 0; i < count; ++i) take(got->Get(static_cast<flatbuffers::uoffset_t>(i)), to[i], field.name);
  }
  void table(auto& to, const auto& field) {
    if (fault_) return;
    const auto* got = (from_.*field.get)();
    if (got == nullptr) return fail(field.name, Text("the field is missing"), Text("a value"));
    if (const auto read_part = read(*got, to); !read_part) fault_ = read_part.error();
  }
  void tables(auto& to, std::size_t& count, const auto& field) {
    if (fault_) return;
    const auto* got = (from_.*field.get)();
    count = got != nullptr ? got->size() : 0;
    if (count > to.size()) return fail(field.name, Text("%1 entries", count), Text("at most %1", to.size()));
    for (std::size_t i = 0; i < count && !fault_; ++i) {
      const auto read_part = read(*got->Get(static_cast<flatbuffers::uoffset_t>(i)), to[i]);
      if (!read_part) fault_ = read_part.error();
    }
  }

 private:
  void fail(const char* place, Text found, Text expected) {
    fault_ = refuse(std::string(place), std::move(found), std::move(expected)).value();
  }
  /// What others wrote, as it may be logged and drawn.
  void take(const flatbuffers::String* from, std::string& to, const char* place) {
    if (fault_) return;
    to.clear();
    if (from == nullptr) return;
    if (from->size() > kMaxTextBytes)
      return fail(place, Text("%1 bytes", from->size()), Text("at most %1", kMaxTextBytes));
    to = plainText({from->c_str(), from->size()}, kMaxTextBytes);
  }

  const Table& from_;
  std::optional<Error> fault_;
};

// What a message must satisfy besides; most of it is isWellFormed().
template <typename T>
Expected<void> checkedNumbers(const T&) {
  return {};
}
Expected<void> checkedNumbers(const DeviceDescription& device) {
  if (isWellFormed(device)) return {};
  return refuse("Device", Text("a value is out of range"), Text("finite numbers, and a minimum below the maximum"));
}
Expected<void> checkedNumbers(const Welcome& welcome) {
  if (welcome.tick_rate_hz > 0.0 && welcome.tick_rate_hz <= 1e5) return {};
  return refuse("Welcome.tick_rate_hz", std::to_string(welcome.tick_rate_hz), Text("above 0, at most 100000"));
}
Expected<void> checkedNumbers(const ConstraintSet& set) {
  if (isWellFormed(set)) return {};
  return refuse("ConstraintSet", Text("a number that is not finite or out of its range"),
                Text("finite numbers within the bounds of docs/library/protocol.md, a unit quaternion, a zone above "
                     "0, and no negative stiffness, damping or friction"));
}
Expected<void> checkedNumbers(const HapticState& state) {
  if (isWellFormed(state)) return {};
  return refuse("State", Text("a number that is not finite or out of its range"), Text("valid poses, finite numbers"));
}
Expected<void> checkedNumbers(const ServerStatistics& statistics) {
  if (isWellFormed(statistics)) return {};
  return refuse("Statistics", Text("a number that is negative or not finite"), Text("finite numbers, 0 or more"));
}
Expected<void> checkedNumbers(const HapticControl& control) {
  if (isWellFormed(control)) return {};
  return refuse("Control", Text("a stiffness, damping or load that is negative, not finite or too large"),
                Text("0 or more, within the bounds of docs/library/protocol.md"));
}
Expected<void> checkedNumbers(const HandTarget& target) {
  if (isWellFormed(target)) return {};
  return refuse("HandTarget", Text("an invalid pose"),
                Text("finite numbers, at most 1 000 000 m, and a unit quaternion"));
}

template <typename T>
Expected<void> read(const wireType<T>& from, T& to) {
  FieldReader fields(from);
  wireFields(fields, to);
  if (fields.fault()) return tl::unexpected(*fields.fault());
  return checkedNumbers(to);
}

/// Reads into the alternative that `message` holds already, if it is the right one: a set is large.
template <typename T>
Expected<void> readInto(const wire::Envelope& envelope, Message& message) {
  if (!std::holds_alternative<T>(message)) message.emplace<T>();
  return read(*envelope.body_as<wireType<T>>(), std::get<T>(message));
}

Expected<void> readBody(const wire::Envelope& envelope, Message& message) {
  if (envelope.body() == nullptr) return refuse({}, Text("an empty message"), Text("a message with content"));
  switch (envelope.body_type()) {
    case wire::Body_Hello:
      return readInto<Hello>(envelope, message);
    case wire::Body_Welcome:
      return readInto<Welcome>(envelope, message);
    case wire::Body_Refusal:
      return readInto<Refusal>(envelope, message);
    case wire::Body_ConstraintSet:
      return readInto<ConstraintSet>(envelope, message);
    case wire::Body_State:
      return readInto<HapticState>(envelope, message);
    case wire::Body_Statistics:
      return readInto<ServerStatistics>(envelope, message);
    case wire::Body_Control:
      return readInto<HapticControl>(envelope, message);
    case wire::Body_HandTarget:
      return readInto<HandTarget>(envelope, message);
    case wire::Body_Heartbeat:
      return readInto<Heartbeat>(envelope, message);
    case wire::Body_DeviceCondition:
      return readInto<DeviceCondition>(envelope, message);
    case wire::Body_Calibrate:
      return readInto<Calibrate>(envelope, message);
    case wire::Body_NONE:
      break;
  }
  return refuse({}, Text("message type %1", static_cast<int>(envelope.body_type())),
                Text("1 to %1", static_cast<int>(wire::Body_MAX)));
}

Expected<void> decodeAligned(const std::uint8_t* bytes, std::size_t size, Message& message) {
  flatbuffers::Verifier verifier(bytes, size, kMaxDepth, kMaxTables);
  if (size < 12 || !wire::EnvelopeBufferHasIdentifier(bytes)) {
    return refuse({}, Text("%1 bytes without the identifier", size), Text("a FlatBuffer with the identifier HCEL"));
  }
  if (!wire::VerifyEnvelopeBuffer(verifier)) {
    return refuse({}, Text("a damaged FlatBuffer"), Text("a valid Envelope"));
  }
  return readBody(*wire::GetEnvelope(bytes), message);
}

}  // namespace

Expected<void> decode(std::span<const std::uint8_t> flatbuffer, Message& message) {
  if (flatbuffer.size() > kMaxFrameBytes) {
    return refuse({}, Text("%1 bytes", flatbuffer.size()), Text("at most %1", kMaxFrameBytes));
  }
  // FlatBuffers reads eight-byte numbers in place: the buffer must start where one may.
  if (reinterpret_cast<std::uintptr_t>(flatbuffer.data()) % alignof(std::uint64_t) == 0) {
    return decodeAligned(flatbuffer.data(), flatbuffer.size(), message);
  }
  thread_local std::vector<std::uint64_t> aligned;
  aligned.resize(flatbuffer.size() / sizeof(std::uint64_t) + 1);
  std::memcpy(aligned.data(), flatbuffer.data(), flatbuffer.size());
  return decodeAligned(reinterpret_cast<const std::uint8_t*>(aligned.data()), flatbuffer.size(), message);
}

void FrameReader::append(std::span<const std::uint8_t> bytes) {
  if (begin_ > 0) {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
    begin_ = 0;
  }
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

Expected<std::span<const std::uint8_t>> FrameReader::next() {
  const std::span<const std::uint8_t> rest = std::span<const std::uint8_t>(buffer_).subspan(begin_);
  if (rest.size() < kFrameHeaderBytes) return std::span<const std::uint8_t>();
  std::uint32_t length = 0;
  for (std::size_t i = kFrameHeaderBytes; i-- > 0;) length = (length << 8) | rest[i];
  if (length == 0 || length > kMaxFrameBytes) {
    return refuse(Text("frame length"), Text("%1 bytes", length), Text("1 to %1", kMaxFrameBytes));
  }
  if (rest.size() < kFrameHeaderBytes + length) return std::span<const std::uint8_t>();
  begin_ += kFrameHeaderBytes + length;
  return rest.subspan(kFrameHeaderBytes, length);
}

}  // namespace hapticell::haptic
