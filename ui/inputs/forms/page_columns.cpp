// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/page_columns.h"

#include "ui/inputs/editors/form_metrics.h"
#include "ui/inputs/forms/section_box.h"

#include <QStyle>
#include <QWidget>

#include <algorithm>

namespace sparkout {

namespace {

constexpr int between = metrics::wide; ///< the columns

int heightAt(const QLayoutItem& item, int width) {
    const int height =
        item.hasHeightForWidth() ? item.heightForWidth(width) : item.sizeHint().height();
    return std::max(height, item.minimumSize().height());
}

} // namespace

void PageColumns::addWide(QWidget* part) {
    addWidget(part);
    m_wide.push_back(part);
}

/// A column is at least as wide as a page of one column with a scroll bar.
bool PageColumns::hasTwo(int width) const {
    const int bar = parentWidget()->style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    return (width - between) / 2 >= panelWidth() - bar - 2 * metrics::margin;
}

bool PageColumns::isWide(const QLayoutItem& item) const {
    const QWidget* widget = const_cast<QLayoutItem&>(item).widget();
    return std::ranges::find(m_wide, widget) != m_wide.end();
}

/// Rows of fields are layouts, with a smaller gap than parts with a frame or a title.
int PageColumns::gap(const QLayoutItem& above, const QLayoutItem& below) const {
    const auto isRow = [](const QLayoutItem& item) {
        return const_cast<QLayoutItem&>(item).layout() != nullptr;
    };
    return isRow(above) && isRow(below) ? metrics::row : spacing();
}

int PageColumns::heightOf(std::span<const Part> parts) const {
    int height = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        height += parts[i].height + (i > 0 ? gap(*parts[i - 1].item, *parts[i].item) : 0);
    }
    return height;
}

/// The number of parts on the left: the first of the splits whose higher column is lowest.
std::size_t PageColumns::split(std::span<const Part> parts) const {
    std::size_t best = parts.size();
    int least = heightOf(parts);
    for (std::size_t left = 1; left < parts.size(); ++left) {
        const int height = std::max(heightOf(parts.first(left)), heightOf(parts.subspan(left)));
        if (height < least) {
            least = height;
            best = left;
        }
    }
    return best;
}

int PageColumns::placeColumn(std::span<const Part> parts, QRect room, const Put& put) const {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const int y = room.top() + heightOf(parts.first(i + 1)) - parts[i].height;
        put(*parts[i].item, {room.left(), y, room.width(), parts[i].height});
    }
    return heightOf(parts);
}

/// Places parts in two columns; a single box spans both.
int PageColumns::placeColumns(const Items& items, const QRect& room, const Put& put) const {
    const bool isAlone = items.size() == 1 && qobject_cast<SectionBox*>(items.front()->widget());
    const int width = isAlone ? room.width() : (room.width() - between) / 2;
    std::vector<Part> parts;
    for (QLayoutItem* item : items) {
        parts.push_back({item, heightAt(*item, width)});
    }
    const std::span<const Part> all(parts);
    const std::size_t left = split(all);
    const QRect first(room.left(), room.top(), width, room.height());
    const QRect second = first.translated(room.width() - width, 0);
    return std::max(placeColumn(all.first(left), first, put),
                    placeColumn(all.subspan(left), second, put));
}

int PageColumns::place(const QRect& room, const Put& put) const {
    Items shown;
    for (int i = 0; i < count(); ++i) {
        if (!itemAt(i)->isEmpty()) {
            shown.push_back(itemAt(i));
        }
    }
    if (!hasTwo(room.width())) {
        std::vector<Part> parts;
        for (QLayoutItem* item : shown) {
            parts.push_back({item, heightAt(*item, room.width())});
        }
        return placeColumn(parts, room, put);
    }
    int y = room.top();
    QLayoutItem* above = nullptr;
    for (auto item = shown.begin(); item != shown.end();) {
        const auto end = isWide(**item)
                             ? item + 1
                             : std::find_if(item, shown.end(), [this](const QLayoutItem* next) {
                                   return isWide(*next);
                               });
        y += above ? gap(*above, **item) : 0;
        const QRect rest(room.left(), y, room.width(), room.bottom() + 1 - y);
        if (isWide(**item)) {
            const Part part{*item, heightAt(**item, room.width())};
            y += placeColumn({&part, 1}, rest, put);
        } else {
            y += placeColumns({item, end}, rest, put);
        }
        above = *(end - 1);
        item = end;
    }
    return y - room.top();
}

int PageColumns::heightForWidth(int width) const {
    const QMargins margins = contentsMargins();
    const QRect room(0, 0, width - margins.left() - margins.right(), 0);
    return margins.top() + place(room, [](QLayoutItem&, const QRect&) {}) + margins.bottom();
}

int PageColumns::minimumHeightForWidth(int width) const {
    return heightForWidth(width);
}

/// The height follows from the width.
QSize PageColumns::minimumSize() const {
    return {QVBoxLayout::minimumSize().width(), 0};
}

void PageColumns::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    place(rect.marginsRemoved(contentsMargins()),
          [](QLayoutItem& item, const QRect& at) { item.setGeometry(at); });
}

} // namespace sparkout
