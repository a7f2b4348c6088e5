// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): not ours.
class App;
}

namespace hapticell::cli {

/// What may stand in place of the last of these words of a command line (it may be empty; the program's name is not
/// among them), a line each: the word and, after a tabulator, what it means. ":files ENDING..." stands for the files
/// with these endings (without any: all), ":folders" for folders. What does not begin as the last word does is listed
/// too; the shell leaves it out.
std::vector<std::string> completions(const CLI::App& app, const std::vector<std::string>& words);

/// `hapticell-cli completion WORD...`: writes the script that teaches a shell (bash, zsh, fish) these completions, or,
/// for "words", the completions of the words that follow. The process's exit status.
int runCompletion(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace hapticell::cli
