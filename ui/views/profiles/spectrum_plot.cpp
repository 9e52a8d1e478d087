// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/spectrum_plot.h"

#include "core/units.h"
#include "ui/plot/plot_style.h"
#include "ui/text/names.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

using units::umPerMm;

constexpr int visibleUndulations = 18;
constexpr int axisTicks = 4;          ///< fits below narrow cells
constexpr double barShare = 0.4;      ///< width relative to the step between two bars
constexpr double barFloor_um = 1e-12; ///< lower end of bars on a logarithmic axis
constexpr double faintest_um = 1e-4;  ///< a tenth of a nanometre: smaller is out of sight
constexpr double spectrumRoom = 1.15; ///< headroom above the highest bar
constexpr double logarithmicRoom = 2;

void setBars(QCPBars& bars, const std::vector<Harmonic>& spectrum) {
    QVector<double> n, amplitude;
    for (std::size_t i = 1; i < spectrum.size(); ++i) { // lobe number 0 is the mean radius
        n << spectrum[i].lobes;
        amplitude << std::max(spectrum[i].amplitude_mm * umPerMm, barFloor_um);
    }
    bars.setData(n, amplitude, true);
}

double highestOf(const QCPBars& bars) {
    double highest = 0;
    for (const QCPBarsData& bar : *bars.data()) {
        highest = std::max(highest, bar.value);
    }
    return highest;
}

} // namespace

SpectrumPlot::SpectrumPlot(QWidget* parent) : ProfilePlot(parent) {
    setNotAntialiasedElements(QCP::aeAll);
    retranslate();
    setBuilt();
}

void SpectrumPlot::setSeries(const ProfileSeries& series, const std::vector<int>& shown) {
    const bool same = shown.size() == m_cells.size() && !m_cells.empty()
                      && m_blank.size() == series.blank_mm.size() / 2 + 1;
    if (!same) {
        rebuild(shown.size());
    }
    if (series.profiles.empty()) {
        return;
    }
    const Directions directions(series.blank_mm.size());
    m_blank = harmonics(series.blank_mm, directions);
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const Profile& profile = series.profiles[static_cast<std::size_t>(shown[i])];
        Cell& cell = m_cells[i];
        cell.zone = profile.zone;
        cell.section = profile.section;
        cell.left = harmonics(profile.radii_mm, directions);
        setBars(*cell.blank, m_blank);
        setBars(*cell.profile, cell.left);
    }
    showChoice();
    retranslate();
    if (!same) {
        fit();
    } else if (amplitudeAxis()->range() == m_fitted) {
        fitAmplitudes(); // unless the user has zoomed
    }
}

// --- building -----------------------------------------------------------------------------------

void SpectrumPlot::rebuild(std::size_t count) {
    clearPlottables();
    for (const Cell& cell : m_cells) {
        delete cell.sideBySide; // a child of the plot, not of its cell
    }
    plotLayout()->clear();
    m_caption = nullptr;
    m_cells.clear();
    m_cells.resize(count);
    if (count == 0) {
        return;
    }
    auto* grid = new QCPLayoutGrid;
    grid->setRowSpacing(0);
    plotLayout()->setRowSpacing(0);
    plotLayout()->addElement(0, 0, grid);
    std::vector<QCPAxisRect*> rects;
    for (std::size_t i = 0; i < count; ++i) {
        buildCell(m_cells[i], *grid, static_cast<int>(i));
        rects.push_back(m_cells[i].rect);
    }
    tie(rects, QCPAxis::atBottom);
    tie(rects, QCPAxis::atLeft);
    grid->setRowStretchFactor(0, 0.001);
    m_caption = new QCPTextElement(this);
    plotLayout()->addElement(1, 0, m_caption);
    plotLayout()->setRowStretchFactor(1, 0.001);
    restyle();
}

void SpectrumPlot::buildCell(Cell& cell, QCPLayoutGrid& into, int column) {
    cell.header = new QCPTextElement(this);
    cell.rect = new QCPAxisRect(this, true);
    into.addElement(0, column, cell.header);
    into.addElement(1, column, cell.rect);
    cell.header->setMargins(QMargins(2, 2, 2, 0));
    cell.rect->setMinimumMargins(QMargins(0, 2, 6, 0));
    for (QCPAxis* axis : style::axesOf(*cell.rect)) {
        style::setUpAxis(*axis);
    }
    QSharedPointer<QCPAxisTickerFixed> whole(new QCPAxisTickerFixed);
    whole->setTickStep(1);
    whole->setTickCount(axisTicks);
    whole->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
    cell.rect->axis(QCPAxis::atBottom)->setTicker(whole);
    cell.rect->axis(QCPAxis::atBottom)->grid()->setVisible(false);
    cell.sideBySide = new QCPBarsGroup(this);
    cell.sideBySide->setSpacing(0);
    for (QCPBars** bars : {&cell.blank, &cell.profile}) {
        *bars = new QCPBars(cell.rect->axis(QCPAxis::atBottom), cell.rect->axis(QCPAxis::atLeft));
        (*bars)->setWidth(barShare);
        (*bars)->setBaseValue(barFloor_um);
        (*bars)->setBarsGroup(cell.sideBySide);
    }
    style::setLogarithmic(*cell.rect->axis(QCPAxis::atLeft), m_logarithmic);
}

QCPAxis* SpectrumPlot::amplitudeAxis() const {
    return m_cells.front().rect->axis(QCPAxis::atLeft);
}

double SpectrumPlot::highestBar() const {
    double highest = 0;
    for (const Cell& cell : m_cells) {
        for (const QCPBars* bars : {cell.blank, cell.profile}) {
            highest = std::max(highest, highestOf(*bars)); // one scale for all
        }
    }
    return highest;
}

void SpectrumPlot::fit() {
    if (m_cells.empty()) {
        return;
    }
    const int last = std::clamp(static_cast<int>(m_blank.size()) - 1, 2, visibleUndulations);
    style::setSafeRange(*m_cells.front().rect->axis(QCPAxis::atBottom), 0.4, last + 0.6);
    fitAmplitudes();
}

void SpectrumPlot::fitAmplitudes() {
    QCPAxis& amplitude = *amplitudeAxis();
    const double highest = highestBar();
    if (m_logarithmic) {
        style::setSafeRange(amplitude, faintest_um,
                            std::max(highest, 10 * faintest_um) * logarithmicRoom);
    } else {
        style::setSafeRange(amplitude, 0, std::max(highest, faintest_um) * spectrumRoom);
    }
    m_fitted = amplitude.range();
}

// --- what is shown ------------------------------------------------------------------------------

QCPBars* SpectrumPlot::bars(int index, ProfileLine line) const {
    return line == ProfileLine::blank ? at(index).blank : at(index).profile;
}

std::vector<ProfileLine> SpectrumPlot::lines() const {
    return {ProfileLine::profile, ProfileLine::blank};
}

void SpectrumPlot::showChoice() {
    for (const Cell& cell : m_cells) {
        cell.blank->setVisible(visible(ProfileLine::blank));
        cell.profile->setVisible(visible(ProfileLine::profile));
    }
}

void SpectrumPlot::setLogarithmic(bool on) {
    m_logarithmic = on;
    for (const Cell& cell : m_cells) {
        style::setLogarithmic(*cell.rect->axis(QCPAxis::atLeft), on);
    }
    fit();
}

void SpectrumPlot::restyle() {
    ViewPlot::restyle();
    if (m_caption) {
        m_caption->setFont(font());
        m_caption->setTextColor(palette().color(QPalette::Text));
    }
    for (Cell& cell : m_cells) {
        cell.header->setFont(font());
        cell.header->setTextColor(palette().color(QPalette::Text));
        for (const ProfileLine line : {ProfileLine::blank, ProfileLine::profile}) {
            QCPBars* bars = line == ProfileLine::blank ? cell.blank : cell.profile;
            const QColor colour = ProfileLook::pen(line, palette(), isDimmed()).color();
            bars->setPen(QPen(colour, 1));
            bars->setBrush(colour);
        }
    }
}

void SpectrumPlot::setTexts() {
    for (Cell& cell : m_cells) {
        cell.name = Names::zone(cell.zone, cell.section);
        cell.header->setText(cell.name);
        cell.rect->axis(QCPAxis::atLeft)
            ->setLabel(&cell == &m_cells.front() ? tr("Amplitude, µm") : QString());
    }
    if (m_caption) {
        m_caption->setText(tr("Undulations per revolution"));
    }
}

// --- numbers ------------------------------------------------------------------------------------

QString SpectrumPlot::valuesAt(const QPointF& at) const {
    for (const Cell& cell : m_cells) {
        if (!cell.rect->rect().contains(at.toPoint())) {
            continue;
        }
        const double x = cell.rect->axis(QCPAxis::atBottom)->pixelToCoord(at.x());
        const auto n = std::lround(x);
        if (n >= 1 && n < static_cast<long>(cell.left.size())) {
            const auto um = [n](const std::vector<Harmonic>& spectrum) {
                return Names::significant(spectrum[static_cast<std::size_t>(n)].amplitude_mm
                                          * umPerMm);
            };
            return (n == 1 ? tr("%1, %2 undulation per revolution (eccentricity): amplitude %3 µm, "
                                "of the blank %4 µm")
                           : tr("%1, %2 undulations per revolution: amplitude %3 µm, of the blank "
                                "%4 µm"))
                .arg(cell.name, QString::number(n), um(cell.left), um(m_blank));
        }
    }
    return {};
}

CsvTable SpectrumPlot::table() const {
    const bool withBlank = visible(ProfileLine::blank);
    const bool withProfile = visible(ProfileLine::profile);
    CsvTable table;
    table.header << tr("undulations per revolution");
    if (withBlank) {
        table.header << tr("blank: amplitude, µm");
    }
    for (const Cell& cell : m_cells) {
        if (withProfile) {
            table.header << tr("%1: amplitude, µm").arg(cell.name);
        }
    }
    const auto um = [](const std::vector<Harmonic>& spectrum, std::size_t n) {
        return spectrum[n].amplitude_mm * umPerMm;
    };
    for (std::size_t n = 1; n < m_blank.size() && !m_cells.empty(); ++n) {
        if (!m_cells.front().rect->axis(QCPAxis::atBottom)->range().contains(double(n))) {
            continue;
        }
        std::vector<CsvCell> row{double(n)};
        if (withBlank) {
            row.emplace_back(um(m_blank, n));
        }
        for (const Cell& cell : m_cells) {
            if (withProfile) {
                row.emplace_back(um(cell.left, n));
            }
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace sparkout
