// SPDX-License-Identifier: Apache-2.0
#include "mannequin/body/body_request_text.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "geometry/system/plain_number.h"

namespace hapticell::mannequin {
namespace {

std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// The number in front of `unit`; nothing where the word is not that.
std::optional<double> numberBefore(std::string_view word, std::string_view unit) {
  if (word.size() <= unit.size() || word.substr(word.size() - unit.size()) != unit) return std::nullopt;
  const std::string_view digits = word.substr(0, word.size() - unit.size());
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

Error refusal(const std::string& text, const std::string& place) {
  return {.file = text,
          .place = place,
          .found = "no mannequin",
          .expected = "mannequin:SEX:PERCENTILE or mannequin:SEX:STATUREmm, such as mannequin:female:5"};
}

bool takeOwnMeasure(const std::string& word, BodyRequest& request) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) return false;
  const auto dimension = findDimension(std::string_view(word).substr(0, equals));
  const auto value = numberBefore(std::string_view(word).substr(equals + 1), "");
  if (!dimension || !value) return false;
  request.own[static_cast<std::size_t>(*dimension)] = *value;
  return true;
}

std::string decimals(double value, int count) {
  return plainNumber(value, std::chars_format::fixed, count);
}

}  // namespace

Expected<BodyRequest> parseBodyRequest(const std::string& text) {
  const std::vector<std::string> words = wordsOf(text);
  const bool known = words.size() >= 3 && words[0] == "mannequin" && (words[1] == "male" || words[1] == "female");
  if (!known) return makeError(refusal(text, ""));
  BodyRequest request;
  request.sex = words[1] == "male" ? Sex::kMale : Sex::kFemale;
  if (const auto millimetres = numberBefore(words[2], "mm")) {
    request.stature = *millimetres / 1000.0;
  } else if (const auto percentile = numberBefore(words[2], "")) {
    const Expected<double> stature = statureOfPercentile(request.sex, *percentile);
    HAPTICELL_TRY(stature);
    request.stature = *stature;
  } else {
    return makeError(refusal(text, words[2]));
  }
  for (std::size_t i = 3; i < words.size(); ++i) {
    if (const auto mass = numberBefore(words[i], "kg")) {
      request.mass = *mass;
    } else if (!takeOwnMeasure(words[i], request)) {
      return makeError(refusal(text, words[i]));
    }
  }
  return request;
}

std::string bodyRequestText(const BodyRequest& request) {
  std::string text = request.sex == Sex::kMale ? "mannequin:male:" : "mannequin:female:";
  text += decimals(1000.0 * request.stature, 1) + "mm";
  if (request.mass) text += ":" + decimals(*request.mass, 2) + "kg";
  for (std::size_t i = 0; i < kDimensionCount; ++i) {
    if (!request.own[i]) continue;
    text.append(":").append(nameOf(static_cast<Dimension>(i))).append("=").append(decimals(*request.own[i], 4));
  }
  return text;
}

}  // namespace hapticell::mannequin
