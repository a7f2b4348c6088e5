// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "app/host/application.h"
#include "app/style/fonts.h"
#include "app/style/proxy_style.h"
#include "app/style/theme.h"

int main(int argc, char** argv) {
  hapticell::app::Application application(argc, argv);
  QApplication::setStyle(new hapticell::app::ProxyStyle);
  QApplication::setFont(hapticell::app::textFont(hapticell::app::TextRole::kText));
  QApplication::setPalette(hapticell::app::paletteOf(hapticell::app::darkTheme()));
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
