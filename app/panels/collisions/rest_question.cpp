// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions/rest_question.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/style/icon.h"
#include "app/style/units.h"

namespace hapticell::app {

namespace {

QString namesOf(const workcell::PairRule& rule) {
  const auto side = [](const std::string& entity, const std::string& part) {
    const QString name = QString::fromStdString(entity);
    return part.empty() ? name : name + QStringLiteral(" · ") + QString::fromStdString(part);
  };
  return side(rule.first, rule.first_part) + QStringLiteral(" – ") + side(rule.second, rule.second_part);
}

/// The first two, and how many more.
QString shortList(const QStringList& names) {
  const QString list = QStringList(names.mid(0, 2)).join(QStringLiteral(", "));
  return names.size() <= 2 ? list : list + RestQuestion::tr(" and %1 more").arg(names.size() - 2);
}

QString touchText(const QStringList& names) {
  if (names.size() == 1)
    return RestQuestion::tr("1 pair touches at rest: %1. Exclude it from the check?").arg(names.front());
  return RestQuestion::tr("%1 pairs touch at rest: %2. Exclude them from the check?")
      .arg(names.size())
      .arg(shortList(names));
}

QString overlapText(const QStringList& names) {
  if (names.size() == 1)
    return RestQuestion::tr("A pair overlaps: %1. Move it apart, or exclude it if the overlap is intended.")
        .arg(names.front());
  return RestQuestion::tr("%1 pairs overlap: %2. Move them apart, or exclude them if the overlaps are intended.")
      .arg(names.size())
      .arg(shortList(names));
}

void emphasize(QPushButton* button, bool is_main) {
  button->setProperty("main", is_main);
  button->update();
}

}  // namespace

RestQuestion::RestQuestion(Host& host, QWidget* parent) : QFrame(parent), host_(host) {
  setObjectName("questionAtRest");
  setBackgroundRole(QPalette::AlternateBase);
  setAutoFillBackground(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 6, 12, 6);
  auto* mark = new QLabel;
  mark->setPixmap(icon("info").pixmap(16, 16));
  text_ = makeLabel({}, TextRole::kText);
  text_->setWordWrap(true);
  leave_out_ = new QPushButton(tr("Exclude"));
  leave_out_->setObjectName("buttonLeaveOut");
  keep_ = new QPushButton(tr("Keep checking"));
  keep_->setObjectName("buttonKeepChecked");
  row->addWidget(mark);
  row->addWidget(text_, 1);
  row->addWidget(leave_out_);
  row->addWidget(keep_);
  hide();
  connect(leave_out_, &QPushButton::clicked, this, &RestQuestion::leaveOut);
  connect(keep_, &QPushButton::clicked, this, &RestQuestion::keep);
}

void RestQuestion::ask(RestCheck::Touching found) {
  left_ = std::move(found);
  const auto isKept = [this](const workcell::PairRule& rule) {
    return std::any_of(kept_.begin(), kept_.end(), [&](const auto& one) { return workcell::samePair(one, rule); });
  };
  std::erase_if(left_.pairs, isKept);
  std::erase_if(left_.deep, [&](const manipulation::DeepOverlap& one) { return isKept(one.rule); });
  showNext();
}

void RestQuestion::forget() {
  kept_.clear();
  hide();
}

void RestQuestion::keep() {
  kept_.insert(kept_.end(), asked_.begin(), asked_.end());
  showNext();
}

void RestQuestion::showNext() {
  is_deep_ = left_.pairs.empty();
  QStringList names;
  asked_.clear();
  if (is_deep_) {
    for (const manipulation::DeepOverlap& one : left_.deep) {
      names << namesOf(one.rule) + QStringLiteral(" (%1)").arg(lengthText(one.depth));
      asked_.push_back(one.rule);
    }
    left_.deep.clear();
  } else {
    for (const workcell::PairRule& rule : left_.pairs) names << namesOf(rule);
    std::swap(asked_, left_.pairs);
  }
  setVisible(!asked_.empty());
  if (asked_.empty()) return;
  leave_out_->setEnabled(true);
  emphasize(leave_out_, !is_deep_);
  emphasize(keep_, is_deep_);
  text_->setToolTip(names.join('\n'));
  text_->setText(is_deep_ ? overlapText(names) : touchText(names));
}

void RestQuestion::setOutdated() {
  leave_out_->setEnabled(false);
}

void RestQuestion::leaveOut() {
  const int count = static_cast<int>(asked_.size());
  const QString overlaps = count == 1 ? tr("Exclude a pair that overlaps") : tr("Exclude %1 pairs that overlap").arg(count);
  const QString touches =
      count == 1 ? tr("Exclude a pair that touches at rest") : tr("Exclude %1 pairs that touch at rest").arg(count);
  const QString text = is_deep_ ? overlaps : touches;
  auto rules = std::move(asked_);
  showNext();
  host_.documentModel().execute(workcell::SetPairRules{std::move(rules), text.toStdString()});
}

}  // namespace hapticell::app
