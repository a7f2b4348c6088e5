// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/rate_section.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/viewport/widget/viewport_widget.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"

namespace hapticell::app {

RateSection::RateSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent)
    : QObject(parent), host_(host), controller_(controller) {
  QVBoxLayout* section = addSection(column, {});
  auto* grid = new QGridLayout;
  grid->setVerticalSpacing(1);
  const QString names[3]{tr("Haptic"), tr("Collision"), tr("Window")};
  for (int i = 0; i < 3; ++i) {
    grid->addWidget(makeLabel(names[i], TextRole::kSecond, true), 0, i);
    rates_[i][0] = makeLabel({}, TextRole::kSection);
    rates_[i][1] = makeLabel({}, TextRole::kSecond, true);
    for (QLabel* label : rates_[i]) label->setObjectName("labelRate");
    grid->addWidget(rates_[i][0], 1, i);
    grid->addWidget(rates_[i][1], 2, i);
    grid->setColumnStretch(i, 1);
  }
  section->addLayout(grid);
}

void RateSection::show() {
  const manipulation::SceneSnapshot& now = controller_.snapshot();
  const double window = controller_.isStarted() ? controller_.guiRate() : 0.0;
  const double hertz[3]{now.server.rate_hz, now.rate_manipulation_hz, window};
  const double times[3]{now.server.late_p99_ms, now.step_p99_ms, 1000.0 * host_.viewport().lastFrameSeconds()};
  const QString words[3]{tr("late %1 ms"), tr("step %1 ms"), tr("frame %1 ms")};
  const auto rate = [](double value) { return value > 0.0 ? tr("%1 Hz").arg(std::lround(value)) : tr("off"); };
  for (int i = 0; i < 3; ++i) {
    const bool idle = now.idle && i > 0;
    if (!idle) steady_rates_[i].take(hertz[i], now.idle ? SteadyNumber::kAtRest : 1.0);
    if (!idle) steady_times_[i].take(times[i], now.idle ? SteadyNumber::kAtRest : 1.0);
    rates_[i][0]->setText(idle ? tr("idle") : rate(steady_rates_[i].shown()));
    rates_[i][1]->setText(words[i].arg(steady_times_[i].shown(), 0, 'f', i == 0 ? 2 : 1));
  }
}

}  // namespace hapticell::app
