// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::test {

/// A second reader of C3D, written from the format's description and sharing nothing with the first: it computes
/// sums only. Of all statements on start, analog samples and frames it takes the first that fills the file.
struct SecondC3d {
  std::size_t markers = 0, frames = 0, seen = 0;
  dvec3 sum{0.0};  ///< In the file's unit and axes.
};

class SecondC3dReader {
 public:
  explicit SecondC3dReader(const std::string& bytes) : d_(bytes) {}

  std::optional<SecondC3d> read() {
    if (d_.size() < 1024 || u8(1) != 0x50) return std::nullopt;
    const std::size_t pa = 512 * (u8(0) - std::size_t{1});
    if (pa + 4 >= d_.size()) return std::nullopt;
    processor_ = u8(pa + 3);
    collect(pa);
    const std::size_t n = static_cast<std::size_t>(number("POINT:USED").value_or(u16(2)));
    double scale = number("POINT:SCALE").value_or(0.0);
    if (scale == 0.0) scale = f32(12);
    const bool real = scale < 0.0;
    if (f32(12) > 0.0) scale = f32(12);
    const std::size_t size = real ? 4 : 2;
    std::optional<std::array<std::size_t, 3>> best;  // Start, row, frames.
    std::size_t rest_of_best = 0;
    for (const double block : {number("POINT:DATA_START").value_or(0.0), 1.0 * u16(16)}) {
      if (block < 2.0) continue;
      for (const double analog : analogs()) {
        for (const double frames : frameCounts()) {
          const std::size_t row = (4 * n + static_cast<std::size_t>(analog)) * size;
          const std::size_t start = 512 * (static_cast<std::size_t>(block) - 1);
          const std::size_t need = start + row * static_cast<std::size_t>(frames);
          if (frames < 1.0 || need > d_.size()) continue;
          const std::size_t rest = d_.size() - need;
          if (best && !(rest < 512 && rest_of_best >= 512)) continue;
          best = {start, row, static_cast<std::size_t>(frames)};
          rest_of_best = rest;
        }
      }
    }
    if (!best || n == 0) return std::nullopt;
    SecondC3d result{n, (*best)[2], 0, dvec3(0.0)};
    for (std::size_t f = 0; f < (*best)[2]; ++f) {
      for (std::size_t m = 0; m < n; ++m) add((*best)[0] + f * (*best)[1] + 4 * m * size, real, scale, result);
    }
    return result;
  }

 private:
  std::uint8_t u8(std::size_t at) const { return static_cast<std::uint8_t>(d_[at]); }
  std::uint16_t u16(std::size_t at) const {
    if (at + 2 > d_.size()) return 0;
    return static_cast<std::uint16_t>(processor_ == 86 ? 256 * u8(at) + u8(at + 1) : u8(at) + 256 * u8(at + 1));
  }
  /// By sign, exponent and fraction, not by the machine's own floats.
  double f32(std::size_t at) const {
    const std::uint32_t high = processor_ == 84 ? u16(at + 2) : u16(at), low = processor_ == 84 ? u16(at) : u16(at + 2);
    const int exponent = static_cast<int>(high >> 7 & 0xff);
    const double fraction = static_cast<double>((high & 0x7f) * 65536 + low) / 8388608.0;
    if (exponent == 0) return 0.0;
    if (exponent == 255 && processor_ != 85) return NAN;
    const double value = std::ldexp(1.0 + fraction, exponent - (processor_ == 85 ? 129 : 127));
    return high & 0x8000 ? -value : value;
  }

  struct Entry {
    int type;
    std::size_t at, count;
  };
  void collect(std::size_t pa) {
    std::map<int, std::string> groups;
    std::map<std::pair<int, std::string>, Entry> entries;
    const std::size_t end = std::min(d_.size(), u8(pa + 2) ? pa + 512 * std::size_t{u8(pa + 2)} : d_.size());
    for (std::size_t at = pa + 4; at + 4 < end;) {
      const std::size_t letters = static_cast<std::size_t>(std::abs(static_cast<std::int8_t>(u8(at))));
      const int group = static_cast<std::int8_t>(u8(at + 1));
      if (letters == 0 || at + letters + 6 > end) break;
      std::string name = d_.substr(at + 2, letters);
      for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      const std::size_t link = at + 2 + letters, step = u16(link);
      if (group < 0) {
        groups[-group] = name;
      } else {
        std::size_t count = 1;
        for (std::size_t k = 0; k < u8(link + 3) && link + 4 + k < d_.size(); ++k) count *= u8(link + 4 + k);
        entries[{group, name}] = {static_cast<std::int8_t>(u8(link + 2)), link + 4 + u8(link + 3), count};
      }
      if (step == 0 || link + step >= end) break;
      at = link + step;
    }
    for (const auto& [key, entry] : entries) entries_[groups[key.first] + ":" + key.second] = entry;
  }
  std::optional<double> number(const std::string& name, std::size_t i = 0) const {
    const auto found = entries_.find(name);
    if (found == entries_.end() || i >= found->second.count) return std::nullopt;
    if (found->second.type == 4) return f32(found->second.at + 4 * i);
    if (found->second.type == 2) return u16(found->second.at + 2 * i);
    return std::nullopt;
  }
  std::vector<double> analogs() const {
    const double used = number("ANALOG:USED").value_or(0.0), rate = number("POINT:RATE").value_or(0.0);
    const double times = rate > 0.0 ? std::round(number("ANALOG:RATE").value_or(0.0) / rate) : 0.0;
    return {1.0 * u16(4), used * times, used * u16(18)};
  }
  std::vector<double> frameCounts() const {
    std::vector<double> counts;
    const auto a = number("TRIAL:ACTUAL_START_FIELD"), b = number("TRIAL:ACTUAL_START_FIELD", 1);
    const auto c = number("TRIAL:ACTUAL_END_FIELD"), d = number("TRIAL:ACTUAL_END_FIELD", 1);
    if (a && b && c && d) counts.push_back(*c + 65536.0 * *d - *a - 65536.0 * *b + 1.0);
    counts.push_back(number("POINT:LONG_FRAMES").value_or(0.0));
    counts.push_back((u16(8) - u16(6) + 65536) % 65536 + 1);
    counts.push_back(number("POINT:FRAMES").value_or(0.0));
    return counts;
  }
  void add(std::size_t at, bool real, double scale, SecondC3d& result) const {
    dvec3 p(0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      p[static_cast<int>(k)] = real ? f32(at + 4 * k) : scale * static_cast<std::int16_t>(u16(at + 2 * k));
      if (!std::isfinite(p[static_cast<int>(k)]) || std::abs(p[static_cast<int>(k)]) > 1e12) return;
    }
    const double residual = real ? f32(at + 12) : static_cast<std::int16_t>(u16(at + 6));
    if (!(residual >= 0.0)) return;
    ++result.seen;
    result.sum += p;
  }

  const std::string& d_;
  int processor_ = 84;
  std::map<std::string, Entry> entries_;
};

}  // namespace hapticell::test
