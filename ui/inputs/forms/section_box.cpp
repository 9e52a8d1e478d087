// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/section_box.h"

#include "ui/inputs/forms/page_columns.h"
#include "ui/kit/metrics.h"

#include <QStyleOptionGroupBox>
#include <QStylePainter>

namespace sparkout {

namespace {

constexpr int deepest = 2;

/// The margin that the style leaves beside the contents of a box.
int styleInset() {
    static const int inset = [] {
        QGroupBox box;
        box.ensurePolished();
        return box.contentsMargins().left();
    }();
    return inset;
}

} // namespace

int SectionBox::inset(int depth) {
    return (deepest - depth) * styleInset();
}

SectionBox::SectionBox(int depth, QWidget* parent)
    : QGroupBox(parent), m_depth(depth), m_rows(new PageColumns(this)) {
    m_rows->setContentsMargins(0, metrics::row, 0, metrics::tight);
    m_rows->setSpacing(metrics::gap);
}

void SectionBox::paintEvent(QPaintEvent*) {
    QStylePainter painter(this);
    QStyleOptionGroupBox option;
    initStyleOption(&option);
    option.subControls &= ~QStyle::SC_GroupBoxFrame;
    painter.translate(inset(m_depth - 1), 0);
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    option.fontMetrics = QFontMetrics(bold);
    painter.drawComplexControl(QStyle::CC_GroupBox, option);
}

} // namespace sparkout
