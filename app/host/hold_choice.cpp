// SPDX-License-Identifier: Apache-2.0
#include "app/host/hold_choice.h"

#include "geometry/system/overloaded.h"

namespace hapticell::app {

HoldChoice::MovedBy HoldChoice::withOptions(const MovedBy& way) const {
  return std::visit(Overloaded{
                        [&](const by::Default&) { return MovedBy(by::Default{.tool = tool_}); },
                        [&](const by::Tool&) { return MovedBy(tool_); },
                        [&](const by::Base&) {
                          return MovedBy(by::Base{keeps_tool_, tool_.at_singularity});
                        },
                        [](const by::Origin& origin) { return MovedBy(origin); },
                        [](const by::Center& center) { return MovedBy(center); },
                        [&](const by::Frame& frame) {
                          return MovedBy(by::Frame{frame.name, tool_.at_singularity});
                        },
                        [](const by::Whole& whole) { return MovedBy(whole); },
                        [&](const by::Hand& hand) {
                          return MovedBy(by::Hand{hand.side, hands_.may_step, hands_.locks});
                        },
                        [&](const by::BothHands&) { return MovedBy(hands_); },
                        [&](const by::Head&) { return MovedBy(by::Head{hands_.locks}); },
                    },
                    way);
}

}  // namespace hapticell::app
