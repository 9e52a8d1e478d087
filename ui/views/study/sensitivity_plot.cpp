// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/sensitivity_plot.h"

#include "ui/chart/quantity_colour.h"
#include "ui/text/names.h"
#include "ui/views/study/batch_text.h"

#include <utility>

namespace sparkout {

SensitivityPlot::SensitivityPlot(QWidget* parent) : BarPlot(parent) {}

void SensitivityPlot::setBatch(BatchOutcomePtr outcome, const std::string& name) {
    m_outcome = std::move(outcome);
    m_indices.reset();
    m_name = name;
    fill();
}

void SensitivityPlot::setIndices(SobolIndicesPtr indices) {
    m_indices = std::move(indices);
    fill();
}

void SensitivityPlot::setKind(SensitivityKind kind) {
    m_kind = kind;
    fill();
}

void SensitivityPlot::fill() {
    m_bars.clear();
    for (const std::size_t i : m_outcome ? placesOf(m_outcome->summary, m_name, mostPlaces)
                                         : std::vector<std::size_t>()) {
        Bars bars{i, {}, {}};
        if (m_kind == SensitivityKind::ranks) {
            const auto& regression = m_outcome->regressions[i];
            if (regression && m_outcome->summary.isSample) {
                bars.inner = bars.outer = regression->coefficients;
                bars.determination = regression->determination;
            }
        } else if (m_indices) {
            for (const SobolIndex& index : m_indices->byCharacteristic[i]) {
                bars.inner.push_back(index.first);
                bars.outer.push_back(index.total);
            }
        }
        if (!bars.inner.empty()) {
            m_bars.push_back(std::move(bars));
        }
    }
    setChart(makeChart());
}

std::size_t SensitivityPlot::seriesOfPlace() const {
    return m_kind == SensitivityKind::ranks ? 1 : 2;
}

/// Makes one bar per place for ranks, two for Sobol indices: first-order, and hatched total ones.
BarChart SensitivityPlot::makeChart() const {
    BarChart chart;
    if (m_bars.empty()) {
        return chart;
    }
    const bool ranks = m_kind == SensitivityKind::ranks;
    chart.shape = BarChart::Shape::grouped;
    chart.isLying = true;
    chart.what = tr("Factor");
    chart.axis =
        ranks ? tr("Coefficient of the standardised rank regression") : tr("Share of the variance");
    chart.number = [](double value) { return Names::fixed(value, 2); };
    for (const auto& factor : m_outcome->factors) {
        chart.categories << BatchText::factor(factor);
    }
    for (std::size_t i = 0; i < m_bars.size(); ++i) {
        const Bars& bars = m_bars[i];
        const BarColour colour = barColour(style::oneOfSeries(i));
        if (ranks) {
            chart.series.push_back({tr("%1, R² %2", "RZ1, R² 0.97")
                                        .arg(placeName(bars), Names::fixed(bars.determination, 2)),
                                    colour, hatchAt(i), bars.inner});
        } else {
            chart.series.push_back(
                {tr("%1 alone", "zone").arg(placeName(bars)), colour, Hatch::none, bars.inner});
            chart.series.push_back({tr("%1 with interactions", "zone").arg(placeName(bars)), colour,
                                    Hatch::rising, bars.outer});
        }
    }
    return chart;
}

double SensitivityPlot::weight(std::size_t place, std::size_t factor) const {
    return m_bars[place].outer[factor];
}

// --- displayed influences -----------------------------------------------------------------------

QString SensitivityPlot::placeName(const Bars& bars) const {
    return BatchText::where(m_outcome->summary.characteristics[bars.characteristic].characteristic);
}

CsvTable SensitivityPlot::ranksTable(const BatchOutcome& outcome) {
    CsvTable table;
    table.header << tr("Where") << tr("Characteristic") << tr("Factor")
                 << tr("Standardised rank regression") << tr("R²");
    for (std::size_t i = 0; i < outcome.regressions.size(); ++i) {
        const Characteristic& of = outcome.summary.characteristics[i].characteristic;
        for (std::size_t f = 0; outcome.regressions[i] && f < outcome.factors.size(); ++f) {
            table.rows.push_back(
                {BatchText::where(of), BatchText::name(of), BatchText::factor(outcome.factors[f]),
                 outcome.regressions[i]->coefficients[f], outcome.regressions[i]->determination});
        }
    }
    return table;
}

CsvTable SensitivityPlot::sobolTable(const BatchOutcome& outcome, const SobolIndices& indices) {
    CsvTable table;
    table.header << tr("Where") << tr("Characteristic") << tr("Factor")
                 << tr("Sobol index, first order") << tr("Sobol index, total");
    for (std::size_t i = 0; i < indices.byCharacteristic.size(); ++i) {
        const Characteristic& of = outcome.summary.characteristics[i].characteristic;
        const std::vector<SobolIndex>& byFactor = indices.byCharacteristic[i];
        for (std::size_t f = 0; f < byFactor.size(); ++f) {
            table.rows.push_back({BatchText::where(of), BatchText::name(of),
                                  BatchText::factor(outcome.factors[f]), byFactor[f].first,
                                  byFactor[f].total});
        }
    }
    return table;
}

CsvTable SensitivityPlot::table() const {
    const bool ranks = m_kind == SensitivityKind::ranks;
    CsvTable table;
    table.header << tr("Where") << tr("Factor");
    table.header << (ranks ? QStringList{tr("Standardised rank regression"), tr("R²")}
                           : QStringList{tr("Sobol index, first order"), tr("Sobol index, total")});
    for (std::size_t i = 0; i < m_bars.size(); ++i) {
        const Bars& bars = m_bars[i];
        for (std::size_t f = 0; f < bars.inner.size() && shows(i * seriesOfPlace()); ++f) {
            table.rows.push_back({placeName(bars), BatchText::factor(m_outcome->factors[f]),
                                  bars.inner[f], ranks ? bars.determination : bars.outer[f]});
        }
    }
    return table;
}

QString SensitivityPlot::described(const BarPart& part) const {
    const Bars& bars = m_bars.at(part.series / seriesOfPlace());
    const auto number = [](double value) { return Names::fixed(value, 2); };
    const QString who = QStringLiteral("%1, %2").arg(
        placeName(bars), BatchText::factor(m_outcome->factors[part.category]));
    return m_kind == SensitivityKind::ranks
               ? tr("%1: %2 of the standardised rank regression")
                     .arg(who, number(bars.inner[part.category]))
               : tr("%1: %2 of the variance alone, %3 with its interactions")
                     .arg(who, number(bars.inner[part.category]),
                          number(bars.outer[part.category]));
}

/// Redraws everything, since the chart contains texts.
void SensitivityPlot::setTexts() {
    BarPlot::setTexts();
    setChart(makeChart());
}

} // namespace sparkout
