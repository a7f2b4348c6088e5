// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/subcommand.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "workcell/text/text_cursor.h"

namespace hapticell::cli {

namespace {

/// Decimal digits of a number that a T holds. CLI11 reads "-1" as a huge number where T has no sign, and "010" as 8.
template <class T>
CLI::Validator wholeNumber() {
  return CLI::Validator(
      [](std::string& text) {
        const bool has_sign = !text.empty() && (text[0] == '+' || (std::is_signed_v<T> && text[0] == '-'));
        const bool whole = text.size() > (has_sign ? 1U : 0U) &&
                           text.find_first_not_of("0123456789", has_sign ? 1 : 0) == std::string::npos;
        if (!whole)
          return "'" + text + "' found, a whole number " + (std::is_signed_v<T> ? "" : "from 0 ") + "expected";
        T value{};
        const char* const begin = text.data() + (text[0] == '+' ? 1 : 0);
        if (std::from_chars(begin, text.data() + text.size(), value).ec != std::errc())
          return "'" + text + "' found, a whole number nearer to 0 expected";
        text = std::to_string(value);
        return std::string();
      },
      "");
}

}  // namespace

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::takes(ValueKind kind) {
  option_->type_name(std::string(wordsOf(kind).word));
  return *this;
}

Option& Option::within(double least, double greatest) {
  char words[80];
  std::snprintf(words, sizeof words, "a number from %g to %g", least, greatest);
  option_->check(CLI::Validator(
      [=, expected = std::string(words)](std::string& text) {
        const auto value = workcell::parseNumber(text);
        const bool good = value && std::isfinite(*value) && *value >= least && *value <= greatest;
        return good ? std::string() : "'" + text + "' found, " + expected + " expected";
      },
      words));
  return *this;
}

Option& Option::withinWhole(int least, int greatest) {
  option_->check(CLI::Range(least, greatest));
  return *this;
}

Option& Option::among(std::initializer_list<const char*> words) {
  option_->check(CLI::IsMember(std::vector<std::string>(words.begin(), words.end())));
  return *this;
}

Option& Option::separatedByCommas() {
  option_->delimiter(',');
  return *this;
}

Option& Option::values(int count) {
  return values(count, count);
}

Option& Option::values(int least, int most) {
  option_->expected(least, most);
  return *this;
}

Option& Option::oneAtATime() {
  option_->allow_extra_args(false);
  return *this;
}

Option& Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}

Subcommand Subcommand::add(const std::string& name, const std::string& description) {
  return Subcommand(*app_->add_subcommand(name, description));
}

void Subcommand::mustGoOn() {
  app_->require_subcommand(1);
}

template <class T>
Option Subcommand::option(const std::string& names, T& value, const std::string& description) {
  CLI::Option* const option = app_->add_option(names, value, description);
  if constexpr (std::is_same_v<T, std::size_t>) option->transform(wholeNumber<std::size_t>());
  if constexpr (std::is_same_v<T, int> || std::is_same_v<T, std::optional<int>>) option->transform(wholeNumber<int>());
  return Option(option);
}

Option Subcommand::flag(const std::string& names, bool& value, const std::string& description) {
  return Option(app_->add_flag(names, value, description));
}

void Subcommand::onChosen(std::function<void()> call) {
  app_->callback(std::move(call));
}

// What options may be.
template Option Subcommand::option(const std::string&, double&, const std::string&);
template Option Subcommand::option(const std::string&, int&, const std::string&);
template Option Subcommand::option(const std::string&, std::size_t&, const std::string&);
template Option Subcommand::option(const std::string&, std::string&, const std::string&);
template Option Subcommand::option(const std::string&, std::optional<double>&, const std::string&);
template Option Subcommand::option(const std::string&, std::optional<int>&, const std::string&);
template Option Subcommand::option(const std::string&, std::optional<std::string>&, const std::string&);
template Option Subcommand::option(const std::string&, std::vector<double>&, const std::string&);
template Option Subcommand::option(const std::string&, std::vector<std::string>&, const std::string&);

}  // namespace hapticell::cli
