// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/name_levels.h"

#include <utility>
#include <vector>

namespace hapticell::workcell {

Levels levelsOf(const std::unordered_map<std::string, std::string>& above, int most) {
  Levels result;
  std::unordered_map<std::string, int> levels;  // 0: on the way that is gone.
  for (const auto& [name, ignored] : above) {
    std::vector<const std::string*> way;
    const std::string* at = &name;
    while (above.contains(*at) && levels.try_emplace(*at, 0).second) {
      way.push_back(at);
      at = &above.find(*at)->second;
    }
    const auto known = levels.find(*at);
    if (known != levels.end() && known->second == 0) result.in_circle.insert(*at);
    int level = known == levels.end() ? 0 : known->second;
    for (auto step = way.rbegin(); step != way.rend(); ++step) levels[**step] = ++level;
    if (level > most) result.too_deep = name;
  }
  return result;
}

}  // namespace hapticell::workcell
