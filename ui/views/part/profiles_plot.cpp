// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/part/profiles_plot.h"

#include "core/file/safe_file.h"
#include "core/measured/measured_table.h"
#include "core/measured/number_table.h"
#include "ui/chart/view_plot.h"
#include "ui/kit/font_size.h"
#include "ui/measured/measured_text.h"
#include "ui/session/project_io.h"
#include "ui/text/file_error_text.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/part/profiles_text.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

namespace sparkout {

std::optional<MeasuredSection> MeasuredSection::read(const QString& path, double nominalRadius_mm,
                                                     QString& reason) {
    auto bytes = readFile(systemPath(path), limits::measuredBytes);
    if (const auto* fault = std::get_if<FileError>(&bytes)) {
        reason = readErrorText(*fault);
        return std::nullopt;
    }
    ClosedProfile profile = readClosedProfile(std::get<std::string>(bytes), nominalRadius_mm);
    constexpr std::size_t mostFaults = 5;
    QStringList faults;
    for (std::size_t i = 0; i < profile.faults.size() && i < mostFaults; ++i) {
        faults << MeasuredText::fault(profile.faults[i]);
    }
    if (!faults.isEmpty()) {
        reason = tr("A table of two columns is needed: the angle in °, and the radius in mm or the "
                    "deviation from it in µm.")
                 + u'\n' + faults.join(u'\n');
        return std::nullopt;
    }
    MeasuredSection section;
    section.name = printableText(QFileInfo(path).fileName());
    section.radii_mm = std::move(profile.radii_mm);
    return section;
}

std::optional<MeasuredSection> MeasuredSection::ask(QWidget* window, double nominalRadius_mm) {
    const QString path =
        QFileDialog::getOpenFileName(window, tr("Read a measured profile"), {},
                                     tr("Tables (*.csv *.txt *.tsv *.dat);;All files (*)"));
    if (path.isEmpty()) {
        return std::nullopt;
    }
    QString reason;
    auto section = read(path, nominalRadius_mm, reason);
    if (!section) {
        QMessageBox box(QMessageBox::Information, tr("The profile was not read"), reason,
                        QMessageBox::Ok, window);
        box.setTextFormat(Qt::PlainText);
        box.exec();
    }
    return section;
}

namespace {

constexpr double leastReach = 1.15; ///< relative to the base circle
constexpr double mostField = 2;     ///< a field that reaches further is cut off
constexpr double border = 1.12;     ///< space for the names of the angles inside the rim
constexpr double edge = 3;          ///< around the drawing [px]
constexpr int numberLines = 2;      ///< plus one for the roundness
constexpr int besideLetters = 26;   ///< space for numbers beside a cell

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
    m_series = std::move(series);
    m_shown = std::move(shown);
    const bool sameCells = cellCount() == m_cells.size() && !m_cells.empty();
    drawProfiles();
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
    drawProfiles();
    showAll();
    rebuild(); // the numbers may need another line
}

void ProfilesPlot::setFilter(std::optional<int> cutoff_upr) {
    m_cutoff_upr = cutoff_upr;
    drawProfiles();
    fit();
}

void ProfilesPlot::setMeasured(std::optional<MeasuredSection> measured) {
    m_measured = std::move(measured);
    drawProfiles();
    showAll();
    rebuild();
}

void ProfilesPlot::drawProfiles() {
    m_drawn.clear();
    for (const int index : m_shown) {
        m_drawn.push_back(shownProfile(m_series.profiles[static_cast<std::size_t>(index)],
                                       m_circles, m_cutoff_upr));
    }
    if (m_measured && !m_shown.empty()) {
        m_drawn.push_back(
            shownProfile(measuredProfile(m_series, m_measured->radii_mm), m_circles, m_cutoff_upr));
    }
}

Reach ProfilesPlot::reach() const {
    Reach reach = reachOf(m_series, m_shown, m_reference, visible(ProfileLine::blank));
    if (cellCount() > m_shown.size()) {
        const Profile& measured = m_drawn.back();
        const PolarScale scale = polarScale(m_series, measured, RadiusReference::mean, 1);
        for (const double radius : measured.radii_mm) {
            reach.include(radius - scale.reference_mm);
        }
    }
    return reach;
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
    const int count = std::max(static_cast<int>(cellCount()), 1);
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
    for (std::size_t i = 0; i < cellCount(); ++i) {
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
    return possibleMagnifications(reach(), m_series.target_mm);
}

void ProfilesPlot::chooseMagnification() {
    Reach all = reach();
    if (m_wanted) {
        m_magnification =
            std::min(*m_wanted, possibleMagnifications(all, m_series.target_mm).back());
        return;
    }
    if (m_reference == RadiusReference::target && visible(ProfileLine::field)) {
        all.include(m_series.lowerLimit_mm - m_series.target_mm);
        all.include(m_series.upperLimit_mm - m_series.target_mm);
    }
    m_magnification = suitableMagnification(all, m_series.target_mm);
}

void ProfilesPlot::fill() {
    if (m_cells.empty()) {
        return;
    }
    chooseMagnification();
    const double base = m_series.target_mm;
    m_reach = std::max(base * leastReach, base + m_magnification * reach().outward_mm);
    for (std::size_t i = 0; i < m_cells.size() && visible(ProfileLine::field); ++i) {
        const PolarScale scale = scaleOf(i);
        m_reach = std::max(m_reach, std::min(scale.at(m_series.upperLimit_mm), base * mostField));
    }
    m_reach *= border;
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        m_cells[i].fill(m_series, profile(i), scaleOf(i), m_reach, hidden(), m_circles);
        if (isMeasured(i)) {
            m_cells[i].showFormAlone();
        }
    }
    if (m_pointedRadius >= 0) {
        pointAt(m_pointedCell, m_pointedRadius);
    }
}

/// The set-up of a roundness machine does not determine the size.
PolarScale ProfilesPlot::scaleOf(std::size_t cell) const {
    return polarScale(m_series, profile(cell),
                      isMeasured(cell) ? RadiusReference::mean : m_reference, m_magnification);
}

QCPCurve* ProfilesPlot::curve(int index, ProfileLine line) const {
    const ProfileCell& cell = at(index);
    switch (line) {
    case ProfileLine::profile: return cell.profile();
    case ProfileLine::blank: return cell.blank();
    case ProfileLine::leastSquares: return cell.leastSquares();
    case ProfileLine::circumscribed:
    case ProfileLine::minimumZone: return cell.outerCircle();
    case ProfileLine::inscribed: return cell.innerCircle();
    default: return nullptr;
    }
}

QString ProfilesPlot::numbers(int index) const {
    return at(index).numbers()->text();
}

std::vector<ProfileLine> ProfilesPlot::lines() const {
    using enum ProfileLine;
    const auto circle = lineOf(m_circles);
    return circle ? std::vector{profile, target, *circle, field, blank}
                  : std::vector{profile, target, field, blank};
}

CsvTable ProfilesPlot::table() const {
    QStringList names;
    for (std::size_t i = 0; i < m_drawn.size(); ++i) {
        names << nameOf(i);
    }
    return ProfilesTable::across(m_series, m_drawn, names, m_circles, hidden());
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
    const auto radiusIn = [&](const Profile& p) { // at the same angle
        const auto own = static_cast<int>(p.radii_mm.size());
        return own == radii ? m_pointedRadius : nearestRadius(angleOf(m_pointedRadius, radii), own);
    };
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const Profile& p = profile(i);
        m_cells[i].point(p, scaleOf(i), radiusIn(p));
    }
    layer(QStringLiteral("overlay"))->replot();
    const auto pointedAt = static_cast<std::size_t>(m_pointedCell);
    const Profile& p = profile(pointedAt);
    emit pointed(ProfilesText::sample(m_series, p, nameOf(pointedAt), radiusIn(p),
                                      visible(ProfileLine::blank) && !isMeasured(pointedAt)));
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

// Arrows alone move the plot; with Ctrl they step from sample to sample.
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
    bool brief = false; // the same for all cells
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        brief = brief || widthOf(numbersOf(i, false), metrics) > numbersRoom;
    }
    int widest = 1;
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        widest = std::max(widest, widthOf(numbersOf(i, brief), metrics));
    }
    const QFont own =
        widest > numbersRoom ? enlarged(font(), double(numbersRoom) / widest) : font();
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const ProfileCell& cell = m_cells[i];
        cell.header()->setText(headerOf(i, room));
        cell.numbers()->setFont(own);
        cell.numbers()->setText(numbersOf(i, brief));
        const QString name = nameOf(i);
        cell.profile()->setName(tr("%1: profile").arg(name));
        cell.blank()->setName(tr("%1: blank").arg(name));
        cell.leastSquares()->setName(tr("%1: least-squares circle").arg(name));
        const auto [inner, outer] = circleNames();
        cell.innerCircle()->setName(inner.arg(name));
        cell.outerCircle()->setName(outer.arg(name));
    }
    if (m_caption) {
        QString text = caption();
        for (const QChar end : {u';', u','}) { // one line per part if they do not fit
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

/// The names of the inner and the outer circle.
std::pair<QString, QString> ProfilesPlot::circleNames() const {
    switch (m_circles) {
    case ReferenceCircles::inscribed:
        return {tr("%1: maximum inscribed circle"), tr("%1: circle about its centre, outside")};
    case ReferenceCircles::circumscribed:
        return {tr("%1: circle about its centre, inside"), tr("%1: minimum circumscribed circle")};
    default:
        return {tr("%1: inner circle of the minimum zone"),
                tr("%1: outer circle of the minimum zone")};
    }
}

QString ProfilesPlot::nameOf(std::size_t cell) const {
    const Profile& p = profile(cell);
    return isMeasured(cell) ? tr("Measured") : Names::zone(p.zone, p.section);
}

QString ProfilesPlot::numbersOf(std::size_t cell, bool brief) const {
    const Profile& p = profile(cell);
    const QString numbers =
        isMeasured(cell) ? ProfilesText::measured(p) : ProfilesText::numbers(m_series, p, brief);
    if (m_circles == ReferenceCircles::none || !m_series.isWhole) {
        return numbers;
    }
    const RoundnessZone* const zone = shownZone(p, m_circles);
    return numbers + u'\n'
           + (zone ? ProfilesText::roundness(*zone, brief,
                                             m_series.knowsRoundness || isMeasured(cell),
                                             m_series.knowsEccentricity || isMeasured(cell))
                   : tr("the circle does not exist"));
}

QString ProfilesPlot::describeMeasured() const {
    return m_measured && !m_drawn.empty()
               ? tr("Measured profile %1: %2")
                     .arg(m_measured->name,
                          numbersOf(m_drawn.size() - 1, false).replace(u'\n', QStringLiteral("; ")))
               : QString();
}

/// The longest name that fits; the zones have full names if all fit.
QString ProfilesPlot::headerOf(std::size_t cell, int room) const {
    const QFontMetrics metrics(font());
    const auto fits = [&](const QString& name) { return metrics.horizontalAdvance(name) <= room; };
    if (isMeasured(cell)) {
        const QString full = tr("Measured: %1").arg(m_measured->name);
        return fits(full) ? full : nameOf(cell);
    }
    const auto full = [this](std::size_t at) {
        return Names::zoneFull(profile(at).zone, profile(at).section);
    };
    bool allFit = true;
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        allFit = allFit && (isMeasured(i) || fits(full(i)));
    }
    const QString name = allFit ? full(cell) : nameOf(cell);
    const QString withGauge = tr("%1 (gauge)").arg(name);
    return profile(cell).gauge && fits(withGauge) ? withGauge : name;
}

QString ProfilesPlot::caption() const {
    const QString times = ProfilesText::magnification(m_magnification);
    const QString scale =
        m_reference == RadiusReference::target
            ? tr("Deviations from the target radius drawn %1, scale in µm").arg(times)
            : tr("Deviations from each one's mean radius drawn %1, scale in µm").arg(times);
    const QString text =
        tr("%1; straight lines between the %2 radii").arg(scale).arg(m_series.radii());
    return m_cutoff_upr ? text + QStringLiteral("; ") + ProfilesText::filter(m_cutoff_upr) : text;
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
