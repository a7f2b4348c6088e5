// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell {

/// One function object of several, for std::visit: one function for each alternative. Without one that takes anything
/// the compiler names every place that a new alternative must be thought of.
template <typename... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace hapticell
