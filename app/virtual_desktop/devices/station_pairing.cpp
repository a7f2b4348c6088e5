// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/station_pairing.h"

#include <filesystem>

#include "app/style/library_text.h"

namespace hapticell::app {
namespace {

// ms between two looks at the link. Half, twice: the answer is seen so much later.
constexpr int kLookPeriod = 50;

}  // namespace

bool isThisStation(const QString& host) {
  return host == QStringLiteral("localhost") || host.startsWith(QStringLiteral("127.")) ||
         host == QStringLiteral("::1");
}

StationPairing::StationPairing(QObject* parent) : QObject(parent) {
  timer_.setInterval(kLookPeriod);
  connect(&timer_, &QTimer::timeout, this, &StationPairing::look);
}

bool StationPairing::knows(const QString& host, int port) {
  std::error_code ignored;
  return std::filesystem::exists(haptic::knownServerKeyFile(host.toStdString(), static_cast<std::uint16_t>(port)),
                                 ignored);
}

void StationPairing::start(const QString& host, int port, const QString& code) {
  cancel();
  host_ = host.trimmed();
  port_ = port;
  typed_.reset();
  if (host_.isEmpty())
    return end(false,
               tr("Enter the address of the other station: its network name, or four numbers such as 192.168.1.20."));
  haptic::TcpLinkOptions options;
  if (code.trimmed().isEmpty()) {
    auto known = haptic::linkOptionsFor(host_.toStdString(), static_cast<std::uint16_t>(port_));
    if (!known) return end(false, shownText(known.error()));
    options = *known;
  } else {
    const auto key = haptic::PairingKey::parse(code.trimmed().toStdString());
    if (!key) return end(false, shownText(key.error()));
    typed_ = options.key = *key;
  }
  options.host = host_.toStdString();
  options.port = static_cast<std::uint16_t>(port_);
  options.kind = haptic::ClientKind::kWatcher;
  options.program = "HaptiCell's pairing";
  link_ = std::make_unique<haptic::TcpLink>(options);
  since_.start();
  timer_.start();
}

void StationPairing::cancel() {
  timer_.stop();
  link_.reset();
}

void StationPairing::look() {
  if (const auto device = link_->device()) {
    if (typed_) {
      const auto file = haptic::knownServerKeyFile(host_.toStdString(), static_cast<std::uint16_t>(port_));
      if (const auto saved = haptic::saveKey(*typed_, file); !saved) return end(false, shownText(saved.error()));
    }
    return end(true, tr("%1 responds at %2.").arg(QString::fromStdString(device->name), host_));
  }
  // What cannot get better by waiting is said at once.
  const bool refused = link_->linkState() == haptic::LinkState::kRefused;
  if (!refused && since_.elapsed() < kPatience) return;
  const QString problem = shownText(link_->problem());
  end(false, problem.isEmpty() ? tr("No haptic server is responding at %1:%2.").arg(host_).arg(port_) : problem);
}

void StationPairing::end(bool fits, const QString& sentence) {
  cancel();
  emit tried(fits, sentence);
}

}  // namespace hapticell::app
