// SPDX-License-Identifier: Apache-2.0
#include "app/views/view_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>

#include "app/kit/action_face.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/viewport/widget/viewport_widget.h"
#include "app/views/follow_camera.h"
#include "app/views/saved_views.h"
#include "app/views/view_pictures.h"

namespace hapticell::app {
namespace {

class ViewActions : public QObject {
 public:
  ViewActions(Host& host, QMenu& view)
      : QObject(&host.window()), host_(host), views_(host.userSettings()), follow_(host, this) {
    view.addSeparator();
    addStandard(view);
    saved_ = view.addMenu(tr("Saved views"));
    saved_->setObjectName("menuSavedViews");
    connect(saved_, &QMenu::aboutToShow, this, &ViewActions::fillSaved);
    addFollow(view);
    view.addSeparator();
    QAction* full = add(view, {"actionFullScreen", tr("Full screen"), {}, QKeySequence(Qt::Key_F11), {}});
    full->setCheckable(true);
    connect(full, &QAction::toggled, this, [this](bool on) {
      QMainWindow& window = host_.window();
      window.setWindowState(on ? window.windowState() | Qt::WindowFullScreen
                               : window.windowState() & ~Qt::WindowFullScreen);
    });
    QAction* keep =
        add(view, {"actionKeepView", tr("Save this view"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_V), {}});
    connect(keep, &QAction::triggered, this, [this] {
      setCell();
      const QString name = views_.freeName();
      views_.keep(name, host_.viewport().camera());
      host_.messages().tell(Severity::kInformation, tr("%1 is saved").arg(name),
                            tr("To go back to it: View > Saved views."));
    });
    addPictures(host_, view, this);
    connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
      setCell();
      views_.closeCell();
    });
    fillSaved();
  }

 private:
  QAction* add(QMenu& menu, const ActionFace& face) {
    QAction* action = makeAction(&host_.window(), face);
    host_.window().addAction(action);
    menu.addAction(action);
    return action;
  }

  void addStandard(QMenu& view) {
    const auto one = [&](const char* name, const QString& text, StandardView way, const QKeySequence& key) {
      connect(add(view, {name, text, {}, key, {}}), &QAction::triggered, this,
              [this, way] { host_.viewport().setStandardView(way); });
    };
    const auto pad = [](Qt::Key key) {
      return QKeySequence(QKeyCombination(Qt::KeypadModifier | Qt::ControlModifier, key));
    };
    one("actionBack", tr("Back"), StandardView::kBack, pad(Qt::Key_1));
    one("actionLeft", tr("Left"), StandardView::kLeft, pad(Qt::Key_3));
    one("actionBottom", tr("Bottom"), StandardView::kBottom, pad(Qt::Key_7));
  }

  void addFollow(QMenu& view) {
    QMenu* menu = view.addMenu(tr("Follow"));
    menu->setObjectName("menuFollow");
    auto* group = new QActionGroup(this);
    using What = FollowCamera::What;
    const auto one = [&](const char* name, const QString& text, What what) {
      QAction* action = add(*menu, {name, text, {}, {}, {}});
      action->setCheckable(true);
      action->setChecked(what == What::kNothing);
      group->addAction(action);
      connect(action, &QAction::triggered, this, [this, what] { follow(what); });
      connect(&follow_, &FollowCamera::changed, action,
              [this, action, what] { action->setChecked(follow_.what() == what); });
      connect(menu, &QMenu::aboutToShow, action,
              [this, action, what] { action->setEnabled(what == What::kNothing || follow_.canFollow(what)); });
    };
    one("actionFollowNothing", tr("Nothing"), What::kNothing);
    one("actionFollowTool", tr("The robot's tool centre point"), What::kTool);
    one("actionFollowEyes", tr("Through the mannequin's eyes"), What::kEyes);
  }

  void follow(FollowCamera::What what) {
    using What = FollowCamera::What;
    if (what == What::kNothing || follow_.canFollow(what)) return follow_.follow(what);
    host_.messages().tell(Severity::kInformation, tr("There is nothing to follow"),
                          what == What::kTool ? tr("Add a robot to the cell first.")
                                              : tr("Add a mannequin to the cell first."));
    emit follow_.changed();  // The entry that was chosen is not the one that holds.
  }

  void setCell() { views_.setCell(QString::fromStdString(host_.documentModel().document().path().string())); }

  void fillSaved() {
    setCell();
    saved_->clear();
    const QStringList names = views_.names();
    for (const QString& name : names)
      saved_->addAction(name, this, [this, name] {
        if (const auto camera = views_.find(name)) host_.viewport().setCamera(*camera);
      });
    if (names.isEmpty()) saved_->addAction(tr("None yet. Save this view adds one."))->setEnabled(false);
    if (names.isEmpty()) return;
    saved_->addSeparator();
    QMenu* remove = saved_->addMenu(tr("Remove"));
    for (const QString& name : names) remove->addAction(name, this, [this, name] { views_.remove(name); });
  }

  Host& host_;
  SavedViews views_;
  FollowCamera follow_;
  QMenu* saved_;
};

}  // namespace

void addViewActions(Host& host, QMenu& view) {
  new ViewActions(host, view);
}

}  // namespace hapticell::app
