// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>

#include "app/style/segmented.h"
#include "tests/app/pages/window_page.h"

namespace hapticell::app {

/// What a user does with the import panel.
class ImportPage : public WindowPage {
 public:
  using WindowPage::WindowPage;
  /// Asks for files and waits until all of them are shown.
  bool ask(const QStringList& paths) {
    window().importFiles(paths);
    return until(
        [this] {
          const auto& files = window().files().session().files();
          return std::all_of(files.begin(), files.end(),
                             [](const FileImport& file) { return file.stage == FileImport::Stage::kReady; });
        },
        60000);
  }
  const FileImport& shown() { return window().files().session().files().front(); }
  QString text(const char* label) { return window().files().dock().findChild<QLabel*>(label)->text(); }
  QString unit() { return window().files().dock().findChild<QComboBox*>("importUnit")->currentText(); }
  void chooseUnit(const QString& begins) {
    auto* box = window().files().dock().findChild<QComboBox*>("importUnit");
    for (int row = 0; row < box->count(); ++row) {
      if (!box->itemText(row).startsWith(begins)) continue;
      box->setCurrentIndex(row);
      emit box->activated(row);
    }
  }
  void choose(const char* segments, int index) {
    auto* found = window().files().dock().findChild<Segmented*>(segments);
    found->setCurrent(index);
    emit found->chosen(index);
  }
  bool press(const char* button) {
    auto* found = window().files().dock().findChild<QAbstractButton*>(button);
    if (!found || !found->isEnabled()) return false;
    found->click();
    return true;
  }
  bool idle() {
    return until([this] { return !window().files().isBusy(); }, 60000);
  }
  /// The newest message whose title holds `words`.
  const Message* told(const QString& words) {
    const auto& all = window().messages().messages();
    for (auto message = all.rbegin(); message != all.rend(); ++message)
      if (message->title.contains(words)) return &*message;
    return nullptr;
  }
  const workcell::Entity* entity(const char* name) { return window().documentModel().document().findByName(name); }
};

/// A block of x times y times z as an ASCII OFF file.
inline QString writeBlock(const QString& path, double x, double y, double z) {
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return {};
  QString text = QStringLiteral("OFF\n8 6 12\n");
  for (int k = 0; k < 8; ++k)
    text += QStringLiteral("%1 %2 %3\n").arg(k & 1 ? x : 0).arg(k & 2 ? y : 0).arg(k & 4 ? z : 0);
  text += "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
  file.write(text.toLatin1());
  return path;
}

}  // namespace hapticell::app
