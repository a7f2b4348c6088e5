// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <initializer_list>
#include <string>

#include "cli/kit/value_kind.h"

namespace CLI {  // NOLINT(readability-identifier-naming): not ours.
class App;
class Option;
}  // namespace CLI

namespace hapticell::cli {

/// One option or positional word of a command, for setting its rules. A handle of CLI11, valid as long as the command
/// line; copied like a pointer. Words that break a rule end the command with a sentence.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required();
  /// Kind of value that its word names.
  Option& takes(ValueKind kind);
  /// A number between these, both included; rejects "nan", which CLI11's own range accepts.
  Option& within(double least, double greatest);
  /// A whole number between these, both included.
  Option& withinWhole(int least, int greatest);
  Option& among(std::initializer_list<const char*> words);
  /// Several values in one word, separated by commas.
  Option& separatedByCommas();
  /// Exactly `count` values, or `least` to `most`.
  Option& values(int count);
  Option& values(int least, int most);
  /// May be repeated, each time with one value: the next word is not taken as a second value.
  Option& oneAtATime();
  /// Must not be given together with the other one.
  Option& excludes(const Option& other);

 private:
  CLI::Option* option_;
};

/// A command of hapticell-cli, or a sub-command. A handle of CLI11, like Option.
///
/// Only two sources include CLI11's headers, because these would dominate the time to compile each command.
class Subcommand {
 public:
  explicit Subcommand(CLI::App& app) : app_(&app) {}

  /// Adds a sub-command.
  Subcommand add(const std::string& name, const std::string& description);
  /// Requires one of the sub-commands.
  void mustGoOn();
  /// `names`: "--long", "-s,--long", or a word without dashes for a positional argument. `value` does not change if the
  /// option is not given, and must exist until the command has run. Whole numbers are decimal, and not below 0 for
  /// std::size_t. Allowed types T: end of subcommand.cpp.
  template <class T>
  Option option(const std::string& names, T& value, const std::string& description);
  Option flag(const std::string& names, bool& value, const std::string& description);
  /// Called after all words were read, if this command was chosen.
  void onChosen(std::function<void()> call);

 private:
  CLI::App* app_;
};

}  // namespace hapticell::cli
