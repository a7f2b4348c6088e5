// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/report_head.h"

#include <QBuffer>
#include <QHBoxLayout>
#include <QImageReader>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>

#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/user_settings.h"
#include "app/kit/file_dialog.h"

namespace hapticell::app {
namespace {

constexpr const char* kCompanyKey = "report/company";
constexpr const char* kLogoKey = "report/logo";
constexpr QSize kLogoMost(780, 192);  // Twice as fine as paper shows at 300 dots an inch on the report's 130 x 32 pt.
constexpr int kChipHeight = 16;

ergonomics::ReportPicture reportPictureOf(const QImage& image) {
  const QImage drawn = image.convertToFormat(QImage::Format_ARGB32_Premultiplied);
  ergonomics::ReportPicture picture{drawn.width(), drawn.height(), {}};
  for (int y = 0; y < drawn.height(); ++y) {
    const auto* line = static_cast<const QRgb*>(static_cast<const void*>(drawn.constScanLine(y)));
    picture.pixels.insert(picture.pixels.end(), line, line + drawn.width());
  }
  return picture;
}

}  // namespace

ReportHead::ReportHead(Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 0, 0, 0);
  name_ = new QLineEdit(host.userSettings().value(kCompanyKey).toString());
  name_->setObjectName("editCompany");
  name_->setPlaceholderText(tr("Company name"));
  name_->setAccessibleName(tr("Company name"));
  name_->setMaxLength(80);
  choose_ = new QPushButton(tr("Logo"));
  choose_->setObjectName("buttonLogo");
  auto* menu = new QMenu(choose_);
  auto* open = menu->addAction(tr("Choose a picture…"));
  open->setObjectName("logo_choose");
  auto* drop = menu->addAction(tr("No logo"));
  drop->setObjectName("logo_none");
  choose_->setMenu(menu);
  line->addWidget(name_, 1);
  line->addWidget(choose_);
  logo_ = reportPictureOf(
      QImage::fromData(QByteArray::fromBase64(host.userSettings().value(kLogoKey).toString().toLatin1())));
  showLogo();
  connect(name_, &QLineEdit::textChanged, this, [this](const QString& text) {
    host_.userSettings().setValue(kCompanyKey, text.trimmed());
    emit changed();
  });
  connect(open, &QAction::triggered, this, [this] {
    const QString file =
        askToOpen(this, tr("Choose the report logo"), {}, tr("Pictures (*.png *.jpg *.jpeg *.svg);;All files (*)"));
    if (!file.isEmpty()) takeLogo(file);
  });
  connect(drop, &QAction::triggered, this, &ReportHead::dropLogo);
}

std::string ReportHead::company() const {
  return name_->text().trimmed().toStdString();
}

bool ReportHead::takeLogo(const QString& file) {
  QImageReader reader(file);
  reader.setDecideFormatFromContent(true);
  const QSize size = reader.size();
  // Shapes are drawn as fine as wanted; of pixels there are no more than the file has.
  if (size.isValid() &&
      (reader.format() == "svg" || size.width() > kLogoMost.width() || size.height() > kLogoMost.height()))
    reader.setScaledSize(size.scaled(kLogoMost, Qt::KeepAspectRatio).expandedTo({1, 1}));
  const QImage read = reader.read();
  if (read.isNull()) {
    host_.messages().tell(
        Severity::kProblem, tr("The logo was not read"),
        tr("%1 is not a readable picture. Choose a PNG, JPEG or SVG file. The report is unchanged.").arg(file));
    return false;
  }
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  read.save(&buffer, "PNG");
  host_.userSettings().setValue(kLogoKey, QString::fromLatin1(bytes.toBase64()));
  logo_ = reportPictureOf(read);
  showLogo();
  emit changed();
  return true;
}

void ReportHead::dropLogo() {
  host_.userSettings().remove(kLogoKey);
  logo_ = {};
  showLogo();
  emit changed();
}

void ReportHead::showLogo() {
  if (logo_.isEmpty()) {
    choose_->setIcon({});
    choose_->setToolTip(tr("A picture at the top of every report; none is chosen"));
    return;
  }
  const auto* bytes = static_cast<const uchar*>(static_cast<const void*>(logo_.pixels.data()));
  const QImage image(bytes, logo_.width, logo_.height, QImage::Format_ARGB32_Premultiplied);
  choose_->setIconSize({4 * kChipHeight, kChipHeight});
  choose_->setIcon(QPixmap::fromImage(image.copy()));
  choose_->setToolTip(tr("This picture is at the top of every report"));
}

}  // namespace hapticell::app
