// SPDX-License-Identifier: Apache-2.0
// The live view in the whole window under a virtual display, watched by a viewer of this file.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QAbstractButton>
#include <QClipboard>
#include <QLabel>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <string>

#include "app/style/segmented.h"
#include "config/configuration.h"
#include "tests/app/pages/window_page.h"

namespace hapticell::app {
namespace {

/// A connection by hand (RFC 6455): what it sends has a mask of zeros, what it gets is kept as bytes.
class RawViewer {
 public:
  explicit RawViewer(int port, const std::string& path = "/") : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    is_connected_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    put("GET " + path +
        " HTTP/1.1\r\nHost: here\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Protocol: foxglove.websocket.v1\r\n\r\n");
  }
  ~RawViewer() { ::close(socket_); }
  RawViewer(const RawViewer&) = delete;
  RawViewer& operator=(const RawViewer&) = delete;
  bool isConnected() const { return is_connected_; }
  void subscribe(int channel) {
    const std::string text = R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":)" + std::to_string(channel) + "}]}";
    put(std::string("\x81", 1) + static_cast<char>(0x80 | text.size()) + std::string(4, '\0') + text);
  }
  /// What has come so far.
  const std::string& bytes() {
    char piece[65536];
    for (ssize_t count = 0; (count = ::recv(socket_, piece, sizeof piece, MSG_DONTWAIT)) > 0;)
      bytes_.append(piece, static_cast<std::size_t>(count));
    return bytes_;
  }
  bool hears(const std::string& words) {
    return WindowPage::until([&] { return bytes().find(words) != std::string::npos; }, 30000);
  }

 private:
  void put(const std::string& bytes) {
    if (!is_connected_) return;
    EXPECT_EQ(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL), static_cast<ssize_t>(bytes.size()));
  }
  int socket_;
  bool is_connected_ = false;
  std::string bytes_;
};

class LivePage : public WindowPage {
 public:
  /// Another port than the usual one, so that a live view on this machine is not in the way.
  LivePage() { trigger("actionLive"); }
  template <class Widget>
  Widget* find(const char* name) {
    auto* found = window().findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void click(const char* button) {
    find<QAbstractButton>(button)->click();
    settle();
  }
  std::string line() { return find<QLabel>("labelLiveView")->text().toStdString(); }
  QString address() { return find<QPlainTextEdit>("textLiveAddress")->toPlainText(); }
  void choosePort(int port) { find<QSpinBox>("spinLivePort")->setValue(port); }
  /// Starts at the first free port from `port` on.
  int startFrom(int port) {
    for (; port < 65535; ++port) {
      choosePort(port);
      click("buttonLive");
      if (!address().isEmpty()) break;
    }
    return port;
  }
};

std::string cellFile() {
  const auto folder = config::findShippedFile("workcells");
  return folder ? *folder + "/demo.hcell" : std::string();
}

TEST(LiveView, AViewerSeesTheCellAndItsChanges) {
  LivePage page;
  EXPECT_EQ(page.line(), "Off. Nobody can watch.");
  const int port = page.startFrom(18765);
  EXPECT_EQ(page.address().toStdString(), "ws://127.0.0.1:" + std::to_string(port));
  EXPECT_FALSE(page.find<QSpinBox>("spinLivePort")->isEnabled());
  page.click("buttonCopyLiveAddress");
  EXPECT_EQ(QGuiApplication::clipboard()->text(), page.address());
  RawViewer viewer(port);
  ASSERT_TRUE(viewer.isConnected());
  ASSERT_TRUE(viewer.hears("\"/contact_points\""));
  viewer.subscribe(1);  // The topics are numbered in the order of cell_view.h: shapes first.
  EXPECT_TRUE(LivePage::until([&] { return page.line() == "On. Viewers watching: 1"; }, 30000)) << page.line();
  ASSERT_TRUE(page.open(QString::fromStdString(cellFile())));
  EXPECT_TRUE(viewer.hears("\"id\":\"robot/")) << "the robot's links";
  page.click("buttonLive");
  EXPECT_EQ(page.line(), "Off. Nobody can watch.");
  EXPECT_EQ(page.address(), "");
  EXPECT_FALSE(RawViewer(port).isConnected());
}

TEST(LiveView, OthersNeedTheCode) {
  LivePage page;
  page.find<Segmented>("segmentsLiveWho")->setCurrent(1);
  const int port = page.startFrom(18865);
  const QString first = page.address().split('\n').front();
  const QString code = first.section('/', -1);
  EXPECT_GE(code.size(), 20) << first.toStdString();
  RawViewer stranger(port);
  EXPECT_TRUE(stranger.hears("403"));
  RawViewer known(port, "/" + code.toStdString());
  EXPECT_TRUE(known.hears("serverInfo"));
}

TEST(LiveView, SaysWhyItCannotServe) {
  LivePage page;
  const int port = page.startFrom(18965);
  LivePage other;
  other.choosePort(port);
  other.click("buttonLive");
  EXPECT_NE(other.line().find(std::to_string(port)), std::string::npos) << other.line();
  EXPECT_TRUE(other.address().isEmpty());
  other.choosePort(port + 37);
  other.click("buttonLive");
  EXPECT_EQ(other.line().substr(0, 3), "On.") << other.line();
}

}  // namespace
}  // namespace hapticell::app
