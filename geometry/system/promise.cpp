// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/promise.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "geometry/system/assertion.h"

namespace hapticell {

namespace {

/// Four digits, with '.' whatever the locale.
std::string fewDigits(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4);
  return {text.data(), end.ptr};
}

Text withUnit(double value, const std::string& unit) {
  if (unit.empty()) return Text("%1 of the limit", fewDigits(value));
  return fewDigits(value) + ' ' + unit;
}

/// By which share of what was asked the promise is missed. Infinite for a measurement that is no number.
double missedBy(const Promise& promise) {
  if (std::isnan(promise.measured)) return std::numeric_limits<double>::infinity();
  const double excess = promise.is_at_least ? promise.asked - promise.measured : promise.measured - promise.asked;
  return excess / std::max(std::abs(promise.asked), 1e-300);
}

}  // namespace

bool Promise::isKept() const {
  if (std::isnan(measured)) return false;
  return is_at_least ? measured >= asked - rounding : measured <= asked + rounding;
}

bool Promises::areKept() const {
  return worst() == nullptr;
}

const Promise* Promises::worst() const {
  const Promise* worst = nullptr;
  for (const Promise& promise : list) {
    if (promise.isKept()) continue;
    if (worst == nullptr || missedBy(promise) > missedBy(*worst)) worst = &promise;
  }
  return worst;
}

Error Promises::missed(const std::string& file) const {
  const Promise* promise = worst();
  HAPTICELL_DEMAND(promise != nullptr);
  const Text asked = withUnit(promise->asked, promise->unit);
  const Text unwritten = can_be_forced ? Text("Nothing was written. To write the file anyway, use --allow-miss.")
                                       : Text("Nothing was written.");
  const Text found = promise->found.empty() ? Text("%1 %2", promise->name, withUnit(promise->measured, promise->unit))
                                            : promise->found;
  const Text limit = promise->is_at_least ? Text("at least %1", asked) : Text("at most %1", asked);
  return {.file = file,
          .place = promise->place,
          .found = found,
          .expected = promise->expected.empty() ? limit : promise->expected,
          .fix = help.empty() ? unwritten : Text("%1 %2", help, unwritten)};
}

}  // namespace hapticell
