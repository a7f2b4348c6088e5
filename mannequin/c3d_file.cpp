// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <system_error>

#include "mannequin/c3d_numbers.h"
#include "mannequin/marker_clip.h"

namespace hapticell::mannequin {

namespace {

constexpr std::size_t kBlock = 512, kMostMarkers = 10'000, kMostSamples = 2'000'000;
constexpr std::size_t kMostBytes = std::size_t{1} << 30;

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::string trimmed(std::string_view text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.remove_suffix(1);
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  return std::string(text);
}

/// A parameter where it stands in the file.
struct Parameter {
  int type = 0;  ///< -1 letters, 1 bytes, 2 whole numbers, 4 real ones.
  std::vector<std::size_t> sizes;
  std::size_t at = 0, count = 1;
};

class C3dReader {
 public:
  C3dReader(std::string_view bytes, const std::string& name)
      : bytes_(bytes, C3dProcessor::kIntel), all_(bytes), name_(name) {}

  Expected<MarkerClip> read() {
    if (auto done = readHeader(); !done) return makeError(done.error());
    if (auto done = readParameters(); !done) return makeError(done.error());
    if (auto done = readLayout(); !done) return makeError(done.error());
    readNames();
    if (auto done = readPlaces(); !done) return makeError(done.error());
    return std::move(clip_);
  }

 private:
  tl::unexpected<Error> fail(std::size_t at, std::string found, std::string expected) const {
    return makeError({name_, "byte " + std::to_string(at), std::move(found), std::move(expected), ""});
  }

  /// The two fixed bytes, where the parameters stand, and whose numbers these are.
  Expected<void> readHeader() {
    constexpr std::uint8_t kMark = 0x50;
    if (!bytes_.holds(0, kBlock) || bytes_.byte(1) != kMark) return fail(1, "no C3D header", "a C3D file");
    parameters_at_ = (std::max<std::size_t>(*bytes_.byte(0), 1) - 1) * kBlock;
    const auto processor = bytes_.byte(parameters_at_ + 3);
    if (parameters_at_ == 0 || !processor)
      return fail(0, "parameters that are not in the file", "a block behind the header");
    if (*processor < 84 || *processor > 86) {
      return fail(parameters_at_ + 3, "processor " + std::to_string(*processor), "84 (Intel), 85 (DEC) or 86 (MIPS)");
    }
    bytes_ = C3dBytes(all_, static_cast<C3dProcessor>(*processor));
    return {};
  }

  /// Groups (negative number) and parameters follow each other, each telling how far the next one is.
  Expected<void> readParameters() {
    std::map<int, std::string> groups;
    std::map<std::pair<int, std::string>, Parameter> found;
    for (std::size_t at = parameters_at_ + 4;;) {
      const auto length = bytes_.byte(at), number = bytes_.byte(at + 1);
      if (!length || !number) return fail(at, "the end of the file", "the parameters' end");
      const std::size_t letters = static_cast<std::size_t>(std::abs(static_cast<std::int8_t>(*length)));
      if (letters == 0) break;
      const int group = static_cast<int>(static_cast<std::int8_t>(*number));
      const std::string name = upper(bytes_.text(at + 2, letters));
      const std::size_t link = at + 2 + letters;
      const auto step = bytes_.word(link);
      if (name.empty() || !step) return fail(at, "a parameter that is cut", "its name and length");
      if (group < 0) {
        groups[-group] = name;
      } else if (const auto parameter = parameterAt(link + 2)) {
        found[{group, name}] = *parameter;
      } else {
        return fail(link + 2, "the parameter " + name + " is cut or of no known kind",
                    "letters or numbers in the file");
      }
      if (*step == 0) break;
      at = link + *step;
    }
    for (auto& [key, parameter] : found) {
      if (const auto group = groups.find(key.first); group != groups.end())
        parameters_[group->second + ":" + key.second] = std::move(parameter);
    }
    return {};
  }

  std::optional<Parameter> parameterAt(std::size_t at) const {
    const auto type = bytes_.byte(at), dimensions = bytes_.byte(at + 1);
    if (!type || !dimensions) return std::nullopt;
    Parameter parameter;
    parameter.type = static_cast<int>(static_cast<std::int8_t>(*type));
    if (parameter.type != -1 && parameter.type != 1 && parameter.type != 2 && parameter.type != 4) return std::nullopt;
    constexpr std::size_t kMostCounted = 1 << 24;
    for (std::size_t k = 0; k < *dimensions; ++k) {
      const auto size = bytes_.byte(at + 2 + k);
      if (!size) return std::nullopt;
      parameter.sizes.push_back(*size);
      parameter.count *= *size;
      if (parameter.count > kMostCounted) return std::nullopt;
    }
    parameter.at = at + 2 + *dimensions;
    const std::size_t each = parameter.type == -1 ? 1 : static_cast<std::size_t>(parameter.type);
    if (!bytes_.holds(parameter.at, parameter.count * each)) return std::nullopt;
    return parameter;
  }

  const Parameter* parameter(const char* name) const {
    const auto found = parameters_.find(name);
    return found == parameters_.end() || found->second.count == 0 ? nullptr : &found->second;
  }
  std::optional<double> number(const char* name, std::size_t index = 0) const {
    const Parameter* p = parameter(name);
    if (!p || index >= p->count) return std::nullopt;
    if (p->type == 4) return bytes_.real(p->at + 4 * index);
    if (p->type != 2) return std::nullopt;
    const auto word = bytes_.word(p->at + 2 * index);
    return word ? std::optional(static_cast<double>(*word)) : std::nullopt;
  }
  std::vector<std::string> texts(const std::string& name) const {
    const Parameter* p = parameter(name.c_str());
    std::vector<std::string> found;
    if (!p || p->type != -1 || p->sizes.empty()) return found;
    const std::size_t letters = p->sizes[0];
    for (std::size_t at = 0; letters > 0 && at + letters <= p->count; at += letters)
      found.push_back(trimmed(bytes_.text(p->at + at, letters)));
    return found;
  }

  /// Counts, scale, rate and unit, from the parameters where they are, else from the header.
  Expected<void> readLayout() {
    const double markers = number("POINT:USED").value_or(*bytes_.word(2));
    if (!(markers >= 1.0)) return fail(2, "no points", "at least one marker");
    if (markers > static_cast<double>(kMostMarkers))
      return fail(2, std::to_string(std::llround(markers)) + " points", "at most 10000");
    markers_ = static_cast<std::size_t>(markers);
    analog_ = *bytes_.word(4);
    const auto scale = number("POINT:SCALE");
    const auto header_scale = bytes_.real(12);
    if (!scale && !header_scale) return fail(12, "a scale that is no number", "a real number");
    scale_ = scale.value_or(header_scale.value_or(1.0));
    const double rate = number("POINT:RATE").value_or(bytes_.real(20).value_or(0.0));
    if (!(rate > 0.0 && rate < 1e6)) return fail(20, "no frame rate", "frames a second above 0");
    clip_.frame_time = 1.0 / rate;
    const double start = number("POINT:DATA_START").value_or(*bytes_.word(16));
    if (start < 2.0) return fail(16, "points in the header", "a block behind it");
    data_at_ = (static_cast<std::size_t>(start) - 1) * kBlock;
    return readUnit();
  }

  Expected<void> readUnit() {
    const std::vector<std::string> words = texts("POINT:UNITS");
    const std::string unit = words.empty() ? "" : upper(words.front());
    constexpr std::array<std::pair<const char*, double>, 7> kUnits{
        {{"MM", 1e-3}, {"CM", 1e-2}, {"DM", 0.1}, {"M", 1.0}, {"METERS", 1.0}, {"IN", 0.0254}, {"MILLIMETERS", 1e-3}}};
    const auto known = std::find_if(kUnits.begin(), kUnits.end(), [&](const auto& each) { return unit == each.first; });
    if (known != kUnits.end()) {
      clip_.metres_per_unit = known->second;
    } else if (unit.empty()) {
      clip_.warnings.push_back("the file names no unit; its numbers are taken as millimetres");
    } else {
      return fail(parameter("POINT:UNITS")->at, "the unit '" + words.front() + "'", "mm, cm, m or in");
    }
    return {};
  }

  /// The header counts in 16 bits; longer recordings say it elsewhere.
  std::size_t statedFrames() const {
    const auto trial = [&](const char* name) -> std::optional<double> {
      const auto low = number(name, 0), high = number(name, 1);
      return low && high ? std::optional(*low + 65536.0 * *high) : std::nullopt;
    };
    const auto first = trial("TRIAL:ACTUAL_START_FIELD"), last = trial("TRIAL:ACTUAL_END_FIELD");
    if (first && last && *last >= *first) return static_cast<std::size_t>(*last - *first) + 1;
    if (const auto many = number("POINT:LONG_FRAMES"); many && *many >= 1.0)
      return static_cast<std::size_t>(std::min(*many, 1e9));
    return static_cast<std::size_t>(static_cast<std::uint16_t>(*bytes_.word(8) - *bytes_.word(6))) + 1;
  }

  void readNames() {
    std::vector<std::string> names = texts("POINT:LABELS");
    for (int more = 2; names.size() < markers_ && more < 100; ++more) {  // 255 is the most that one of them holds.
      const std::vector<std::string> next = texts("POINT:LABELS" + std::to_string(more));
      if (next.empty()) break;
      names.insert(names.end(), next.begin(), next.end());
    }
    names.resize(markers_);
    for (std::size_t k = 0; k < markers_; ++k) {
      if (names[k].empty()) names[k] = "marker " + std::to_string(k + 1);
    }
    clip_.names = std::move(names);
  }

  /// The file's axis that points up, from the names of the screen's axes ("+X", "+Z"); z where it does not say.
  dvec3 upright(const dvec3& p) const {
    const std::vector<std::string> words = texts("POINT:Y_SCREEN");
    const std::string up = words.empty() ? "" : upper(words.front());
    if (up == "+Y") return {p.x, -p.z, p.y};
    if (up == "+X") return {p.y, p.z, p.x};
    return p;
  }

  Expected<void> readPlaces() {
    const bool real = scale_ < 0.0;
    const std::size_t size = real ? 4 : 2, row = (4 * markers_ + analog_) * size, frames = statedFrames();
    if (frames > kMostSamples) return fail(6, std::to_string(frames) + " frames", "at most 2000000");
    const std::size_t there = data_at_ < bytes_.size() ? (bytes_.size() - data_at_) / row : 0;
    if (there < frames) {
      return fail(data_at_, std::to_string(there) + " frames", std::to_string(frames) + " frames, as the file states");
    }
    clip_.places.reserve(frames * markers_);
    for (std::size_t frame = 0; frame < frames; ++frame) {
      for (std::size_t marker = 0; marker < markers_; ++marker)
        clip_.places.push_back(placeAt(data_at_ + frame * row + 4 * marker * size, real));
    }
    return {};
  }

  /// Nothing where the fourth number is negative (not seen) or a coordinate is none.
  std::optional<dvec3> placeAt(std::size_t at, bool real) const {
    dvec3 p(0.0);
    const std::size_t size = real ? 4 : 2;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = real ? bytes_.real(at + axis * size) : std::optional<double>(*bytes_.whole(at + axis * size));
      if (!value) return std::nullopt;
      p[static_cast<int>(axis)] = *value * (real ? 1.0 : scale_);
    }
    const auto seen = real ? bytes_.real(at + 12) : std::optional<double>(*bytes_.whole(at + 6));
    if (!seen || *seen < 0.0) return std::nullopt;
    return upright(p * clip_.metres_per_unit);
  }

  C3dBytes bytes_;
  std::string_view all_;
  const std::string& name_;
  MarkerClip clip_;
  std::map<std::string, Parameter> parameters_;
  std::size_t parameters_at_ = 0, data_at_ = 0, markers_ = 0, analog_ = 0;
  double scale_ = 1.0;
};

}  // namespace

double MarkerClip::seenShare(std::size_t marker) const {
  if (frames() == 0) return 0.0;
  std::size_t seen = 0;
  for (std::size_t frame = 0; frame < frames(); ++frame) seen += at(frame, marker) ? 1 : 0;
  return static_cast<double>(seen) / static_cast<double>(frames());
}

Expected<MarkerClip> parseC3d(std::string_view bytes, const std::string& name) {
  return C3dReader(bytes, name).read();
}

Expected<MarkerClip> readC3d(const std::filesystem::path& file) {
  std::error_code fault;
  if (!std::filesystem::is_regular_file(file, fault))
    return makeError({file.string(), "", "there is no such file", "", ""});
  if (std::filesystem::file_size(file, fault) > kMostBytes) {
    return makeError({file.string(), "", "a file over 1 GB", "a C3D recording", "Cut it into parts."});
  }
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(std::filesystem::file_size(file, fault)), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (fault || !stream) return makeError({file.string(), "", "it cannot be read", "", "Look at its permissions."});
  return parseC3d(bytes, file.string());
}

}  // namespace hapticell::mannequin
