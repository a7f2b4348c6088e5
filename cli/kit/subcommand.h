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

/// One option or positional word of a command, to say what may be given for it. A handle of CLI11's own, which lives as
/// long as the command line; copied like a pointer. Words that break a rule end the command with a sentence.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required();
  /// What its word names.
  Option& takes(ValueKind kind);
  /// A number within these, both included, and no "nan", which CLI11's own range lets through.
  Option& within(double least, double greatest);
  /// A whole number within these, both included.
  Option& withinWhole(int least, int greatest);
  Option& among(std::initializer_list<const char*> words);
  /// Several values in one word, with commas between.
  Option& separatedByCommas();
  /// Exactly so many values; `least` to `most` of them.
  Option& values(int count);
  Option& values(int least, int most);
  /// May be repeated, each time with one value: what follows is not taken for a second one.
  Option& oneAtATime();
  /// Not together with the other.
  Option& excludes(const Option& other);

 private:
  CLI::Option* option_;
};

/// A command of hapticell-cli, or a word below one. A handle of CLI11's own, like Option.
///
/// CLI11's headers are seen by two sources only: they are most of what each command would take to compile.
class Subcommand {
 public:
  explicit Subcommand(CLI::App& app) : app_(&app) {}

  /// A word below this one.
  Subcommand add(const std::string& name, const std::string& description);
  /// One of the words below must follow.
  void mustGoOn();
  /// `names`: "--long", "-s,--long", or a word without dashes for a positional one. `value` keeps what it is where the
  /// option is not given, and must live until the command has run. For what is a T: subcommand.cpp, at the end.
  template <class T>
  Option option(const std::string& names, T& value, const std::string& description);
  Option flag(const std::string& names, bool& value, const std::string& description);
  /// Called once all words were read, when this is the command that was chosen.
  void onChosen(std::function<void()> call);

 private:
  CLI::App* app_;
};

}  // namespace hapticell::cli
