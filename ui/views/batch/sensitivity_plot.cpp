// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/batch/sensitivity_plot.h"

#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"
#include "ui/text/names.h"
#include "ui/views/batch/batch_text.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

constexpr double groupShare = 0.8; ///< of a factor's row that its bars take
constexpr int outerAlpha = 90;

} // namespace

SensitivityPlot::SensitivityPlot(QWidget* parent) : ViewPlot(parent) {
    setNotAntialiasedElements(QCP::aeAll);
    m_rect = addRect();
    QCPAxis& factors = *m_rect->axis(QCPAxis::atLeft);
    factors.setRangeReversed(true); // the first factor on top
    factors.grid()->setVisible(false);
    factors.setTickLength(0);
    built();
}

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
    clearPlottables();
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
    for (std::size_t place = 0; place < m_bars.size(); ++place) {
        draw(m_bars[place], place);
    }
    nameFactors();
    contentSet();
}

double SensitivityPlot::barWidth() const {
    return groupShare / static_cast<double>(std::max<std::size_t>(m_bars.size(), 1));
}

double SensitivityPlot::barAt(std::size_t place, std::size_t factor) const {
    const double beside = static_cast<double>(place) - static_cast<double>(m_bars.size() - 1) / 2;
    return static_cast<double>(factor) + beside * barWidth();
}

void SensitivityPlot::draw(Bars& bars, std::size_t place) {
    const auto add = [&](const std::vector<double>& weights, double share) {
        auto* added = new QCPBars(m_rect->axis(QCPAxis::atLeft), m_rect->axis(QCPAxis::atBottom));
        added->setWidth(share * barWidth());
        QVector<double> keys, values;
        for (std::size_t f = 0; f < weights.size(); ++f) {
            keys << barAt(place, f);
            values << weights[f];
        }
        added->setData(keys, values, true);
        return added;
    };
    if (m_kind == SensitivityKind::sobol) {
        bars.outerBars = add(bars.outer, 0.9);
    }
    bars.innerBars = add(bars.inner, m_kind == SensitivityKind::sobol ? 0.5 : 0.9);
    setKeyed(static_cast<int>(place), {bars.outerBars, bars.innerBars});
}

void SensitivityPlot::nameFactors() {
    QSharedPointer<QCPAxisTickerText> names(new QCPAxisTickerText);
    for (std::size_t f = 0; m_outcome && f < m_outcome->factors.size(); ++f) {
        names->addTick(static_cast<double>(f), BatchText::factor(m_outcome->factors[f].kind));
    }
    m_rect->axis(QCPAxis::atLeft)->setTicker(names);
}

void SensitivityPlot::fit() {
    const auto factors = m_outcome ? static_cast<double>(m_outcome->factors.size()) : 1;
    double low = 0, high = 1;
    for (const Bars& bars : m_bars) {
        for (const std::vector<double>* weights : {&bars.inner, &bars.outer}) {
            for (const double weight : *weights) {
                low = std::min(low, weight);
                high = std::max(high, weight);
            }
        }
    }
    if (m_kind == SensitivityKind::ranks) {
        low = std::min(low, -1.0);
    }
    const double beside = 0.03 * (high - low);
    style::setSafeRange(*m_rect->axis(QCPAxis::atBottom), low < 0 ? low - beside : 0,
                        high + beside);
    style::setSafeRange(*m_rect->axis(QCPAxis::atLeft), -0.5, factors - 0.5);
}

double SensitivityPlot::weight(std::size_t place, std::size_t factor) const {
    return m_bars[place].outer[factor];
}

// --- what is shown ------------------------------------------------------------------------------

QString SensitivityPlot::placeName(const Bars& bars) const {
    return BatchText::where(m_outcome->summary.characteristics[bars.characteristic].characteristic);
}

LegendEntries SensitivityPlot::legendEntries() const {
    LegendEntries entries;
    for (std::size_t i = 0; i < m_bars.size(); ++i) {
        const Bars& bars = m_bars[i];
        const QString name =
            m_kind == SensitivityKind::ranks
                ? tr("%1, R² %2", "RZ1, R² 0.97")
                      .arg(placeName(bars), locale().toString(bars.determination, 'f', 2))
                : placeName(bars);
        entries.push_back(areaEntry(static_cast<int>(i), bars.innerBars->brush().color(), name));
    }
    return entries;
}

CsvTable SensitivityPlot::ranksTable(const BatchOutcome& outcome) {
    CsvTable table;
    table.header << tr("Where") << tr("Characteristic") << tr("Factor")
                 << tr("Standardised rank regression") << tr("R²");
    for (std::size_t i = 0; i < outcome.regressions.size(); ++i) {
        const Characteristic& of = outcome.summary.characteristics[i].characteristic;
        for (std::size_t f = 0; outcome.regressions[i] && f < outcome.factors.size(); ++f) {
            table.rows.push_back({BatchText::where(of), BatchText::name(of),
                                  BatchText::factor(outcome.factors[f].kind),
                                  outcome.regressions[i]->coefficients[f],
                                  outcome.regressions[i]->determination});
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
                                  BatchText::factor(outcome.factors[f].kind), byFactor[f].first,
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
        for (std::size_t f = 0; f < bars.inner.size() && shows(static_cast<int>(i)); ++f) {
            table.rows.push_back({placeName(bars), BatchText::factor(m_outcome->factors[f].kind),
                                  bars.inner[f], ranks ? bars.determination : bars.outer[f]});
        }
    }
    return table;
}

QString SensitivityPlot::valuesAt(const QPointF& at) const {
    if (!m_rect->rect().contains(at.toPoint())) {
        return {};
    }
    const double y = m_rect->axis(QCPAxis::atLeft)->pixelToCoord(at.y());
    for (std::size_t i = 0; i < m_bars.size(); ++i) {
        for (std::size_t f = 0; f < m_bars[i].inner.size(); ++f) {
            if (std::abs(y - barAt(i, f)) > barWidth() / 2 || !shows(static_cast<int>(i))) {
                continue;
            }
            const Bars& bars = m_bars[i];
            const auto number = [](double v) { return Names::fixed(v, 2); };
            const QString who = QStringLiteral("%1, %2").arg(
                placeName(bars), BatchText::factor(m_outcome->factors[f].kind));
            return m_kind == SensitivityKind::ranks
                       ? tr("%1: %2 of the standardised rank regression")
                             .arg(who, number(bars.inner[f]))
                       : tr("%1: %2 of the variance alone, %3 with its interactions")
                             .arg(who, number(bars.inner[f]), number(bars.outer[f]));
        }
    }
    return {};
}

// --- look and words -----------------------------------------------------------------------------

void SensitivityPlot::restyle() {
    ViewPlot::restyle();
    for (std::size_t i = 0; i < m_bars.size(); ++i) {
        QColor colour = toned(style::oneOfSeries(i));
        m_bars[i].innerBars->setPen(Qt::NoPen);
        m_bars[i].innerBars->setBrush(colour);
        if (m_bars[i].outerBars) {
            m_bars[i].outerBars->setPen(QPen(colour, 1));
            colour.setAlpha(outerAlpha);
            m_bars[i].outerBars->setBrush(colour);
        }
    }
}

void SensitivityPlot::setTexts() {
    m_rect->axis(QCPAxis::atBottom)
        ->setLabel(m_kind == SensitivityKind::ranks
                       ? tr("Coefficient of the standardised rank regression")
                       : tr("Share of the variance: full alone, pale with interactions"));
    nameFactors();
}

} // namespace sparkout
