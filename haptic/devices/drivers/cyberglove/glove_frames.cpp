// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/cyberglove/glove_frames.h"

#include <algorithm>

namespace hapticell::driver {

namespace {

constexpr std::array<std::uint8_t, 3> kSync{0x0D, 0x0A, 0x00};
constexpr std::size_t kStamp = 14;
// Bytes kept while no frame is found: 16 of the longest. Half: eight; twice: garbage is searched for longer.
constexpr std::size_t kMostPending = 1024;
constexpr unsigned kWideMost = 4094;

}  // namespace

bool GloveFrames::take(std::span<const std::uint8_t> bytes, GloveSample& sample) {
  bool found = false;
  if (format_.wide) {
    pending_.insert(pending_.end(), bytes.begin(), bytes.end());
    while (takeWide(sample)) found = true;
    if (pending_.size() > kMostPending) pending_.erase(pending_.begin(), pending_.end() - kMostPending / 2);
    return found;
  }
  for (const std::uint8_t byte : bytes) found = takeNarrow(byte, sample) || found;
  return found;
}

bool GloveFrames::takeNarrow(std::uint8_t byte, GloveSample& sample) {
  if (byte != 0) {
    if (pending_.size() < kMostPending) pending_.push_back(byte);
    return false;
  }
  const std::size_t wanted = 1 + format_.sensors + (format_.status ? 1 : 0);
  const bool good = pending_.size() == wanted && (pending_[0] == 'G' || pending_[0] == 'S');
  if (good) {
    sample = {};
    sample.count = format_.sensors;
    std::copy_n(pending_.begin() + 1, format_.sensors, sample.readings.begin());
    if (format_.status) {
      const std::uint8_t bits = pending_.back();
      sample.has_status = true;
      sample.glove_in = (bits & 1) != 0;
      sample.switch_on = (bits & 2) != 0;
      sample.light_on = (bits & 4) != 0;
    }
  } else {
    ++garbled_;
  }
  pending_.clear();
  return good;
}

bool GloveFrames::takeWide(GloveSample& sample) {
  const std::size_t body = kStamp + 2 * format_.sensors;
  while (true) {
    const auto sync = std::search(pending_.begin(), pending_.end(), kSync.begin(), kSync.end());
    if (sync == pending_.end()) return false;
    const auto at = static_cast<std::size_t>(sync - pending_.begin());
    if (pending_.size() < at + kSync.size() + body) return false;
    const std::uint8_t* const data = pending_.data() + at + kSync.size();
    GloveSample read;
    read.count = format_.sensors;
    bool good = data[kStamp - 1] == 'S';
    for (std::size_t i = 0; i < format_.sensors && good; ++i) {
      const unsigned raw = static_cast<unsigned>(data[kStamp + 2 * i] << 8) | data[kStamp + 2 * i + 1];
      good = raw >= 1 && raw <= kWideMost;
      read.readings[i] = raw * (255.0 / 4095.0);
    }
    if (good) {
      sample = read;
      pending_.erase(pending_.begin(), sync + static_cast<std::ptrdiff_t>(kSync.size() + body));
      return true;
    }
    ++garbled_;
    pending_.erase(pending_.begin(), sync + 1);
  }
}

}  // namespace hapticell::driver
