// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/spacemouse/hid_layout.h"

#include <gtest/gtest.h>

#include <vector>

namespace hapticell::driver {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// The mouse of "Device Class Definition for HID 1.11", appendix E.10: three buttons, x and y.
const Bytes kMouse = {0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x09, 0x01, 0xA1, 0x00, 0x05, 0x09, 0x19,
                      0x01, 0x29, 0x03, 0x15, 0x00, 0x25, 0x01, 0x95, 0x03, 0x75, 0x01, 0x81, 0x02,
                      0x95, 0x01, 0x75, 0x05, 0x81, 0x01, 0x05, 0x01, 0x09, 0x30, 0x09, 0x31, 0x15,
                      0x81, 0x25, 0x7F, 0x75, 0x08, 0x95, 0x02, 0x81, 0x06, 0xC0, 0xC0};

TEST(HidLayout, OfTheStandardsMouse) {
  const HidLayout layout = HidLayout::parse(kMouse);
  EXPECT_FALSE(layout.hasReportIds());
  EXPECT_FALSE(layout.statesAxes()) << "two axes only";
  ASSERT_EQ(layout.fields().size(), 5u) << "the five constant bits are no field";
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(layout.fields()[i].page, HidLayout::kButtons);
    EXPECT_EQ(layout.fields()[i].usage, i + 1);
    EXPECT_EQ(layout.fields()[i].bit, i);
  }
  EXPECT_EQ(layout.fields()[4].usage, HidLayout::kFirstAxis + 1);
  EXPECT_EQ(layout.fields()[4].bit, 16u);
  EXPECT_EQ(layout.fields()[4].low, -127);
  EXPECT_EQ(layout.fields()[4].high, 127);
  const Bytes report = {0x05, 0x10, 0xF0};  // The first and the third button, x = 16, y = -16.
  std::int32_t value = 99;
  const std::int32_t expected[] = {1, 0, 1, 16, -16};
  for (std::size_t i = 0; i < 5; ++i) {
    ASSERT_TRUE(layout.read(layout.fields()[i], report, value));
    EXPECT_EQ(value, expected[i]) << i;
  }
  EXPECT_FALSE(layout.read(layout.fields()[4], std::span(report).first(2), value)) << "the report ends before it";
  EXPECT_FALSE(layout.read(layout.fields()[0], {}, value));
}

/// Six axes of 16 bits in report 1 and two buttons in report 3, as 3D mice have them.
const Bytes kSixAxes = {0x05, 0x01, 0x09, 0x08, 0xA1, 0x01, 0x85, 0x01, 0x16, 0xA2, 0xFE, 0x26, 0x5E,
                        0x01, 0x75, 0x10, 0x95, 0x06, 0x09, 0x30, 0x09, 0x31, 0x09, 0x32, 0x09, 0x33,
                        0x09, 0x34, 0x09, 0x35, 0x81, 0x02, 0x85, 0x03, 0x05, 0x09, 0x19, 0x01, 0x29,
                        0x02, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x02, 0x81, 0x02, 0xC0};

TEST(HidLayout, OfNumberedReports) {
  const HidLayout layout = HidLayout::parse(kSixAxes);
  ASSERT_EQ(layout.fields().size(), 8u);
  EXPECT_TRUE(layout.hasReportIds());
  EXPECT_TRUE(layout.statesAxes());
  EXPECT_EQ(layout.fields()[0].low, -350);
  EXPECT_EQ(layout.fields()[0].high, 350);
  EXPECT_EQ(layout.fields()[6].report, 3);
  EXPECT_EQ(layout.fields()[6].bit, 0u) << "each report is counted from its own beginning";
  const Bytes report = {0x01, 0x5E, 0x01, 0xA2, 0xFE, 0, 0, 0, 0, 0, 0, 1, 0};
  std::int32_t value = 0;
  ASSERT_TRUE(layout.read(layout.fields()[0], report, value));
  EXPECT_EQ(value, 350);
  ASSERT_TRUE(layout.read(layout.fields()[1], report, value));
  EXPECT_EQ(value, -350);
  ASSERT_TRUE(layout.read(layout.fields()[5], report, value));
  EXPECT_EQ(value, 1);
}

TEST(HidLayout, ALargestValueWrittenInTooFewBytesIsTakenAsMeant) {
  // 0 to 255 with one byte each: 255 would be -1.
  const HidLayout layout =
      HidLayout::parse(Bytes{0x05, 0x01, 0x09, 0x30, 0x15, 0x00, 0x25, 0xFF, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02});
  ASSERT_EQ(layout.fields().size(), 1u);
  EXPECT_EQ(layout.fields()[0].high, 255);
  std::int32_t value = 0;
  ASSERT_TRUE(layout.read(layout.fields()[0], Bytes{0xFE}, value));
  EXPECT_EQ(value, 254);
}

TEST(HidLayout, IsEmptyForBrokenDescriptors) {
  EXPECT_TRUE(HidLayout::parse({}).fields().empty());
  EXPECT_TRUE(HidLayout::parse(Bytes{0x05}).fields().empty());
  EXPECT_TRUE(HidLayout::parse(Bytes{0xB4}).fields().empty()) << "a pop without a push";
  EXPECT_TRUE(HidLayout::parse(Bytes{0x75, 0x01, 0x97, 0xFF, 0xFF, 0xFF, 0x7F, 0x81, 0x02}).fields().empty())
      << "more fields than there can be";
  for (std::size_t size = 0; size < kSixAxes.size(); ++size) {
    const HidLayout layout = HidLayout::parse(std::span(kSixAxes).first(size));
    for (const HidField& field : layout.fields()) EXPECT_LE(field.bits, 32) << size;
  }
}

}  // namespace
}  // namespace hapticell::driver
