// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/server_options.h"

#include <gtest/gtest.h>

#include <vector>

namespace hapticell::haptic {
namespace {

Expected<ServerOptions> parse(const std::vector<std::string_view>& words) {
  return parseServerOptions(words);
}

TEST(ServerOptions, AllOfThem) {
  const auto options =
      parse({"--device", "touch", "--listen=::1", "--port", "0", "--config", "my.toml", "--seconds=2.5", "--state-rate",
             "60", "--no-real-time", "--key=a.key", "--pair", "--log-level=debug"});
  ASSERT_TRUE(options.has_value());
  EXPECT_EQ(options->device, "touch");
  EXPECT_EQ(options->listen, "::1");
  EXPECT_EQ(options->port, 0);
  EXPECT_EQ(options->config, "my.toml");
  EXPECT_EQ(options->seconds, 2.5);
  EXPECT_EQ(options->state_rate_hz, 60.0);
  EXPECT_FALSE(options->real_time);
  EXPECT_EQ(options->key, "a.key");
  EXPECT_TRUE(options->pair);
  EXPECT_EQ(options->log_level, config::LogLevel::kDebug);
}

TEST(ServerOptions, NoneIsLoopbackAndAsConfigured) {
  const auto options = parse({});
  ASSERT_TRUE(options.has_value());
  EXPECT_EQ(options->listen, "127.0.0.1");
  EXPECT_FALSE(options->port.has_value());
  EXPECT_FALSE(options->device.has_value());
  EXPECT_TRUE(options->real_time);
  EXPECT_EQ(options->key, "");
  EXPECT_FALSE(options->pair);
  EXPECT_EQ(options->log_level, config::LogLevel::kInfo);
}

TEST(ServerOptions, BadWordsAreNamed) {
  const std::vector<std::vector<std::string_view>> bad = {{"--port"},
                                                          {"--port", "66000"},
                                                          {"--log-level", "loud"},
                                                          {"--port", "-1"},
                                                          {"--port", "47x"},
                                                          {"--port", ""},
                                                          {"--seconds", "nan"},
                                                          {"--seconds", "-1"},
                                                          {"--state-rate", "0"},
                                                          {"--prot", "1"},
                                                          {"--prot=1"},
                                                          {"4747"},
                                                          {"--device"},
                                                          {"--state-rate", "1e9"},
                                                          {"-x"},
                                                          {"--help=1"}};
  for (const auto& words : bad) {
    const auto options = parse(words);
    ASSERT_FALSE(options.has_value()) << words.back();
    const std::string name(words.front().substr(0, words.front().find('=')));
    EXPECT_NE(options.error().message().find(name), std::string::npos) << options.error().message();
  }
}

}  // namespace
}  // namespace hapticell::haptic
