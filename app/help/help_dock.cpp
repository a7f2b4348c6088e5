// SPDX-License-Identifier: Apache-2.0
#include "app/help/help_dock.h"

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QRegularExpression>
#include <QTimer>

#include "app/help/help_panel.h"
#include "app/help/scene_text.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/language.h"
#include "app/host/selection.h"
#include "app/kit/dock_front.h"
#include "app/kit/key_overlay.h"
#include "app/style/dock_title_bar.h"
#include "app/style/icon.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

// ms between two sentences on the scene: a reader is not to be talked over. Half: sentences pile up; twice: they are
// late.
constexpr int kReadMilliseconds = 1000;
constexpr int kHelpWidth = 332;
const QString kSceneWords = QStringLiteral("sceneWords");

/// As Markdown that reads the same.
QString escaped(QString text) {
  static const QRegularExpression marks(QStringLiteral(R"(([\\`*_{}\[\]<>#|~]))"));
  return text.replace(marks, QStringLiteral("\\\\1"));
}

class HelpDock : public QObject {
 public:
  explicit HelpDock(Host& host) : QObject(&host.window()), host_(host) {
    opens("actionHelp", [this] {
      const QString dock = dockInFocus(host_);
      if (dock == QStringLiteral("dockHelp")) return panel()->page();
      return dock.isEmpty() ? QStringLiteral("scene") : dock;
    });
    opens("actionManual", [] { return QStringLiteral("firstSteps"); });
    opens("actionSceneText", [] { return kSceneWords; });
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, this, &HelpDock::readAloud);
    timer->start(kReadMilliseconds);
  }

 private:
  template <typename Page>
  void opens(const char* action, Page page) {
    auto* found = host_.window().findChild<QAction*>(QString::fromLatin1(action));
    if (!found) return;
    connect(found, &QAction::triggered, this, [this, page] {
      const QString name = page();
      if (panel()->page() == name)
        panel()->refresh();
      else
        panel()->showPage(name);
      bringToFront(dock_);
      panel()->setFocus(Qt::ShortcutFocusReason);
    });
  }

  QString now() const {
    return sceneText(host_.documentModel().document().state(), host_.selection().all(), host_.viewport().scene());
  }

  /// The scene's text is its accessible description, so that a screen reader has it without a panel.
  void readAloud() {
    const bool shown = dock_ && dock_->isVisible() && panel_->page() == kSceneWords;
    if (!QAccessible::isActive() && !shown) return;
    const QString text = now();
    if (text == told_) return;
    told_ = text;
    host_.viewport().setAccessibleDescription(text);
    if (shown) panel_->refresh();
  }

  /// What a page says of this cell and of this user's keys.
  QString addition(const QString& page) const {
    QString lines;
    if (page == kSceneWords)
      for (const QString& line : now().split('\n')) lines += QStringLiteral("- ") + escaped(line) + '\n';
    if (page == QStringLiteral("keys"))
      for (const KeyLine& line : keyLines(host_.window()))
        lines += QStringLiteral("- **%1**  %2\n").arg(escaped(line.key), escaped(line.does));
    return lines;
  }

  HelpPanel* panel() {
    if (panel_) return panel_;
    panel_ = new HelpPanel(languageNow(), [this](const QString& page) { return addition(page); });
    panel_->setMinimumWidth(kHelpWidth);
    dock_ = makeDock("dockHelp", tr("Help"), panel_);
    dock_->setWindowIcon(icon("help"));
    host_.addDock(dock_, Qt::RightDockWidgetArea);
    return panel_;
  }

  Host& host_;
  HelpPanel* panel_ = nullptr;
  QDockWidget* dock_ = nullptr;
  QString told_;
};

}  // namespace

QString dockInFocus(Host& host) {
  const QWidget* focus = QApplication::focusWidget();
  const bool nowhere = !focus || focus == &host.window();
  for (const QDockWidget* dock : host.window().findChildren<QDockWidget*>()) {
    if (focus && dock->isAncestorOf(focus)) return dock->objectName();
    if (nowhere && !dock->visibleRegion().isEmpty() &&
        host.window().dockWidgetArea(const_cast<QDockWidget*>(dock)) == Qt::RightDockWidgetArea)
      return dock->objectName();
  }
  return {};
}

void addHelp(Host& host) {
  new HelpDock(host);
}

}  // namespace hapticell::app
