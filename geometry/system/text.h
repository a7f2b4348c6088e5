// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace hapticell {

/// A sentence for the user as a value: the English sentence with places %1, %2, ... as its id, and what fills the
/// places.
///
/// Libraries hand out texts; the command line and files show them in plain English by english(), the window in its own
/// language and units (app/style/library_text.h). tools/translations finds the ids of all libraries by the literal in
/// `Text("...")`, `warn("...")` and the members of an Error. A value; any thread. It allocates, so it is not for the
/// force loop.
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
  /// Several texts as one argument are shown with "; " between them.
  using Argument = std::variant<std::string, Length, Angle, std::int64_t, std::vector<Text>>;

  /// Says nothing.
  Text() = default;
  /// A sentence without places. `id` is a literal (its address is kept).
  template <std::size_t kSize>
  Text(const char (&id)[kSize]) : id_(id) {}  // NOLINT(google-explicit-constructor)
  /// A buffer that changes is no id.
  template <std::size_t kSize>
  Text(char (&buffer)[kSize]) = delete;
  explicit Text(const char* id) : id_(id) {}
  /// With a place for each argument: a string, Length, Angle, a whole number, or another Text.
  template <typename First, typename... Rest>
  explicit Text(const char* id, First&& first, Rest&&... rest) : id_(id) {
    arguments_.reserve(1 + sizeof...(rest));
    arguments_.push_back(argumentOf(std::forward<First>(first)));
    (arguments_.push_back(argumentOf(std::forward<Rest>(rest))), ...);
  }
  /// Words that are not translated: a name, what the system or a foreign library says.
  Text(std::string words);  // NOLINT(google-explicit-constructor)
  static Text plain(std::string words) { return Text(std::move(words)); }
  /// With an id that came from another process. The ids are kept for good, so their number is limited: beyond it the
  /// text is plain English.
  static Text received(std::string_view id, std::vector<Argument> arguments);

  bool empty() const { return id_.empty(); }
  std::string_view id() const { return id_; }
  const std::vector<Argument>& arguments() const { return arguments_; }
  bool operator==(const Text&) const = default;

 private:
  template <typename T>
  static Argument argumentOf(T&& value) {
    using Value = std::remove_cvref_t<T>;
    if constexpr (std::is_same_v<Value, Text>) {
      return std::vector<Text>{std::forward<T>(value)};
    } else if constexpr (std::is_integral_v<Value>) {
      static_assert(!std::is_same_v<Value, bool> && !std::is_same_v<Value, char>);
      return static_cast<std::int64_t>(value);
    } else if constexpr (std::is_convertible_v<T&&, std::string_view> && !std::is_same_v<Value, std::string>) {
      return std::string(std::string_view(value));
    } else {
      return Argument(std::forward<T>(value));
    }
  }

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
