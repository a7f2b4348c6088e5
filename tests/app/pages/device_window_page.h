// SPDX-License-Identifier: Apache-2.0
#pragma once

// The window with devices, driven by real events: the real drivers, a haptic server of its own, fake devices (a
// pseudo-terminal, hidraw on a mocked system). Run under umockdev-wrapper.
//
// HAPTICELL_LOOK_FOLDER=folder saves pictures.
#include "tests/haptic/devices/drivers/spacemouse/mock_hidraw.h"  // First: what it includes has members called `signals`.

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QAbstractItemView>
#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QTemporaryDir>
#include <fstream>

#include "app/shell/module_loader.h"
#include "tests/app/pages/cell_page.h"

namespace hapticell::app {

inline constexpr int kPatience = 60000;  // ms: states are waited for, no time is asserted.

inline int freePort() {
  const int probe = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  const bool bound = bind(probe, any, length) == 0 && getsockname(probe, any, &length) == 0;
  close(probe);
  return bound ? ntohs(address.sin_port) : 0;
}

/// The settings of a user of the test's own: window, server and listing read the same file.
class OwnUser {
 public:
  explicit OwnUser(const std::string& settings) {
    qputenv("XDG_CONFIG_HOME", folder_.path().toLocal8Bit());
    QDir(folder_.path()).mkpath("hapticell");
    std::ofstream file(folder_.path().toStdString() + "/hapticell/hapticell.toml");
    file << "[server]\nport = " << freePort() << "\n[manipulation]\nrate_hz = 60.0\n" << settings;
  }
  QString file(const char* name) const { return folder_.path() + "/hapticell/" + name; }

 private:
  QTemporaryDir folder_;
};

class DevicePage : public OwnUser, public CellPage {
 public:
  /// `settings`: more lines of its hapticell.toml.
  explicit DevicePage(const std::string& settings = {})
      : OwnUser(settings), CellPage(config::loadConfiguration().value()) {
    window().resize(1360, 900);
    settle();
  }
  void start() {
    window().loadModules(ModuleLoader::defaultFolders());
    ASSERT_TRUE(window().startModule("Virtual Desktop"));
    settle();
  }
  QString text(const char* label) {
    auto* found = window().findChild<QLabel*>(label);
    return found ? found->text() : QString();
  }
  testing::AssertionResult says(const char* label, const QString& part) {
    if (until([&] { return text(label).contains(part); }, kPatience)) return testing::AssertionSuccess();
    return testing::AssertionFailure() << label << " says: " << text(label).toStdString();
  }
  bool lists(const char* name, const QString& part) {
    auto* combo = find<QComboBox>(name);
    return combo && until([&] { return combo->findText(part, Qt::MatchContains) >= 0; }, kPatience);
  }
  /// Opens the list by a click and takes the entry. By the keyboard: a list takes no click right after it has opened.
  void choose(const char* name, const QString& part) {
    ASSERT_TRUE(lists(name, part)) << name << ' ' << part.toStdString();
    auto* combo = find<QComboBox>(name);
    // A list that is filled anew while it opens closes again: then a user clicks once more.
    const auto opens = [&] {
      reveal(combo);
      click(combo, combo->rect().center());
      return until([&] { return combo->view()->isVisible(); }, kPatience / 20);
    };
    bool open = opens();
    for (int again = 0; again < 20 && !open; ++again) open = opens();
    ASSERT_TRUE(open);
    const QModelIndex entry = combo->model()->index(combo->findText(part, Qt::MatchContains), 0);
    combo->view()->setCurrentIndex(entry);
    QTest::keyClick(combo->view(), Qt::Key_Return);
    settle();
    ASSERT_TRUE(combo->currentText().contains(part)) << combo->currentText().toStdString();
  }
  void pressSeen(const char* name) {
    auto* button = find<QAbstractButton>(name);
    ASSERT_NE(button, nullptr);
    ASSERT_TRUE(until([&] { return button->isVisible() && button->isEnabled(); }, kPatience)) << name;
    reveal(button);
    click(button, button->rect().center());
  }
  void reveal(QWidget* widget) {
    for (QWidget* parent = widget->parentWidget(); parent; parent = parent->parentWidget()) {
      if (auto* scroll = qobject_cast<QScrollArea*>(parent)) scroll->ensureWidgetVisible(widget);
    }
    settle();
  }
  const std::optional<manipulation::SceneSnapshot>& snapshot() { return window().viewport().scene().snapshot(); }
  std::optional<manipulation::StylusState> second() { return snapshot() ? snapshot()->second : std::nullopt; }
  /// Waits until the stylus is connected and stands still; of two, both, beside each other.
  testing::AssertionResult stylusesRest(bool both = true) {
    std::uint64_t seen = 0;
    dvec3 last_first{0.0}, last_second{0.0};
    int rests = 0;
    const auto rest = [&] {
      if (!snapshot() || !snapshot()->stylus.connected) return false;
      if (snapshot()->step == seen) return rests > 10;
      if (both && !(second() && second()->connected)) return false;
      seen = snapshot()->step;
      const dvec3 first_at = snapshot()->stylus.X_WStylus.p;
      const dvec3 second_at = both ? second()->X_WStylus.p : first_at + dvec3(1.0);
      const double moved = glm::length(first_at - last_first) + glm::length(second_at - last_second);
      last_first = first_at;
      last_second = second_at;
      rests = moved < 1e-4 && glm::length(first_at - second_at) > 0.01 ? rests + 1 : 0;
      return rests > 10;
    };
    return until(rest, kPatience) ? testing::AssertionSuccess() : testing::AssertionFailure() << "they do not rest";
  }
  /// The mouse takes the pen whose tip is there and drags it 40 pixels to the right.
  void dragPen(const dvec3& p_WTip) {
    ViewportWidget& viewport = window().viewport();
    const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    const auto tip = viewport.camera().project(p_WTip, size);
    ASSERT_TRUE(tip);
    const auto send = [&](QEvent::Type type, double right, Qt::MouseButtons held) {
      const QPointF place(tip->x + 2 + right, tip->y - 2);
      QMouseEvent event(type, place, viewport.mapToGlobal(place),
                        type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, held, Qt::NoModifier);
      QApplication::sendEvent(&viewport, &event);
      settle();
    };
    send(QEvent::MouseButtonPress, 0.0, Qt::LeftButton);
    for (int i = 1; i <= 5; ++i) send(QEvent::MouseMove, 8.0 * i, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, 40.0, Qt::NoButton);
  }
  /// Turns the view by so many pixels of a drag to the right.
  void lookRound(double pixels) {
    Camera camera = window().viewport().camera();
    camera.orbit({pixels, 0.0}, camera.target_W);
    window().viewport().setCamera(camera, false);
    settle();
  }
  void picture(const char* name) {
    const QString folder = qEnvironmentVariable("HAPTICELL_LOOK_FOLDER");
    if (folder.isEmpty()) return;
    setFinePictures();
    settle();
    window().viewport().finishedPicture();
    window().viewport().update();  // With what is painted over it.
    settle();
    const QRect seen = window().frameGeometry();
    window()
        .screen()
        ->grabWindow(0, seen.x(), seen.y(), seen.width(), seen.height())
        .save(folder + '/' + name + ".png");
  }
};

inline bool connected(DevicePage& page) {
  const auto& snapshot = page.window().viewport().scene().snapshot();
  return snapshot && snapshot->stylus.connected;
}

}  // namespace hapticell::app
