// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/widgets/preparation_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "app/style/icon.h"

namespace hapticell::app {

namespace {

constexpr int kMargin = 12;

}  // namespace

PreparationBar::PreparationBar(QWidget* parent) : QWidget(parent) {
  setObjectName("barPreparation");
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Window);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 4, 6, 4);
  row->setSpacing(6);
  text_ = new QLabel;
  bar_ = new QProgressBar;
  bar_->setObjectName("progressPreparation");
  bar_->setAccessibleName(tr("Preparing contacts"));
  bar_->setRange(0, 100);
  bar_->setTextVisible(false);
  bar_->setFixedSize(96, 6);
  auto* cancel = new QToolButton;
  cancel->setObjectName("buttonCancelPreparation");
  cancel->setAutoRaise(true);
  cancel->setIcon(icon("close"));
  cancel->setToolTip(tr("Cancel: the change is not felt until the next change"));
  row->addWidget(text_);
  row->addWidget(bar_);
  row->addWidget(cancel);
  hide();
  connect(cancel, &QToolButton::clicked, this, &PreparationBar::cancelled);
}

void PreparationBar::setShare(std::optional<double> share) {
  if (!share) {
    since_.invalidate();
    hide();
    return;
  }
  if (!since_.isValid()) since_.start();
  const int percent = static_cast<int>(100.0 * *share);
  text_->setText(tr("Not felt yet: preparing contacts %1 %").arg(percent));
  bar_->setValue(percent);
  if (since_.elapsed() < patience_) return;
  adjustSize();
  if (const QWidget* over = parentWidget()) move(kMargin, over->height() - height() - kMargin);
  show();
  raise();
}

}  // namespace hapticell::app
