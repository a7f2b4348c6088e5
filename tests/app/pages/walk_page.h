// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDir>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QToolBar>
#include <QWindow>

#include "tests/app/pages/cell_page.h"
#include "tests/app/pages/server_first.h"

namespace hapticell::app {

/// A person at the window: everything is done by mouse and keys as the window system gives them, so what lies under
/// something else, out of sight or without the focus does not answer; and everything is counted. A haptic server of
/// its own has a simulated stylus. Pictures go to the folder named by HAPTICELL_WALK_PICTURES, if it is set.
class WalkPage : public ServerFirst, public CellPage {
 public:
  static constexpr int kPatience = 20000;  // ms.

  WalkPage() : CellPage(on(withoutMotion())) {
    window().resize(1600, 1000);
    window().loadModules(ModuleLoader::defaultFolders());
    EXPECT_TRUE(window().startModule("Virtual Desktop"));
    window().restoreLayout();
    EXPECT_TRUE(until([this] { return window().snapshot() && window().snapshot()->stylus.connected; }, kPatience));
    trigger("actionFirstPage");
    activate();
  }
  int clicks() const { return clicks_; }
  int keys() const { return keys_; }
  int texts() const { return texts_; }
  std::string counted() const {
    return std::to_string(clicks_) + " clicks, " + std::to_string(keys_) + " keys, " + std::to_string(texts_) +
           " typed texts";
  }

  void clickAt(QWidget* widget, const QPoint& place, Qt::MouseButton button = Qt::LeftButton) {
    ASSERT_NE(widget, nullptr);
    const QPoint global = widget->mapToGlobal(place);
    QWidget* under = QApplication::widgetAt(global);
    ASSERT_TRUE(under && (under == widget || widget->isAncestorOf(under)))
        << nameOf(widget) << " is under " << nameOf(under) << " or out of sight";
    QCursor::setPos(global);
    QWindow* screen = under->window()->windowHandle();
    QTest::mouseClick(screen, button, Qt::NoModifier, under->window()->mapFromGlobal(global));
    ++clicks_;
    settle();
    activateTop();
  }
  /// A button, a card, a field: in its middle.
  void clickOn(const char* name) {
    QWidget* widget = seen(name);
    ASSERT_NE(widget, nullptr) << name << " is not seen";
    ASSERT_TRUE(widget->isEnabled()) << name << " is grey";
    scrollTo(widget);
    clickAt(widget, widget->rect().center());
  }
  /// A button of the tool bar.
  void clickTool(const char* action_name) {
    auto* action = window().findChild<QAction*>(action_name);
    ASSERT_TRUE(action && action->isEnabled()) << action_name;
    for (QToolBar* bar : window().findChildren<QToolBar*>())
      if (QWidget* button = bar->widgetForAction(action)) return clickAt(button, button->rect().center());
    ADD_FAILURE() << action_name << " is in no tool bar";
  }
  void clickSegment(const char* name, int index) {
    auto* segments = dynamic_cast<Segmented*>(seen(name));
    ASSERT_NE(segments, nullptr) << name;
    scrollTo(segments->button(index));
    clickAt(segments->button(index), segments->button(index)->rect().center());
  }
  /// A menu of the bar and an entry of it: two clicks.
  void choose(const char* menu_name, const char* action_name) {
    auto* menu = window().menuBar()->findChild<QMenu*>(menu_name);
    auto* action = window().findChild<QAction*>(action_name);
    ASSERT_TRUE(menu && action && action->isEnabled()) << menu_name << ' ' << action_name;
    clickAt(window().menuBar(), window().menuBar()->actionGeometry(menu->menuAction()).center());
    ASSERT_TRUE(until([menu] { return menu->isVisible(); }, kPatience)) << menu_name;
    clickAt(menu, menu->actionGeometry(action).center());
  }
  void rightClickAt(QWidget* widget, const QPoint& place) { clickAt(widget, place, Qt::RightButton); }
  /// An entry of the menu that a click has opened.
  void chooseFromPopup(const char* action_name) {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    auto* action = window().findChild<QAction*>(action_name);
    ASSERT_NE(menu, nullptr) << "no menu is open";
    ASSERT_TRUE(action && action->isVisible() && menu->actions().contains(action)) << action_name;
    clickAt(menu, menu->actionGeometry(action).center());
  }
  void clickTab(const char* dock) {
    const auto* wanted = window().findChild<QDockWidget*>(dock);
    ASSERT_NE(wanted, nullptr) << dock;
    for (QTabBar* bar : window().findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
      for (int tab = 0; tab < bar->count(); ++tab)
        if (bar->isVisible() && bar->tabText(tab) == wanted->windowTitle())
          return clickAt(bar, bar->tabRect(tab).center());
    ADD_FAILURE() << dock << " has no tab";
  }
  void clickRow(const char* list, int row) {
    auto* view = dynamic_cast<QAbstractItemView*>(seen(list));
    ASSERT_NE(view, nullptr) << list;
    ASSERT_LT(row, view->model()->rowCount()) << list;
    view->scrollTo(view->model()->index(row, 0));
    clickAt(view->viewport(), view->visualRect(view->model()->index(row, 0)).center());
  }
  /// The row of a list or tree whose text begins so; in a tree the first such at any depth that is open.
  void clickText(const char* list, const QString& begins) {
    auto* view = dynamic_cast<QAbstractItemView*>(seen(list));
    ASSERT_NE(view, nullptr) << list;
    const auto found = view->model()->match(view->model()->index(0, 0), Qt::DisplayRole, begins, 1,
                                            Qt::MatchStartsWith | Qt::MatchRecursive);
    ASSERT_FALSE(found.isEmpty()) << begins.toStdString() << " is not in " << list;
    view->scrollTo(found.front());
    clickAt(view->viewport(), view->visualRect(found.front()).center());
  }
  void press(Qt::Key key, Qt::KeyboardModifiers held = Qt::NoModifier) {
    QTest::keyClick(keyboard(), key, held);
    ++keys_;
    settle();
  }
  void hold(Qt::Key key) {
    QTest::keyPress(keyboard(), key);
    ++keys_;
    settle();
  }
  void letGo(Qt::Key key) {
    QTest::keyRelease(keyboard(), key);
    settle();
  }
  /// One text, typed where the focus is.
  void typeText(const QString& text) {
    for (const QChar c : text) QTest::keyClick(keyboard(), c.toLatin1());
    ++texts_;
    settle();
  }
  /// Does what asks for a file, and answers with its name and Enter; a question before it gets what it proposes, and changes
  /// are discarded.
  template <class Ask>
  void withFile(const QString& path, Ask&& ask) {
    bool answered = false;
    QTimer timer;
    const QWidget* asked = nullptr;
    QObject::connect(&timer, &QTimer::timeout, [&] {
      QWidget* dialog = QApplication::activeModalWidget();
      if (auto* question = qobject_cast<QMessageBox*>(dialog); question && question != asked) {
        asked = question;
        QAbstractButton* answer = question->button(QMessageBox::Discard);
        if (!answer) answer = question->defaultButton();
        // By a timer of its own: this one is not called again while the file dialog is open within its call.
        QTimer::singleShot(0, answer, [this, answer] { clickAt(answer, answer->rect().center()); });
      }
      if (answered || !dialog || dialog->objectName() != "fileDialog" || !dialog->windowHandle()) return;
      answered = true;
      auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
      name->setFocus();  // Where a person would type, too: it has the focus once the dialog is open.
      name->selectAll();
      typeText(path);
      press(Qt::Key_Return);
    });
    timer.start(50);
    ask();
    EXPECT_TRUE(answered) << "nobody asked for a file";
    activateTop();
  }
  /// The pointer into the scene, at parts of its width and height.
  void pointInto(double right, double down) {
    place_ = QPointF(right * window().viewport().width(), down * window().viewport().height());
    moveTo(place_);
  }
  /// The mouse goes by so many pixels over the scene, a few at a time.
  void drag(double right, double down) {
    const int steps = static_cast<int>(std::ceil(std::max(std::abs(right), std::abs(down)) / 8.0));
    const QPointF from = place_;
    for (int i = 1; i <= steps; ++i) {
      place_ = from + QPointF(right, down) * (double(i) / steps);
      moveTo(place_);
    }
  }
  const manipulation::SceneSnapshot& now() { return *window().snapshot(); }
  void picture(const char* name) {
    const QString folder = qEnvironmentVariable("HAPTICELL_WALK_PICTURES");
    if (folder.isEmpty()) return;
    setFinePictures();
    until([this] { return window().viewport().isFinished(); }, 5000);
    QDir().mkpath(folder);
    window().grab().save(folder + '/' + QLatin1String(name) + ".png");
  }

 private:
  static config::Configuration withoutMotion() {
    config::Configuration configuration;
    configuration.gui.motion = false;
    return configuration;
  }
  static std::string nameOf(const QWidget* widget) {
    if (!widget) return "nothing";
    return widget->metaObject()->className() + std::string(" ") + widget->objectName().toStdString();
  }
  /// The one of this name that is seen: a page that is not in front may have another.
  QWidget* seen(const char* name) {
    QWidget* any = nullptr;
    for (QWidget* widget : QApplication::allWidgets()) {
      if (widget->objectName() != QLatin1String(name)) continue;
      if (widget->isVisible()) return widget;
      any = widget;
    }
    EXPECT_EQ(any, nullptr) << name << " is hidden";
    return nullptr;
  }
  static void scrollTo(QWidget* widget) {
    for (QWidget* holder = widget->parentWidget(); holder; holder = holder->parentWidget())
      if (auto* area = qobject_cast<QScrollArea*>(holder)) area->ensureWidgetVisible(widget, 0, 12);
    settle();
  }
  /// The window that is on top has the keys: on a desktop its window manager sees to that.
  void activateTop() {
    if (QApplication::activePopupWidget() || QApplication::activeModalWidget()) return;
    QWidget* top = &window();
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (widget->isVisible() && widget->inherits("QDialog")) top = widget;
    if (top->isActiveWindow()) return;
    top->activateWindow();
    until([top] { return top->isActiveWindow(); }, 2000);
  }
  QWindow* keyboard() {
    if (QWidget* dialog = QApplication::activeModalWidget()) return dialog->windowHandle();
    QWindow* focus = QGuiApplication::focusWindow();
    return focus ? focus : window().windowHandle();
  }
  void moveTo(const QPointF& place) {
    const QPoint in_window = window().viewport().mapTo(&window(), place.toPoint());
    QCursor::setPos(window().mapToGlobal(in_window));
    QTest::mouseMove(window().windowHandle(), in_window);
    QApplication::processEvents(QEventLoop::AllEvents, 10);
  }
  int clicks_ = 0, keys_ = 0, texts_ = 0;
  QPointF place_;
};

}  // namespace hapticell::app
