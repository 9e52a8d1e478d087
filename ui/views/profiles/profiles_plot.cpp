// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/profiles_plot.h"

#include "ui/kit/font_size.h"
#include "ui/plot/plot_style.h"
#include "ui/text/names.h"
#include "ui/views/profiles/profiles_layers.h"
#include "ui/views/profiles/profiles_table.h"
#include "ui/views/profiles/profiles_text.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr double leastReach = 1.15; ///< of the base circle
constexpr double mostField = 2;     ///< a field that reaches further is cut off
constexpr double border = 1.12;     ///< room for the names of the angles inside the rim
constexpr double edge = 3;          ///< around the drawing [px]
constexpr int numberLines = 2;      ///< and one of the roundness
constexpr int besideLetters = 26;   ///< room for numbers beside a cell

int widthOf(const QString& lines, const QFontMetrics& metrics) {
    int width = 0;
    for (const QString& line : lines.split(u'\n')) {
        width = std::max(width, metrics.horizontalAdvance(line));
    }
    return width;
}

} // namespace

ProfilesPlot::ProfilesPlot(QWidget* parent) : FramedPlot(parent) {
    connect(this, &QCustomPlot::afterLayout, this, &ProfilesPlot::keepScales);
    setBuilt();
}

void ProfilesPlot::setSeries(ProfileSeries series, std::vector<int> shown) {
    const bool sameCells = shown.size() == m_cells.size() && !m_cells.empty();
    m_series = std::move(series);
    m_shown = std::move(shown);
    addZones();
    if (!sameCells || arrangement() != m_arrangement) {
        showAll();
        rebuild();
        return;
    }
    fill();
    setTexts();
}

void ProfilesPlot::setReference(RadiusReference reference) {
    m_reference = reference;
    fit();
}

void ProfilesPlot::setMagnification(std::optional<double> wanted) {
    m_wanted = wanted;
    fit();
}

void ProfilesPlot::setCircles(ReferenceCircles circles) {
    m_circles = circles;
    addZones();
    showAll();
    rebuild(); // the numbers may take a line more
}

void ProfilesPlot::addZones() {
    if (m_circles == ReferenceCircles::minimumZone) {
        addMinimumZones(m_series, m_shown);
    }
}

void ProfilesPlot::fit() {
    showAll();
    fill();
    setTexts();
}

// --- the cells ----------------------------------------------------------------------------------

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
    for (ProfileCell& cell : m_cells) {
        cell.removeLayers();
    }
    m_cells.clear();
    clearPlottables();
    plotLayout()->clear();
    m_caption = nullptr;
}

void ProfilesPlot::rebuild() {
    clearCells();
    m_arrangement = arrangement();
    if (m_shown.empty()) {
        return;
    }
    auto* cells = new QCPLayoutGrid;
    cells->setRowSpacing(0);
    cells->setColumnSpacing(0);
    plotLayout()->setRowSpacing(0);
    plotLayout()->addElement(0, 0, cells);
    for (std::size_t i = 0; i < m_shown.size(); ++i) {
        auto* grid = new QCPLayoutGrid;
        grid->setRowSpacing(0);
        grid->setColumnSpacing(0);
        const int index = static_cast<int>(i);
        cells->addElement(index / m_arrangement.columns, index % m_arrangement.columns, grid);
        buildCell(*grid);
    }
    m_caption = new QCPTextElement(this);
    plotLayout()->addElement(1, 0, m_caption);
    plotLayout()->setRowStretchFactor(1, 0.001);
    restyle();
    fill();
    retranslate();
}

void ProfilesPlot::buildCell(QCPLayoutGrid& into) {
    followMoves(*m_cells.emplace_back(*this, into, m_arrangement.beside).rect());
}

// --- contents -----------------------------------------------------------------------------------

std::vector<double> ProfilesPlot::magnifications() const {
    const Reach reach = reachOf(m_series, m_shown, m_reference, visible(ProfileLine::blank));
    return possibleMagnifications(reach, m_series.target_mm);
}

void ProfilesPlot::chooseMagnification() {
    Reach reach = reachOf(m_series, m_shown, m_reference, visible(ProfileLine::blank));
    if (m_wanted) {
        m_magnification =
            std::min(*m_wanted, possibleMagnifications(reach, m_series.target_mm).back());
        return;
    }
    if (m_reference == RadiusReference::target && visible(ProfileLine::field)) {
        reach.include(m_series.lowerLimit_mm - m_series.target_mm);
        reach.include(m_series.upperLimit_mm - m_series.target_mm);
    }
    m_magnification = suitableMagnification(reach, m_series.target_mm);
}

void ProfilesPlot::fill() {
    if (m_cells.empty()) {
        return;
    }
    chooseMagnification();
    const double base = m_series.target_mm;
    const Reach reach = reachOf(m_series, m_shown, m_reference, visible(ProfileLine::blank));
    m_reach = std::max(base * leastReach, base + m_magnification * reach.outward_mm);
    for (std::size_t i = 0; i < m_cells.size() && visible(ProfileLine::field); ++i) {
        const PolarScale scale = polarScale(m_series, profile(i), m_reference, m_magnification);
        m_reach = std::max(m_reach, std::min(scale.at(m_series.upperLimit_mm), base * mostField));
    }
    m_reach *= border;
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        m_cells[i].fill(m_series, profile(i),
                        polarScale(m_series, profile(i), m_reference, m_magnification), m_reach,
                        hidden(), m_circles);
    }
    if (m_pointedRadius >= 0) {
        pointAt(m_pointedCell, m_pointedRadius);
    }
}

QCPCurve* ProfilesPlot::curve(int index, ProfileLine line) const {
    const ProfileCell& cell = at(index);
    switch (line) {
    case ProfileLine::profile: return cell.profile();
    case ProfileLine::blank: return cell.blank();
    case ProfileLine::leastSquares: return cell.leastSquares();
    case ProfileLine::minimumZone: return cell.outerCircle();
    default: return nullptr;
    }
}

QString ProfilesPlot::numbers(int index) const {
    return at(index).numbers()->text();
}

std::vector<ProfileLine> ProfilesPlot::lines() const {
    using enum ProfileLine;
    switch (m_circles) {
    case ReferenceCircles::leastSquares: return {profile, target, leastSquares, field, blank};
    case ReferenceCircles::minimumZone: return {profile, target, minimumZone, field, blank};
    case ReferenceCircles::none: break;
    }
    return {profile, target, field, blank};
}

/// Without the circles that were not chosen.
CsvTable ProfilesPlot::table() const {
    ProfileLines without = hidden();
    if (m_circles != ReferenceCircles::leastSquares) {
        without.insert(ProfileLine::leastSquares);
    }
    if (m_circles != ReferenceCircles::minimumZone) {
        without.insert(ProfileLine::minimumZone);
    }
    return ProfilesTable::across(m_series, m_shown, without);
}

// --- one scale for all --------------------------------------------------------------------------

void ProfilesPlot::keepScales() {
    double unitsPerPixel = 0;
    for (const ProfileCell& cell : m_cells) {
        const QSizeF area(cell.rect()->size());
        const double half = std::max(std::min(area.width(), area.height()) / 2 - edge, 10.0);
        unitsPerPixel = std::max(
            unitsPerPixel, frame() ? std::max(frame()->width() / std::max(area.width(), 1.0),
                                              frame()->height() / std::max(area.height(), 1.0))
                                   : m_reach / half);
    }
    const QPointF centre = frame() ? frame()->center() : QPointF();
    for (const ProfileCell& cell : m_cells) {
        showAround(*cell.rect(), centre, unitsPerPixel);
    }
}

// --- pointing -----------------------------------------------------------------------------------

void ProfilesPlot::onMouse(QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton) {
        return;
    }
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const QCPAxisRect* rect = m_cells[i].rect();
        if (rect->rect().contains(event->pos())) {
            const double x = rect->axis(QCPAxis::atBottom)->pixelToCoord(event->pos().x());
            const double y = rect->axis(QCPAxis::atLeft)->pixelToCoord(event->pos().y());
            pointAt(static_cast<int>(i), nearestRadius(std::atan2(y, x), m_series.radii()));
            return;
        }
    }
    pointAway();
}

void ProfilesPlot::pointAt(int cell, int k) {
    const int radii = m_series.radii();
    m_pointedCell = std::clamp(cell, 0, static_cast<int>(m_cells.size()) - 1);
    m_pointedRadius = (k % radii + radii) % radii;
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const Profile& p = profile(i);
        const PolarScale scale = polarScale(m_series, p, m_reference, m_magnification);
        m_cells[i].point(m_series, p, scale, m_pointedRadius);
    }
    layer(QStringLiteral("overlay"))->replot();
    emit pointed(ProfilesText::sample(m_series, profile(static_cast<std::size_t>(m_pointedCell)),
                                      m_pointedRadius, visible(ProfileLine::blank)));
}

void ProfilesPlot::pointAway() {
    if (m_pointedRadius < 0) {
        return;
    }
    m_pointedRadius = -1;
    for (const ProfileCell& cell : m_cells) {
        cell.pointer()->clear();
    }
    layer(QStringLiteral("overlay"))->replot();
    emit pointed({});
}

// Arrows alone move the plot; with Ctrl they walk from sample to sample.
void ProfilesPlot::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    const bool sideways = (key == Qt::Key_Left || key == Qt::Key_Right)
                          && event->modifiers().testFlag(Qt::ControlModifier);
    const bool upDown = key == Qt::Key_PageUp || key == Qt::Key_PageDown;
    if (m_cells.empty() || (!sideways && !upDown && key != Qt::Key_Escape)) {
        QCustomPlot::keyPressEvent(event);
    } else if (key == Qt::Key_Escape) {
        pointAway();
    } else if (m_pointedRadius < 0) {
        pointAt(m_pointedCell, 0);
    } else if (sideways) {
        pointAt(m_pointedCell, m_pointedRadius + (key == Qt::Key_Right ? 1 : -1));
    } else {
        pointAt(m_pointedCell + (key == Qt::Key_PageDown ? 1 : -1), m_pointedRadius);
    }
}

// --- look and words -----------------------------------------------------------------------------

void ProfilesPlot::setTexts() {
    const QFontMetrics metrics(font());
    const int room = width() / std::max(m_arrangement.columns, 1) - 16;
    const int numbersRoom =
        m_arrangement.beside ? metrics.averageCharWidth() * besideLetters : room;
    bool brief = false; // all alike
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        brief = brief || widthOf(numbersOf(profile(i), false), metrics) > numbersRoom;
    }
    int widest = 1;
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        widest = std::max(widest, widthOf(numbersOf(profile(i), brief), metrics));
    }
    const QFont own =
        widest > numbersRoom ? enlarged(font(), double(numbersRoom) / widest) : font();
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const Profile& p = profile(i);
        const ProfileCell& cell = m_cells[i];
        cell.header()->setText(headerOf(p, room));
        cell.numbers()->setFont(own);
        cell.numbers()->setText(numbersOf(p, brief));
        const QString name = Names::zone(p.zone, p.section);
        cell.profile()->setName(tr("%1: profile").arg(name));
        cell.blank()->setName(tr("%1: blank").arg(name));
        cell.leastSquares()->setName(tr("%1: least-squares circle").arg(name));
        cell.innerCircle()->setName(tr("%1: inner circle of the minimum zone").arg(name));
        cell.outerCircle()->setName(tr("%1: outer circle of the minimum zone").arg(name));
    }
    if (m_caption) {
        QString text = caption();
        for (const QChar end : {u';', u','}) { // a line for each part, where they have no room
            const QStringList lines = text.split(u'\n');
            if (std::ranges::any_of(lines, [&](const QString& line) {
                    return metrics.horizontalAdvance(line) > width() - 8;
                })) {
                text.replace(end + QStringLiteral(" "), end + QStringLiteral("\n"));
            }
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
    for (ProfileCell& cell : m_cells) {
        cell.restyle(font(), palette(), isDimmed());
    }
    if (m_caption) {
        m_caption->setFont(font());
        m_caption->setTextColor(palette().color(QPalette::Text));
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
