// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace hapticell {

/// "a, b, c" of texts, or of what `text_of` (a function, or a pointer to a member) says of each item.
template <typename Items, typename TextOf = std::identity>
std::string listed(const Items& items, const TextOf& text_of = {}) {
  std::string list;
  for (const auto& item : items) {
    if (!list.empty()) list += ", ";
    list += std::invoke(text_of, item);
  }
  return list;
}

}  // namespace hapticell
