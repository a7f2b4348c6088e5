// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/text.h"
#include "mannequin/motion/c3d_parameters.h"

namespace hapticell::mannequin {

/// Layout of the points in a C3D file.
struct C3dLayout {
  std::size_t data_at = 0;  ///< First byte.
  std::size_t markers = 0, analog = 0, frames = 0;
  bool real = true;    ///< Numbers of 4 bytes instead of 2.
  double scale = 1.0;  ///< Of whole numbers.
  std::vector<Text> warnings;

  std::size_t numberBytes() const { return real ? 4 : 2; }
  std::size_t rowBytes() const { return (4 * markers + analog) * numberBytes(); }
};

/// Counts, offsets and number formats. Header and parameters state most of it twice, and files of some makers
/// contradict themselves: the combination that fills the file to its last block is used; otherwise the parameters, with
/// all frames that are present. Each real choice gives a warning. Errors: no points, more than 10000, fewer frames than
/// stated, more than two million.
inline Expected<C3dLayout> c3dLayout(const C3dParameters& parameters, const std::string& name);

namespace c3d {

inline constexpr std::size_t kBlockBytes = C3dParameters::kBlock;
/// Guard memory and time, and tell what a field cannot mean. Half, twice: other files are refused with a message.
inline constexpr std::size_t kMostPoints = 10'000, kMostRows = 2'000'000, kMostAnalog = 1'000'000;

inline tl::unexpected<Error> fault(std::string name, std::size_t at, Text found, Text expected) {
  return makeError({.file = std::move(name),
                    .place = Text("byte %1", at),
                    .found = std::move(found),
                    .expected = std::move(expected)});
}

/// Possible values, the likeliest first, without repetitions.
template <typename T>
class Choices {
 public:
  void add(T value) {
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  std::vector<T> values;
};

class LayoutFinder {
 public:
  LayoutFinder(const C3dParameters& parameters, const std::string& name)
      : p_(parameters), b_(parameters.bytes()), name_(name) {}

  Expected<C3dLayout> find() {
    HAPTICELL_TRY(collect());
    const C3dLayout first = layout(0, 0, 0, 0, 0);
    if (fills(first) || (fits(first) && restIsEmpty(first))) return finished(first, first);
    if (const auto other = best(true)) return finished(*other, first);
    if (fits(first)) return finished(withAllRows(first), first);
    if (const auto other = best(false)) return finished(withAllRows(*other), first);
    return fail(first.data_at, Text("%1 frames", rowsThere(first)),
                Text("%1 frames, as the file states", first.frames));
  }

 private:
  tl::unexpected<Error> fail(std::size_t at, Text found, Text expected) const {
    return c3d::fault(name_, at, std::move(found), std::move(expected));
  }

  Expected<void> collect() {
    const double used = p_.number("POINT:USED").value_or(*b_.word(2));
    if (!(used >= 1.0) && *b_.word(2) < 1) return fail(2, Text("no points"), Text("at least one marker"));
    if (p_.number("POINT:USED") && !(used >= 1.0)) return fail(2, Text("no points"), Text("at least one marker"));
    if (used > static_cast<double>(kMostPoints))
      return fail(2, Text("%1 points", std::llround(used)), Text("at most 10000"));
    markers_.add(static_cast<std::size_t>(used));
    if (*b_.word(2) >= 1 && *b_.word(2) <= kMostPoints) markers_.add(*b_.word(2));
    collectKinds();
    collectAnalog();
    collectStarts();
    collectFrames();
    if (kinds_.values.empty()) return fail(12, Text("the scale factor is not a number"), Text("a finite number"));
    return {};
  }

  void collectKinds() {
    for (const auto& scale : {p_.number("POINT:SCALE"), b_.real(12)}) {
      if (scale && *scale != 0.0) kinds_.add(*scale < 0.0);
    }
  }

  void collectAnalog() {
    const double said = *b_.word(4), samples = *b_.word(18);
    const double channels = p_.number("ANALOG:USED").value_or(0.0), rate = p_.number("POINT:RATE").value_or(0.0);
    const double times = rate > 0.0 ? std::round(p_.number("ANALOG:RATE").value_or(0.0) / rate) : 0.0;
    for (const double count : {said, channels * times, channels * samples, said * times, said * samples, channels}) {
      if (count >= 0.0 && count <= static_cast<double>(kMostAnalog)) analog_.add(static_cast<std::size_t>(count));
    }
  }

  void collectStarts() {
    for (const double block : {p_.number("POINT:DATA_START").value_or(0.0), static_cast<double>(*b_.word(16))}) {
      const double at = (block - 1.0) * static_cast<double>(kBlockBytes);
      if (block >= 2.0 && at < static_cast<double>(b_.size())) starts_.add(static_cast<std::size_t>(at));
    }
    starts_.add(p_.end());
  }

  void collectFrames() {
    const auto trial = [&](const char* name) -> std::optional<double> {
      const auto low = p_.number(name, 0), high = p_.number(name, 1);
      return low && high ? std::optional(*low + 65536.0 * *high) : std::nullopt;
    };
    const auto add = [this](double count) {
      if (count >= 1.0 && count <= static_cast<double>(kMostRows)) frames_.add(static_cast<std::size_t>(count));
    };
    const auto first = trial("TRIAL:ACTUAL_START_FIELD"), last = trial("TRIAL:ACTUAL_END_FIELD");
    if (first && last && *last >= *first) add(*last - *first + 1.0);
    if (const auto many = p_.number("POINT:LONG_FRAMES")) add(*many);
    const double header = static_cast<double>(static_cast<std::uint16_t>(*b_.word(8) - *b_.word(6))) + 1.0;
    add(header);
    const double parameter = p_.number("POINT:FRAMES").value_or(0.0);
    add(parameter);
    // 16 bits wrap around to 0.
    for (double k = 1.0; k <= 30.0; k += 1.0) {
      add(header + 65536.0 * k);
      if (parameter >= 1.0) add(parameter + 65536.0 * k);
    }
  }

  C3dLayout layout(std::size_t kind, std::size_t marker, std::size_t analog, std::size_t start,
                   std::size_t frame) const {
    C3dLayout found;
    found.real = kinds_.values[kind];
    found.markers = markers_.values[marker];
    found.analog = analog_.values[analog];
    found.data_at = starts_.values[start];
    found.frames = frames_.values[frame];
    return found;
  }
  std::size_t there(const C3dLayout& l) const { return l.data_at < b_.size() ? b_.size() - l.data_at : 0; }
  std::size_t rowsThere(const C3dLayout& l) const { return there(l) / l.rowBytes(); }
  bool fits(const C3dLayout& l) const { return l.frames <= rowsThere(l); }
  /// To the file's last block.
  bool fills(const C3dLayout& l) const { return fits(l) && there(l) - l.frames * l.rowBytes() < kBlockBytes; }
  bool isEmpty(std::size_t from, std::size_t count) const {
    const std::string_view bytes = b_.text(from, count);
    return bytes.find_first_not_of('\0') == std::string_view::npos;
  }
  bool restIsEmpty(const C3dLayout& l) const {
    const std::size_t end = l.data_at + l.frames * l.rowBytes();
    return isEmpty(end, b_.size() - end);
  }

  /// The likeliest of all combinations that fills the file, or else that fits into it.
  std::optional<C3dLayout> best(bool to_the_end) const {
    std::optional<C3dLayout> found;
    std::size_t least = static_cast<std::size_t>(-1);
    for (std::size_t k = 0; k < kinds_.values.size(); ++k) {
      for (std::size_t m = 0; m < markers_.values.size(); ++m) {
        for (std::size_t a = 0; a < analog_.values.size(); ++a) {
          for (std::size_t s = 0; s < starts_.values.size(); ++s) {
            for (std::size_t f = 0; f < frames_.values.size(); ++f) {
              const C3dLayout l = layout(k, m, a, s, f);
              const std::size_t cost = 8 * k + 8 * m + 2 * a + 4 * s + f;
              if (cost >= least || !(to_the_end ? fills(l) : fits(l))) continue;
              least = cost;
              found = l;
            }
          }
        }
      }
    }
    return found;
  }

  /// True if rows continue after the stated number of frames, up to the file's last block.
  C3dLayout withAllRows(C3dLayout l) const {
    std::size_t rows = rowsThere(l);
    while (rows > l.frames && isEmpty(l.data_at + (rows - 1) * l.rowBytes(), l.rowBytes())) --rows;
    const std::size_t rest = there(l) - rows * l.rowBytes();
    if (rest < kBlockBytes) l.frames = rows;
    return l;
  }

  Expected<C3dLayout> finished(C3dLayout l, const C3dLayout& first) const {
    if (l.frames > kMostRows) return fail(6, Text("%1 frames", l.frames), Text("at most 2000000"));
    const auto warn = [&](Text text) { l.warnings.push_back(std::move(text)); };
    const std::size_t stated = *b_.word(16);
    if (stated < 2 || l.data_at != first.data_at)
      warn(Text("header and parameters disagree on where the points begin; they are read from byte %1", l.data_at));
    if (l.real != first.real)
      warn(
          l.real
              ? Text("header and parameters disagree on the number format; real numbers match the file size and are "
                     "read")
              : Text("header and parameters disagree on the number format; integers match the file size and are read"));
    if (l.markers != first.markers)
      warn(Text("the parameters state %1 points and the header %2; the header matches the file size and is used",
                first.markers, l.markers));
    if (l.analog != first.analog)
      warn(Text(
          "the header states %1 analog samples per frame; %2 (channels × samples) match the file size and are read",
          first.analog, l.analog));
    const std::size_t header = static_cast<std::size_t>(static_cast<std::uint16_t>(*b_.word(8) - *b_.word(6))) + 1;
    if (l.frames != first.frames || (l.frames != header && header != 65'535 && header != 65'536 && l.frames < 65'536))
      warn(Text("the header states %1 frames; the file has %2, which are read", header, l.frames));
    if (const std::size_t end = l.data_at + l.frames * l.rowBytes();
        b_.size() >= end + kBlockBytes && !isEmpty(end, b_.size() - end))
      warn(Text("%1 bytes after the last frame are not read; they are not complete frames", b_.size() - end));
    l.scale = scaleOf(l);
    return l;
  }

  /// If both disagree, the header's value is the one that was used for writing.
  double scaleOf(C3dLayout& l) const {
    if (l.real) return 1.0;
    const auto parameter = p_.number("POINT:SCALE"), header = b_.real(12);
    const double written = header && *header > 0.0 ? *header : std::abs(parameter.value_or(1.0));
    if (parameter && *parameter > 0.0 && std::abs(*parameter - written) > 1e-3 * written) {
      const auto shown = [](double value) {
        char text[32];
        std::snprintf(text, sizeof text, "%.6g", value);
        return std::string(text);
      };
      l.warnings.push_back(Text("the scale of the points is %1 in the header and %2 in the parameters; %1 is used",
                                shown(written), shown(*parameter)));
    }
    return written;
  }

  const C3dParameters& p_;
  const C3dBytes& b_;
  const std::string& name_;
  Choices<bool> kinds_;
  Choices<std::size_t> markers_, analog_, starts_, frames_;
};

}  // namespace c3d

inline Expected<C3dLayout> c3dLayout(const C3dParameters& parameters, const std::string& name) {
  return c3d::LayoutFinder(parameters, name).find();
}

}  // namespace hapticell::mannequin
