// SPDX-License-Identifier: Apache-2.0
#include "config/configuration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/support/test_data.h"

namespace hapticell::config {
namespace {

using ::testing::HasSubstr;

std::string textOf(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

Expected<Configuration> read(const std::string& content) {
  const test::TemporaryFolder folder;
  return readConfiguration(folder.write("hapticell.toml", content).string());
}

TEST(Configuration, ShippedFileEqualsTheBuiltInValues) {
  const auto shipped = readConfiguration(test::sourceFile("config/hapticell.toml").string());
  ASSERT_TRUE(shipped) << shipped.error().message();
  const auto from_file = settings(*shipped), built_in = settings(Configuration{});
  ASSERT_EQ(from_file.size(), built_in.size());
  for (std::size_t i = 0; i < built_in.size(); ++i) {
    EXPECT_EQ(from_file[i].key, built_in[i].key);
    EXPECT_EQ(from_file[i].value, built_in[i].value) << built_in[i].key;
  }
}

TEST(Configuration, OfVersion01IsRead) {
  const auto kept = readConfiguration(test::sourceFile("tests/samples/0.1/hapticell.toml").string());
  ASSERT_TRUE(kept) << kept.error().message();
  EXPECT_EQ(kept->haptic.rate_hz, 500.0);
  EXPECT_EQ(kept->haptic.device, "touch");
  EXPECT_EQ(kept->haptic.stiffness, 800.0);
  EXPECT_EQ(kept->server.host, "192.168.1.20");
  EXPECT_EQ(kept->server.port, 4800);
  EXPECT_TRUE(kept->manipulation.hold_to_move);
  EXPECT_EQ(kept->manipulation.safety_distance, 0.002);
  EXPECT_FALSE(kept->robot.self_collision);
  EXPECT_EQ(kept->scale.fine, 0.1);
  EXPECT_EQ(kept->gui.theme, "light");
  EXPECT_FALSE(kept->gui.sound);
  EXPECT_EQ(kept->hand.mass, 0.2);
  EXPECT_EQ(kept->materials.at("steel").friction, 0.25);
  EXPECT_EQ(kept->materials.at("rubber").friction, 0.9);
}

TEST(Configuration, EveryKeyStandsInTheShippedFile) {
  const std::string text = textOf(test::sourceFile("config/hapticell.toml"));
  for (const Setting& setting : settings(Configuration{})) {
    const std::string last = setting.key.substr(setting.key.rfind('.') + 1);
    EXPECT_THAT(text, HasSubstr("\n" + last + " = ")) << setting.key;
  }
}

TEST(Configuration, ClassicPresetIsThePapersTenHertz) {
  const auto classic = read("preset = \"classic\"\n[gui]\ntheme = \"light\"\n");
  ASSERT_TRUE(classic);
  EXPECT_EQ(classic->manipulation.rate_hz, 10.0);
  EXPECT_EQ(classic->gui.rate_hz, 10.0);
  EXPECT_EQ(classic->gui.theme, "light");
}

TEST(Configuration, BadValueNamesLineKeyAndRange) {
  const auto bad = read("[scale]\nrough = 2.0\nfine = -1.0\n");
  ASSERT_FALSE(bad);
  EXPECT_THAT(bad.error().message(), HasSubstr("line 3"));
  EXPECT_THAT(bad.error().message(), HasSubstr("scale.fine"));
  EXPECT_THAT(bad.error().message(), HasSubstr("0.001 .. 1000"));
}

TEST(Configuration, WrongTypesUnknownKeysAndBrokenFilesAreSentences) {
  EXPECT_THAT(read("[gui]\nrate_hz = \"fast\"\n").error().message(), HasSubstr("10 .. 240"));
  EXPECT_THAT(read("[gui]\ntheme = \"pink\"\n").error().message(), HasSubstr("dark, light"));
  EXPECT_THAT(read("[gui]\nsound = 3\n").error().message(), HasSubstr("true or false"));
  EXPECT_THAT(read("[scale]\nfine = [1, 2]\n").error().message(), HasSubstr("a list"));
  EXPECT_THAT(read("[manipulation]\nrate = 10\n").error().message(), HasSubstr("manipulation.rate_hz"));
  EXPECT_THAT(read("[gui\n").error().message(), HasSubstr("line 1"));
  EXPECT_FALSE(readConfiguration("/nowhere/hapticell.toml"));
}

TEST(Configuration, MaterialsMayBeAdded) {
  const auto with_wood = read("[materials.wood]\nfriction = 0.5\n");
  ASSERT_TRUE(with_wood) << with_wood.error().message();
  EXPECT_EQ(with_wood->materials.at("wood").friction, 0.5);
  EXPECT_EQ(with_wood->materials.at("wood").stiffness, 1000.0);
  EXPECT_EQ(with_wood->materials.size(), 6u);
}

TEST(Configuration, SetValueTakesWhatSettingsGives) {
  Configuration changed;
  changed.scale.fine = 0.125;
  changed.server.port = 5000;
  changed.gui.sound = false;
  Configuration rebuilt;
  for (const Setting& setting : settings(changed)) {
    std::string text = setting.value;
    std::erase(text, '"');
    ASSERT_TRUE(setValue(rebuilt, setting.key, text)) << setting.key;
  }
  EXPECT_EQ(rebuilt.scale.fine, 0.125);
  EXPECT_EQ(rebuilt.server.port, 5000);
  EXPECT_FALSE(rebuilt.gui.sound);
}

TEST(Configuration, SetValueRefusesAndChangesNothing) {
  Configuration configuration;
  EXPECT_FALSE(setValue(configuration, "server.port", "80.5"));
  EXPECT_FALSE(setValue(configuration, "server.port", "0"));
  EXPECT_FALSE(setValue(configuration, "scale.fine", "nan"));
  EXPECT_FALSE(setValue(configuration, "nothing", "1"));
  EXPECT_EQ(configuration.server.port, 4747);
  EXPECT_EQ(configuration.scale.fine, 0.25);
}

}  // namespace
}  // namespace hapticell::config
