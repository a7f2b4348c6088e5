// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/workspace_section.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "app/kit/form.h"
#include "app/style/theme.h"
#include "app/style/units.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"
#include "app/virtual_desktop/widgets/force_meter.h"

namespace hapticell::app {
namespace {

constexpr int kWorkspaceLines = 8;  // Size, way to the edge, and four keys with their margins.

/// A key as a cap, what it does beside it.
QString keyLine(const QString& key, const QString& does, const Theme& theme) {
  return QStringLiteral(
             "<tr><td><span style=\"font-size:11px; color:%3; background-color:%4\">&nbsp;%1&nbsp;</span></td>"
             "<td>&nbsp;%2</td></tr>")
      .arg(key, does, theme.text1.name(), theme.line.name());
}

}  // namespace

WorkspaceSection::WorkspaceSection(VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent)
    : QObject(parent), controller_(controller) {
  QVBoxLayout* section = addSection(column, tr("Hand in the device's workspace"));
  auto* row = new QHBoxLayout;
  workspace_ = new WorkspaceView;
  text_ = makeLabel({}, TextRole::kSecond, true);
  text_->setTextFormat(Qt::RichText);  // Numbers and words of our own only.
  text_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  text_->setMinimumHeight(kWorkspaceLines * text_->fontMetrics().lineSpacing());
  row->addWidget(workspace_);
  row->addWidget(text_, 1);
  section->addLayout(row);
}

void WorkspaceSection::show() {
  const manipulation::SceneSnapshot& now = controller_.snapshot();
  if (const auto& device = controller_.device()) {
    const dvec3 low = device->workspace_min, high = device->workspace_max, tip = now.stylus.X_DS.p;
    workspace_->setState({low.x, low.y, low.z}, {high.x, high.y, high.z}, {tip.x, tip.y, tip.z}, true);
    const dvec3 size = high - low;
    const auto number = [](double metres) { return lengthText(metres, 0).section(QLatin1Char(' '), 0, 0); };
    const Theme& theme = themeOf(text_->palette());
    const QString keys = keyLine("Space", tr("hold: clutch"), theme) + keyLine("1–4", tr("scale"), theme) +
                         keyLine("C", tr("contact mode"), theme) + keyLine("B", tr("stylus button"), theme);
    text_->setText(QStringLiteral("%1 × %2 × %3<br>%4<table style=\"margin-top:6px\" cellpadding=\"1\">%5</table>")
                       .arg(number(size.x), number(size.y), lengthText(size.z, 0))
                       .arg(tr("%1 to the edge").arg(lengthText(now.stylus.device_edge_m, 0)), keys));
  } else {
    workspace_->setState({-0.08, -0.065, -0.065}, {0.08, 0.065, 0.065}, {0, 0, 0}, false);
    text_->setText(tr("No device"));
  }
}

}  // namespace hapticell::app
