// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace hapticell::access {

/// The items by their keys, the least first; of equal ones the first. Sorts numbers, not items: std::stable_sort of g++ 12
/// spoils the first one of glm vectors (-O3, GLM_FORCE_CTOR_INIT).
template <class Item, class KeyOf>
std::vector<Item> ordered(std::vector<Item> items, const KeyOf& key_of) {
  std::vector<std::pair<decltype(key_of(items[0])), std::size_t>> order;
  for (std::size_t i = 0; i < items.size(); ++i) order.emplace_back(key_of(items[i]), i);
  std::sort(order.begin(), order.end());
  std::vector<Item> sorted;
  for (const auto& one : order) sorted.push_back(std::move(items[one.second]));
  return sorted;
}

}  // namespace hapticell::access
