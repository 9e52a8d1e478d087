// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/verdict/narrow_table.h"

#include "ui/kit/font_size.h"

#include <QHeaderView>
#include <QIcon>
#include <QPainter>
#include <QScrollBar>
#include <QStyle>
#include <QStyledItemDelegate>

#include <utility>

namespace sparkout {

namespace {

/// Narrow cells, so that three stages and the cycle fit beside their names into 300 px:
/// right-aligned numbers, a mark before them, two pixels of space.
class NarrowCells : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& given,
                                 const QModelIndex& index) const override {
        QStyleOptionViewItem option = given;
        initStyleOption(&option, index);
        const int mark = option.icon.isNull() ? 0 : markSize + air;
        return {option.fontMetrics.horizontalAdvance(option.text) + mark + 2 * air,
                option.fontMetrics.height() + 2};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& given,
               const QModelIndex& index) const override {
        QStyleOptionViewItem option = given;
        initStyleOption(&option, index);
        const QString text = std::exchange(option.text, QString());
        const QIcon icon = std::exchange(option.icon, QIcon());
        const QStyle* style = option.widget->style();
        style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);
        const QRect inside = option.rect.adjusted(air, 0, -air, 0);
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        style->drawItemText(painter, inside, Qt::AlignRight | Qt::AlignVCenter, option.palette,
                            true, text, selected ? QPalette::HighlightedText : QPalette::Text);
        if (!icon.isNull()) {
            const int end = inside.right() - option.fontMetrics.horizontalAdvance(text) - air;
            icon.paint(painter, QRect(end - markSize, inside.center().y() - markSize / 2, markSize,
                                      markSize));
        }
    }

private:
    static constexpr int markSize = 10;
    static constexpr int air = 2;
};

} // namespace

NarrowTable::NarrowTable(ValueModel& model, QWidget* parent) : CopyTable(model, parent) {
    setItemDelegate(new NarrowCells(this));
    setWordWrap(false);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setRelativeFont(*verticalHeader(), 0.92);
    verticalHeader()->setSectionsClickable(false);
    verticalHeader()->setHighlightSections(false);
    verticalHeader()->setMinimumSectionSize(10);
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    connect(this, &CopyTable::resized, this, &NarrowTable::fit, Qt::QueuedConnection);
}

/// Makes columns as wide as their numbers and shares the remainder; if they need more, a scroll bar
/// appears below.
void NarrowTable::fit() {
    const int count = model() ? model()->columnCount() : 0;
    if (m_fitting || count == 0) {
        return;
    }
    m_fitting = true;
    QHeaderView* header = horizontalHeader();
    resizeColumnsToContents();
    int left = viewport()->width() - header->length();
    const bool wide = left < 0;
    for (int column = 0; left > 0 && column < count; ++column) {
        const int share = left / (count - column);
        header->resizeSection(column, header->sectionSize(column) + share);
        left -= share;
    }
    setHorizontalScrollBarPolicy(wide ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
    const int bar = wide ? horizontalScrollBar()->sizeHint().height() : 0;
    setFixedHeight(header->sizeHint().height() + verticalHeader()->length() + 2 * frameWidth()
                   + bar);
    if (parentWidget()) {
        parentWidget()->updateGeometry();
    }
    m_fitting = false;
}

} // namespace sparkout
