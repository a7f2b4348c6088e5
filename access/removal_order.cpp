// SPDX-License-Identifier: Apache-2.0
#include "access/removal_order.h"

#include <bit>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace hapticell::access {

namespace {

/// Sets of units that are looked at: some seconds. Half: rarely a longer order; twice: twice the wait.
constexpr std::size_t kMostNodes = 200'000;

UnitSet only(std::size_t unit) {
  return UnitSet{1} << unit;
}

/// Takes units of `among` away as long as one can go, the lowest number first; `last` only when nothing else can.
std::vector<std::size_t> peeled(UnitSet among, std::size_t last, const Alternatives& alternatives) {
  std::vector<std::size_t> order;
  UnitSet gone = 0;
  const auto can = [&](std::size_t unit) {
    for (const UnitSet needs : alternatives(unit))
      if ((needs & ~gone) == 0) return true;
    return false;
  };
  for (bool found = true; found && among != 0;) {
    found = false;
    for (UnitSet left = among & ~only(last); left != 0 && !found; left &= left - 1) {
      const auto unit = static_cast<std::size_t>(std::countr_zero(left));
      if (!can(unit)) continue;
      order.push_back(unit);
      gone |= only(unit);
      among &= ~only(unit);
      found = true;
    }
    if (!found && (among & only(last)) != 0 && can(last)) {
      order.push_back(last);
      return order;
    }
  }
  return order;
}

/// What must go is known of all units in `settled`.
struct Node {
  int cost = 0;
  UnitSet needed = 0, settled = 0;
  auto key() const { return std::tuple(cost, needed, settled); }
  bool operator>(const Node& other) const { return key() > other.key(); }
};

}  // namespace

std::optional<RemovalOrder> removalOrder(std::size_t count, std::size_t wanted, const Alternatives& alternatives) {
  std::priority_queue<Node, std::vector<Node>, std::greater<>> open;
  std::set<std::pair<UnitSet, UnitSet>> seen;
  open.push({1, only(wanted), 0});
  for (std::size_t nodes = 0; !open.empty() && nodes < kMostNodes; ++nodes) {
    const Node node = open.top();
    open.pop();
    const UnitSet left = node.needed & ~node.settled;
    if (left == 0) {
      auto order = peeled(node.needed, wanted, alternatives);
      if (order.size() == static_cast<std::size_t>(node.cost)) return RemovalOrder{std::move(order), true};
      continue;  // They wait for each other.
    }
    const auto unit = static_cast<std::size_t>(std::countr_zero(left));
    for (const UnitSet needs : alternatives(unit)) {
      const UnitSet needed = node.needed | needs, settled = node.settled | only(unit);
      if (seen.emplace(needed, settled).second) open.push({std::popcount(needed), needed, settled});
    }
  }
  if (open.empty()) return std::nullopt;
  const UnitSet all = count >= 64 ? ~UnitSet{0} : only(count) - 1;
  auto order = peeled(all, wanted, alternatives);
  if (order.empty() || order.back() != wanted) return std::nullopt;
  // Without those that nobody needs.
  UnitSet kept = all;
  for (const std::size_t unit : std::vector<std::size_t>(order)) {
    if (unit == wanted) continue;
    const auto shorter = peeled(kept & ~only(unit), wanted, alternatives);
    if (shorter.empty() || shorter.back() != wanted) continue;
    kept &= ~only(unit);
    order = shorter;
  }
  return RemovalOrder{std::move(order), false};
}

}  // namespace hapticell::access
