// SPDX-License-Identifier: Apache-2.0
#include "access/access_answer.h"

#include <algorithm>
#include <bit>
#include <map>

#include "access/planned_way.h"
#include "access/removal_order.h"
#include "geometry/system/in_parallel.h"

namespace hapticell::access {

namespace {

class Asking {
 public:
  Asking(const AccessQuestion& question, const std::function<void(double)>& progress, const std::atomic<bool>& cancel)
      : question_(question), progress_(progress), cancel_(cancel) {}

  Expected<AccessAnswer> run() {
    auto made = RemovalScene::make(question_.scene, question_.part, question_.within, question_.tolerance);
    HAPTICELL_TRY(made);
    answer_.removal = std::make_shared<const RemovalScene>(std::move(*made));
    report(0.1);
    answer_.ways = waysOf(0);
    for (const std::size_t unit : overlappingAtRest(scene(), 0)) answer_.overlaps.push_back(scene().units()[unit].name);
    HAPTICELL_TRY(order());
    report(0.5);
    for (RemovalStep& step : answer_.order) {
      if (!cancel_) step.clearances = access::clearances(scene(), step.unit, step.gone, step.way);
    }
    report(0.6);
    askPeople();
    answer_.is_complete = !cancel_;
    report(1.0);
    return std::move(answer_);
  }

 private:
  const RemovalScene& scene() const { return *answer_.removal; }
  void report(double share) const {
    if (progress_) progress_(share);
  }

  const std::vector<StraightWay>& waysOf(std::size_t unit) {
    const auto known = ways_.find(unit);
    if (known != ways_.end()) return known->second;
    return ways_.emplace(unit, cancel_ ? std::vector<StraightWay>() : straightWays(scene(), unit)).first->second;
  }

  const std::vector<UnitSet>& needsOf(std::size_t unit) {
    const auto known = needs_.find(unit);
    if (known != needs_.end()) return known->second;
    std::vector<UnitSet> needs;
    for (const StraightWay& way : waysOf(unit))
      if (way.fixed.empty()) needs.push_back(way.blockers);
    return needs_.emplace(unit, std::move(needs)).first->second;
  }

  Expected<void> order() {
    const auto found =
        removalOrder(scene().movableCount(), 0, [this](std::size_t unit) -> const auto& { return needsOf(unit); });
    const bool free = found && found->units.size() == 1;
    if (question_.shown) {
      HAPTICELL_TRY(takeShown(found ? found->units : std::vector<std::size_t>{0}));
    } else if (free) {
      addSteps(found->units);
    } else if (auto bent = cancel_ ? std::nullopt : bentWay(scene(), 0, 0)) {
      answer_.order.push_back({0, question_.part, 0, std::move(*bent)});
    } else if (found) {
      addSteps(found->units);
      answer_.is_shortest = found->is_shortest;
    } else if (auto planned = plannedWay(scene(), 0, 0, cancel_)) {
      answer_.order.push_back({0, question_.part, 0, std::move(*planned)});
    } else {
      wayAfterOthers();
    }
    answer_.removable = answer_.order.size() == 1;
    if (!answer_.removable) tellBlockers();
    return {};
  }

  /// Each unit leaves by its shortest way that the ones before it have freed.
  void addSteps(const std::vector<std::size_t>& units) {
    UnitSet gone = 0;
    for (const std::size_t unit : units) {
      const StraightWay* best = nullptr;
      for (const StraightWay& way : waysOf(unit)) {
        if (!way.fixed.empty() || (way.blockers & ~gone) != 0) continue;
        if (best == nullptr || way.length < best->length) best = &way;
      }
      if (best == nullptr) return;
      answer_.order.push_back({unit, scene().units()[unit].name, gone,
                               straightAsWay(scene(), unit, best->direction_W, best->length)});
      gone |= UnitSet{1} << unit;
    }
  }

  Expected<void> takeShown(const std::vector<std::size_t>& units) {
    auto way = checkedWay(scene(), 0, 0, *question_.shown);
    if (way) {
      answer_.order.push_back({0, question_.part, 0, std::move(*way)});
      return {};
    }
    if (units.size() < 2) return tl::unexpected(way.error());
    addSteps(units);
    if (answer_.order.empty() || answer_.order.back().unit != 0) return tl::unexpected(way.error());
    way = checkedWay(scene(), 0, answer_.order.back().gone, *question_.shown);
    HAPTICELL_TRY(way);
    answer_.order.back().way = std::move(*way);
    return {};
  }

  /// All others go as long as one can; then those that a bent or planned way does not
  /// need stay.
  void wayAfterOthers() {
    std::vector<std::size_t> went;
    UnitSet gone = 0;
    const auto can = [&](std::size_t unit) {
      const auto& needs = needsOf(unit);
      return std::any_of(needs.begin(), needs.end(), [&](UnitSet one) { return (one & ~gone) == 0; });
    };
    for (bool found = true; found && !cancel_;) {
      found = false;
      for (std::size_t unit = 1; unit < scene().movableCount(); ++unit) {
        if ((gone >> unit & 1) != 0 || !can(unit)) continue;
        went.push_back(unit);
        gone |= UnitSet{1} << unit;
        found = true;
      }
    }
    if (cancel_ || went.empty()) return;
    auto way = bentWay(scene(), 0, gone);
    if (!way) way = plannedWay(scene(), 0, gone, cancel_);
    if (!way) return;
    // From the last that went: what is not in the way stays, if nothing that goes needs it to go.
    UnitSet needed = gone;
    for (auto unit = went.rbegin(); unit != went.rend(); ++unit) {
      const UnitSet without = needed & ~(UnitSet{1} << *unit);
      UnitMotion motion(scene(), 0, without);
      bool free = true;
      for (std::size_t i = 1; free && i < way->X_WE.size(); ++i)
        free = motion.advance(way->X_WE[i - 1], way->X_WE[i]) >= 1.0;
      if (free && canAllGo(without, went)) needed = without;
    }
    std::vector<std::size_t> order;
    for (const std::size_t unit : went)
      if ((needed >> unit & 1) != 0) order.push_back(unit);
    addSteps(order);
    if (answer_.order.size() != order.size()) {
      answer_.order.clear();
      return;
    }
    answer_.order.push_back({0, question_.part, needed, std::move(*way)});
    answer_.is_shortest = false;
  }

  bool canAllGo(UnitSet units, const std::vector<std::size_t>& order) {
    UnitSet gone = 0;
    for (const std::size_t unit : order) {
      if ((units >> unit & 1) == 0) continue;
      const auto& needs = needsOf(unit);
      if (!std::any_of(needs.begin(), needs.end(), [&](UnitSet one) { return (one & ~gone) == 0; })) return false;
      gone |= UnitSet{1} << unit;
    }
    return true;
  }

  void tellBlockers() {
    if (answer_.ways.empty()) return;
    const StraightWay& way = answer_.ways.front();
    for (UnitSet left = way.blockers; left != 0; left &= left - 1)
      answer_.blocked_by.push_back(scene().units()[static_cast<std::size_t>(std::countr_zero(left))].name);
    for (const std::size_t unit : way.fixed) answer_.blocked_by.push_back(scene().units()[unit].name);
  }

  void askPeople() {
    const RemovalStep* step = answer_.step();
    if (step == nullptr) return;
    const auto& bodies = question_.people.bodies;
    std::vector<std::vector<BodyAccess>> found(bodies.size());
    geometry::inRanges(bodies.size(), geometry::rangesOf(bodies.size(), 1),
                       [&](std::size_t, std::size_t begin, std::size_t end) {
                         for (std::size_t i = begin; i < end; ++i) {
                           BodyQuestion one = question_.people;
                           one.bodies = {bodies[i]};
                           found[i] = bodyAccess(scene(), 0, step->gone, step->way, one, cancel_);
                         }
                       });
    for (auto& some : found)
      for (BodyAccess& body : some) answer_.people.push_back(std::move(body));
  }

  const AccessQuestion& question_;
  const std::function<void(double)>& progress_;
  const std::atomic<bool>& cancel_;
  AccessAnswer answer_;
  std::map<std::size_t, std::vector<StraightWay>> ways_;
  std::map<std::size_t, std::vector<UnitSet>> needs_;
};

}  // namespace

const NeighbourClearance* AccessAnswer::nearest() const {
  const RemovalStep* last = step();
  if (last == nullptr) return nullptr;
  const auto found = std::find_if(last->clearances.begin(), last->clearances.end(),
                                  [](const auto& one) { return one.least_m < std::numeric_limits<double>::infinity(); });
  return found == last->clearances.end() ? nullptr : &*found;
}

Expected<AccessAnswer> accessOf(const AccessQuestion& question, const std::function<void(double)>& progress,
                                const std::atomic<bool>& cancel) {
  return Asking(question, progress, cancel).run();
}

}  // namespace hapticell::access
