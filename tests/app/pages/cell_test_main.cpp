// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTimer>

#include "app/shell/application.h"
#include "app/style/fonts.h"
#include "app/style/proxy_style.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

/// A question that nobody answers would keep a test until its time is over, without a word: it is told of, with its
/// texts, and cancelled.
class UnansweredQuestions final : public QObject {
 public:
  UnansweredQuestions() { startTimer(1000); }

 private:
  static constexpr int kPatience = 30;  // Seconds: longer than any test waits for something.
  void timerEvent(QTimerEvent* /*event*/) override {
    auto* question = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    seconds_ = question && question == last_ ? seconds_ + 1 : 0;
    last_ = question;
    if (seconds_ < kPatience) return;
    QStringList texts{question->metaObject()->className(), question->objectName(), question->windowTitle()};
    for (const QLabel* label : question->findChildren<QLabel*>()) texts << label->text();
    for (const QLineEdit* edit : question->findChildren<QLineEdit*>()) texts << edit->text();
    for (const QAbstractButton* button : question->findChildren<QAbstractButton*>())
      texts << button->text() + (button->isEnabled() ? "" : " (grey)");
    ADD_FAILURE() << "nobody answers: " << texts.join(" | ").toStdString();
    question->reject();
  }
  QDialog* last_ = nullptr;
  int seconds_ = 0;
};

}  // namespace
}  // namespace hapticell::app

int main(int argc, char** argv) {
  hapticell::app::Application application(argc, argv);
  QApplication::setStyle(new hapticell::app::ProxyStyle);
  QApplication::setFont(hapticell::app::textFont(hapticell::app::TextRole::kText));
  QApplication::setPalette(hapticell::app::paletteOf(hapticell::app::darkTheme()));
  hapticell::app::UnansweredQuestions questions;
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
