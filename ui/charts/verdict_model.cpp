// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/verdict_model.h"

#include "core/quality/light.h"
#include "ui/charts/margin_model.h"
#include "ui/charts/result_tables.h"
#include "ui/text/estimate_names.h"
#include "ui/text/joined.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QFont>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace sparkout {

QString lightName(Light light) {
    switch (light) {
    case Light::holds: return VerdictModel::tr("holds");
    case Light::close: return VerdictModel::tr("close to the limit");
    case Light::fails: return VerdictModel::tr("fails");
    }
    return {};
}

QString lightName(const ConstraintResult& constraint) {
    return constraint.isWhole ? lightName(lightOf(constraint))
                              : VerdictModel::tr("not known: strips uncut");
}

namespace {

/// A name with what its group does not say: the stage and the unit.
QString requirementName(const ConstraintResult& c, const QString& name, const QString& where) {
    QStringList parts{name};
    if (c.section < 0 && requirementOf(c.kind).scope != ConstraintScope::part) {
        if (c.stage > 0) {
            parts << where;
        }
        if (*requirementOf(c.kind).unit) {
            parts << unitText(requirementOf(c.kind).unit);
        }
    }
    return parts.join(QStringLiteral(", "));
}

/// What the heads of the columns mean.
QString headTip(int column) {
    switch (column) {
    case VerdictModel::requirement:
        return VerdictModel::tr("What the drawing, the process or the machine asks of the cycle");
    case VerdictModel::value: return VerdictModel::tr("What the cycle comes to, at its worst");
    case VerdictModel::limit: return VerdictModel::tr("What is allowed");
    case VerdictModel::margin:
        return VerdictModel::tr("How far the value is from its limit; below 0 it is beyond");
    default: return {};
    }
}

} // namespace

void VerdictModel::setOutcome(OutcomePtr outcome) {
    beginResetModel();
    m_outcome = std::move(outcome);
    m_rows.clear();
    if (m_outcome) {
        std::vector<const ConstraintResult*> sorted;
        for (const ConstraintResult& c : m_outcome->constraints) {
            sorted.push_back(&c);
        }
        std::ranges::stable_sort(sorted, {}, [](const ConstraintResult* c) {
            const int group = groupOf(*c);
            return std::pair(group < 0, std::abs(group)); // the zones first
        });
        for (const ConstraintResult* c : sorted) {
            const int group = groupOf(*c);
            if (m_rows.empty() || m_rows.back().group != group) {
                m_rows.push_back({nullptr, c->zone, group});
            }
            m_rows.push_back({c, c->zone, group});
        }
    }
    endResetModel();
}

int VerdictModel::groupOf(const ConstraintResult& constraint) {
    return constraint.section >= 0 ? constraint.section
                                   : -1 - static_cast<int>(requirementOf(constraint.kind).scope);
}

QString VerdictModel::groupName(const Row& row) {
    if (row.group >= 0) {
        return tr("%1, µm").arg(Names::zoneFull(row.zone, row.group));
    }
    switch (static_cast<ConstraintScope>(-1 - row.group)) {
    case ConstraintScope::part: return tr("Whole part, µm");
    case ConstraintScope::pass: return tr("Every pass");
    case ConstraintScope::setting: return tr("Machine settings");
    case ConstraintScope::section: break;
    }
    return {};
}

void VerdictModel::setGreyed(bool grey) {
    if (m_grey != grey) {
        beginResetModel();
        m_grey = grey;
        endResetModel();
    }
}

void VerdictModel::setIcons(const std::array<QIcon, 3>& icons) {
    m_icons = icons;
    retranslate();
}

void VerdictModel::retranslate() {
    beginResetModel();
    endResetModel();
}

bool VerdictModel::isZoneRow(int row) const {
    return constraintAt(row) == nullptr;
}

const ConstraintResult* VerdictModel::constraintAt(int row) const {
    return m_rows.at(static_cast<std::size_t>(row)).constraint;
}

QString VerdictModel::text(const ConstraintResult& c, int column) const {
    switch (column) {
    case requirement: return requirementName(c, Names::constraint(c.kind), Names::where(c));
    case value: return Names::value(c);
    case limit: return Names::limit(c);
    case margin: return Names::besideLimit(c);
    default: return {};
    }
}

QVariant VerdictModel::cell(int line, int column, int role) const {
    const Row& row = m_rows.at(static_cast<std::size_t>(line));
    const bool first = column == requirement;
    if (role == Qt::ForegroundRole && m_grey) {
        return QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text);
    }
    if (role == Qt::TextAlignmentRole && !first) {
        return static_cast<int>(Qt::AlignRight | Qt::AlignTop);
    }
    if (role == Qt::TextAlignmentRole) {
        return static_cast<int>(Qt::AlignLeft | Qt::AlignTop);
    }
    return row.constraint ? requirementData(row, column, role) : zoneData(row, first, role);
}

QVariant VerdictModel::zoneData(const Row& row, bool first, int role) const {
    if (first && (role == Qt::DisplayRole || role == Qt::AccessibleTextRole)) {
        return groupName(row);
    }
    if (role == Qt::FontRole) {
        QFont font;
        font.setBold(true);
        return font;
    }
    return {};
}

QVariant VerdictModel::requirementData(const Row& row, int column, int role) const {
    const bool first = column == requirement;
    const Light light = lightOf(*row.constraint);
    const ConstraintKind kind = row.constraint->kind;
    const bool guessed = LimitNames::isGuess(kind, m_outcome->result.project);
    const QString name = guessed ? tr("Ra, estimate") : Names::constraintBrief(kind);
    const QString shown =
        first ? requirementName(*row.constraint, name, tr("stage %1").arg(row.constraint->stage))
              : text(*row.constraint, column);
    switch (role) {
    case Qt::DisplayRole: // in words where it needs attention; else the mark is enough
        return first && light != Light::holds
                   ? shown + QLatin1Char('\n') + lightName(*row.constraint)
                   : shown;
    case Qt::DecorationRole:
        return first // a guess that holds is not shown as one that is known to
                   ? QVariant(m_icons[static_cast<std::size_t>(
                       guessed ? std::max(light, Light::close) : light)])
                   : QVariant();
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole: {
        const QString stated =
            QStringLiteral("%1, %2: %3")
                .arg(Names::where(*row.constraint), Names::constraint(row.constraint->kind),
                     first ? lightName(*row.constraint) : shown);
        if (role == Qt::AccessibleTextRole) {
            return stated;
        }
        const char* const by = requirementOf(kind).measuredBy;
        QStringList lines{stated, Names::isRange(kind) ? rangeText(*row.constraint) : QString(),
                          by ? requirementText(by) : QString(),
                          EstimateNames::behind(m_outcome->result.project, kind),
                          guessed ? tr("Without a calibration of the wheel Ra comes out too small.")
                                  : QString()};
        return joined(lines, QStringLiteral("\n"));
    }
    default: return {};
    }
}

QVariant VerdictModel::head(int column, int role) const {
    if (role == Qt::TextAlignmentRole) {
        return aligned(column != requirement);
    }
    if (role == Qt::ToolTipRole) {
        return headTip(column);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (column) {
    case requirement: return tr("Requirement");
    case value: return tr("Value");
    case limit: return tr("Limit");
    case margin: return tr("Margin");
    default: return {};
    }
}

Qt::ItemFlags VerdictModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) {
        return Qt::NoItemFlags;
    }
    const bool isGroup = !m_rows[static_cast<std::size_t>(index.row())].constraint;
    return isGroup ? Qt::ItemIsEnabled : Qt::ItemIsEnabled | Qt::ItemIsSelectable;
}

QString VerdictModel::asTsv() const {
    QStringList lines;
    QStringList heads{tr("Zone or section")};
    for (int c = 0; c < columnCount_; ++c) {
        heads << head(c, Qt::DisplayRole).toString();
    }
    lines << (heads << tr("Unit") << tr("Verdict")).join(QLatin1Char('\t'));
    for (const Row& row : m_rows) {
        if (!row.constraint) {
            continue;
        }
        QStringList cells{Names::where(*row.constraint)};
        for (int c = 0; c < columnCount_; ++c) {
            cells << text(*row.constraint, c);
        }
        cells << unitText(requirementOf(row.constraint->kind).unit);
        lines << (cells << lightName(*row.constraint)).join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

CsvTable VerdictModel::table() const {
    return m_outcome ? requirementTable(m_outcome->constraints, m_outcome->result.project.operation)
                     : CsvTable();
}

} // namespace sparkout
