// SPDX-License-Identifier: Apache-2.0
#include "haptic/transport/pairing_key.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "tests/support/test_data.h"

namespace hapticell::haptic {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

TEST(PairingKey, ItsCodeReadsBackHoweverItIsTyped) {
  for (int i = 0; i < 200; ++i) {
    const PairingKey key = *PairingKey::make();
    std::string code = key.code();
    EXPECT_THAT(code, MatchesRegex("([0-9A-HJKMNP-TV-Z]{4}-){6}[0-9A-HJKMNP-TV-Z]{4}"));
    EXPECT_EQ(PairingKey::parse(code), key);
    std::string typed;
    for (const char sign : code) {
      if (sign == '-') continue;
      char letter = static_cast<char>(std::tolower(sign));
      if (sign == '0') letter = 'o';
      if (sign == '1') letter = 'l';
      typed += letter;
      if (typed.size() % 7 == 0) typed += ' ';
    }
    EXPECT_EQ(PairingKey::parse(typed + "\n"), key) << typed;
  }
}

TEST(PairingKey, NoTwoAreAlikeAndTheNameDoesNotTellTheSecret) {
  const PairingKey one = *PairingKey::make(), other = *PairingKey::make();
  EXPECT_NE(one.code(), other.code());
  EXPECT_NE(one.secret(), other.secret());
  EXPECT_NE(one.identity(), other.identity());
  std::string secret;
  for (const auto byte : one.secret()) secret += static_cast<char>(byte);
  EXPECT_THAT(one.identity(), Not(HasSubstr(secret.substr(0, 4))));
}

TEST(PairingKey, ASingleMistypedSignIsFound) {
  const std::string code = PairingKey::parse(PairingKey::make()->code())->code();
  int found = 0, tried = 0;
  for (std::size_t at = 0; at < code.size(); ++at) {
    if (code[at] == '-') continue;
    for (const char wrong : {'0', '7', 'A', 'Z'}) {
      if (code[at] == wrong) continue;
      std::string bad = code;
      bad[at] = wrong;
      ++tried;
      if (!PairingKey::parse(bad)) ++found;
    }
  }
  EXPECT_GE(found, tried - 2) << "twelve bits of check sum let one of 4096 through";
}

TEST(PairingKey, WhatIsNoCodeIsRefused) {
  const std::string code = PairingKey::make()->code();
  EXPECT_THAT(PairingKey::parse("").error().message(), HasSubstr("0 characters"));
  EXPECT_THAT(PairingKey::parse(code.substr(1)).error().message(), HasSubstr("27 characters"));
  EXPECT_THAT(PairingKey::parse(code + "0").error().message(), HasSubstr("29 characters"));
  EXPECT_THAT(PairingKey::parse("U" + code.substr(1)).error().message(), HasSubstr("'U'"));
  EXPECT_THAT(PairingKey::parse(std::string(100'000, '7')).error().message(), HasSubstr("characters"));
}

TEST(PairingKey, AFileIsForItsOwnerOnly) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "deep" / "server.key";
  const PairingKey key = *PairingKey::make();
  ASSERT_TRUE(saveKey(key, file).has_value());
  struct stat facts {};
  ASSERT_EQ(stat(file.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0600u);
  EXPECT_EQ(loadKey(file), key);
  const PairingKey next = *PairingKey::make();
  ASSERT_TRUE(saveKey(next, file).has_value());
  EXPECT_EQ(loadKey(file), next) << "a new pairing makes the old key worthless";
  chmod(file.c_str(), 0640);
  EXPECT_THAT(loadKey(file).error().message(), HasSubstr("other users can read"));
  EXPECT_FALSE(loadKey(folder.path() / "none.key").has_value());
}

TEST(PairingKey, AFileOfSomethingElseIsSaidSo) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "server.key";
  std::ofstream(file) << std::string(1000, 'x');
  chmod(file.c_str(), 0600);
  EXPECT_THAT(loadKey(file).error().message(), HasSubstr("no pairing code"));
  EXPECT_FALSE(saveKey(*PairingKey::make(), "/proc/nowhere/server.key").has_value());
}

TEST(PairingKey, AServerOnAnotherMachineHasAFileOfItsOwn) {
  EXPECT_EQ(knownServerKeyFile("10.0.0.7", 4747).filename(), "10.0.0.7_4747.key");
  EXPECT_EQ(knownServerKeyFile("../../etc/passwd", 1).filename(), ".._.._etc_passwd_1.key");
  EXPECT_EQ(knownServerKeyFile("fe80::1%eth0", 1).filename(), "fe80__1_eth0_1.key");
}

}  // namespace
}  // namespace hapticell::haptic
