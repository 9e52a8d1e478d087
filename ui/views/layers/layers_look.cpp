// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers/layers_look.h"

#include "core/units.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"
#include "ui/text/names.h"

#include <algorithm>
#include <array>

namespace sparkout {

namespace {
constexpr float everyOther = 0.62F; ///< opacity
constexpr int uncutAlpha = 46, bandAlpha = 28;
} // namespace

QColor LayersLook::stage(int stage, const QPalette& palette) {
    const auto index = static_cast<std::size_t>(stage > 0 ? stage - 1 : 0);
    return tone(style::oneOfSeries(index), palette);
}

QColor LayersLook::layer(const LayerSeries& series, std::size_t span, const QPalette& palette) {
    QColor colour = stage(series.spans[span].stage, palette);
    if (span % 2 == 1) {
        colour.setAlphaF(everyOther);
    }
    return colour;
}

std::vector<Band> LayersLook::zoneBands(const LayerSeries& series, const QPalette& palette) {
    std::vector<Band> bands;
    for (const LayerColumn& column : series.columns) {
        bands.push_back(zoneBand(column.zone, column.section, column.stretch.from_mm,
                                 column.stretch.to_mm, palette, bandAlpha));
    }
    std::ranges::sort(bands, {}, &Band::from);
    return bands;
}

QColor LayersLook::uncut(const QPalette& palette) {
    return style::thinned(palette.color(QPalette::Text), uncutAlpha);
}

LegendEntries LayersLook::stages(const LayerSeries& series, const CurveChoice& choice,
                                 const QPalette& palette) {
    LegendEntries entries;
    int last = 0;
    for (const LayerSpan& span : series.spans) {
        if (span.stage != last) {
            last = span.stage;
            entries.push_back({stage(last, palette), Qt::NoPen, tr("stage %1").arg(last), last,
                               choice.shows(last)});
        }
    }
    return entries;
}

QString LayersLook::spanName(const LayerSeries& series, std::size_t span) {
    const LayerSpan& of = series.spans[span];
    const bool strokes = series.operation->travels;
    if (of.first == of.last) {
        return (strokes ? tr("Double stroke %1, stage %2") : tr("Revolution %1, stage %2"))
            .arg(of.first)
            .arg(of.stage);
    }
    return (strokes ? tr("Double strokes %1…%2, stage %3") : tr("Revolutions %1…%2, stage %3"))
        .arg(of.first)
        .arg(of.last)
        .arg(of.stage);
}

QString LayersLook::values(const LayerSeries& series, const LayersDone& done, std::size_t column,
                           std::size_t span) {
    const LayerColumn& of = series.columns[column];
    const double before = sumDone_mm(series, done, column, span);
    const double after = sumDone_mm(series, done, column, span + 1);
    const auto um = [](double value_mm) { return Names::micrometres(value_mm * units::umPerMm); };
    const QString radius = Names::signedMicrometres(
        (of.blank_mm - series.removalSign * after - series.target_mm) * units::umPerMm);
    return tr("%1, %2: takes off %3 µm, %4 µm so far, radius %5 µm from target")
        .arg(spanName(series, span), Names::within(Names::zone(of.zone, of.section)),
             um(after - before), um(after), radius);
}

} // namespace sparkout
