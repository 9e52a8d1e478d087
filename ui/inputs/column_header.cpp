// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/column_header.h"

#include "ui/inputs/form_metrics.h"

#include <QAbstractTextDocumentLayout>
#include <QPainter>
#include <QTextDocument>
#include <QTextOption>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace sparkout {

namespace {

/// Margins of a title, left and right; the narrow one if columns are short of width.
constexpr int wideMargin = 3, narrowMargin = 1;
constexpr double smallestTitle = 0.75; ///< least size of titles, relative to the usual

} // namespace

ColumnHeader::ColumnHeader(QWidget* parent)
    : QHeaderView(Qt::Horizontal, parent), m_margin(wideMargin) {
    setSectionResizeMode(QHeaderView::Fixed);
    setMinimumSectionSize(20);
    setSectionsClickable(false);
    setHighlightSections(false);
}

void ColumnHeader::prepare(QTextDocument& title, int section) const {
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * noteType * m_size);
    QTextOption option(Qt::AlignHCenter);
    option.setWrapMode(QTextOption::WordWrap);
    title.setDocumentMargin(0);
    title.setDefaultFont(small);
    title.setDefaultTextOption(option);
    title.setHtml(model()->headerData(section, orientation(), markupRole).toString());
}

std::vector<int> ColumnHeader::titleWidths() const {
    std::vector<int> widths;
    for (int i = 0; i < count(); ++i) {
        QTextDocument title;
        prepare(title, i);
        title.setTextWidth(1);
        widths.push_back(int(std::ceil(title.idealWidth())));
    }
    return widths;
}

void ColumnHeader::fit(int width) {
    const int columns = count();
    if (!model() || columns == 0) {
        return;
    }
    m_size = 1;
    std::vector<int> widths = titleWidths();
    int titles = std::accumulate(widths.begin(), widths.end(), 0);
    if (const int most = width - 2 * narrowMargin * columns; titles > most && most > 0) {
        m_size = std::max(smallestTitle, double(most) / titles);
        widths = titleWidths();
        titles = std::accumulate(widths.begin(), widths.end(), 0);
    }
    const int room = std::max(0, width - titles) / (2 * columns);
    m_margin = room >= wideMargin ? wideMargin : std::min(room, narrowMargin);
    const int used = titles + 2 * m_margin * columns;
    const int spare = std::max(0, width - used);
    double height = 0;
    for (int i = 0; i < columns; ++i) {
        const int own =
            widths[std::size_t(i)] + 2 * m_margin + spare * (i + 1) / columns - spare * i / columns;
        resizeSection(i, own);
        QTextDocument title;
        prepare(title, i);
        title.setTextWidth(own - 2 * m_margin);
        height = std::max(height, title.size().height());
    }
    setFixedHeight(int(std::ceil(height)) + 2 * metrics::row);
}

QSize ColumnHeader::needOf(int section) const {
    QTextDocument title;
    prepare(title, section);
    title.setTextWidth(sectionSize(section) - 2 * m_margin);
    return {int(std::ceil(title.idealWidth())) + 2 * m_margin,
            int(std::ceil(title.size().height()))};
}

void ColumnHeader::paintSection(QPainter* painter, const QRect& rect, int section) const {
    painter->save();
    QStyleOptionHeader option;
    initStyleOption(&option);
    option.rect = rect;
    option.section = section;
    style()->drawControl(QStyle::CE_HeaderSection, &option, painter, this);
    QTextDocument title;
    prepare(title, section);
    title.setTextWidth(rect.width() - 2 * m_margin);
    QAbstractTextDocumentLayout::PaintContext context;
    context.palette.setColor(QPalette::Text, palette().color(QPalette::ButtonText));
    painter->setClipRect(rect);
    painter->translate(rect.left() + m_margin,
                       rect.top() + std::max(0.0, (rect.height() - title.size().height()) / 2));
    title.documentLayout()->draw(painter, context);
    painter->restore();
}

} // namespace sparkout
