// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/packed_text.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/system/overloaded.h"
#include "geometry/system/plain_number.h"

namespace hapticell {
namespace {

// A text is [id argument argument ...]; each part ends in kPartEnd. An argument starts with the letter of its kind.
constexpr char kOpen = '\x01', kClose = '\x02', kPartEnd = '\x03';
// Texts within texts: those of the program nest half as deep. Half, twice: no effect; guards the stack against another
// process.
constexpr int kDeepest = 16;
// Of one text: sentences have a few, lists are cut before. Half, twice: no effect; guards memory against another
// process.
constexpr std::size_t kMostArguments = 64;

bool isControl(char c) {
  return static_cast<unsigned char>(c) < 0x20;
}

bool hasControls(std::string_view words) {
  return std::any_of(words.begin(), words.end(), isControl);
}

std::string clean(std::string_view words) {
  std::string result(words);
  std::replace_if(result.begin(), result.end(), isControl, ' ');
  return result;
}

std::string number(double value) {
  return plainNumber(value, std::chars_format::general, 17);
}

void pack(const Text& text, std::string& line);

void packArgument(const Text::Argument& argument, std::string& line) {
  std::visit(Overloaded{[&](const std::string& words) { line += 's' + clean(words); },
                        [&](const Text::Length& length) { line += (length.whole ? 'L' : 'l') + number(length.metres); },
                        [&](const Text::Angle& angle) { line += 'a' + number(angle.radians); },
                        [&](std::int64_t count) { line += 'n' + std::to_string(count); },
                        [&](const std::vector<Text>& texts) {
                          line += 't';
                          for (const Text& text : texts) pack(text, line);
                        }},
             argument);
  line += kPartEnd;
}

void pack(const Text& text, std::string& line) {
  line += kOpen + clean(text.id()) + kPartEnd;
  for (const Text::Argument& argument : text.arguments()) packArgument(argument, line);
  line += kClose;
}

/// Reads what pack() wrote.
class Unpacker {
 public:
  explicit Unpacker(std::string_view line) : rest_(line) {}

  bool isDone() const { return rest_.empty(); }

  std::optional<Text> text(int depth = 0) {
    if (depth > kDeepest || !take(kOpen)) return std::nullopt;
    const std::optional<std::string_view> id = part();
    if (!id) return std::nullopt;
    std::vector<Text::Argument> arguments;
    while (!take(kClose)) {
      std::optional<Text::Argument> argument = this->argument(depth);
      if (!argument || arguments.size() >= kMostArguments) return std::nullopt;
      arguments.push_back(std::move(*argument));
    }
    if (id->empty()) return Text();
    return Text::received(*id, std::move(arguments));
  }

 private:
  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  std::optional<std::string_view> part() {
    const std::size_t end = rest_.find(kPartEnd);
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view words = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    if (hasControls(words)) return std::nullopt;
    return words;
  }

  std::optional<Text::Argument> argument(int depth) {
    if (rest_.empty()) return std::nullopt;
    const char kind = rest_.front();
    rest_.remove_prefix(1);
    if (kind == 't') return texts(depth);
    const std::optional<std::string_view> words = part();
    if (!words) return std::nullopt;
    if (kind == 's') return std::string(*words);
    if (kind == 'n') return count(*words);
    double value = 0.0;
    const auto [end, fault] = std::from_chars(words->data(), words->data() + words->size(), value);
    if (fault != std::errc() || end != words->data() + words->size()) return std::nullopt;
    if (kind == 'l' || kind == 'L') return Text::Length{value, kind == 'L'};
    if (kind == 'a') return Text::Angle{value};
    return std::nullopt;
  }

  std::optional<Text::Argument> texts(int depth) {
    std::vector<Text> all;
    while (!take(kPartEnd)) {
      std::optional<Text> one = text(depth + 1);
      if (!one || all.size() >= kMostArguments) return std::nullopt;
      all.push_back(std::move(*one));
    }
    return all;
  }

  static std::optional<Text::Argument> count(std::string_view words) {
    std::int64_t value = 0;
    const auto [end, fault] = std::from_chars(words.data(), words.data() + words.size(), value);
    if (fault != std::errc() || end != words.data() + words.size()) return std::nullopt;
    return value;
  }

  std::string_view rest_;
};

}  // namespace

std::string packed(const Text& text) {
  std::string line;
  pack(text, line);
  return line;
}

std::optional<Text> unpackedText(std::string_view line) {
  Unpacker unpacker(line);
  std::optional<Text> text = unpacker.text();
  if (!unpacker.isDone()) return std::nullopt;
  return text;
}

std::string packed(const Error& error) {
  std::string line;
  for (const Text* part : {&error.place, &error.found, &error.expected, &error.fix}) pack(*part, line);
  return line;
}

std::optional<Error> unpackedError(std::string_view line) {
  Unpacker unpacker(line);
  Error error;
  for (Text* part : {&error.place, &error.found, &error.expected, &error.fix}) {
    std::optional<Text> text = unpacker.text();
    if (!text) return std::nullopt;
    *part = std::move(*text);
  }
  if (!unpacker.isDone()) return std::nullopt;
  return error;
}

}  // namespace hapticell
