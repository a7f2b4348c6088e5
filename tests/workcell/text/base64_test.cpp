// SPDX-License-Identifier: Apache-2.0
#include "workcell/text/base64.h"

#include <gtest/gtest.h>

namespace hapticell::workcell {
namespace {

TEST(Base64, GivesTheVectorsOfTheStandard) {  // RFC 4648, section 10.
  const char* const vectors[][2] = {{"", ""},         {"f", "Zg=="},         {"fo", "Zm8="},        {"foo", "Zm9v"},
                                    {"foob", "Zm9vYg=="}, {"fooba", "Zm9vYmE="}, {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) EXPECT_EQ(base64(bytes), text);
  EXPECT_EQ(base64(std::string("\xff\xfb\x00", 3)), "//sA");
}

}  // namespace
}  // namespace hapticell::workcell
