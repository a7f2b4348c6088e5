// SPDX-License-Identifier: Apache-2.0
#include "haptic/transport/pairing_key.h"

#include <openssl/evp.h>
#include <openssl/rand.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <span>

#include "config/user_folders.h"
#include "geometry/system/assertion.h"
#include "geometry/system/atomic_file.h"

namespace hapticell::haptic {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kDigits = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
constexpr std::size_t kSigns = 28;  // 128 bits of entropy and 12 of check sum, five bits a sign.
constexpr std::size_t kGroup = 4;

using Digest = std::array<std::uint8_t, 32>;

Digest digest(std::string_view label, std::span<const std::uint8_t> bytes) {
  std::string text(label);
  text.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  Digest result{};
  unsigned length = 0;
  const int done = EVP_Digest(text.data(), text.size(), result.data(), &length, EVP_sha256(), nullptr);
  HAPTICELL_DEMAND(done == 1 && length == result.size());
  return result;
}

/// The entropy and the first twelve bits of its digest, as 140 bits in 18 bytes.
std::array<std::uint8_t, 18> withCheckSum(std::span<const std::uint8_t> entropy) {
  std::array<std::uint8_t, 18> bits{};
  std::copy(entropy.begin(), entropy.end(), bits.begin());
  const Digest sum = digest("hapticell pairing check", entropy);
  bits[16] = sum[0];
  bits[17] = static_cast<std::uint8_t>(sum[1] & 0xF0);
  return bits;
}

/// The value of a sign of a code; 32: none.
std::size_t valueOf(char sign) {
  char upper = sign >= 'a' && sign <= 'z' ? static_cast<char>(sign - 'a' + 'A') : sign;
  if (upper == 'O') upper = '0';
  if (upper == 'I' || upper == 'L') upper = '1';
  return std::min(kDigits.find(upper), kDigits.size());
}

tl::unexpected<Error> refuseCode(Text found) {
  return makeError({.place = "pairing code",
                    .found = std::move(found),
                    .expected = "28 letters and digits in groups of four, as hapticell-haptic-server --pair shows them",
                    .fix = "Type the code again."});
}

/// The file below the user's settings; empty where it is not known where those are.
fs::path inSettings(const fs::path& name) {
  const auto folder = config::userSettingsFolder();
  return folder ? *folder / name : fs::path();
}

/// Why inSettings() gave no path.
tl::unexpected<Error> nowhere() {
  const auto folder = config::userSettingsFolder();
  return folder ? makeError({.place = "key file", .found = "the name is missing", .expected = "a file name"})
                : makeError(folder.error());
}

tl::unexpected<Error> fileError(const fs::path& file, Text found, Text fix) {
  return makeError({.file = file.string(), .found = std::move(found), .fix = std::move(fix)});
}

}  // namespace

Expected<PairingKey> PairingKey::make() {
  std::array<std::uint8_t, kEntropyBytes> entropy{};
  if (RAND_bytes(entropy.data(), static_cast<int>(entropy.size())) != 1) {
    return makeError(
        {.place = "pairing key", .found = "the system did not provide random numbers", .fix = "Try again."});
  }
  return PairingKey(entropy);
}

Expected<PairingKey> PairingKey::parse(std::string_view code) {
  std::array<std::uint8_t, 18> bits{};
  std::size_t signs = 0;
  for (const char sign : code) {
    if (sign == '-' || sign == ' ' || sign == '\n' || sign == '\r' || sign == '\t') continue;
    const std::size_t value = valueOf(sign);
    if (value == kDigits.size()) return refuseCode(Text("the character '%1'", std::string(1, sign)));
    for (std::size_t bit = 0; bit < 5 && signs < kSigns; ++bit) {
      const std::size_t at = 5 * signs + bit;
      if (value >> (4 - bit) & 1) bits[at / 8] = static_cast<std::uint8_t>(bits[at / 8] | 0x80 >> at % 8);
    }
    ++signs;
  }
  if (signs != kSigns) return refuseCode(Text("%1 characters", signs));
  std::array<std::uint8_t, kEntropyBytes> entropy{};
  std::copy_n(bits.begin(), kEntropyBytes, entropy.begin());
  if (withCheckSum(entropy) != bits) return refuseCode(Text("a typing error (the checksum is wrong)"));
  return PairingKey(entropy);
}

std::string PairingKey::code() const {
  const auto bits = withCheckSum(entropy_);
  std::string text;
  for (std::size_t sign = 0; sign < kSigns; ++sign) {
    if (sign != 0 && sign % kGroup == 0) text += '-';
    std::size_t value = 0;
    for (std::size_t at = 5 * sign; at < 5 * sign + 5; ++at) value = value << 1 | (bits[at / 8] >> (7 - at % 8) & 1);
    text += kDigits[value];
  }
  return text;
}

std::string PairingKey::identity() const {
  constexpr std::string_view kHex = "0123456789abcdef";
  const Digest name = digest("hapticell pairing identity", entropy_);
  std::string text = "hapticell-";
  for (std::size_t i = 0; i < 8; ++i) {
    text += kHex[name[i] >> 4];
    text += kHex[name[i] & 15];
  }
  return text;
}

std::array<std::uint8_t, PairingKey::kSecretBytes> PairingKey::secret() const {
  return digest("hapticell pairing secret", entropy_);
}

fs::path serverKeyFile() {
  return inSettings("server.key");
}

fs::path knownServerKeyFile(std::string_view host, std::uint16_t port) {
  std::string name(host);
  for (char& sign : name) {
    const bool plain = (sign >= 'a' && sign <= 'z') || (sign >= 'A' && sign <= 'Z') || (sign >= '0' && sign <= '9');
    if (!plain && sign != '.' && sign != '-') sign = '_';
  }
  return inSettings(fs::path("servers") / (name + "_" + std::to_string(port) + ".key"));
}

Expected<void> saveKey(const PairingKey& key, const fs::path& file) {
  if (file.empty()) return nowhere();
  std::error_code failed;
  if (auto made = config::makeOwnFolder(fs::absolute(file, failed).parent_path()); !made) return made;
  auto written = AtomicFile::begin(file, {.mode = 0600});
  HAPTICELL_TRY(written);
  if (auto put = written->write(key.code() + "\n"); !put) return put;
  return written->commit();
}

Expected<PairingKey> loadKey(const fs::path& file) {
  if (file.empty()) return nowhere();
  struct stat facts {};
  if (stat(file.c_str(), &facts) != 0) return fileError(file, systemText(errno), {});
  if ((facts.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    return fileError(
        file, Text("a key that other users can read or change"),
        Text("Create a new key (hapticell-haptic-server --pair). If nobody has read this one, run chmod 600 on it."));
  }
  std::error_code ignored;
  HAPTICELL_TRY(config::checkUserFile(fs::absolute(file, ignored)));
  std::ifstream stream(file);
  std::string text;
  std::getline(stream, text);
  auto key = PairingKey::parse(text.substr(0, 100));
  if (!key)
    return fileError(file, Text("no pairing code"), Text("Pair again: hapticell-haptic-server --pair shows a code."));
  return key;
}

}  // namespace hapticell::haptic
