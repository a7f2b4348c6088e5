// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::test {

/// DDS domains of the tests that run beside each other: two that share one would hear each other's robots.
/// bridge.ros2_with_another_dds takes 85 to 98, tests/bridge/ros2/private_domain.h takes 83.
constexpr int kWindowDomain = 71;
constexpr int kPicturesDomain = 72;

}  // namespace hapticell::test
