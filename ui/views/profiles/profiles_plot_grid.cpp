// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of the cross-sections: arranging, building, texts and colours.
#include "ui/plot/plot_style.h"
#include "ui/text/names.h"
#include "ui/views/profiles/profiles_layers.h"
#include "ui/views/profiles/profiles_plot.h"
#include "ui/views/profiles/profiles_text.h"

#include <algorithm>

namespace sparkout {

namespace {

constexpr int numberLines = 2; ///< and one of the roundness
constexpr double markSize_px = 8;
constexpr int besideLetters = 26; ///< room for numbers beside a cell
constexpr int tallest = 100'000;

int widthOf(const QString& lines, const QFontMetrics& metrics) {
    int width = 0;
    for (const QString& line : lines.split(u'\n')) {
        width = std::max(width, metrics.horizontalAdvance(line));
    }
    return width;
}

} // namespace

/// The arrangement with the largest circles.
ProfilesPlot::Arrangement ProfilesPlot::arrangement() const {
    const QFontMetrics metrics(font());
    const int line = metrics.height();
    const int beside = metrics.averageCharWidth() * besideLetters;
    const int count = std::max(static_cast<int>(m_shown.size()), 1);
    const int lines = numberLines + (m_circles == ReferenceCircles::none ? 0 : 1);
    Arrangement best;
    int largest = 0;
    for (int columns = count; columns >= 1; --columns) {
        const int rows = (count + columns - 1) / columns;
        const int width = this->width() / columns;
        const int height = (this->height() - line) / rows - line;
        const int below = std::min(width, height - lines * line);
        const int aside = std::min(width - beside, height);
        if (below > largest) {
            largest = below;
            best = {columns, false};
        }
        if (aside > largest * 1.1) {
            largest = aside;
            best = {columns, true};
        }
    }
    return best;
}

void ProfilesPlot::clearCells() {
    for (Cell& cell : m_cells) {
        delete cell.field;
        delete cell.target;
        delete cell.polar;
        delete cell.pointer;
    }
    m_cells.clear();
    clearPlottables();
    plotLayout()->clear();
    m_caption = nullptr;
}

void ProfilesPlot::rebuild() {
    clearCells();
    m_arrangement = arrangement();
    m_cells.resize(m_shown.size());
    if (m_cells.empty()) {
        return;
    }
    auto* cells = new QCPLayoutGrid;
    cells->setRowSpacing(0);
    cells->setColumnSpacing(0);
    plotLayout()->setRowSpacing(0);
    plotLayout()->addElement(0, 0, cells);
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        auto* grid = new QCPLayoutGrid;
        grid->setRowSpacing(0);
        grid->setColumnSpacing(0);
        const int index = static_cast<int>(i);
        cells->addElement(index / m_arrangement.columns, index % m_arrangement.columns, grid);
        buildCell(m_cells[i], grid);
    }
    m_caption = new QCPTextElement(this);
    plotLayout()->addElement(1, 0, m_caption);
    plotLayout()->setRowStretchFactor(1, 0.001);
    restyle();
    fill();
    retranslate();
}

void ProfilesPlot::buildCell(Cell& cell, QCPLayoutGrid* into) {
    cell.header = new QCPTextElement(this);
    cell.numbers = new QCPTextElement(this);
    cell.rect = new QCPAxisRect(this, true);
    into->addElement(0, 0, cell.header);
    into->addElement(1, 0, cell.rect);
    into->setRowStretchFactor(0, 0.001);
    if (m_arrangement.beside) {
        into->addElement(1, 1, cell.numbers);
        into->setColumnStretchFactor(1, 0.001);
        cell.numbers->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
        cell.numbers->setMaximumSize(tallest, tallest); // else its lines are the row's height
    } else {
        into->addElement(2, 0, cell.numbers);
        into->setRowStretchFactor(2, 0.001);
        cell.numbers->setTextFlags(Qt::AlignHCenter | Qt::AlignTop);
    }
    cell.header->setMargins(QMargins(2, 2, 2, 0));
    cell.numbers->setMargins(QMargins(2, 0, 4, 2));
    cell.rect->setAutoMargins(QCP::msNone);
    cell.rect->setMargins(QMargins(2, 0, 2, 0));
    for (QCPAxis* axis : cell.rect->axes()) {
        axis->setVisible(false);
        axis->grid()->setVisible(false);
        connect(axis, QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
                [this, rect = cell.rect] { onRangeChanged(rect); });
    }
    cell.field = new PolarRing(cell.rect, QStringLiteral("bands"));
    cell.polar = new PolarGrid(cell.rect, QStringLiteral("grid"));
    cell.target = new PolarCircle(cell.rect, QStringLiteral("main"));
    cell.pointer = new PolarPointer(cell.rect);
    addCurves(cell);
}

void ProfilesPlot::addCurves(Cell& cell) {
    for (QCPCurve** curve : {&cell.blank, &cell.leastSquares, &cell.inner, &cell.outer,
                             &cell.centre, &cell.profile, &cell.contacts}) {
        *curve = addCurve(*cell.rect);
    }
    cell.centre->setLineStyle(QCPCurve::lsNone);
    cell.contacts->setLineStyle(QCPCurve::lsNone);
}

void ProfilesPlot::setTexts() {
    const QFontMetrics metrics(font());
    const int room = width() / std::max(m_arrangement.columns, 1) - 16;
    const int numbersRoom =
        m_arrangement.beside ? metrics.averageCharWidth() * besideLetters : room;
    bool brief = false; // all alike
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        brief = brief || widthOf(numbersOf(profile(i), false), metrics) > numbersRoom;
    }
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const Profile& p = profile(i);
        const Cell& cell = m_cells[i];
        cell.header->setText(headerOf(p, room));
        cell.numbers->setText(numbersOf(p, brief));
        const QString name = Names::zone(p.zone, p.section);
        cell.profile->setName(tr("%1: profile").arg(name));
        cell.blank->setName(tr("%1: blank").arg(name));
        cell.leastSquares->setName(tr("%1: least-squares circle").arg(name));
        cell.inner->setName(tr("%1: inner circle of the minimum zone").arg(name));
        cell.outer->setName(tr("%1: outer circle of the minimum zone").arg(name));
    }
    if (m_caption) {
        QString text = caption();
        if (metrics.horizontalAdvance(text) > width() - 8) {
            text.replace(QStringLiteral("; "), QStringLiteral(";\n"));
        }
        m_caption->setText(text);
    }
}

QString ProfilesPlot::numbersOf(const Profile& p, bool brief) const {
    const QString numbers = ProfilesText::numbers(m_series, p, brief);
    switch (m_series.isWhole ? m_circles : ReferenceCircles::none) {
    case ReferenceCircles::leastSquares:
        return numbers + u'\n' + ProfilesText::roundness(p.leastSquares, brief);
    case ReferenceCircles::minimumZone:
        return numbers + u'\n' + ProfilesText::roundness(p.minimumZone, brief);
    case ReferenceCircles::none: break;
    }
    return numbers;
}

/// The longest of the names that fits.
QString ProfilesPlot::headerOf(const Profile& p, int room) const {
    const QString full = Names::zoneFull(p.zone, p.section);
    const QFontMetrics metrics(font());
    const QString withGauge = p.gauge ? tr("%1 (gauge)").arg(full) : full;
    for (const QString& name : {withGauge, full}) {
        if (metrics.horizontalAdvance(name) <= room) {
            return name;
        }
    }
    return Names::zone(p.zone, p.section);
}

QString ProfilesPlot::caption() const {
    const QString times = ProfilesText::magnification(m_magnification);
    const QString scale =
        m_reference == RadiusReference::target
            ? tr("Deviations from the target radius drawn %1, scale in µm").arg(times)
            : tr("Deviations from each one's mean radius drawn %1, scale in µm").arg(times);
    return tr("%1; straight lines between the %2 radii").arg(scale).arg(m_series.radii());
}

void ProfilesPlot::takeLook(bool font) {
    if (font && !m_cells.empty()) {
        rebuild();
    } else {
        restyle();
    }
}

void ProfilesPlot::restyle() {
    setBackground(palette().brush(QPalette::Base));
    const QColor text = palette().color(QPalette::Text);
    for (Cell& cell : m_cells) {
        for (QCPTextElement* element : {cell.header, cell.numbers}) {
            element->setFont(font());
            element->setTextColor(text);
        }
        const auto pen = [this](ProfileLine line) {
            return ProfileLook::pen(line, palette(), isDimmed());
        };
        cell.field->setLook(pen(ProfileLine::field),
                            ProfileLook::fill(ProfileLine::field, palette(), isDimmed()));
        cell.target->setPen(pen(ProfileLine::target));
        cell.blank->setPen(pen(ProfileLine::blank));
        cell.leastSquares->setPen(pen(ProfileLine::leastSquares));
        const QPen circle = pen(ProfileLine::minimumZone);
        cell.inner->setPen(circle);
        cell.outer->setPen(circle);
        const QPen mark(circle.color(), 1.6);
        cell.centre->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssPlus, mark, Qt::NoBrush, markSize_px));
        cell.contacts->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssCircle, mark, Qt::NoBrush, markSize_px));
        cell.profile->setPen(pen(ProfileLine::profile));
    }
    if (m_caption) {
        m_caption->setFont(font());
        m_caption->setTextColor(text);
    }
}

void ProfilesPlot::resizeEvent(QResizeEvent* event) {
    if (!m_cells.empty()) {
        if (arrangement() != m_arrangement) {
            rebuild();
        } else {
            setTexts();
        }
    }
    QCustomPlot::resizeEvent(event);
}

} // namespace sparkout
