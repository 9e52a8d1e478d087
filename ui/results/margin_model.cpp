// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/margin_model.h"

#include "core/quality/verdict.h"
#include "ui/kit/theme.h"
#include "ui/results/result_tables.h"
#include "ui/results/verdict_table.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QApplication>
#include <QPainter>

#include <algorithm>
#include <tuple>
#include <utility>

namespace sparkout {

namespace {

constexpr double fullBar = 1.25; ///< usage at the end of a bar
QString onLines(QString valueAndLimit) {
    return valueAndLimit.replace(QStringLiteral(" / "), QStringLiteral(" /\n"));
}

constexpr int leastBarWidth = 76;
constexpr int air = 4;
constexpr double scaleHeight = 4, pointerWidth = 5; ///< sizes of a range's scale [px]

/// The share of the limit; where the value is a lower bound, so is the share.
QString usageText(const ConstraintResult& c) {
    const QString share = LimitNames::percent(usageOf(c));
    switch (marginKnown(c)) {
    case MarginKnown::exactly: return share;
    case MarginKnown::atMost: return QStringLiteral("≥ ") + share;
    case MarginKnown::no: break;
    }
    return QStringLiteral("–");
}

/// What fails first; settings of the machine last, which hold up to the ends of their ranges.
std::tuple<bool, bool, double> rankOf(const ConstraintResult& c) {
    return {!c.holds, requirementOf(c.kind).scope != ConstraintScope::setting, usageOf(c)};
}

} // namespace

QString rangeText(const ConstraintResult& c) {
    if (!c.otherEnd) {
        return Names::margin(c);
    }
    const auto [low, high] = std::minmax(c.limit, *c.otherEnd);
    return MarginModel::tr("%1, range %2…%3 %4")
        .arg(Names::margin(c), Names::amount(c.kind, low, false),
             Names::amount(c.kind, high, false), unitText(requirementOf(c.kind).unit));
}

void MarginModel::setOutcome(OutcomePtr outcome) {
    m_outcome = std::move(outcome);
    fill();
}

void MarginModel::setAllPlaces(bool all) {
    m_all = all;
    fill();
}

void MarginModel::setIcons(const LightIcons& icons) {
    m_icons = icons;
    retranslate();
}

void MarginModel::setStacked(bool stacked) {
    if (stacked != m_stacked) {
        m_stacked = stacked;
        retranslate();
    }
}

void MarginModel::fill() {
    beginResetModel();
    m_rows.clear();
    if (m_outcome) {
        m_rows = m_all ? m_outcome->constraints : worstByKind(m_outcome->constraints);
        std::ranges::stable_sort(m_rows, [](const ConstraintResult& a, const ConstraintResult& b) {
            return rankOf(a) > rankOf(b);
        });
    }
    endResetModel();
}

int MarginModel::rowOf(const ConstraintResult& wanted) const {
    const auto same = std::ranges::find_if(m_rows, [&](const ConstraintResult& c) {
        return c.kind == wanted.kind && c.section == wanted.section && c.stage == wanted.stage;
    });
    const auto found = same != m_rows.end()
                           ? same
                           : std::ranges::find(m_rows, wanted.kind, &ConstraintResult::kind);
    return found == m_rows.end() ? -1 : static_cast<int>(found - m_rows.begin());
}

QString MarginModel::text(const ConstraintResult& c, int column) {
    switch (column) {
    case requirement:
        return QStringLiteral("%1, %2").arg(Names::constraint(c.kind),
                                            Names::within(Names::where(c)));
    case usage: return Names::isRange(c.kind) ? Names::margin(c) : usageText(c);
    case value:
        return QStringLiteral("%1 / %2 %3")
            .arg(Names::value(c), Names::limit(c), unitText(requirementOf(c.kind).unit))
            .trimmed();
    default: return {};
    }
}

QString MarginModel::stackedText(const ConstraintResult& c, int column) {
    return column == requirement ? QStringLiteral("%1, %2").arg(Names::constraintBrief(c.kind),
                                                                Names::within(Names::where(c)))
                                 : onLines(text(c, column));
}

QVariant MarginModel::cell(int row, int column, int role) const {
    const ConstraintResult& c = at(row);
    const Light light = lightOf(c);
    switch (role) {
    case Qt::DisplayRole: return m_stacked ? stackedText(c, column) : text(c, column);
    case Qt::DecorationRole:
        return column == requirement ? QVariant(m_icons[static_cast<std::size_t>(light)])
                                     : QVariant();
    case Qt::TextAlignmentRole: return aligned(column == value);
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return (Names::isRange(c.kind) ? tr("%1, %2, %3: %4") : tr("%1, %2 used, %3: %4"))
            .arg(text(c, requirement), Names::isRange(c.kind) ? rangeText(c) : text(c, usage),
                 text(c, value), lightName(c));
    case usageRole: return usageOf(c);
    case lightRole: return static_cast<int>(light);
    case placeRole: {
        const std::optional<double> place = placeInRange(c);
        return place ? QVariant(*place) : QVariant();
    }
    default: return {};
    }
}

QVariant MarginModel::head(int column, int role) const {
    if (role == Qt::TextAlignmentRole) {
        return aligned(column == value);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (column) {
    case requirement: return tr("Requirement");
    case usage: return tr("Used up");
    case value: return m_stacked ? onLines(tr("Value / limit")) : tr("Value / limit");
    default: return {};
    }
}

QString MarginModel::asTsv() const {
    QStringList lines{QStringList{tr("Requirement"), tr("Used up, %"), tr("Value"), tr("Limit"),
                                  tr("Margin"), tr("Unit"), tr("Setting / nearer end of the range"),
                                  tr("Verdict")}
                          .join(u'\t')};
    for (const ConstraintResult& c : m_rows) {
        const auto number = [&c](double v) { return Names::amount(c.kind, v, false); };
        const bool range = Names::isRange(c.kind);
        const bool isKnown = marginKnown(c) == MarginKnown::exactly;
        lines << QStringList{text(c, requirement),
                             range || !isKnown ? QString() : Names::significant(100 * usageOf(c)),
                             c.isWhole ? number(c.value) : QString(),
                             Names::limit(c),
                             isKnown ? number(statedMargin(c)) : QString(),
                             unitText(requirementOf(c.kind).unit),
                             range && c.limit > 0 ? Names::significant(c.value / c.limit)
                                                  : QString(),
                             lightName(c)}
                     .join(u'\t');
    }
    return lines.join(u'\n') + u'\n';
}

CsvTable MarginModel::table() const {
    return m_outcome ? requirementTable(m_rows, m_outcome->result.project.operation) : CsvTable();
}

// --- the light ----------------------------------------------------------------------------------

void MarginName::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    const QStyle* style = option->widget ? option->widget->style() : QApplication::style();
    const QRect room = style->subElementRect(QStyle::SE_ItemViewItemText, option, option->widget);
    const int gap = style->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, option->widget) + 1;
    if (option->fontMetrics.horizontalAdvance(option->text) <= room.width() - 2 * gap) {
        option->decorationAlignment = Qt::AlignLeft | Qt::AlignVCenter; // like the text
    }
}

// --- the bar ------------------------------------------------------------------------------------

namespace {

/// A range from end to end, below the text, with the setting on it.
void drawScale(QPainter& painter, const QRectF& area, double place, QColor fill, const QColor& ink,
               const QString& text) {
    const QRectF scale(area.left(), area.bottom() - scaleHeight, area.width(), scaleHeight);
    QColor faint = ink;
    faint.setAlphaF(0.2F);
    painter.fillRect(scale, faint);
    fill.setAlphaF(1);
    painter.fillRect(QRectF(scale.left() + place * (scale.width() - pointerWidth), scale.top() - 2,
                            pointerWidth, scaleHeight + 4),
                     fill);
    painter.setPen(QPen(ink, 1));
    for (const double end : {scale.left(), scale.right()}) {
        painter.drawLine(QLineF(end, scale.top() - 2, end, scale.bottom() + 2));
    }
    painter.drawText(area.adjusted(0, -air, air, -scaleHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     text);
}

} // namespace

void MarginBar::paint(QPainter* painter, const QStyleOptionViewItem& given,
                      const QModelIndex& index) const {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const QString text = std::exchange(option.text, QString());
    const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);
    const double usage = index.data(MarginModel::usageRole).toDouble();
    const auto light = static_cast<Light>(index.data(MarginModel::lightRole).toInt());
    const QRectF area = QRectF(option.rect).adjusted(air, air, -air, -air);
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    const QColor ink = option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text);
    QColor fill = lightColour(light, option.palette);
    fill.setAlphaF(selected ? 0.6F : 0.45F);
    if (const QVariant place = index.data(MarginModel::placeRole); place.isValid()) {
        painter->save();
        drawScale(*painter, area, place.toDouble(), fill, ink, text);
        painter->restore();
        return;
    }
    painter->save();
    painter->fillRect(QRectF(area.left(), area.top(), area.width() * std::min(usage / fullBar, 1.0),
                             area.height()),
                      fill);
    painter->setPen(QPen(ink, 1));
    const double limit = area.left() + area.width() / fullBar;
    painter->drawLine(QLineF(limit, area.top() - 2, limit, area.bottom() + 2));
    painter->drawText(area.adjusted(air, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text);
    painter->restore();
}

QSize MarginBar::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const QString text = index.data().toString();
    return {std::max(leastBarWidth, option.fontMetrics.horizontalAdvance(text) + 2 * air + 1),
            option.fontMetrics.height() + 2 * air};
}

} // namespace sparkout
