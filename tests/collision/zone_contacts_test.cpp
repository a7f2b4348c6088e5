// SPDX-License-Identifier: Apache-2.0
#include "collision/zone_contacts.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "tests/collision/zone_scenes.h"

namespace hapticell::test {
namespace {

TEST(ZoneContacts, AgreesWithExactGeometryInSimpleScenes) {
  for (const ZoneScene& scene : simpleZoneScenes()) {
    ZoneBench bench(scene);
    const ZoneReport report = bench.compare(1500, 0.3);
    std::puts(line(report).c_str());
    EXPECT_TRUE(report.complete) << scene.name;
    EXPECT_LE(report.entries, 64u) << scene.name;
    EXPECT_EQ(report.holes, 0) << scene.name;
  }
}

}  // namespace
}  // namespace hapticell::test
