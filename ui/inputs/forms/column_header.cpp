// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/column_header.h"

#include "ui/inputs/editors/form_metrics.h"

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

constexpr int sideMargin = 3; ///< of a title, left and right

} // namespace

ColumnHeader::ColumnHeader(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) {
    setSectionResizeMode(QHeaderView::Fixed);
    setMinimumSectionSize(20);
    setSectionsClickable(false);
    setHighlightSections(false);
}

void ColumnHeader::prepare(QTextDocument& title, int section) const {
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * noteType);
    QTextOption option(Qt::AlignHCenter);
    option.setWrapMode(QTextOption::WordWrap);
    title.setDocumentMargin(0);
    title.setDefaultFont(small);
    title.setDefaultTextOption(option);
    title.setHtml(model()->headerData(section, orientation(), markupRole).toString());
}

void ColumnHeader::fit(int width) {
    const int columns = count();
    if (!model() || columns == 0) {
        return;
    }
    std::vector<int> widths;
    for (int i = 0; i < columns; ++i) {
        QTextDocument title;
        prepare(title, i);
        title.setTextWidth(1);
        widths.push_back(int(std::ceil(title.idealWidth())) + 2 * sideMargin);
    }
    const int used = std::accumulate(widths.begin(), widths.end(), 0);
    const int spare = std::max(0, width - used);
    double height = 0;
    for (int i = 0; i < columns; ++i) {
        const int own = widths[std::size_t(i)] + spare * (i + 1) / columns - spare * i / columns;
        resizeSection(i, own);
        QTextDocument title;
        prepare(title, i);
        title.setTextWidth(own - 2 * sideMargin);
        height = std::max(height, title.size().height());
    }
    setFixedHeight(int(std::ceil(height)) + 2 * metrics::row);
}

QSize ColumnHeader::needOf(int section) const {
    QTextDocument title;
    prepare(title, section);
    title.setTextWidth(sectionSize(section) - 2 * sideMargin);
    return {int(std::ceil(title.idealWidth())) + 2 * sideMargin,
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
    title.setTextWidth(rect.width() - 2 * sideMargin);
    QAbstractTextDocumentLayout::PaintContext context;
    context.palette.setColor(QPalette::Text, palette().color(QPalette::ButtonText));
    painter->setClipRect(rect);
    painter->translate(rect.left() + sideMargin,
                       rect.top() + std::max(0.0, (rect.height() - title.size().height()) / 2));
    title.documentLayout()->draw(painter, context);
    painter->restore();
}

} // namespace sparkout
