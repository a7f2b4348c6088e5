// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

namespace CLI {  // NOLINT(readability-identifier-naming): not ours.
class App;
}

namespace hapticell::cli {

/// The commands below `app` as data, for programs that offer each of them (python/): a list of `name`, `description`,
/// `runs` (false: one of its own commands must follow), `options` and `commands` (the same again). An option has
/// `name` ("--tip", or "file" for a positional word), `kind` (the word of its ValueKind, "FLOAT", "TEXT", or empty for a
/// flag), `positional`, `required`, `flag`, `values` (least and most of one time; most is -1 without a limit),
/// `repeated` (may be given several times, a value each time), `separator` (between several values in one word, or
/// empty), `choices` and `description`. Help and --json are left out.
nlohmann::ordered_json grammarOf(const CLI::App& app);

}  // namespace hapticell::cli
