// SPDX-License-Identifier: Apache-2.0
#include "app/start/start_page.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

#include "app/host/user_settings.h"
#include "app/kit/form.h"
#include "app/kit/kept_picture.h"
#include "app/start/left_work_card.h"
#include "app/start/recent_card.h"
#include "app/start/recent_files.h"
#include "app/start/sample_card.h"
#include "app/style/icon.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"
#include "config/configuration.h"

namespace hapticell::app {
namespace {

constexpr int kMostRecent = 4;

struct Sample {
  const char* cell;
  QString title, sentence;
};

std::vector<Sample> samples() {
  return {{"demo", StartPage::tr("Robot over a fixture"),
           StartPage::tr("Lower the part onto its locators and feel what it touches.")},
          {"car_door", StartPage::tr("A car door on its hinge"),
           StartPage::tr("Open it by the handle: feel the guide, its stops and a detent.")},
          {"workbench", StartPage::tr("A person at a bench"),
           StartPage::tr("Pose the mannequin and check its reach and posture.")}};
}

}  // namespace

StartPage::StartPage(QWidget& scene, UserSettings& settings, RecentFiles& recent)
    : QFrame(&scene), scene_(scene), settings_(settings), recent_(recent) {
  setObjectName("startPage");
  setAccessibleName(tr("Start page"));
  setFocusPolicy(Qt::StrongFocus);
  hide();
  scene_.installEventFilter(this);
}

void StartPage::open(const std::vector<workcell::LeftWork>& left) {
  build(left);
  place();
  show();
  raise();
  setFocus(Qt::OtherFocusReason);
}

void StartPage::build(const std::vector<workcell::LeftWork>& left) {
  delete scroll_;
  content_ = new QWidget;
  auto* column = new QVBoxLayout(content_);
  column->setContentsMargins(24, 20, 24, 16);
  column->setSpacing(14);
  addLeft(*column, left);
  column->addWidget(makeLabel(tr("Start with a sample or your own cell"), TextRole::kPanelNumber));
  addSamples(*column);
  addOwn(*column);
  auto* whole = new QVBoxLayout;
  delete layout();
  setLayout(whole);
  whole->setContentsMargins(0, 0, 0, 0);
  // A small window shows as much as it can and scrolls to the rest.
  scroll_ = new QScrollArea;
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setWidgetResizable(true);
  scroll_->setWidget(content_);
  content_->setAutoFillBackground(false);
  scroll_->viewport()->setAutoFillBackground(false);
  whole->addWidget(scroll_);
}

void StartPage::addLeft(QVBoxLayout& column, const std::vector<workcell::LeftWork>& left) {
  if (left.empty()) return;
  column.addWidget(makeLabel(tr("HaptiCell was not closed properly"), TextRole::kPanelNumber));
  for (const workcell::LeftWork& work : left) {
    auto* card = new LeftWorkCard(work);
    connect(card, &LeftWorkCard::restoreWanted, this, [this, work] { emit restoreWanted(work); });
    connect(card, &LeftWorkCard::discardWanted, this, [this, work] { emit discardWanted(work); });
    connect(card, &LeftWorkCard::laterWanted, this, [this, work] { emit laterWanted(work); });
    column.addWidget(card);
  }
}

void StartPage::addSamples(QVBoxLayout& column) {
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  for (const Sample& sample : samples()) {
    const std::string base = std::string("workcells/") + sample.cell;
    const auto file = config::findShippedFile(base + ".hcell");
    if (!file) continue;
    const auto picture = config::findShippedFile(base + ".jpg");
    auto* card =
        new SampleCard(picture ? QPixmap(QString::fromStdString(*picture)) : QPixmap(), sample.title, sample.sentence);
    card->setObjectName(QStringLiteral("sample_") + QLatin1String(sample.cell));
    connect(card, &QAbstractButton::clicked, this,
            [this, path = QString::fromStdString(*file)] { emit fileWanted(path); });
    row->addWidget(card);
  }
  row->addStretch(1);
  column.addLayout(row);
}

void StartPage::addOwn(QVBoxLayout& column) {
  auto* row = new QHBoxLayout;
  row->setSpacing(24);
  auto* begin = new QVBoxLayout;
  begin->setSpacing(8);
  begin->addWidget(makeLabel(tr("Custom"), TextRole::kSection));
  const auto add = [&](const QString& text, const QString& icon_name, const char* action) {
    auto* button = new QPushButton(icon(icon_name), text);
    button->setObjectName(QStringLiteral("start_") + QLatin1String(action));
    button->setFixedWidth(248);
    connect(button, &QPushButton::clicked, this, [this, action] { emit actionWanted(QLatin1String(action)); });
    begin->addWidget(button);
  };
  add(tr("Open a workcell…"), "open", "actionOpen");
  add(tr("Import CAD or a robot…"), "import", "actionImport");
  add(tr("Start with an empty cell"), "new", "actionNew");
  begin->addStretch(1);
  auto* last = new QVBoxLayout;
  last->setSpacing(8);
  last->addWidget(makeLabel(tr("Recent files"), TextRole::kSection));
  const QStringList files = recent_.files();
  auto* grid = new QGridLayout;
  grid->setSpacing(8);
  for (int i = 0; i < std::min<int>(kMostRecent, static_cast<int>(files.size())); ++i) {
    const QString& path = files[i];
    auto* card = new RecentCard(path, QPixmap::fromImage(keptPicture(path)));
    card->setObjectName("start_recent");
    connect(card, &QAbstractButton::clicked, this, [this, path] { emit fileWanted(path); });
    grid->addWidget(card, i / 2, i % 2);
  }
  last->addLayout(grid);
  if (files.isEmpty())
    last->addWidget(makeLabel(tr("No recent files. You can also drop files here."), TextRole::kSecond, true));
  last->addStretch(1);
  row->addLayout(begin);
  row->addLayout(last);
  row->addStretch(1);
  column.addLayout(row);
  auto* foot = new QHBoxLayout;
  auto* always = new QCheckBox(tr("Show this page at start-up"));
  always->setObjectName("switchStartPage");
  always->setChecked(settings_.value("start/page", true).toBool());
  connect(always, &QCheckBox::clicked, this, [this](bool on) { settings_.setValue("start/page", on); });
  foot->addWidget(always);
  foot->addStretch(1);
  foot->addWidget(makeLabel(tr("Esc: close · F1: help · ?: shortcuts"), TextRole::kSecond, true));
  column.addLayout(foot);
}

void StartPage::place() {
  if (!content_) return;
  const QSize size = content_->sizeHint().boundedTo(scene_.size() - QSize(16, 16));
  setGeometry(QRect(QPoint((scene_.width() - size.width()) / 2, (scene_.height() - size.height()) / 2), size));
}

void StartPage::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return QFrame::keyPressEvent(event);
  hide();
  scene_.setFocus();
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &scene_ && event->type() == QEvent::Resize && isVisible()) place();
  // Something is to be picked or placed: that needs the scene.
  if (watched == &scene_ && event->type() == QEvent::CursorChange && scene_.cursor().shape() == Qt::CrossCursor) hide();
  return QFrame::eventFilter(watched, event);
}

void StartPage::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  drawBox(&painter, rect(), theme.window, theme.line, 6);
}

}  // namespace hapticell::app
