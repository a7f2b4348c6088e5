// SPDX-License-Identifier: Apache-2.0
#include "exchange/messages/cdr.h"

#include <bit>

#include "exchange/mcap/byte_order.h"

namespace hapticell::exchange {

namespace {

constexpr std::size_t kCdrHeader = 4;

}  // namespace

CdrWriter::CdrWriter() : bytes_("\x00\x01\x00\x00", kCdrHeader) {}

template <typename Unsigned>
void CdrWriter::put(Unsigned value) {
  while ((bytes_.size() - kCdrHeader) % sizeof(Unsigned) != 0) bytes_ += '\0';
  appendNumber(bytes_, value);
}

void CdrWriter::add(std::uint8_t value) {
  put(value);
}
void CdrWriter::add(std::int32_t value) {
  put(static_cast<std::uint32_t>(value));
}
void CdrWriter::add(std::uint32_t value) {
  put(value);
}
void CdrWriter::add(float value) {
  put(std::bit_cast<std::uint32_t>(value));
}
void CdrWriter::add(double value) {
  put(std::bit_cast<std::uint64_t>(value));
}
void CdrWriter::add(std::string_view value) {
  put(static_cast<std::uint32_t>(value.size() + 1));
  bytes_ += value;
  bytes_ += '\0';
}
void CdrWriter::addCount(std::size_t count) {
  put(static_cast<std::uint32_t>(count));
}
void CdrWriter::add(std::span<const double> values) {
  addCount(values.size());
  for (const double value : values) add(value);
}
void CdrWriter::add(std::span<const float> values) {
  addCount(values.size());
  for (const float value : values) add(value);
}
void CdrWriter::add(std::span<const std::int32_t> values) {
  addCount(values.size());
  for (const std::int32_t value : values) add(value);
}
void CdrWriter::add(std::span<const std::string> values) {
  addCount(values.size());
  for (const std::string& value : values) add(std::string_view(value));
}

CdrReader::CdrReader(std::string_view bytes) {
  is_good_ = bytes.size() >= kCdrHeader && bytes[0] == 0 && (bytes[1] == 0 || bytes[1] == 1);
  if (!is_good_) return;
  is_swapped_ = bytes[1] == 0;
  bytes_ = bytes.substr(kCdrHeader);
}

template <typename Unsigned>
Unsigned CdrReader::get() {
  const std::size_t from = (at_ + sizeof(Unsigned) - 1) / sizeof(Unsigned) * sizeof(Unsigned);
  is_good_ = is_good_ && from <= bytes_.size() && bytes_.size() - from >= sizeof(Unsigned);
  if (!is_good_) return 0;
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    const std::size_t place = is_swapped_ ? sizeof(Unsigned) - 1 - i : i;
    const auto digit = static_cast<Unsigned>(static_cast<unsigned char>(bytes_[from + i]));
    value = static_cast<Unsigned>(value | static_cast<Unsigned>(digit << (8 * place)));
  }
  at_ = from + sizeof(Unsigned);
  return value;
}

std::uint8_t CdrReader::byte() {
  return get<std::uint8_t>();
}
std::int32_t CdrReader::int32() {
  return static_cast<std::int32_t>(get<std::uint32_t>());
}
std::uint32_t CdrReader::uint32() {
  return get<std::uint32_t>();
}
float CdrReader::float32() {
  return std::bit_cast<float>(get<std::uint32_t>());
}
double CdrReader::float64() {
  return std::bit_cast<double>(get<std::uint64_t>());
}

std::size_t CdrReader::count(std::size_t least_size) {
  const std::size_t count = get<std::uint32_t>();
  is_good_ = is_good_ && count * least_size <= bytes_.size() - at_;
  return is_good_ ? count : 0;
}

std::string CdrReader::text() {
  const std::size_t size = count(1);
  if (!is_good_ || size == 0) return {};  // Some writers give no closing zero to an empty text.
  std::string value(bytes_.substr(at_, size - 1));
  is_good_ = bytes_[at_ + size - 1] == '\0';
  at_ += size;
  return value;
}

std::vector<double> CdrReader::doubles() {
  std::vector<double> values(count(sizeof(double)));
  for (double& value : values) value = float64();
  return values;
}
std::vector<float> CdrReader::floats() {
  std::vector<float> values(count(sizeof(float)));
  for (float& value : values) value = float32();
  return values;
}
std::vector<std::int32_t> CdrReader::ints() {
  std::vector<std::int32_t> values(count(sizeof(std::int32_t)));
  for (std::int32_t& value : values) value = int32();
  return values;
}
std::vector<std::string> CdrReader::texts() {
  std::vector<std::string> values(count(4));
  for (std::string& value : values) value = text();
  return values;
}

}  // namespace hapticell::exchange
