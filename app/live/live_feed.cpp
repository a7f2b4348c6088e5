// SPDX-License-Identifier: Apache-2.0
#include "app/live/live_feed.h"

#include <QStringList>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/style/library_text.h"
#include "haptic/transport/pairing_key.h"

namespace hapticell::app {

namespace {

constexpr int kPeriodMs = 33;  // 30 Hz, as viewers draw. Half: twice the bytes; twice: motion looks jerky.

}  // namespace

LiveFeed::LiveFeed(Host& host, QObject* parent) : QObject(parent), host_(host) {
  timer_.setInterval(kPeriodMs);
  connect(&timer_, &QTimer::timeout, this, &LiveFeed::send);
  connect(&host.documentModel(), &DocumentModel::changed, this, [this] {
    if (feed_) feed_->showCell(host_.documentModel().document().state());
  });
  connect(&host.documentModel(), &DocumentModel::opened, this, [this] {
    if (feed_) feed_->showCell(host_.documentModel().document().state());
  });
}

QString LiveFeed::start(bool for_others, int port) {
  stop();
  bridge::ViewerAddress address;
  address.port = static_cast<std::uint16_t>(port);
  if (for_others) {
    const auto key = haptic::PairingKey::make();
    if (!key) return shownText(key.error());
    address.host = "0.0.0.0";
    address.code = key->code();
  }
  auto server = bridge::ViewerServer::listen(address);
  if (!server) return shownText(server.error());
  server_ = std::move(*server);
  feed_ = std::make_unique<bridge::CellFeed>(*server_);
  code_ = QString::fromStdString(address.code);
  for_others_ = for_others;
  feed_->showCell(host_.documentModel().document().state());
  timer_.start();
  return {};
}

void LiveFeed::stop() {
  timer_.stop();
  feed_.reset();
  server_.reset();
  viewers_ = 0;
}

QString LiveFeed::addresses() const {
  if (!server_) return {};
  const auto address = [&](const std::string& host) {
    const QString whole = QStringLiteral("ws://%1:%2").arg(QString::fromStdString(host)).arg(server_->port());
    return code_.isEmpty() ? whole : whole + '/' + code_;
  };
  if (!for_others_) return address("127.0.0.1");
  QStringList lines;
  for (const std::string& host : bridge::addressesForOthers()) lines << address(host);
  return lines.isEmpty() ? address("127.0.0.1") : lines.join('\n');
}

int LiveFeed::viewers() const {
  return viewers_;
}

void LiveFeed::send() {
  feed_->update(host_.snapshot().value_or(manipulation::SceneSnapshot{}));
  const int now = static_cast<int>(server_->viewers());
  if (now == viewers_) return;
  viewers_ = now;
  emit viewersChanged();
}

}  // namespace hapticell::app
