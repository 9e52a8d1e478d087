// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/stock_layers.h"

#include "core/process/profile.h"
#include "core/project/part.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

/// The value at the series' radius, or the mean over the radii outside gaps.
template <typename ValueOf>
double overRadii(const LayerSeries& series, int radii, ValueOf valueOf) {
    if (series.radius) {
        return valueOf(static_cast<std::size_t>(*series.radius));
    }
    double sum = 0;
    int ground = 0;
    for (int k = 0; k < radii; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const bool gap = i < series.gaps.size() && series.gaps[i];
        sum += gap ? 0 : valueOf(i);
        ground += gap ? 0 : 1;
    }
    return sum / ground;
}

class LayerBuilder {
public:
    LayerBuilder(const SimulationResult& result, const Trajectory& trajectory,
                 std::optional<int> radius)
        : m_result(result), m_trajectory(trajectory) {
        const Part& part = *result.project.part;
        m_series.operation = result.project.operation;
        m_series.removalSign = part.surface == Surface::external ? 1 : -1;
        m_series.length_mm = part.length_mm;
        m_series.target_mm = targetRadius(part);
        m_series.lowerLimit_mm =
            part.diameter_mm / 2 + part.lower_deviation_um / 2 / units::umPerMm;
        m_series.upperLimit_mm =
            part.diameter_mm / 2 + part.upper_deviation_um / 2 / units::umPerMm;
        m_series.radius = radius;
        m_series.gaps = inGaps(part);
    }

    LayerSeries build() {
        if (!m_trajectory.passes.empty()) {
            addColumns();
            readSums();
            mergeStrokes();
        }
        return std::move(m_series);
    }

private:
    template <typename ValueOf>
    [[nodiscard]] double overRadii(ValueOf valueOf) const {
        return sparkout::overRadii(m_series, m_trajectory.radii, valueOf);
    }

    void addColumns() {
        const Blank blank = makeBlank(*m_result.project.part);
        const std::vector<Stretch> stretches = groundStretches(m_result.project);
        for (std::size_t i = 0; i < m_result.sections.size(); ++i) {
            const SectionResult& section = m_result.sections[i];
            const double depth = overRadii( // there is nothing to grind in a gap
                [&](std::size_t k) {
                    return blank.isGap(k) ? blank.totalInfeed_mm : blank.depthAt(i)[k];
                });
            LayerColumn column;
            column.zone = section.zone;
            column.section = static_cast<int>(i);
            column.stretch = stretches[i];
            column.blank_mm = blank.firstTouchRadius_mm - m_series.removalSign * depth;
            column.final_mm = overRadii([&](std::size_t k) {
                return blank.isGap(k) ? column.blank_mm : section.radii_mm[k];
            });
            m_series.columns.push_back(std::move(column));
        }
    }

    /// Reads Σa after every double stroke or revolution; one without a pass repeats the previous
    /// value.
    void readSums() {
        for (const Pass& pass : m_trajectory.passes) {
            const auto number = static_cast<std::size_t>(std::max(pass.place.cycleCount, 1));
            m_stages.resize(std::max(m_stages.size(), number), pass.place.stage);
            std::vector<double>& sums = m_series.columns[sectionOf(pass.place)].sum_mm;
            sums.resize(std::max(sums.size(), number), sums.empty() ? 0 : sums.back());
            const double sum = overRadii([&](std::size_t k) {
                return m_trajectory.visits[pass.firstVisit + k].accumulated_mm;
            });
            sums.back() = std::isfinite(sum) ? sum : sums.back();
        }
        for (LayerColumn& column : m_series.columns) {
            column.sum_mm.resize(m_stages.size(), column.sum_mm.empty() ? 0 : column.sum_mm.back());
        }
    }

    void mergeStrokes() {
        const int count = static_cast<int>(m_stages.size());
        const int together = (count + mostLayers - 1) / mostLayers;
        for (int i = 0; i < count; ++i) {
            const int stage = m_stages[static_cast<std::size_t>(i)];
            std::vector<LayerSpan>& spans = m_series.spans;
            if (spans.empty() || spans.back().stage != stage
                || i + 1 - spans.back().first >= together) {
                spans.push_back({i + 1, i + 1, stage});
            }
            spans.back().last = i + 1;
        }
        for (LayerColumn& column : m_series.columns) {
            std::vector<double> merged;
            for (const LayerSpan& span : m_series.spans) {
                merged.push_back(column.sum_mm[static_cast<std::size_t>(span.last - 1)]);
            }
            column.sum_mm = std::move(merged);
        }
    }

    const SimulationResult& m_result;
    const Trajectory& m_trajectory;
    std::vector<int> m_stages; ///< stages of each double stroke or revolution
    LayerSeries m_series;
};

} // namespace

std::size_t LayerSeries::spansAt(int strokes) const {
    const auto after = std::ranges::upper_bound(spans, strokes, {}, &LayerSpan::first);
    return static_cast<std::size_t>(after - spans.begin());
}

double LayerSeries::largestSum_mm() const {
    double largest = 0;
    for (const LayerColumn& column : columns) {
        largest = std::max(largest, column.sum_mm.empty() ? 0 : column.sum_mm.back());
    }
    return largest;
}

LayerSeries makeLayerSeries(const SimulationResult& result, const Trajectory& trajectory,
                            std::optional<int> radius) {
    return LayerBuilder(result, trajectory, radius).build();
}

LayersDone allLayers(const LayerSeries& series) {
    LayersDone done{series.spans.size(), {}};
    for (const LayerColumn& column : series.columns) {
        done.sum_mm.push_back(series.sumAfter_mm(column, done.count));
    }
    return done;
}

double sumDone_mm(const LayerSeries& series, const LayersDone& done, std::size_t column,
                  std::size_t count) {
    return count < done.count ? series.sumAfter_mm(series.columns[column], count)
                              : done.sum_mm[column];
}

LayersDone layersDone(const LayerSeries& series, const Trajectory& trajectory,
                      const Progress& progress) {
    LayersDone done;
    if (!progress.isBlank()) {
        done.count = series.spansAt(trajectory.passes[progress.end - 1].place.cycleCount);
    }
    for (const std::vector<const Visit*>& last :
         lastVisits(trajectory, series.columns.size(), progress)) {
        const double sum = overRadii(series, trajectory.radii, [&](std::size_t k) {
            return last[k] ? last[k]->accumulated_mm : 0;
        });
        done.sum_mm.push_back(std::isfinite(sum) ? sum : 0);
    }
    return done;
}

} // namespace sparkout
