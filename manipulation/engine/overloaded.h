// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::manipulation {

/// Several handlers as one, for std::visit.
template <typename... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <typename... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

}  // namespace hapticell::manipulation
