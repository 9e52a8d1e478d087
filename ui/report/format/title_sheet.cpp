// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/title_sheet.h"

#include <QFont>

#include <algorithm>

namespace sparkout::report {

namespace {

constexpr double textPoints = 12, documentPoints = 16, titlePoints = 14;
constexpr double betweenLines = 60, groupsApart = 240; ///< tenths of a point
constexpr double titleAt = 0.3, peopleFrom = 0.45;     ///< shares of height and width

/// Lines one below the other.
class Column {
public:
    Column(double x, double y, double width) : m_x(x), m_y(y), m_width(width) {}

    void add(const QString& text, const QFont& font, Qt::Alignment align) {
        const TextBox box(text, font, m_width, align);
        m_lines.push_back({box, m_x, m_y});
        m_y += box.height() + betweenLines;
    }
    void skip(double height) { m_y += height; }
    [[nodiscard]] double bottom() const { return m_y; }
    [[nodiscard]] std::vector<TitleSheet::Line>& lines() { return m_lines; }

private:
    double m_x, m_y, m_width;
    std::vector<TitleSheet::Line> m_lines;
};

} // namespace

std::vector<TitleSheet::Line> TitleSheet::lines(const TitlePage& title, QSizeF area) {
    const QFont plain = reportFont(textPoints), strong = reportFont(titlePoints, true);
    Column column(0, 0, area.width());
    for (const QString& line : title.above) {
        column.add(line, plain, Qt::AlignHCenter);
    }
    column.skip(std::max(groupsApart, titleAt * area.height() - column.bottom()));
    column.add(title.document.toUpper(), reportFont(documentPoints, true), Qt::AlignHCenter);
    for (const QString& line : title.title) {
        column.add(line, strong, Qt::AlignHCenter);
    }
    const double from = peopleFrom * area.width();
    Column people(from, column.bottom() + 2 * groupsApart, area.width() - from);
    for (const auto& [part, who] : title.people) {
        people.add(part, plain, Qt::AlignLeft);
        people.add(who, plain, Qt::AlignLeft);
        people.skip(betweenLines);
    }
    std::vector<Line> all = std::move(column.lines());
    all.insert(all.end(), people.lines().begin(), people.lines().end());
    const TextBox below(title.below, plain, area.width(), Qt::AlignHCenter);
    all.push_back({below, 0, area.height() - below.height()});
    return all;
}

} // namespace sparkout::report
