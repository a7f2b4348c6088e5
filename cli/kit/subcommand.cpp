// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/subcommand.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "workcell/text/text_cursor.h"

namespace hapticell::cli {

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
  return Option(app_->add_option(names, value, description));
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
