// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cctype>
#include <cmath>
#include <system_error>

#include "geometry/system/regular_file.h"
#include "geometry/system/text_case.h"
#include "mannequin/motion/c3d_layout.h"
#include "mannequin/motion/c3d_parameters.h"
#include "mannequin/motion/marker_clip.h"
#include "mannequin/motion/marker_up.h"

namespace hapticell::mannequin {

namespace {

// Guards memory. Half, twice: other files are refused with a message.
constexpr std::size_t kMostC3dBytes = std::size_t{1} << 30;

struct C3dUnit {
  const char* word;
  double metres;
};
/// Words are matched by their begin, since makers cut them ("mete"); those of two letters only whole.
constexpr std::array<C3dUnit, 18> kC3dUnits{{{"mm", 1e-3},
                                             {"cm", 1e-2},
                                             {"dm", 0.1},
                                             {"m", 1.0},
                                             {"in", 0.0254},
                                             {"ft", 0.3048},
                                             {"um", 1e-6},
                                             {"millimeters", 1e-3},
                                             {"millimetres", 1e-3},
                                             {"centimeters", 1e-2},
                                             {"centimetres", 1e-2},
                                             {"meters", 1.0},
                                             {"metres", 1.0},
                                             {"metre", 1.0},
                                             {"inch", 0.0254},
                                             {"inches", 0.0254},
                                             {"feet", 0.3048},
                                             {"foot", 0.3048}}};

class C3dReader {
 public:
  C3dReader(const C3dParameters& parameters, const C3dLayout& layout, const std::string& name)
      : parameters_(parameters), layout_(layout), name_(name) {
    clip_.warnings = parameters.warnings();
    clip_.warnings.insert(clip_.warnings.end(), layout.warnings.begin(), layout.warnings.end());
  }

  Expected<MarkerClip> read(std::optional<UpAxis> up) {
    HAPTICELL_TRY(readRate());
    HAPTICELL_TRY(readUnit());
    readNames();
    readPlaces();
    const std::vector<std::string> screen = parameters_.texts("POINT:Y_SCREEN");
    turnUpright(clip_, up, screen.empty() ? "" : screen.front());
    return std::move(clip_);
  }

 private:
  tl::unexpected<Error> fail(std::size_t at, Text found, Text expected) const {
    return c3d::fault(name_, at, std::move(found), std::move(expected));
  }

  Expected<void> readRate() {
    const auto sound = [](std::optional<double> rate) { return rate && *rate > 0.0 && *rate < 1e6; };
    const auto parameter = parameters_.number("POINT:RATE"), header = parameters_.bytes().real(20);
    if (!sound(parameter) && !sound(header))
      return fail(20, Text("the frame rate is missing"), Text("frames per second above 0"));
    const double rate = sound(parameter) ? *parameter : *header;
    if (sound(parameter) && sound(header) && std::abs(*parameter - *header) > 1e-3 * *header) {
      clip_.warnings.push_back(Text("the frame rate is %1 Hz in the parameters and %2 Hz in the header; %1 Hz is used",
                                    std::to_string(*parameter), std::to_string(*header)));
    }
    clip_.frame_time = 1.0 / rate;
    return {};
  }

  Expected<void> readUnit() {
    const std::vector<std::string> words = parameters_.texts("POINT:UNITS");
    const std::string unit = words.empty() ? "" : lowerCase(words.front());
    if (unit.empty()) {
      clip_.warnings.push_back(Text("the file has no unit; millimetres are assumed"));
      return {};
    }
    for (const C3dUnit& known : kC3dUnits) {
      const std::string_view word(known.word);
      const bool whole = unit == word || (word.size() > 2 && unit + "s" == word);
      if (!whole && (word.size() <= 3 || unit.size() < 3 || !word.starts_with(unit))) continue;
      clip_.metres_per_unit = known.metres;
      if (!whole)
        clip_.warnings.push_back(Text("the unit '%1' is incomplete; %2 is assumed", words.front(), known.word));
      return {};
    }
    return fail(parameters_.placeOf("POINT:UNITS"), Text("the unit '%1'", words.front()), Text("mm, cm, m, in or ft"));
  }

  void readNames() {
    std::vector<std::string> names = parameters_.texts("POINT:LABELS");
    for (int more = 2; names.size() < layout_.markers && more < 100; ++more) {  // 255 is the most one of them holds.
      const std::vector<std::string> next = parameters_.texts("POINT:LABELS" + std::to_string(more));
      if (next.empty()) break;
      names.insert(names.end(), next.begin(), next.end());
    }
    names.resize(layout_.markers);
    for (std::size_t k = 0; k < layout_.markers; ++k) {
      if (names[k].empty()) names[k] = "marker " + std::to_string(k + 1);
    }
    clip_.names = std::move(names);
  }

  void readPlaces() {
    clip_.places.reserve(layout_.frames * layout_.markers);
    for (std::size_t frame = 0; frame < layout_.frames; ++frame) {
      for (std::size_t marker = 0; marker < layout_.markers; ++marker)
        clip_.places.push_back(
            placeAt(layout_.data_at + frame * layout_.rowBytes() + 4 * marker * layout_.numberBytes()));
    }
  }

  /// Nothing where the fourth number is negative (not seen) or a coordinate is not a number.
  std::optional<dvec3> placeAt(std::size_t at) const {
    const C3dBytes& bytes = parameters_.bytes();
    const std::size_t size = layout_.numberBytes();
    const auto number = [&](std::size_t k) {
      return layout_.real ? bytes.real(at + k * size) : std::optional<double>(*bytes.whole(at + k * size));
    };
    dvec3 p(0.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = number(axis);
      if (!value) return std::nullopt;
      p[static_cast<int>(axis)] = *value * layout_.scale;
    }
    const auto seen = number(3);
    if (!seen || *seen < 0.0) return std::nullopt;
    return p * clip_.metres_per_unit;
  }

  const C3dParameters& parameters_;
  const C3dLayout& layout_;
  const std::string& name_;
  MarkerClip clip_;
};

}  // namespace

double MarkerClip::seenShare(std::size_t marker) const {
  if (frames() == 0) return 0.0;
  std::size_t seen = 0;
  for (std::size_t frame = 0; frame < frames(); ++frame) seen += at(frame, marker) ? 1 : 0;
  return static_cast<double>(seen) / static_cast<double>(frames());
}

Expected<MarkerClip> parseC3d(std::string_view bytes, const std::string& name, std::optional<UpAxis> up) {
  const Expected<C3dParameters> parameters = C3dParameters::read(bytes, name);
  HAPTICELL_TRY(parameters);
  const Expected<C3dLayout> layout = c3dLayout(*parameters, name);
  HAPTICELL_TRY(layout);
  return C3dReader(*parameters, *layout, name).read(up);
}

Expected<MarkerClip> readC3d(const std::filesystem::path& file, std::optional<UpAxis> up) {
  const auto bytes = geometry::readRegularFile(file, kMostC3dBytes);
  HAPTICELL_TRY(bytes);
  return parseC3d(*bytes, file.string(), up);
}

}  // namespace hapticell::mannequin
