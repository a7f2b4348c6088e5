// SPDX-License-Identifier: Apache-2.0
#include "app/controls/color_choice.h"

#include <QColorDialog>
#include <QMainWindow>

#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/style/style_painting.h"
#include "app/viewport/scene/part_colors.h"

namespace hapticell::app {

void choosePartColor(Host& host, const QColor& now, std::function<void(const QColor&)> take) {
  auto* dialog = new QColorDialog(now, &host.window());
  dialog->setObjectName("dialogColor");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setOption(QColorDialog::DontUseNativeDialog);  // A native one has the desktop's theme.
  dialog->setWindowTitle(QObject::tr("Colour of the part"));
  QObject::connect(dialog, &QColorDialog::colorSelected, &host.window(), [&host, take](const QColor& chosen) {
    take(chosen);
    const std::array<float, 3> own = channelsOf(chosen);
    if (partColor(own) != own)
      host.messages().tell(
          Severity::kInformation, QObject::tr("The part is shown in a quieter colour than %1").arg(chosen.name()),
          QObject::tr(
              "This keeps contacts easy to see. To change it: Settings > Appearance > Show parts in full colour."));
  });
  dialog->open();
}

}  // namespace hapticell::app
