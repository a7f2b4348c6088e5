// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/peer_process.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

namespace hapticell::haptic {

namespace {

namespace fs = std::filesystem;

constexpr unsigned long kExiting = 0x4;  // PF_EXITING of the kernel's task flags.

bool isLoopback(std::string_view hex_address) {
  if (hex_address.size() == 8)
    return hex_address.substr(6) == "7F";  // Bytes of the address from the last to the first.
  return hex_address == "00000000000000000000000001000000" ||
         (hex_address.starts_with("0000000000000000FFFF0000") && hex_address.ends_with("7F"));
}

/// "0100007F:D0A4": true when it is a loopback address with that port.
bool isHere(std::string_view entry, unsigned port) {
  const std::size_t colon = entry.find(':');
  if (colon == std::string_view::npos) return false;
  unsigned value = 0;
  std::from_chars(entry.data() + colon + 1, entry.data() + entry.size(), value, 16);
  return value == port && isLoopback(entry.substr(0, colon));
}

/// The inode of the socket that is bound to `from` and connected to `to`, both here; empty: not found.
std::string socketInode(const char* table, unsigned from, unsigned to) {
  std::ifstream file(table);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string slot, local, remote, state, queues, timer, retries, user, timeout, inode;
    if (!(words >> slot >> local >> remote >> state >> queues >> timer >> retries >> user >> timeout >> inode))
      continue;
    if (state == "01" && inode != "0" && isHere(local, from) && isHere(remote, to)) return inode;
  }
  return {};
}

bool holds(const fs::path& process, const std::string& socket) {
  std::error_code failed;
  for (fs::directory_iterator entry(process / "fd", failed), end; !failed && entry != end; entry.increment(failed)) {
    std::error_code gone;
    if (fs::read_symlink(entry->path(), gone) == socket) return true;
  }
  return false;
}

/// A thread that is ending, or has ended: it runs no more of its program.
bool isEnding(const fs::path& stat) {
  std::ifstream file(stat);
  std::string text;
  if (!std::getline(file, text)) return true;
  const std::size_t name_end = text.rfind(')');  // The name may hold anything.
  if (name_end == std::string::npos) return false;
  std::istringstream words(text.substr(name_end + 1));
  std::string state, skipped;
  words >> state;
  if (state == "Z" || state == "X") return true;
  for (int i = 0; i < 5; ++i) words >> skipped;
  unsigned long flags = 0;
  words >> flags;
  return words && (flags & kExiting) != 0;
}

}  // namespace

std::optional<PeerProcess> PeerProcess::find(const std::string& client, std::uint16_t server_port) {
  const std::size_t colon = client.rfind(':');
  if (colon == std::string::npos) return std::nullopt;
  const auto port = static_cast<unsigned>(std::strtoul(client.c_str() + colon + 1, nullptr, 10));
  std::string inode = socketInode("/proc/net/tcp", port, server_port);
  if (inode.empty()) inode = socketInode("/proc/net/tcp6", port, server_port);
  if (inode.empty()) return std::nullopt;
  const std::string socket = "socket:[" + inode + "]";
  std::error_code failed;
  for (fs::directory_iterator entry("/proc", failed), end; !failed && entry != end; entry.increment(failed)) {
    const std::string name = entry->path().filename();
    if (!std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; })) continue;
    if (holds(entry->path(), socket)) return PeerProcess(static_cast<pid_t>(std::atoi(name.c_str())));
  }
  return std::nullopt;
}

bool PeerProcess::isDying() const {
  const fs::path process = fs::path("/proc") / std::to_string(id_);
  if (!isEnding(process / "stat")) return false;
  // Its first thread may have ended while others go on.
  std::error_code failed;
  for (fs::directory_iterator entry(process / "task", failed), end; !failed && entry != end; entry.increment(failed)) {
    if (!isEnding(entry->path() / "stat")) return false;
  }
  return true;
}

}  // namespace hapticell::haptic
