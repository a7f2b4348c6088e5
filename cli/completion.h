// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): not ours.
class App;
}

namespace hapticell::cli {

/// The possible completions of the last of these words of a command line (which may be empty; the program's name is not
/// included), one per line: the word and, after a tab, its meaning. ":files ENDING..." stands for the files with these
/// extensions (without any: all), ":folders" for folders. Also lists words that do not begin like the last word; the
/// shell leaves them out.
std::vector<std::string> completions(const CLI::App& app, const std::vector<std::string>& words);

/// `hapticell-cli completion WORD...`: writes the script that teaches a shell (bash, zsh, fish) these completions, or,
/// for "words", the completions of the words that follow. Returns the process's exit status.
int runCompletion(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace hapticell::cli
