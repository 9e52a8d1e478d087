// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/verdict/verdict_shop_model.h"

#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"
#include "ui/text/texts.h"

#include <QGuiApplication>
#include <QIcon>
#include <QPalette>

namespace sparkout {

namespace {

/// Marked up, or a tool tip does not wrap; V_k with its index below the line.
QString paragraphs(const QStringList& texts) {
    QString tip;
    for (const QString& text : texts) {
        if (!text.isEmpty()) {
            tip += QStringLiteral("<p>%1</p>").arg(withIndices(text));
        }
    }
    return tip;
}

} // namespace

void ShopModel::setOutcome(OutcomePtr outcome) {
    beginResetModel();
    m_outcome = std::move(outcome);
    m_rows.clear();
    if (m_outcome && !m_outcome->shop.stages.empty()) {
        for (int row = 0; row <= static_cast<int>(ShopRow::rotationRatio); ++row) {
            const bool overlaps = m_outcome->result.project.operation->axial();
            if (static_cast<ShopRow>(row) != ShopRow::overlap || overlaps) {
                m_rows.push_back(static_cast<ShopRow>(row));
            }
        }
    }
    endResetModel();
}

void ShopModel::setGreyed(bool grey) {
    if (m_grey != grey) {
        m_grey = grey;
        retranslate();
    }
}

void ShopModel::retranslate() {
    beginResetModel();
    endResetModel();
}

Operation ShopModel::operation() const {
    return m_outcome->result.project.operation;
}

bool ShopModel::isCycle(int column) const {
    return column + 1 == columnCount();
}

const ShopColumn& ShopModel::numbers(int column) const {
    const ShopNumbers& shop = m_outcome->shop;
    return isCycle(column) ? shop.cycle : shop.stages.at(static_cast<std::size_t>(column));
}

/// One rotation ratio holds for all stages: it stands in the cycle's column.
QString ShopModel::text(int row, int column) const {
    if (rowAt(row) == ShopRow::rotationRatio) {
        return isCycle(column) ? shop::number(m_outcome->shop.rotationRatio) : QString();
    }
    return shop::value(rowAt(row), numbers(column));
}

bool ShopModel::isOutside(int row, int column) const {
    if (rowAt(row) == ShopRow::rotationRatio) {
        return isCycle(column) && m_outcome->shop.ratioNearInteger();
    }
    const BandSide band = shop::band(rowAt(row), numbers(column));
    return band == BandSide::below || band == BandSide::above;
}

QString ShopModel::sideText(int row, int column) const {
    if (!isOutside(row, column)) {
        return {};
    }
    if (rowAt(row) == ShopRow::rotationRatio) {
        return tr("near a whole number");
    }
    return shop::band(rowAt(row), numbers(column)) == BandSide::below ? tr("below the usual")
                                                                      : tr("above the usual");
}

QString ShopModel::columnName(int column) const {
    return isCycle(column) ? tr("Whole cycle") : tr("Stage %1").arg(column + 1);
}

QString ShopModel::spoken(int row, int column) const {
    QString said =
        tr("%1, %2: %3")
            .arg(columnName(column), shop::name(rowAt(row), operation()), text(row, column));
    const QString side = sideText(row, column);
    return side.isEmpty() ? said : said + QStringLiteral("; ") + side;
}

QVariant ShopModel::cell(int row, int column, int role) const {
    switch (role) {
    case Qt::DisplayRole: return text(row, column);
    case Qt::DecorationRole:
        return isOutside(row, column) ? QVariant(themeIcon(u"warning")) : QVariant();
    case Qt::TextAlignmentRole: return aligned(true);
    case Qt::ForegroundRole:
        return m_grey
                   ? QVariant(QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text))
                   : QVariant();
    case Qt::AccessibleTextRole: return spoken(row, column);
    case Qt::ToolTipRole:
        return paragraphs({spoken(row, column),
                           shop::detail(rowAt(row), numbers(column), operation()),
                           shop::hint(rowAt(row))});
    default: return {};
    }
}

QVariant ShopModel::side(int row, int role) const {
    switch (role) {
    case Qt::DisplayRole: return shop::label(rowAt(row), operation());
    case Qt::AccessibleTextRole: return shop::name(rowAt(row), operation());
    case Qt::ToolTipRole:
        return paragraphs({shop::name(rowAt(row), operation()), shop::hint(rowAt(row))});
    case Qt::TextAlignmentRole: return aligned(false);
    default: return {};
    }
}

QVariant ShopModel::head(int column, int role) const {
    switch (role) {
    case Qt::DisplayRole: return isCycle(column) ? tr("Cycle") : QString::number(column + 1);
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole: return columnName(column);
    case Qt::TextAlignmentRole: return aligned(true);
    default: return {};
    }
}

QString ShopModel::asTsv() const {
    QStringList lines;
    QStringList heads{tr("Quantity")};
    for (int column = 0; column < columnsShown(); ++column) {
        heads << columnName(column);
    }
    lines << (heads << tr("Outside the usual")).join(QLatin1Char('\t'));
    for (int row = 0; row < rowCount(); ++row) {
        QStringList cells{shop::name(rowAt(row), operation())};
        QStringList outside;
        for (int column = 0; column < columnCount(); ++column) {
            cells << text(row, column);
            if (isOutside(row, column)) {
                outside << tr("%1: %2").arg(columnName(column), sideText(row, column));
            }
        }
        lines << (cells << outside.join(QStringLiteral("; "))).join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

} // namespace sparkout
