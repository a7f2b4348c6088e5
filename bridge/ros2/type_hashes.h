// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace hapticell::bridge {

/// The type hash (RIHS01, REP 2011) of a topic of ros2_messages.idl, "RIHS01_" with 64 hexadecimal digits, by the name
/// that DDS has for its type ("std_msgs::msg::dds_::String_"). Requests and responses have that of their service. Empty:
/// not one of these types.
std::string_view typeHash(std::string_view dds_type);

}  // namespace hapticell::bridge
