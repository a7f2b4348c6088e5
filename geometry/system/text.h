// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace hapticell {

/// A sentence for the user as a value: the English sentence with places %1, %2, ... as its id, and what fills the
/// places.
///
/// Libraries hand out texts; the command line and files show them in plain English by english(), the window in its own
/// language and units (app/style/library_text.h). tools/translations finds the ids of all libraries by the literal in
/// `Text("...")`. A value; any thread. It allocates, so it is not for the force loop.
class Text {
 public:
  struct Length {
    double metres = 0.0;
    bool whole = false;  ///< In whole millimetres, whatever units are set.
    bool operator==(const Length&) const = default;
  };
  struct Angle {
    double radians = 0.0;
    bool operator==(const Angle&) const = default;
  };
  using Argument = std::variant<std::string, Length, Angle, std::int64_t>;

  /// Says nothing.
  Text() = default;
  /// `id` is a literal (its address is kept), with a place for each argument.
  template <typename... Arguments>
  explicit Text(const char* id, Arguments&&... arguments) : id_(id) {
    arguments_.reserve(sizeof...(arguments));
    (arguments_.emplace_back(std::forward<Arguments>(arguments)), ...);
  }
  /// Words that nobody translates: an error's message, a driver's own sentence.
  static Text plain(std::string words);

  bool empty() const { return id_.empty(); }
  std::string_view id() const { return id_; }
  const std::vector<Argument>& arguments() const { return arguments_; }
  bool operator==(const Text&) const = default;

 private:
  std::string_view id_;
  std::vector<Argument> arguments_;
};

/// "A5 is 1.2 deg from its upper limit": in English, millimetres and degrees.
std::string english(const Text& text);
/// Several, with "; " between them.
std::string english(std::span<const Text> texts);

/// `form` with its places %1 .. %9 filled; a place without a value stays. Values are not looked at for places.
std::string filled(std::string_view form, std::span<const std::string> values);

/// Marks words of a table that are translated where they are shown: tools/translations finds them.
#define HAPTICELL_TRANSLATED(...) __VA_ARGS__

}  // namespace hapticell
