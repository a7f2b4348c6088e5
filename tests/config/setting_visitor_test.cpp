// SPDX-License-Identifier: Apache-2.0
#include "config/setting_visitor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "config/toml_place.h"

namespace hapticell::config {
namespace {

TEST(SettingVisitor, EachSettingIsVisitedOnceWithLimitsThatHoldItsValue) {
  Configuration configuration;
  std::set<std::string> keys;
  visitSettings(configuration, [&](const std::string& key, auto& value, const auto& limits) {
    EXPECT_TRUE(keys.insert(key).second) << key << " comes twice";
    EXPECT_NE(key.find('.'), std::string::npos) << key;
    if constexpr (std::is_same_v<std::decay_t<decltype(limits)>, NumberRange>) {
      EXPECT_LT(limits.min, limits.max) << key;
      if constexpr (!std::is_same_v<std::decay_t<decltype(value)>, std::string>) {
        EXPECT_GE(static_cast<double>(value), limits.min) << key;
        EXPECT_LE(static_cast<double>(value), limits.max) << key;
      }
    } else if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>) {
      EXPECT_TRUE(limits.empty() || std::find(limits.begin(), limits.end(), value) != limits.end())
          << key << " is " << value;
    }
  });
  EXPECT_EQ(keys.size(), settings(configuration).size() - configuration.drivers.size());
}

TEST(SettingVisitor, MaterialsAreVisitedByTheirNames) {
  Configuration configuration;
  configuration.materials = {{"foam", {100.0, 5.0, 0.9}}};
  std::vector<std::string> keys;
  visitSettings(configuration, [&](const std::string& key, auto&, const auto&) {
    if (key.starts_with("materials.")) keys.push_back(key);
  });
  EXPECT_EQ(keys, (std::vector<std::string>{"materials.foam.stiffness", "materials.foam.damping",
                                            "materials.foam.friction"}));
}

TEST(SettingVisitor, WhatAVisitorSetsIsSetInTheConfiguration) {
  Configuration configuration;
  visitSettings(configuration, [](const std::string& key, auto& value, const auto&) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) {
      if (key == "scale.fine") value = 0.5;
    }
  });
  EXPECT_EQ(configuration.scale.fine, 0.5);
}

TEST(SettingVisitor, EachLimitIsKeptByTheFileAndByTheSetter) {
  Configuration configuration;
  visitSettings(configuration, [](const std::string& key, auto& value, const auto& limits) {
    if constexpr (std::is_same_v<std::decay_t<decltype(limits)>, NumberRange> &&
                  std::is_same_v<std::decay_t<decltype(value)>, double>) {
      Configuration own;
      EXPECT_TRUE(setValue(own, key, std::to_string(limits.min)) || limits.min < 1e-6) << key;
      EXPECT_FALSE(setValue(own, key, std::to_string(limits.max + 1.0))) << key;
      EXPECT_FALSE(setValue(own, key, std::to_string(limits.min - 1.0))) << key;
      EXPECT_FALSE(setValue(own, key, "nan")) << key;
      EXPECT_FALSE(setValue(own, key, "")) << key;
    }
  });
}

TEST(TomlPlace, ALineIsCountedFromOne) {
  const toml::table table = toml::parse("a = 1\n\n[b]\nc = 'x'\n");
  EXPECT_EQ(english(lineOf(*table.get("a"))), "line 1");
  EXPECT_EQ(english(lineOf(*table.at_path("b.c").node())), "line 4");
}

}  // namespace
}  // namespace hapticell::config
