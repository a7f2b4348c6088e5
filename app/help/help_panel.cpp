// SPDX-License-Identifier: Apache-2.0
#include "app/help/help_panel.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QScrollBar>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/help/help_pages.h"
#include "app/style/icon.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kPageName = Qt::UserRole;
constexpr int kContentsHeight = 190, kPageHeight = 420;  // All chapters are seen where one is open.

QString nameOfPage(const QUrl& url) {
  return url.fileName().section('.', 0, 0);
}

QUrl urlOfPage(const QString& name) {
  return QUrl(QStringLiteral("help:/%1.md").arg(name));
}

/// Finds the pages that links name, so that back and forward are Qt's.
class PageBrowser final : public QTextBrowser {
 public:
  PageBrowser(QString language, HelpPanel::Addition addition)
      : language_(std::move(language)), addition_(std::move(addition)) {}
  QVariant loadResource(int type, const QUrl& url) override {
    if (url.scheme() != QStringLiteral("help")) return QTextBrowser::loadResource(type, url);
    const QString name = nameOfPage(url);
    return QString(helpPage(name, language_) + QStringLiteral("\n\n") + addition_(name));
  }

 private:
  QString language_;
  HelpPanel::Addition addition_;
};

/// Markdown has no room above headings and between paragraphs.
void spread(QTextDocument& document) {
  constexpr double kAboveHeading = 14.0, kBelow = 6.0;
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    QTextBlockFormat format;
    const bool heading = block.blockFormat().headingLevel() > 0;
    format.setTopMargin(heading && block.blockNumber() > 0 ? kAboveHeading : 0.0);
    format.setBottomMargin(kBelow);
    QTextCursor(block).mergeBlockFormat(format);
  }
}

}  // namespace

HelpPanel::HelpPanel(const QString& language, Addition addition, QWidget* parent)
    : QWidget(parent),
      language_(language),
      addition_(std::move(addition)),
      typed_(new QLineEdit),
      contents_(new QTreeWidget),
      browser_(new PageBrowser(language, addition_)) {
  setObjectName("panelHelp");
  browser_->setObjectName("browserHelp");
  browser_->setAccessibleName(tr("Help"));
  browser_->setFrameShape(QFrame::NoFrame);
  browser_->document()->setDocumentMargin(12);
  makeContents();
  auto* halves = new QSplitter(Qt::Vertical);
  halves->addWidget(contents_);
  halves->addWidget(browser_);
  halves->setChildrenCollapsible(false);
  halves->setStretchFactor(1, 1);
  halves->setSizes({kContentsHeight, kPageHeight});
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeBar());
  column->addWidget(halves, 1);
  setFocusProxy(browser_);
  // The browser's own source is still the old one then.
  connect(browser_, &QTextBrowser::sourceChanged, this, [this](const QUrl& url) { shown(nameOfPage(url)); });
}

QWidget* HelpPanel::makeBar() {
  const auto button = [](const char* name, const QString& what, const QString& drawn, QTextBrowser* browser,
                         void (QTextBrowser::*go)(), void (QTextBrowser::*can)(bool)) {
    auto* made = new QToolButton;
    made->setObjectName(QString::fromLatin1(name));
    made->setIcon(icon(drawn));
    made->setToolTip(what);
    made->setAccessibleName(what);
    made->setAutoRaise(true);
    made->setEnabled(false);
    connect(made, &QToolButton::clicked, browser, go);
    connect(browser, can, made, &QToolButton::setEnabled);
    return made;
  };
  typed_->setObjectName("fieldHelpSearch");
  typed_->setPlaceholderText(tr("Search the manual"));
  typed_->setClearButtonEnabled(true);
  typed_->setProperty("search", true);
  connect(typed_, &QLineEdit::textChanged, this, &HelpPanel::search);
  connect(typed_, &QLineEdit::returnPressed, this, &HelpPanel::openFirst);
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(8, 6, 8, 6);
  row->setSpacing(4);
  row->addWidget(button("buttonHelpBack", tr("Previous page"), "left", browser_, &QTextBrowser::backward,
                        &QTextBrowser::backwardAvailable));
  row->addWidget(button("buttonHelpForward", tr("Next page"), "right", browser_, &QTextBrowser::forward,
                        &QTextBrowser::forwardAvailable));
  row->addWidget(typed_, 1);
  return bar;
}

void HelpPanel::makeContents() {
  contents_->setObjectName("treeHelp");
  contents_->setAccessibleName(tr("Contents"));
  contents_->setHeaderHidden(true);
  contents_->setFrameShape(QFrame::NoFrame);
  for (const HelpChapter& chapter : helpContents()) {
    auto* top = new QTreeWidgetItem(contents_, {chapter.title});
    for (const QString& page : chapter.pages) {
      auto* row = new QTreeWidgetItem(top, {helpTitle(page, language_)});
      row->setData(0, kPageName, page);
    }
  }
  contents_->setExpandsOnDoubleClick(false);
  connect(contents_, &QTreeWidget::itemClicked, this, [](QTreeWidgetItem* row) {
    if (row->childCount() > 0) row->setExpanded(!row->isExpanded());
  });
  connect(contents_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* row) {
    if (row && row->childCount() == 0) showPage(row->data(0, kPageName).toString());
  });
}

void HelpPanel::showPage(const QString& name) {
  browser_->setSource(urlOfPage(name));
}

QString HelpPanel::page() const {
  return nameOfPage(browser_->source());
}

void HelpPanel::refresh() {
  const int place = browser_->verticalScrollBar()->value();
  browser_->reload();
  browser_->verticalScrollBar()->setValue(place);
}

QTreeWidgetItem* HelpPanel::rowOf(const QString& name) const {
  for (int i = 0; i < contents_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* chapter = contents_->topLevelItem(i);
    for (int j = 0; j < chapter->childCount(); ++j)
      if (chapter->child(j)->data(0, kPageName).toString() == name) return chapter->child(j);
  }
  return nullptr;
}

/// Leaves the pages in the contents that have what is typed.
void HelpPanel::search() {
  const QStringList found = helpPagesWith(typed_->text(), language_);
  for (int i = 0; i < contents_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* chapter = contents_->topLevelItem(i);
    bool any = false;
    for (int j = 0; j < chapter->childCount(); ++j) {
      const bool has = found.contains(chapter->child(j)->data(0, kPageName).toString());
      chapter->child(j)->setHidden(!has);
      any |= has;
    }
    chapter->setHidden(!any);
    chapter->setExpanded(any && !typed_->text().trimmed().isEmpty());
  }
  markWords();
}

void HelpPanel::openFirst() {
  const QStringList found = helpPagesWith(typed_->text(), language_);
  if (found.isEmpty()) return;
  showPage(found.front());
  contents_->setFocus();
}

void HelpPanel::shown(const QString& name) {
  spread(*browser_->document());
  const QSignalBlocker quiet(contents_);
  if (QTreeWidgetItem* row = rowOf(name)) {
    row->parent()->setExpanded(true);
    contents_->setCurrentItem(row);
  }
  markWords();
}

/// The words searched for stand out in the page, and the first is in sight.
void HelpPanel::markWords() {
  const Theme& theme = themeOf(palette());
  QList<QTextEdit::ExtraSelection> marks;
  for (const QString& word : typed_->text().split(' ', Qt::SkipEmptyParts))
    for (QTextCursor at = browser_->document()->find(word); !at.isNull(); at = browser_->document()->find(word, at)) {
      QTextEdit::ExtraSelection mark;
      mark.cursor = at;
      mark.format.setBackground(theme.on);
      mark.format.setForeground(theme.on_text);
      marks << mark;
    }
  browser_->setExtraSelections(marks);
  if (marks.isEmpty()) return;
  QTextCursor first = marks.front().cursor;
  first.clearSelection();
  browser_->setTextCursor(first);
}

}  // namespace hapticell::app
