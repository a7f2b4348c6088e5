// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/scores/french_words.h"

#include <iterator>
#include <unordered_map>
#include <utility>

namespace hapticell::ergonomics {
namespace {

constexpr std::pair<std::string_view, std::string_view> kFrenchWords[] = {
#include "mannequin/ergonomics/scores/french_table.h"
};

const std::unordered_map<std::string_view, std::string_view>& dictionary() {
  static const std::unordered_map<std::string_view, std::string_view> words(std::begin(kFrenchWords), std::end(kFrenchWords));
  return words;
}

}  // namespace

std::string_view french(std::string_view english) {
  const auto found = dictionary().find(english);
  return found == dictionary().end() ? english : found->second;
}

}  // namespace hapticell::ergonomics
