// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/system/error.h"

namespace hapticell::haptic {

/// The secret shared by a haptic server and its clients: 128 random bits, written as a code that a person can read out
/// and type. TLS 1.3 uses it as an external pre-shared key (RFC 8446, 4.2.11).
class PairingKey {
 public:
  static constexpr std::size_t kEntropyBytes = 16;
  static constexpr std::size_t kSecretBytes = 32;

  /// A new key from the system's random numbers. Error: these are not available.
  static Expected<PairingKey> make();
  /// Reads a code: letters of any case, with or without dashes and blanks; O is read as 0, I and L as 1 (Crockford's
  /// base 32). Errors: other characters, a wrong length, a wrong checksum (a mistyped character).
  static Expected<PairingKey> parse(std::string_view code);

  /// Seven groups of four characters: the entropy and 12 bits of checksum. Anyone who has the code can control the
  /// stylus.
  std::string code() const;
  /// Identifies the key without revealing it; sent unencrypted at the beginning of a connection.
  std::string identity() const;
  /// The key for TLS: SHA-256 of the entropy with a label.
  std::array<std::uint8_t, kSecretBytes> secret() const;

  friend bool operator==(const PairingKey&, const PairingKey&) = default;

 private:
  explicit PairingKey(const std::array<std::uint8_t, kEntropyBytes>& entropy) : entropy_(entropy) {}
  std::array<std::uint8_t, kEntropyBytes> entropy_;
};

/// The file of the server's own key: server.key in config::userSettingsFolder(). If that folder is unknown, this and
/// the path below are empty, and saveKey() and loadKey() give the reason.
std::filesystem::path serverKeyFile();
/// The file of a client's key for the server at host:port: hapticell/servers/HOST_PORT.key in the same folder.
/// Characters that a host name cannot have become '_'.
std::filesystem::path knownServerKeyFile(std::string_view host, std::uint16_t port);

/// Writes the code, readable by this user only (0600), replacing an older file. Errors name the file.
Expected<void> saveKey(const PairingKey& key, const std::filesystem::path& file);
/// Errors: the file does not exist, has no valid code, or others may read or write it or its folder.
Expected<PairingKey> loadKey(const std::filesystem::path& file);

}  // namespace hapticell::haptic
