// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/tool_row.h"

#include <QComboBox>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QWidget>

#include <algorithm>
#include <numeric>

namespace sparkout {

namespace {

int roundedShare(int whole, int part, int of) {
    return of > 0 ? static_cast<int>(static_cast<long long>(whole) * part / of) : 0;
}

/// Ignores the least width of a box, which may be that of an older font.
int hintOf(const QLayoutItem& item) {
    const auto* box = qobject_cast<const QComboBox*>(const_cast<QLayoutItem&>(item).widget());
    return box && !box->isHidden() ? box->sizeHint().width() : item.sizeHint().width();
}

/// A box needs only the width of its current text. Measuring all its texts in every layout would
/// take too long.
int leastOf(const QLayoutItem& item) {
    const auto* box = qobject_cast<const QComboBox*>(const_cast<QLayoutItem&>(item).widget());
    if (!box) {
        return item.minimumSize().width();
    }
    constexpr int air = 4;
    QStyleOptionComboBox option;
    option.initFrom(box);
    option.frame = box->hasFrame();
    option.editable = box->isEditable();
    const QString text = box->currentIndex() < 0 ? box->placeholderText() : box->currentText();
    const QFontMetrics metrics = box->fontMetrics();
    const QSize contents(metrics.horizontalAdvance(text), metrics.height());
    const int need =
        box->style()->sizeFromContents(QStyle::CT_ComboBox, &option, contents, box).width();
    return std::clamp(need + air, 0, hintOf(item));
}

} // namespace

ToolRow::ToolRow(QWidget* parent) : QLayout(parent) {}

ToolRow::~ToolRow() = default;

int ToolRow::Tool::least() const {
    const int own = leastOf(*item);
    const QWidget* widget = letters > 0 ? const_cast<QLayoutItem&>(*item).widget() : nullptr;
    return widget ? std::max(own, letters * widget->fontMetrics().averageCharWidth()) : own;
}

void ToolRow::addWidget(QWidget* widget, int stretch) {
    addChildWidget(widget);
    if (auto* box = qobject_cast<QComboBox*>(widget)) {
        connect(box, &QComboBox::currentTextChanged, this, &QLayout::update);
    }
    m_items.push_back({std::make_unique<QWidgetItem>(widget), stretch});
    invalidate();
}

void ToolRow::addText(QWidget* widget, int letters, int stretch) {
    addWidget(widget, stretch);
    m_items.back().letters = letters;
}

void ToolRow::addStretch(int stretch) {
    m_items.push_back({std::make_unique<QSpacerItem>(0, 0), stretch});
    invalidate();
}

void ToolRow::addItem(QLayoutItem* item) {
    m_items.push_back({std::unique_ptr<QLayoutItem>(item), 0});
    invalidate();
}

QLayoutItem* ToolRow::itemAt(int index) const {
    return index >= 0 && index < count() ? m_items[std::size_t(index)].item.get() : nullptr;
}

QLayoutItem* ToolRow::takeAt(int index) {
    if (index < 0 || index >= count()) {
        return nullptr;
    }
    QLayoutItem* item = m_items[std::size_t(index)].item.release();
    m_items.erase(m_items.begin() + index);
    invalidate();
    return item;
}

int ToolRow::leastWidth(const Line& line) const {
    const int gaps = std::max(0, static_cast<int>(line.size()) - 1) * spacing();
    return std::accumulate(line.begin(), line.end(), gaps,
                           [](int sum, const Tool* tool) { return sum + tool->least(); });
}

/// Distributes surplus width to stretching items; takes missing width from those that can shrink.
std::vector<int> ToolRow::widthsOf(const Line& line, int room) const {
    const int least = leastWidth(line);
    int wished = least, stretches = 0;
    for (const Tool* tool : line) {
        wished += std::max(0, hintOf(*tool->item) - tool->least());
        stretches += tool->stretch;
    }
    std::vector<int> widths;
    for (const Tool* tool : line) {
        const int mine = std::min(tool->least(), room); // a text with a line to itself may be less
        const int own = std::max(mine, hintOf(*tool->item));
        widths.push_back(
            wished <= room
                ? own + roundedShare(room - wished, tool->stretch, stretches)
                : mine + roundedShare(std::max(0, room - least), own - mine, wished - least));
    }
    return widths;
}

/// The height of a wrapped text depends on its width.
int ToolRow::heightOf(const Line& line, int room) const {
    const std::vector<int> widths = widthsOf(line, room);
    int height = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const QLayoutItem& item = *line[i]->item;
        height = std::max(height, item.hasHeightForWidth() ? item.heightForWidth(widths[i])
                                                           : item.sizeHint().height());
    }
    return height;
}

/// One line if all fit; otherwise tools between two stretches stay together as far as possible.
std::vector<ToolRow::Line> ToolRow::lines(int width) const {
    std::vector<Line> groups(1);
    for (const Tool& tool : m_items) {
        if (tool.item->spacerItem()) {
            groups.emplace_back();
        }
        if (tool.item->spacerItem() || !tool.item->isEmpty()) {
            groups.back().push_back(&tool);
        }
    }
    std::vector<Line> lines(1);
    for (const Line& group : groups) {
        Line together = lines.back();
        together.insert(together.end(), group.begin(), group.end());
        if (leastWidth(together) <= width) {
            lines.back() = together;
            continue;
        }
        if (!lines.back().empty()) {
            lines.emplace_back();
        }
        for (const Tool* tool : group) {
            lines.back().push_back(tool);
            if (lines.back().size() > 1 && leastWidth(lines.back()) > width) {
                lines.back().pop_back();
                lines.push_back({tool});
            }
        }
    }
    return lines;
}

int ToolRow::heightForWidth(int width) const {
    const QMargins margins = contentsMargins();
    const int room = width - margins.left() - margins.right();
    int height = margins.top() + margins.bottom() - spacing();
    for (const Line& line : lines(room)) {
        height += heightOf(line, room) + spacing();
    }
    return height;
}

QSize ToolRow::sizeHint() const {
    QSize size(-spacing(), 0);
    for (const Tool& tool : m_items) {
        if (tool.item->spacerItem() || !tool.item->isEmpty()) {
            size.rwidth() += hintOf(*tool.item) + spacing();
            size.setHeight(std::max(size.height(), tool.item->sizeHint().height()));
        }
    }
    return size.grownBy(contentsMargins());
}

QSize ToolRow::minimumSize() const {
    QSize size(0, 0);
    for (const Tool& tool : m_items) {
        if (!tool.item->isEmpty()) {
            size = size.expandedTo({leastOf(*tool.item), tool.item->minimumSize().height()});
        }
    }
    return size.grownBy(contentsMargins());
}

void ToolRow::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    const QRect room = rect.marginsRemoved(contentsMargins());
    int top = room.top();
    const std::vector<Line> all = lines(room.width());
    for (const Line& line : all) {
        const int height = all.size() == 1 ? room.height() : heightOf(line, room.width());
        layOut(line, {room.left(), top, room.width(), height});
        top += height + spacing();
    }
}

void ToolRow::layOut(const Line& line, const QRect& rect) const {
    const std::vector<int> widths = widthsOf(line, rect.width());
    int x = rect.left();
    for (std::size_t i = 0; i < line.size(); ++i) {
        line[i]->item->setGeometry({x, rect.top(), widths[i], rect.height()});
        x += widths[i] + spacing();
    }
}

} // namespace sparkout
