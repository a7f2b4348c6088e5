// SPDX-License-Identifier: Apache-2.0
#include "app/import/remark_lines.h"

#include <QRegularExpression>
#include <algorithm>

namespace hapticell::app {

namespace {

/// A list of names counts as one: how many there are does not make a kind of its own.
QString kindOf(const QString& remark) {
  static const QRegularExpression names(QStringLiteral("'[^']*'(?:, '[^']*')*(?: and (?:'[^']*'|\\d+ more))?"));
  static const QRegularExpression files(QStringLiteral("\\S*/\\S+|\\S+\\.[A-Za-z]\\w+"));
  static const QRegularExpression numbers(QStringLiteral("\\d+(?:\\.\\d+)?"));
  QString kind = remark;
  for (const QRegularExpression* varying : {&names, &files, &numbers}) kind.replace(*varying, QStringLiteral("…"));
  return kind;
}

std::vector<workcell::EntityId> partsNamedIn(const QString& remark, const NamedParts& parts) {
  static const QRegularExpression quoted(QStringLiteral("'([^']+)'"));
  std::vector<workcell::EntityId> found;
  for (auto names = quoted.globalMatch(remark); names.hasNext();) {
    const auto [begin, end] = parts.equal_range(names.next().captured(1).toStdString());
    for (auto part = begin; part != end; ++part) {
      if (std::find(found.begin(), found.end(), part->second) == found.end()) found.push_back(part->second);
    }
  }
  return found;
}

}  // namespace

void addNames(const workcell::Entity& entity, workcell::EntityId id, NamedParts& parts) {
  parts.emplace(entity.name, id);
  if (!entity.robot) return;
  for (const kinematics::Link& link : entity.robot->links) parts.emplace(link.name, id);
  for (const kinematics::Joint& joint : entity.robot->joints) parts.emplace(joint.name, id);
}

std::vector<RemarkLine> remarkLines(const std::vector<std::string>& remarks, const NamedParts& parts) {
  std::vector<RemarkLine> lines;
  for (const std::string& remark : remarks) {
    const QString text = QString::fromStdString(remark);
    const QString kind = kindOf(text);
    const auto last = std::find_if(lines.rbegin(), lines.rend(), [&](const RemarkLine& line) { return line.kind == kind; });
    lines.insert(last == lines.rend() ? lines.end() : last.base(), {kind, text, partsNamedIn(text, parts)});
  }
  return lines;
}

}  // namespace hapticell::app
