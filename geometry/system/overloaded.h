// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell {

/// Combines several function objects into one for std::visit, one for each alternative. If none of them accepts every
/// type, the compiler reports each place where a new alternative is not handled.
template <typename... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace hapticell
