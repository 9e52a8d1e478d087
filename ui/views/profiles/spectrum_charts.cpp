// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/spectrum_charts.h"

#include "core/form/harmonics.h"
#include "core/units.h"
#include "ui/text/names.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr int visibleUndulations = 18;
constexpr double barShare = 0.4;      ///< width relative to the step between two bars
constexpr double faintest_um = 1e-4;  ///< a tenth of a nanometre: smaller is out of sight
constexpr double spectrumRoom = 1.15; ///< headroom above the highest bar
constexpr double logarithmicRoom = 2;

/// Amplitudes by the number of undulations [µm]; number 0 is the mean radius.
std::vector<double> spectrumOf(const std::vector<double>& radii_mm, const Directions& directions) {
    std::vector<double> amplitudes;
    for (const Harmonic& harmonic : harmonics(radii_mm, directions)) {
        amplitudes.push_back(harmonic.amplitude_mm * units::umPerMm);
    }
    return amplitudes;
}

ChartSeries barsOf(const std::vector<double>& spectrum, ProfileLine line, double beside) {
    ChartSeries bars{.key = static_cast<int>(line),
                     .name = ProfileLook::name(line),
                     .kind = ChartSeries::Kind::bars,
                     .colour =
                         line == ProfileLine::blank ? style::Drawn::blank : style::Drawn::profile,
                     .barWidth = barShare};
    for (std::size_t n = 1; n < spectrum.size(); ++n) {
        bars.points.push_back({static_cast<double>(n) + beside, spectrum[n]});
    }
    return bars;
}

} // namespace

ChartGrid SpectrumCharts::of(const ProfileSeries& series, const std::vector<int>& shown,
                             bool isLogarithmic, const std::function<bool(ProfileLine)>& isShown) {
    ChartGrid grid;
    if (series.profiles.empty() || shown.empty()) {
        return grid;
    }
    grid.columns = shown.size();
    grid.caption = tr("Undulations per revolution");
    grid.sharesValues = true;
    const Directions directions(series.blank_mm.size());
    const std::vector<double> blank = spectrumOf(series.blank_mm, directions);
    QStringList names;
    std::vector<std::vector<double>> spectra;
    for (const int index : shown) {
        const Profile& profile = series.profiles[static_cast<std::size_t>(index)];
        spectra.push_back(spectrumOf(profile.radii_mm, directions));
        LineChart chart;
        const QString name = Names::zone(profile.zone, profile.section);
        chart.headings << name;
        chart.series = {barsOf(blank, ProfileLine::blank, -barShare / 2),
                        barsOf(spectra.back(), ProfileLine::profile, barShare / 2)};
        chart.placeText = [name, blank, left = spectra.back()](double place) {
            const auto n = std::lround(place);
            if (n < 1 || n >= std::ssize(left)) {
                return QString();
            }
            const auto um = [n](const std::vector<double>& spectrum) {
                return Names::significant(spectrum[static_cast<std::size_t>(n)]);
            };
            return (n == 1 ? tr("%1, %2 undulation per revolution (eccentricity): amplitude %3 µm, "
                                "of the blank %4 µm")
                           : tr("%1, %2 undulations per revolution: amplitude %3 µm, of the blank "
                                "%4 µm"))
                .arg(name, QString::number(n), um(left), um(blank));
        };
        names << name;
        grid.cells.push_back(std::move(chart));
    }
    double highest = 0; // one scale for all
    for (const LineChart& chart : grid.cells) {
        for (const ChartSeries& bars : chart.series) {
            for (const XY& bar : bars.points) {
                highest = std::max(highest, bar.y);
            }
        }
    }
    const int last = std::clamp(static_cast<int>(blank.size()) - 1, 2, visibleUndulations);
    for (LineChart& chart : grid.cells) {
        chart.across = {.range = {0.4, last + 0.6}, .room = 0, .isCounted = true, .hasGrid = false};
        chart.up = {.label = tr("Amplitude, µm"), .room = 0, .isLogarithmic = isLogarithmic};
        chart.up.range =
            isLogarithmic
                ? ChartSpan{faintest_um, std::max(highest, 10 * faintest_um) * logarithmicRoom}
                : ChartSpan{0, std::max(highest, faintest_um) * spectrumRoom};
    }
    grid.cells.front().table = [names, blank, spectra, isShown] {
        ChartTable table;
        table.cells.header << tr("undulations per revolution");
        const bool withBlank = isShown(ProfileLine::blank);
        const bool withProfile = isShown(ProfileLine::profile);
        if (withBlank) {
            table.cells.header << tr("blank: amplitude, µm");
        }
        for (const QString& name : withProfile ? names : QStringList()) {
            table.cells.header << tr("%1: amplitude, µm").arg(name);
        }
        for (std::size_t n = 1; n < blank.size(); ++n) {
            const auto place = static_cast<double>(n);
            std::vector<CsvCell> row{place};
            if (withBlank) {
                row.emplace_back(blank[n]);
            }
            for (std::size_t i = 0; withProfile && i < spectra.size(); ++i) {
                row.emplace_back(spectra[i][n]);
            }
            table.cells.rows.push_back(std::move(row));
            table.places.push_back({.across = {place, place}});
        }
        return table;
    };
    return grid;
}

} // namespace sparkout
