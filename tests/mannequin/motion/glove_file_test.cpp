// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/glove_file.h"

#include <gtest/gtest.h>

#include "tests/support/test_data.h"

namespace hapticell::mannequin {
namespace {

TEST(GloveFile, ComesBackToTheLastBit) {
  const test::TemporaryFolder folder;
  GloveCalibration calibration;
  for (std::size_t i = 0; i < kGloveSensors; ++i) {
    calibration.gain[i] = 0.1 / (3.0 + static_cast<double>(i));
    calibration.offset[i] = -1.0 / (7.0 + static_cast<double>(i));
  }
  const auto file = folder.path() / "new" / "glove.json";  // Its folder is made.
  ASSERT_TRUE(writeGloveCalibration(calibration, file));
  const auto read = readGloveCalibration(file);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->gain, calibration.gain);
  EXPECT_EQ(read->offset, calibration.offset);
}

TEST(GloveFile, RefusesWhatIsNone) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(readGloveCalibration(folder.path() / "missing.json"));
  for (const char* text : {"", "[]", R"({"format":"hapticell-glove","version":2})",
                           R"({"format":"hapticell-glove","version":1,"gain":[1,2],"offset":[]})", R"({"format":3})"}) {
    EXPECT_FALSE(readGloveCalibration(folder.write("odd.json", text))) << text;
  }
}

TEST(GloveFile, TheRoughOneClosesAHand) {
  const GloveCalibration rough = roughGloveCalibration();
  GloveReadings flat, fist;
  flat.fill(60.0);
  fist.fill(200.0);
  EXPECT_NEAR(gloveAngles(rough, flat)[4], 0.0, 1e-9);
  EXPECT_NEAR(gloveAngles(rough, fist)[4], 1.5708, 1e-3);
}

}  // namespace
}  // namespace hapticell::mannequin
