// SPDX-License-Identifier: Apache-2.0
#include "app/help/about_dialog.h"

#include <QApplication>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "app/kit/form.h"

namespace hapticell::app {
namespace {

constexpr QSize kSize{680, 560};
constexpr int kIcon = 64;

/// What is told in words that depend on the language; libraries and licences are names.
class AboutDialog : public QDialog {
  Q_DECLARE_TR_FUNCTIONS(AboutDialog)
 public:
  explicit AboutDialog(QWidget* parent) : QDialog(parent) {
    setObjectName("dialogAbout");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("About HaptiCell"));
    resize(kSize);
    auto* column = new QVBoxLayout(this);
    auto* head = new QHBoxLayout;
    auto* mark = new QLabel;
    mark->setPixmap(QApplication::windowIcon().pixmap(kIcon, kIcon));
    auto* words = new QVBoxLayout;
    auto* name = makeLabel(tr("HaptiCell %1").arg(QApplication::applicationVersion()), TextRole::kPanelState);
    name->setObjectName("labelVersion");
    auto* purpose = makeLabel(tr("Move solids, robots and people in a CAD workcell, and feel the contacts."),
                              TextRole::kText, true);
    auto* licence =
        makeLabel(tr("Apache License 2.0. Runs with Qt %1.").arg(QLatin1String(qVersion())), TextRole::kText, true);
    for (QLabel* label : {name, purpose, licence}) words->addWidget(label);
    head->addWidget(mark, 0, Qt::AlignTop);
    head->addSpacing(12);
    head->addLayout(words, 1);
    column->addLayout(head);
    auto* licences = new QTextBrowser;
    licences->setObjectName("textLicences");
    licences->setAccessibleName(tr("Libraries and their licences"));
    QFile page(QStringLiteral(":/hapticell/help/licences.md"));
    if (page.open(QIODevice::ReadOnly)) licences->setMarkdown(QString::fromUtf8(page.readAll()));
    column->addWidget(licences, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setText(tr("Close"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
  }
};

}  // namespace

void showAbout(QWidget& parent) {
  auto* open = parent.findChild<QDialog*>("dialogAbout");
  if (!open) open = new AboutDialog(&parent);
  open->show();
  open->raise();
  open->activateWindow();
}

}  // namespace hapticell::app
