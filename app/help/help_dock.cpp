// SPDX-License-Identifier: Apache-2.0
#include "app/help/help_dock.h"

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QMainWindow>
#include <QMenu>
#include <QTextBrowser>
#include <QTimer>

#include "app/help/scene_text.h"
#include "app/host/actions.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/settings/user_choices.h"
#include "app/style/dock_title_bar.h"
#include "app/style/icon.h"
#include "app/viewport/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr int kReadMilliseconds = 1000;  // A reader is not to be talked over.

QString read(const QString& language, const QString& page) {
  QFile file(QStringLiteral(":/hapticell/help/%1/%2.md").arg(language, page));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

class HelpDock : public QObject {
 public:
  explicit HelpDock(Host& host) : QObject(&host.window()), host_(host) {
    if (auto* help = host.window().findChild<QAction*>("actionHelp"))
      connect(help, &QAction::triggered, this, [this] { showPage(dockInFocus(host_)); });
    if (auto* words = host.window().findChild<QAction*>("actionSceneText"))
      connect(words, &QAction::triggered, this, [this] {
        shows_scene_ = true;
        browser()->setPlainText(now());
        bring(tr("The scene in words"));
      });
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, this, &HelpDock::tellReader);
    timer->start(kReadMilliseconds);
  }

 private:
  QString now() const {
    return sceneText(host_.documentModel().document().state(), host_.selection().all(), host_.viewport().scene());
  }

  /// The scene's text is its accessible description, so that a screen reader has it without a panel.
  void tellReader() {
    if (!QAccessible::isActive() && !(dock_ && dock_->isVisible() && shows_scene_)) return;
    const QString text = now();
    if (text == told_) return;
    told_ = text;
    host_.viewport().setAccessibleDescription(text);
    if (dock_ && dock_->isVisible() && shows_scene_) browser()->setPlainText(text);
  }

  void showPage(const QString& dock) {
    shows_scene_ = false;
    browser()->setMarkdown(helpPage(dock, languageFrom(host_.userSettings())));
    bring(tr("Help"));
  }

  QTextBrowser* browser() {
    if (browser_) return browser_;
    browser_ = new QTextBrowser;
    browser_->setObjectName("browserHelp");
    browser_->setAccessibleName(tr("Help"));
    browser_->setFrameShape(QFrame::NoFrame);
    browser_->setMinimumWidth(332);
    browser_->document()->setDocumentMargin(12);
    dock_ = makeDock("dockHelp", tr("Help"), browser_);
    dock_->setWindowIcon(icon("help"));
    host_.addDock(dock_, Qt::RightDockWidgetArea);
    return browser_;
  }

  void bring(const QString& title) {
    dock_->setWindowTitle(title);
    dock_->show();
    dock_->raise();
    browser_->setFocus(Qt::ShortcutFocusReason);
  }

  Host& host_;
  QTextBrowser* browser_ = nullptr;
  QDockWidget* dock_ = nullptr;
  QString told_;
  bool shows_scene_ = false;
};

}  // namespace

QString helpPage(const QString& dock, const QString& language) {
  for (const QString& page : {dock, QStringLiteral("scene")})
    for (const QString& spoken : {language, QStringLiteral("en")})
      if (const QString text = page.isEmpty() ? QString() : read(spoken, page); !text.isEmpty()) return text;
  return {};
}

QString dockInFocus(Host& host) {
  const QWidget* focus = QApplication::focusWidget();
  for (const QDockWidget* dock : host.window().findChildren<QDockWidget*>())
    if (focus && dock->isAncestorOf(focus)) return dock->objectName();
  return {};
}

void addHelp(Host& host) {
  new HelpDock(host);
}

}  // namespace hapticell::app
