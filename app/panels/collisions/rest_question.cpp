// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions/rest_question.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/style/icon.h"

namespace hapticell::app {

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
  leave_out_->setProperty("main", true);
  auto* keep = new QPushButton(tr("Keep checking"));
  keep->setObjectName("buttonKeepChecked");
  row->addWidget(mark);
  row->addWidget(text_, 1);
  row->addWidget(leave_out_);
  row->addWidget(keep);
  hide();
  connect(leave_out_, &QPushButton::clicked, this, &RestQuestion::leaveOut);
  connect(keep, &QPushButton::clicked, this, &QWidget::hide);
}

void RestQuestion::ask(std::vector<workcell::PairRule> touching) {
  touching_ = std::move(touching);
  leave_out_->setEnabled(true);
  setVisible(!touching_.empty());
  if (touching_.empty()) return;
  QStringList names;
  const auto side = [](const std::string& entity, const std::string& part) {
    const QString name = QString::fromStdString(entity);
    return part.empty() ? name : name + QStringLiteral(" · ") + QString::fromStdString(part);
  };
  for (const workcell::PairRule& rule : touching_) {
    names << side(rule.first, rule.first_part) + QStringLiteral(" – ") + side(rule.second, rule.second_part);
  }
  const int count = static_cast<int>(names.size());
  text_->setToolTip(names.join('\n'));
  QString list = QStringList(names.mid(0, 2)).join(QStringLiteral(", "));
  if (count > 2) list += tr(" and %1 more").arg(count - 2);
  text_->setText(count == 1 ? tr("1 pair touches at rest: %1. Exclude it from the check?").arg(list)
                            : tr("%1 pairs touch at rest: %2. Exclude them from the check?").arg(count).arg(list));
}

void RestQuestion::setOutdated() {
  leave_out_->setEnabled(false);
}

void RestQuestion::leaveOut() {
  hide();
  const int count = static_cast<int>(touching_.size());
  const QString text =
      count == 1 ? tr("Exclude a pair that touches at rest") : tr("Exclude %1 pairs that touch at rest").arg(count);
  host_.documentModel().execute(workcell::SetPairRules{std::move(touching_), text.toStdString()});
  touching_.clear();
}

}  // namespace hapticell::app
