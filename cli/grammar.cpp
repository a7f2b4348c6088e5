// SPDX-License-Identifier: Apache-2.0
#include "cli/grammar.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <string>
#include <vector>

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

/// The words between braces in what help says of an option's value.
std::vector<std::string> choicesOf(const std::string& type) {
  std::vector<std::string> words;
  const std::size_t open = type.find('{'), close = type.find('}', open);
  if (open == std::string::npos || close == std::string::npos) return words;
  for (std::size_t from = open + 1; from < close;) {
    const std::size_t to = std::min(type.find(',', from), close);
    words.push_back(type.substr(from, to - from));
    from = to + 1;
  }
  return words;
}

std::string nameOf(const CLI::Option& option) {
  if (!option.get_lnames().empty()) return "--" + option.get_lnames().front();
  if (!option.get_snames().empty()) return "-" + option.get_snames().front();
  return option.get_name();
}

/// CLI11's word for no limit is a large number.
int mostOf(const CLI::Option& option) {
  constexpr int kMany = 1 << 20;
  return option.get_items_expected_max() >= kMany ? -1 : option.get_items_expected_max();
}

ordered_json optionJson(const CLI::Option& option) {
  const bool flag = option.get_items_expected_max() == 0;
  const std::string kind = flag ? std::string() : option.get_type_name();
  const char separator = option.get_delimiter();
  const bool repeated = !flag && mostOf(option) != 1 && !option.get_allow_extra_args();
  return {{"name", nameOf(option)},
          {"kind", kind.substr(0, kind.find(':'))},
          {"positional", option.get_positional() && option.get_lnames().empty()},
          {"required", option.get_required()},
          {"flag", flag},
          {"values", {option.get_items_expected_min(), mostOf(option)}},
          {"repeated", repeated},
          {"separator", separator == '\0' ? std::string() : std::string(1, separator)},
          {"choices", choicesOf(option.get_type_name())},
          {"description", option.get_description()}};
}

}  // namespace

ordered_json grammarOf(const CLI::App& app) {
  ordered_json commands = ordered_json::array();
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    ordered_json options = ordered_json::array();
    for (const CLI::Option* option : command->get_options()) {
      if (option != command->get_help_ptr()) options.push_back(optionJson(*option));
    }
    const bool runs = command->get_require_subcommand_min() == 0;
    commands.push_back({{"name", command->get_name()},
                        {"description", command->get_description()},
                        {"runs", runs},
                        {"options", std::move(options)},
                        {"commands", grammarOf(*command)}});
  }
  return commands;
}

}  // namespace hapticell::cli
