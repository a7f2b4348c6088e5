// SPDX-License-Identifier: Apache-2.0
#include "config/user_folders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <optional>

#include "config/configuration.h"
#include "tests/support/test_data.h"

namespace hapticell::config {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Variables = std::map<std::string, std::optional<std::string>>;

/// Variables of the environment for one test; nothing: not set.
class Environment {
 public:
  explicit Environment(const Variables& variables) {
    for (const auto& [name, value] : variables) {
      const char* const old = std::getenv(name.c_str());
      before_[name] = old != nullptr ? std::optional<std::string>(old) : std::nullopt;
      set(name, value);
    }
  }
  ~Environment() {
    for (const auto& [name, value] : before_) set(name, value);
  }

 private:
  static void set(const std::string& name, const std::optional<std::string>& value) {
    value ? ::setenv(name.c_str(), value->c_str(), 1) : ::unsetenv(name.c_str());
  }
  Variables before_;
};

/// The test's current folder for as long as it lives.
class CurrentFolder {
 public:
  explicit CurrentFolder(const fs::path& folder) : before_(fs::current_path()) { fs::current_path(folder); }
  ~CurrentFolder() { fs::current_path(before_); }

 private:
  fs::path before_;
};

const std::optional<std::string> kNotSet;

TEST(UserFolders, AreWhereTheVariablesSay) {
  const Environment environment(
      Variables{{"HOME", "/home/u"}, {"XDG_CONFIG_HOME", kNotSet}, {"XDG_STATE_HOME", "/var/u"}});
  EXPECT_EQ(userSettingsFolder(), fs::path("/home/u/.config/hapticell"));
  EXPECT_EQ(userStateFolder(), fs::path("/var/u/hapticell"));
  EXPECT_EQ(userLibraryFolder(), fs::path("/home/u/.local/lib/hapticell"));
}

TEST(UserFolders, AreNeverBelowTheCurrentFolder) {
  for (const auto& home : {kNotSet, std::optional<std::string>(""), std::optional<std::string>("home"),
                           std::optional<std::string>("./x")}) {
    for (const auto& xdg : {kNotSet, std::optional<std::string>(""), std::optional<std::string>("cfg")}) {
      const Environment environment(Variables{{"HOME", home}, {"XDG_CONFIG_HOME", xdg}, {"XDG_STATE_HOME", xdg}});
      for (const auto& folder : {userSettingsFolder(), userStateFolder(), userLibraryFolder()}) {
        ASSERT_FALSE(folder) << *folder;
        EXPECT_THAT(folder.error().message(), HasSubstr("HOME"));
      }
    }
  }
}

TEST(UserFolders, SettingsInTheCurrentFolderAreNotRead) {
  const test::TemporaryFolder folder;
  folder.write(".config/hapticell/hapticell.toml", "[server]\nport = 4999\n");
  folder.write("hapticell/hapticell.toml", "[server]\nport = 4999\n");
  const CurrentFolder current(folder.path());
  for (const auto& home : {kNotSet, std::optional<std::string>(""), std::optional<std::string>(".")}) {
    const Environment environment(Variables{{"HOME", home}, {"XDG_CONFIG_HOME", kNotSet}});
    const auto read = loadConfiguration();
    ASSERT_FALSE(read) << read->server.port;
    EXPECT_THAT(read.error().message(), HasSubstr("Set HOME or XDG_CONFIG_HOME"));
  }
  const Environment relative(Variables{{"HOME", "/nonexistent"}, {"XDG_CONFIG_HOME", "."}});
  EXPECT_NE(loadConfiguration().value().server.port, 4999);
}

TEST(UserFolders, SettingsThatOthersMayWriteAreRefused) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("cfg/hapticell/hapticell.toml", "[server]\nport = 4999\n");
  const Environment environment(Variables{{"XDG_CONFIG_HOME", (folder.path() / "cfg").string()}});
  ASSERT_EQ(loadConfiguration().value().server.port, 4999);
  for (const fs::path& opened : {file, file.parent_path(), folder.path() / "cfg"}) {
    struct stat before {};
    ::stat(opened.c_str(), &before);
    ::chmod(opened.c_str(), 0777);
    const auto read = loadConfiguration();
    ASSERT_FALSE(read) << opened;
    EXPECT_THAT(read.error().message(), HasSubstr(opened.string() + ": other users can write to it"));
    ::chmod(opened.c_str(), before.st_mode & 07777);
  }
  ASSERT_TRUE(loadConfiguration());
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give files away";
  ::chown(file.c_str(), 12345, 0);
  const auto read = loadConfiguration();
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message(), HasSubstr("it belongs to user 12345"));
}

TEST(UserFolders, AFolderOfAllWithTheStickyBitIsAsGoodAsTmp) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("own/file", "x");
  ::chmod(folder.path().c_str(), 01777);
  EXPECT_TRUE(checkOwn(file, 2));
  ::chmod(folder.path().c_str(), 0777);
  EXPECT_FALSE(checkOwn(file, 2));
  EXPECT_TRUE(checkOwn(file, 1));
  EXPECT_TRUE(checkOwn(folder.path() / "none/file", 1)) << "what is not there is passed over";
}

TEST(UserFolders, AreMadeForThisUserOnly) {
  const test::TemporaryFolder folder;
  const fs::path made = folder.path() / "a/b";
  ASSERT_TRUE(makeOwnFolder(made));
  struct stat facts {};
  ASSERT_EQ(::stat(made.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0700u);
  EXPECT_TRUE(makeOwnFolder(made)) << "it is there";
  EXPECT_FALSE(makeOwnFolder("/proc/none/x"));
}

TEST(SystemProgram, IsFoundByWholePathsOnly) {
  const test::TemporaryFolder folder;
  const fs::path tool = folder.write("bin/tool", "#!/bin/sh\n");
  ::chmod(tool.c_str(), 0755);
  const CurrentFolder current(folder.path() / "bin");
  for (const char* path : {".", "", ":", "bin", "./", "../bin:.", ".:/nonexistent"}) {
    const Environment environment(Variables{{"PATH", path}});
    EXPECT_EQ(systemProgram("tool"), fs::path()) << path;
  }
  const Environment environment(Variables{{"PATH", ".:" + tool.parent_path().string()}});
  EXPECT_EQ(systemProgram("tool"), tool);
  EXPECT_EQ(systemProgram("../bin/tool"), fs::path());
  ::chmod(tool.c_str(), 0777);
  EXPECT_EQ(systemProgram("tool"), fs::path()) << "others may have written it";
}

TEST(Environment, LosesWhatMeansTheCurrentFolder) {
  const test::TemporaryFolder folder;
  ::chmod(folder.path().c_str(), 0777);
  const Environment environment(Variables{{"PATH", "/usr/bin:.::/bin:x"},
                                          {"QT_PLUGIN_PATH", "plugins:" + folder.path().string()},
                                          {"QT_QPA_PLATFORM_PLUGIN_PATH", "/usr/lib"}});
  const auto sentences = cleanEnvironment();
  EXPECT_STREQ(std::getenv("PATH"), "/usr/bin:/bin");
  EXPECT_EQ(std::getenv("QT_PLUGIN_PATH"), nullptr);
  EXPECT_STREQ(std::getenv("QT_QPA_PLATFORM_PLUGIN_PATH"), "/usr/lib");
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_THAT(english(sentences[0]), HasSubstr("QT_PLUGIN_PATH names 'plugins'"));
  EXPECT_THAT(english(sentences[1]), HasSubstr(folder.path().string()));
}

}  // namespace
}  // namespace hapticell::config
