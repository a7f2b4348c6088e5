// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/system/error.h"

namespace hapticell::haptic {

/// What a haptic server and the clients that may use it have in common: 128 random bits, written as a code that a
/// person can read out and type, and what TLS 1.3 makes of it (RFC 8446, 4.2.11: an external pre-shared key).
class PairingKey {
 public:
  static constexpr std::size_t kEntropyBytes = 16;
  static constexpr std::size_t kSecretBytes = 32;

  /// A new key from the system's source of random numbers. Error: it gives none.
  static Expected<PairingKey> make();
  /// Reads a code: letters of any case, with or without dashes and blanks; O is read as 0, I and L as 1 (Crockford's
  /// base 32). Errors: other signs, a wrong length, a check sum that does not fit (a mistyped sign).
  static Expected<PairingKey> parse(std::string_view code);

  /// Seven groups of four signs: the entropy and 12 bits of check sum. Whoever has it may take the stylus.
  std::string code() const;
  /// Names the key without telling it; sent in the clear at the beginning of a connection.
  std::string identity() const;
  /// What TLS is keyed with: SHA-256 of the entropy under a label.
  std::array<std::uint8_t, kSecretBytes> secret() const;

  friend bool operator==(const PairingKey&, const PairingKey&) = default;

 private:
  explicit PairingKey(const std::array<std::uint8_t, kEntropyBytes>& entropy) : entropy_(entropy) {}
  std::array<std::uint8_t, kEntropyBytes> entropy_;
};

/// Where the server's own key lies: server.key in config::userSettingsFolder(). Empty, as below, where it is not known
/// where that is; saveKey() and loadKey() then say why.
std::filesystem::path serverKeyFile();
/// Where a client keeps the key of the server at host:port: hapticell/servers/HOST_PORT.key in the same place.
/// Signs that are none of a host's name become '_'.
std::filesystem::path knownServerKeyFile(std::string_view host, std::uint16_t port);

/// Writes the code, readable by this user only (0600), in place of what was there. Errors name the file.
Expected<void> saveKey(const PairingKey& key, const std::filesystem::path& file);
/// Errors: no such file, one that others may read or write, or that lies where they may, one that holds no code.
Expected<PairingKey> loadKey(const std::filesystem::path& file);

}  // namespace hapticell::haptic
