// SPDX-License-Identifier: Apache-2.0
#include "app/start/left_work_card.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/kit/form.h"
#include "app/style/icon.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr QSize kPicture(160, 90);

QString shownPath(const std::filesystem::path& path) {
  return QDir::toNativeSeparators(QString::fromStdString(path.string()));
}

QString shownTime(const std::filesystem::path& file) {
  return QLocale().toString(QFileInfo(QString::fromStdString(file.string())).lastModified(),
                            LeftWorkCard::tr("d MMMM yyyy, HH:mm:ss"));
}

}  // namespace

LeftWorkCard::LeftWorkCard(const workcell::LeftWork& left, QWidget* parent) : QWidget(parent) {
  setObjectName("leftWork");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 12, 12, 12);
  row->setSpacing(14);
  addPicture(*row, left);
  addWords(*row, left);
  addButtons(*row, !left.copy.empty());
}

void LeftWorkCard::addPicture(QHBoxLayout& row, const workcell::LeftWork& left) {
  auto* label = new QLabel;
  label->setFixedSize(kPicture);
  label->setAlignment(Qt::AlignCenter);
  const QPixmap picture(QString::fromStdString(left.picture.string()));
  if (picture.isNull()) {
    label->setPixmap(icon("cell").pixmap(32, 32));
  } else {
    const QPixmap wide = picture.scaled(kPicture, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    label->setPixmap(wide.copy(
        QRect(QPoint((wide.width() - kPicture.width()) / 2, (wide.height() - kPicture.height()) / 2), kPicture)));
  }
  row.addWidget(label, 0, Qt::AlignTop);
}

void LeftWorkCard::addWords(QHBoxLayout& row, const workcell::LeftWork& left) {
  auto* words = new QVBoxLayout;
  words->setSpacing(3);
  const auto add = [words](const QString& text, TextRole role, bool quiet) {
    auto* label = makeLabel(text, role, quiet);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    words->addWidget(label);
  };
  if (left.copy.empty()) {
    add(tr("HaptiCell crashed; no changes were lost"), TextRole::kSection, false);
  } else if (left.document.empty()) {
    add(tr("New workcell"), TextRole::kSection, false);
    add(tr("Never saved. Kept up to %1.").arg(shownTime(left.copy)), TextRole::kText, false);
  } else {
    add(QString::fromStdString(left.document.filename().string()), TextRole::kSection, false);
    add(tr("Unsaved changes, kept up to %1.").arg(shownTime(left.copy)), TextRole::kText, false);
    add(shownPath(left.document.parent_path()), TextRole::kSecond, true);
    if (left.document_changed)
      add(tr("Another program has changed the file since; the copy does not have those changes."), TextRole::kSecond,
          true);
  }
  add(left.crash.empty() ? tr("The program was terminated, or the power failed.")
                         : tr("Cause: %1").arg(QString::fromStdString(left.crash)),
      TextRole::kSecond, true);
  words->addStretch(1);
  row.addLayout(words, 1);
}

void LeftWorkCard::addButtons(QHBoxLayout& row, bool has_copy) {
  auto* column = new QVBoxLayout;
  column->setSpacing(6);
  const auto add = [&](const QString& text, const char* name, void (LeftWorkCard::*signal)()) {
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    button->setMinimumWidth(124);
    connect(button, &QPushButton::clicked, this, signal);
    column->addWidget(button);
    return button;
  };
  if (has_copy) {
    add(tr("Restore"), "buttonRestoreLeft", &LeftWorkCard::restoreWanted)->setProperty("main", true);
    add(tr("Later"), "buttonLaterLeft", &LeftWorkCard::laterWanted);
    add(tr("Discard copy"), "buttonDiscardLeft", &LeftWorkCard::discardWanted);
  } else {
    add(tr("Close"), "buttonDiscardLeft", &LeftWorkCard::discardWanted);
  }
  column->addStretch(1);
  row.addLayout(column);
}

void LeftWorkCard::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  drawBox(&painter, rect(), theme.header, theme.line, 4);
  painter.fillRect(QRect(0, 0, 3, height()), theme.near_miss);
}

}  // namespace hapticell::app
