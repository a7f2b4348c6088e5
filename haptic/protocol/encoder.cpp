// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "geometry/system/assertion.h"
#include "haptic/protocol/codec.h"
#include "haptic/protocol/wire_fields.h"

namespace hapticell::haptic {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

namespace {

template <typename T>
Offset<wireType<T>> write(FlatBufferBuilder& builder, const T& message);

/// No message has more texts, lists and tables in it.
constexpr std::size_t kMostParts = 2;

/// Writes what a table refers to, which FlatBuffers wants finished before the table begins.
struct PartWriter {
  FlatBufferBuilder& builder;
  std::array<flatbuffers::uoffset_t, kMostParts> parts{};
  std::size_t count = 0;

  void operator()(const auto&, const auto&) {}
  void required(const auto&, const auto&) {}
  void trim(const auto&, const auto&) {}
  void known(const auto&, const auto&, const auto&) {}
  void text(std::string_view text, const auto&) { add(cut(text)); }
  void texts(const std::vector<std::string>& texts, const auto&) {
    std::array<Offset<flatbuffers::String>, kMaxCalibrationSteps> offsets;
    const std::size_t sent = std::min(texts.size(), offsets.size());
    std::transform(texts.begin(), texts.begin() + static_cast<std::ptrdiff_t>(sent), offsets.begin(),
                   [this](const std::string& text) { return cut(text); });
    add(builder.CreateVector(offsets.data(), sent));
  }
  void table(const auto& message, const auto&) { add(write(builder, message)); }
  void tables(const auto& messages, std::size_t used, const auto&) {
    HAPTICELL_DEMAND(used <= kMaxConstraints);
    std::array<Offset<wire::Constraint>, kMaxConstraints> offsets;
    std::transform(messages.begin(), messages.begin() + used, offsets.begin(),
                   [this](const auto& message) { return write(builder, message); });
    add(builder.CreateVector(offsets.data(), used));
  }

 private:
  Offset<flatbuffers::String> cut(std::string_view text) { return builder.CreateString(text.substr(0, kMaxTextBytes)); }
  void add(auto offset) {
    HAPTICELL_DEMAND(count < kMostParts);
    parts[count++] = offset.o;
  }
};

/// Writes the fields of a table; `parts` come from a PartWriter of the same message.
template <typename Builder>
struct FieldWriter {
  Builder& builder;
  std::span<const flatbuffers::uoffset_t> parts;

  template <typename T>
  void operator()(const T& value, const auto& field) {
    if constexpr (std::is_arithmetic_v<T>) {
      (builder.*field.add)(value);
    } else if constexpr (std::is_enum_v<T>) {
      (builder.*field.add)(toWire(value));
    } else if (value != T{}) {
      required(value, field);
    }
  }
  void required(const auto& value, const auto& field) {
    const auto on_wire = toWire(value);
    (builder.*field.add)(&on_wire);
  }
  void trim(const Constraint& constraint, const auto& field) {
    const wire::Trim trim(constraint.trim_gap, toWire(constraint.trim_gradient));
    if (constraint.has_trim) (builder.*field.add)(&trim);
  }
  void known(const auto& value, const auto& is_known, const auto& number) {
    (builder.*is_known.add)(value.has_value());
    (builder.*number.add)(value.value_or(0.0));
  }
  void text(const auto&, const auto& field) { part(field.add); }
  void texts(const auto&, const auto& field) { part(field.add); }
  void table(const auto&, const auto& field) { part(field.add); }
  void tables(const auto&, std::size_t, const auto& field) { part(field.add); }

 private:
  template <typename Part>
  void part(void (Builder::*add)(Offset<Part>)) {
    (builder.*add)(Offset<Part>(parts.front()));
    parts = parts.subspan(1);
  }
};

template <typename T>
Offset<wireType<T>> write(FlatBufferBuilder& builder, const T& message) {
  PartWriter parts{builder};
  wireFields(parts, message);
  typename wireType<T>::Builder table(builder);
  FieldWriter<typename wireType<T>::Builder> fields{table, std::span(parts.parts).first(parts.count)};
  wireFields(fields, message);
  return table.Finish();
}

}  // namespace

struct Encoder::Implementation {
  FlatBufferBuilder builder{1024};
  std::vector<std::uint8_t> frame;

  template <typename T>
  std::span<const std::uint8_t> encode(const T& value) {
    builder.Clear();
    const auto body = write(builder, value);
    const auto envelope = wire::CreateEnvelope(builder, wire::BodyTraits<wireType<T>>::enum_value, body.Union());
    // Not FinishSizePrefixed(): that aligns numbers to the prefix, so the FlatBuffer alone would not be a valid one.
    builder.Finish(envelope, wire::EnvelopeIdentifier());
    const std::uint32_t length = builder.GetSize();
    frame.resize(kFrameHeaderBytes + length);
    for (std::size_t i = 0; i < kFrameHeaderBytes; ++i) frame[i] = static_cast<std::uint8_t>(length >> (8 * i));
    std::copy_n(builder.GetBufferPointer(), length, frame.data() + kFrameHeaderBytes);
    return frame;
  }
};

Encoder::Encoder() : implementation_(std::make_unique<Implementation>()) {}
Encoder::~Encoder() = default;
Encoder::Encoder(Encoder&&) noexcept = default;
Encoder& Encoder::operator=(Encoder&&) noexcept = default;

std::span<const std::uint8_t> Encoder::encode(const ConstraintSet& set) {
  return implementation_->encode(set);
}

std::span<const std::uint8_t> Encoder::encode(const HapticState& state) {
  return implementation_->encode(state);
}

std::span<const std::uint8_t> Encoder::encode(const Message& message) {
  return std::visit(
      [this](const auto& value) -> std::span<const std::uint8_t> {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>) {
          HAPTICELL_DEMAND(!"a message without content cannot be sent");
          return {};
        } else {
          return implementation_->encode(value);
        }
      },
      message);
}

}  // namespace hapticell::haptic
