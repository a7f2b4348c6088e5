// SPDX-License-Identifier: Apache-2.0
// The headers of a few lines each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <clocale>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <variant>
#include <vector>

#include "geometry/system/assertion.h"
#include "geometry/system/overloaded.h"
#include "geometry/system/percentile.h"
#include "geometry/system/plain_number.h"
#include "geometry/system/sanitizers.h"

namespace hapticell {
namespace {

TEST(AssertionDeathTest, ABrokenContractNamesPlaceAndConditionAndAborts) {
  const int wheels = 3;
  EXPECT_EXIT(HAPTICELL_DEMAND(wheels == 4), ::testing::KilledBySignal(SIGABRT),
              "small_parts_test.cpp:[0-9]+: contract broken: wheels == 4");
}

TEST(AssertionDeathTest, TheFirstBrokenContractIsKeptForTheHandlerOfTheSignal) {
  const auto report = [](int) {
    std::fprintf(stderr, "kept: %s\n", brokenContract());
    std::_Exit(7);
  };
  EXPECT_EXIT(
      {
        std::signal(SIGABRT, report);
        HAPTICELL_DEMAND(1 + 1 == 3);
      },
      ::testing::ExitedWithCode(7), "kept: small_parts_test.cpp:[0-9]+: 1 \\+ 1 == 3");
}

TEST(Assertion, WhatHoldsCostsNothingAndKeepsNothing) {
  int asked = 0;
  HAPTICELL_DEMAND(++asked == 1);
  EXPECT_EQ(asked, 1) << "the condition is evaluated once";
  HAPTICELL_ASSERT(asked == 1);
  EXPECT_STREQ(brokenContract(), "");
}

TEST(Overloaded, EachAlternativeFindsItsFunction) {
  const Overloaded kind{[](int) { return std::string("whole"); }, [](double) { return std::string("real"); },
                        [](const std::string& text) { return "text " + text; }};
  using Any = std::variant<int, double, std::string>;
  EXPECT_EQ(std::visit(kind, Any(3)), "whole");
  EXPECT_EQ(std::visit(kind, Any(3.0)), "real");
  EXPECT_EQ(std::visit(kind, Any(std::string("three"))), "text three");
}

TEST(Percentile, OfNothingIsZeroAndOfOneIsThatOne) {
  EXPECT_EQ(percentile({}, 0.5), 0.0);
  for (const double share : {-1.0, 0.0, 0.3, 1.0, 9.0}) EXPECT_EQ(percentile({4.5}, share), 4.5);
}

TEST(Percentile, EndsAreTheLeastAndTheLargestWhateverTheOrder) {
  const std::vector<double> values{3.0, -2.0, 8.0, 8.0, 0.5};
  EXPECT_EQ(percentile(values, 0.0), -2.0);
  EXPECT_EQ(percentile(values, 0.5), 3.0);
  EXPECT_EQ(percentile(values, 1.0), 8.0);
  EXPECT_EQ(percentile(values, -0.1), -2.0) << "shares are put into 0 to 1";
  EXPECT_EQ(percentile(values, 1.1), 8.0);
}

RC_GTEST_PROP(Percentile, AgreesWithSorting, ()) {
  const auto whole = *rc::gen::nonEmpty<std::vector<int>>();
  const double share = *rc::gen::inRange(0, 1001) / 1000.0;
  std::vector<double> sorted(whole.begin(), whole.end());
  const double found = percentile(sorted, share);
  std::sort(sorted.begin(), sorted.end());
  const double rank = share * static_cast<double>(sorted.size() - 1);
  RC_ASSERT(found >= sorted[static_cast<std::size_t>(rank)]);
  RC_ASSERT(found <= sorted[static_cast<std::size_t>(std::ceil(rank))]);
}

TEST(PlainNumber, IsWhatTheCLocaleWritesWhateverTheLocale) {
  std::array<char, 400> text{};
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const double value : {0.0, -0.0, 0.1, -1234.5678, 1e-7, 123456789.0, 1e300, 2.5, 3.5}) {
    for (const int digits : {0, 1, 4, 9, 17}) {
      std::snprintf(text.data(), text.size(), "%.*f", digits, value);
      for (const char* locale : {"C", "de_DE.UTF-8", "fr_FR.UTF-8"}) {
        std::setlocale(LC_ALL, locale);  // some of them may not be installed
        EXPECT_EQ(plainNumber(value, std::chars_format::fixed, digits), text.data()) << locale;
      }
      std::setlocale(LC_ALL, "C");
      if (digits == 0) continue;
      std::snprintf(text.data(), text.size(), "%.*g", digits, value);
      EXPECT_EQ(plainNumber(value, std::chars_format::general, digits), text.data());
    }
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Sanitizers, TheMacroIsZeroOrOne) {
  EXPECT_TRUE(HAPTICELL_SANITIZED == 0 || HAPTICELL_SANITIZED == 1);
#if defined(__SANITIZE_ADDRESS__)
  EXPECT_EQ(HAPTICELL_SANITIZED, 1);
#endif
}

}  // namespace
}  // namespace hapticell
