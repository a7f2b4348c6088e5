// SPDX-License-Identifier: Apache-2.0
// Another station's haptic server is paired with from the window: by real events, against a server that has a key.
#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "app/style/segmented.h"
#include "app/virtual_desktop/devices/server_process.h"
#include "app/virtual_desktop/widgets/station_panel.h"
#include "tests/haptic/server/live_server.h"
#include "tests/support/test_data.h"

namespace hapticell::app {
namespace {

/// The panel as a user works it, with a server behind a key and a configuration folder of its own.
class StationPage {
 public:
  StationPage()
      : key_(*haptic::PairingKey::make()),
        server_(keyed(key_)),
        panel_(QStringLiteral("127.0.0.1"), 4747),
        chosen_(&panel_, &StationPanel::stationChosen) {
    qputenv("XDG_CONFIG_HOME", QByteArray::fromStdString(folder_.path().string()));
    panel_.show();
    QTest::mouseClick(find<QWidget>("segmentsStation")->findChildren<QAbstractButton*>().at(1), Qt::LeftButton);
    type("editStationHost", "127.0.0.1");
    find<QSpinBox>("spinStationPort")->setValue(server_.port());
  }
  template <typename Widget>
  Widget* find(const char* name) {
    return panel_.findChild<Widget*>(QString::fromLatin1(name));
  }
  void type(const char* name, const QString& text) {
    auto* field = find<QLineEdit>(name);
    field->selectAll();
    QTest::keyClicks(field, text);
  }
  /// Presses the button and waits until there is an answer.
  void pair() {
    auto* button = find<QPushButton>("buttonPairStation");
    const QString before = button->text();
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_TRUE(QTest::qWaitFor([&] { return button->text() == before; }, 30'000));
  }
  QString said() { return find<QLabel>("labelStation")->text(); }
  const QSignalSpy& chosen() const { return chosen_; }
  QString code() const { return QString::fromStdString(key_.code()); }
  int port() const { return server_.port(); }

 private:
  static haptic::NetworkOptions keyed(const haptic::PairingKey& key) {
    haptic::NetworkOptions options;
    options.key = key;
    return options;
  }
  test::TemporaryFolder folder_;
  haptic::PairingKey key_;
  haptic::LiveServer server_;
  StationPanel panel_;
  QSignalSpy chosen_;
};

TEST(Station, APairedServerIsUsedAndItsCodeIsKept) {
  StationPage page;
  EXPECT_TRUE(page.said().contains("--pair")) << "who has no code is told how to come by one";
  page.type("editStationCode", page.code().toLower());
  page.pair();
  ASSERT_EQ(page.chosen().count(), 1) << page.said().toStdString();
  EXPECT_EQ(page.chosen().at(0).at(0).toString(), "127.0.0.1");
  EXPECT_EQ(page.chosen().at(0).at(1).toInt(), page.port());
  EXPECT_TRUE(StationPairing::knows("127.0.0.1", page.port()));
  EXPECT_TRUE(page.find<QLineEdit>("editStationCode")->text().isEmpty()) << "a secret does not stay on the screen";

  page.pair();
  EXPECT_EQ(page.chosen().count(), 2) << "the code is known from now on";
}

TEST(Station, AnotherCodeIsRefusedAndNotKept) {
  StationPage page;
  page.type("editStationCode", QString::fromStdString(haptic::PairingKey::make()->code()));
  page.pair();
  EXPECT_EQ(page.chosen().count(), 0);
  EXPECT_FALSE(page.said().isEmpty());
  EXPECT_FALSE(StationPairing::knows("127.0.0.1", page.port()));
}

TEST(Station, AMistypedCodeAndAMissingAddressAreSaidAtOnce) {
  StationPage page;
  QString mistyped = page.code();
  mistyped[0] = mistyped[0] == QLatin1Char('7') ? QLatin1Char('8') : QLatin1Char('7');
  page.type("editStationCode", mistyped);
  page.pair();
  EXPECT_EQ(page.chosen().count(), 0);
  const QString wrong_code = page.said();
  page.find<QLineEdit>("editStationHost")->clear();
  page.pair();
  EXPECT_NE(page.said(), wrong_code);
  EXPECT_TRUE(page.said().contains("address")) << page.said().toStdString();
}

TEST(Station, ThisStationIsChosenAgainByOneClick) {
  StationPage page;
  QTest::mouseClick(page.find<QWidget>("segmentsStation")->findChildren<QAbstractButton*>().at(0), Qt::LeftButton);
  ASSERT_EQ(page.chosen().count(), 1);
  EXPECT_EQ(page.chosen().at(0).at(0).toString(), "127.0.0.1");
  EXPECT_EQ(page.chosen().at(0).at(1).toInt(), 4747);
}

TEST(ServerLines, AWarningStandsWhereTheServerPutsIt) {
  EXPECT_EQ(ServerProcess::warningIn("12:34:56.789 warning: The loop missed 3 ticks."), "The loop missed 3 ticks.");
  EXPECT_EQ(ServerProcess::warningIn("12:34:56.789 info: x warning: FORGED at 127.0.0.1:5 watches."), "");
  EXPECT_EQ(ServerProcess::warningIn("x 12:34:56.789 warning: FORGED"), "");
  EXPECT_EQ(ServerProcess::warningIn(""), "");
}

}  // namespace
}  // namespace hapticell::app

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
