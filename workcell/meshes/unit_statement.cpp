// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/unit_statement.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>
#include <vector>

namespace hapticell::workcell {

namespace {

/// A word of letters and digits in small letters, and the character that follows it.
struct Word {
  std::string text;
  char next = ' ';
};

std::vector<Word> wordsOf(std::string_view comment) {
  std::vector<Word> words;
  std::string text;
  const auto close = [&](char next) {
    if (!text.empty()) words.push_back({std::exchange(text, {}), next});
  };
  for (const char c : comment.substr(0, 256)) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || byte >= 0x80) {
      text += static_cast<char>(std::tolower(byte));
    } else {
      close(c);
    }
  }
  close(' ');
  return words;
}

std::optional<double> metresPerWord(const Word& word) {
  using Names = std::array<std::string_view, 5>;
  constexpr std::array<std::pair<Names, double>, 7> kUnits = {{
      {{"m", "meter", "meters", "metre", "metres"}, 1.0},
      {{"mm", "millimeter", "millimeters", "millimetre", "millimetres"}, 1e-3},
      {{"cm", "centimeter", "centimeters", "centimetre", "centimetres"}, 1e-2},
      {{"um", "micrometer", "micrometers", "micron", "microns"}, 1e-6},
      {{"in", "inch", "inches", "inchs", "zoll"}, 0.0254},
      {{"ft", "foot", "feet", "foots", "fuss"}, 0.3048},
      {{"yd", "yard", "yards", "yds", "yrd"}, 0.9144},
  }};
  constexpr std::string_view kPartOfMore = "/^*_+";
  if (kPartOfMore.find(word.next) != std::string_view::npos) return std::nullopt;
  for (const auto& [names, metres] : kUnits) {
    if (std::find(names.begin(), names.end(), word.text) != names.end()) return metres;
  }
  return std::nullopt;
}

bool isOneOf(const std::string& text, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

/// The unit that stands behind words[begin], with nothing but "is", "are", "in", "1" between.
std::optional<double> unitBehind(const std::vector<Word>& words, std::size_t begin) {
  for (std::size_t k = begin + 1; k < words.size(); ++k) {
    const bool filler = isOneOf(words[k].text, {"is", "are", "in", "1"});
    const bool more = k + 1 < words.size() &&
                      (isOneOf(words[k + 1].text, {"is", "are", "in", "1"}) || metresPerWord(words[k + 1]).has_value());
    if (filler && more) continue;
    return metresPerWord(words[k]);
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> statedUnit(std::string_view comment) {
  const std::vector<Word> words = wordsOf(comment);
  for (std::size_t k = 0; k < words.size(); ++k) {
    const bool unit = isOneOf(words[k].text, {"unit", "units"});
    const bool sizes = isOneOf(words[k].text, {"dimensions", "coordinates", "lengths"}) && k + 1 < words.size() &&
                       isOneOf(words[k + 1].text, {"in", "are"});
    if (!unit && !sizes) continue;
    if (const auto metres = unitBehind(words, k)) return metres;
    const bool uses = k >= 3 && words[k - 1].text == "as" && isOneOf(words[k - 3].text, {"uses", "using"});
    if (const auto metres = uses ? metresPerWord(words[k - 2]) : std::nullopt) return metres;
  }
  return std::nullopt;
}

}  // namespace hapticell::workcell
