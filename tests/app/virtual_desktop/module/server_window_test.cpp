// SPDX-License-Identifier: Apache-2.0
// The haptic server dies while forces are on: everything in the window says so until the user has seen to it.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>

#include "tests/app/pages/cell_page.h"
#include "tests/app/pages/processes.h"

namespace hapticell::app {
namespace {

constexpr int kLong = 60000;  // ms.

config::Configuration withOwnServer() {
  config::Configuration configuration;
  configuration.server.port = freePort();
  return configuration;
}

TEST(LostServer, IsToldByStatusRatesMessageAndPanelUntilForcesAreAskedForAgain) {
  if (!QFile::exists("/proc/self/task")) GTEST_SKIP() << "no list of processes here";
  CellPage page(withOwnServer());
  page.window().loadModules(ModuleLoader::defaultFolders());
  page.addSolid("box", geometry::makeBox(dvec3(0.06)));
  ASSERT_TRUE(page.window().startModule("Virtual Desktop"));
  const StatusLine& status = page.window().statusLine();
  ASSERT_TRUE(
      WindowPage::until([&] { return page.window().snapshot() && page.window().snapshot()->stylus.connected; }, kLong));
  page.trigger("actionForcesOn");
  ASSERT_TRUE(WindowPage::until([&] { return page.window().snapshot()->stylus.forces_on; }, kLong));
  ASSERT_TRUE(WindowPage::until([&] { return status.rates().haptic_hz > 0.0; }, kLong));
  EXPECT_TRUE(status.deviceWorks());
  const pid_t server = childCalled("hapticell-haptic-server");
  ASSERT_NE(server, 0);
  const std::size_t told = page.window().messages().messages().size();
  ASSERT_EQ(::kill(server, SIGKILL), 0);
  const auto forcesWentOff = [&] {
    const auto& messages = page.window().messages().messages();
    return std::any_of(messages.begin() + static_cast<std::ptrdiff_t>(told), messages.end(), [](const Message& m) {
      return m.severity == Severity::kProblem && m.title.contains("the haptic server stopped responding");
    });
  };
  ASSERT_TRUE(WindowPage::until(forcesWentOff, kLong));
  EXPECT_FALSE(status.deviceWorks()) << status.device().toStdString();
  ASSERT_TRUE(WindowPage::until([&] { return !page.window().snapshot()->stylus.forces_on; }, kLong));
  EXPECT_EQ(page.window().snapshot()->server.rate_hz, 0.0);
  // It is started again by itself; that the forces are gone stays to be read.
  ASSERT_TRUE(WindowPage::until([&] { return page.window().snapshot()->stylus.connected; }, kLong));
  WindowPage::until([&] { return status.device().contains("forces lost"); }, kLong);
  EXPECT_TRUE(status.device().contains("forces lost")) << status.device().toStdString();
  EXPECT_FALSE(page.window().snapshot()->stylus.forces_on);
  page.trigger("actionForcesOn");
  EXPECT_TRUE(
      WindowPage::until([&] { return page.window().snapshot()->stylus.forces_on && status.deviceWorks(); }, kLong));
}

}  // namespace
}  // namespace hapticell::app
