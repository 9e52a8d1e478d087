// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/force_law_choice.h"

#include "core/measured/fit_data.h"
#include "core/process/force.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

constexpr double decides = 6; ///< difference of Akaike's criteria
constexpr double sourcesParameters = 4, thresholdParameters = 3;
constexpr int mostMore = 500;           ///< revolutions
constexpr double leastMean_mm2 = 1e-18; ///< of squares, if there is no noise

/// A straight line fitted to a curve: offset and scale.
struct Line {
    double scale = 0, offset = 0;
    double squares = std::numeric_limits<double>::infinity();
};

/// The readings, and interpolation of curves given at whole revolutions.
class Readings {
public:
    explicit Readings(const SparkOutRecord& record) : m_values(record.size_mm) {
        for (const double time_s : record.time_s) {
            m_places.push_back(time_s / record.revolution_s);
        }
        m_at.resize(m_places.size());
    }
    [[nodiscard]] std::size_t count() const { return m_values.size(); }
    [[nodiscard]] std::size_t revolutions() const {
        return static_cast<std::size_t>(std::ceil(m_places.back()));
    }

    /// Least squares of offset + scale·curve, with a bounded scale.
    [[nodiscard]] Line fitted(const std::vector<double>& curve, double least = 0,
                              double most = std::numeric_limits<double>::infinity()) {
        const auto count = static_cast<double>(m_values.size());
        double sumX = 0, sumY = 0;
        for (std::size_t i = 0; i < m_values.size(); ++i) {
            m_at[i] = valueAt(curve, m_places[i]);
            sumX += m_at[i];
            sumY += m_values[i];
        }
        const double meanX = sumX / count, meanY = sumY / count;
        double xx = 0, xy = 0;
        for (std::size_t i = 0; i < m_values.size(); ++i) {
            xx += (m_at[i] - meanX) * (m_at[i] - meanX);
            xy += (m_at[i] - meanX) * (m_values[i] - meanY);
        }
        Line line;
        line.scale = std::clamp(xx > 0 ? xy / xx : 0, least, most);
        line.offset = meanY - line.scale * meanX;
        line.squares = 0;
        for (const double rest : residuals(line)) {
            line.squares += rest * rest;
        }
        return line;
    }
    /// For the last fitted curve.
    [[nodiscard]] std::vector<double> residuals(const Line& line) const {
        std::vector<double> rests;
        for (std::size_t i = 0; i < m_values.size(); ++i) {
            rests.push_back(m_values[i] - line.offset - line.scale * m_at[i]);
        }
        return rests;
    }

private:
    static double valueAt(const std::vector<double>& curve, double place) {
        const auto before = std::min(static_cast<std::size_t>(place), curve.size() - 2);
        const double share = place - static_cast<double>(before);
        return curve[before] + share * (curve[before + 1] - curve[before]);
    }

    std::vector<double> m_places, m_values, m_at;
};

/// A law with its best values: a curve over revolutions with two shapes, or one.
struct LawFit {
    Line line;
    double first = 0, second = 0; ///< logarithms of the shapes
    std::vector<double> curve;
};

/// y_m of y_{m−1} − y_m = u², (1 + α)·u² + u = y_{m−1}: D/β².
std::vector<double> sourcesCurve(double alpha, double start, std::size_t revolutions) {
    std::vector<double> curve{start};
    for (std::size_t m = 0; m < revolutions; ++m) {
        const double y = curve.back();
        const double u = 2 * y / (1 + std::sqrt(1 + 4 * (1 + alpha) * y));
        curve.push_back(y - u * u);
    }
    return curve;
}

/// r^m, by the time constant in revolutions.
std::vector<double> thresholdCurve(double constant, std::size_t revolutions) {
    std::vector<double> curve{1};
    const double r = std::exp(-1 / constant);
    for (std::size_t m = 0; m < revolutions; ++m) {
        curve.push_back(curve.back() * r);
    }
    return curve;
}

/// β over α [√mm] of wheels with usual dullness.
struct Ratios {
    double least = 0, most = 0;
};

Ratios ratiosOf(const Project& project) {
    Project sources = project;
    sources.material->force_law = ForceLawKind::sources;
    sources.wheel->force_recipe.reset();
    const Range& usual = tableOf<Wheel>().find("dullness")->soft;
    const auto ratio = [&](double dullness) {
        sources.wheel->dullness = dullness;
        const ForceLaw law = forceLaw(sources);
        return law.kr / law.ks;
    };
    return {ratio(usual.low), ratio(usual.high)};
}

/// The best of a grid of logarithms, refined by steps that are halved where none is better.
template <class Try>
std::pair<double, double> searched(std::pair<double, double> first,
                                   std::pair<double, double> second, int cells,
                                   const Try& squaresAt, const std::stop_token& stop) {
    const auto place = [cells](const std::pair<double, double>& ends, int i) {
        return ends.first + (ends.second - ends.first) * i / cells;
    };
    const int secondCells = second.first < second.second ? cells : 0;
    std::pair<double, double> best{first.first, second.first};
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= cells && !stop.stop_requested(); ++i) {
        for (int k = 0; k <= secondCells; ++k) {
            const std::pair at{place(first, i), secondCells > 0 ? place(second, k) : second.first};
            if (const double squares = squaresAt(at); squares < least) {
                least = squares;
                best = at;
            }
        }
    }
    double one = (first.second - first.first) / cells;
    double other = secondCells > 0 ? (second.second - second.first) / cells : 0;
    constexpr double finest = 1e-9;
    while (one > finest && !stop.stop_requested()) {
        bool moved = false;
        for (const auto& [dx, dy] :
             {std::pair(one, 0.0), std::pair(-one, 0.0), std::pair(0.0, other),
              std::pair(0.0, -other), std::pair(one, other), std::pair(-one, -other),
              std::pair(one, -other), std::pair(-one, other)}) {
            const std::pair at{std::clamp(best.first + dx, first.first, first.second),
                               std::clamp(best.second + dy, second.first, second.second)};
            if (const double squares = squaresAt(at); squares < least) {
                least = squares;
                best = at;
                moved = true;
            }
        }
        if (!moved) {
            one /= 2;
            other /= 2;
        }
    }
    return best;
}

LawFit fitSources(Readings& readings, const Ratios& ratios, const std::stop_token& stop) {
    constexpr int cells = 40;
    const std::size_t revolutions = readings.revolutions();
    const auto lineAt = [&](const std::pair<double, double>& at, const std::vector<double>& curve) {
        // the scale is 2·β², with β between two multiples of α
        const double alpha = std::exp(at.first);
        const double least = alpha * ratios.least, most = alpha * ratios.most;
        return readings.fitted(curve, 2 * least * least, 2 * most * most);
    };
    const auto curveAt = [&](const std::pair<double, double>& at) {
        return sourcesCurve(std::exp(at.first), std::exp(at.second), revolutions);
    };
    const auto best = searched(
        {std::log(1e-4), std::log(1e2)}, {std::log(1e-6), std::log(1e6)}, cells,
        [&](const std::pair<double, double>& at) { return lineAt(at, curveAt(at)).squares; }, stop);
    LawFit fit{{}, best.first, best.second, curveAt(best)};
    fit.line = lineAt(best, fit.curve);
    return fit;
}

LawFit fitThreshold(Readings& readings, const std::stop_token& stop) {
    constexpr int cells = 200;
    const std::size_t revolutions = readings.revolutions();
    const auto curveAt = [&](double constant) {
        return thresholdCurve(std::exp(constant), revolutions);
    };
    const auto best = searched(
        {std::log(0.05), std::log(1e4)}, {0, 0}, cells,
        [&](const std::pair<double, double>& at) {
            return readings.fitted(curveAt(at.first)).squares;
        },
        stop);
    LawFit fit{{}, best.first, 0, curveAt(best.first)};
    fit.line = readings.fitted(fit.curve);
    return fit;
}

/// The share of independent readings, by the correlation of neighbours.
double independentShare(const std::vector<double>& rests) {
    double squares = 0, products = 0;
    for (std::size_t i = 0; i < rests.size(); ++i) {
        squares += rests[i] * rests[i];
        products += i > 0 ? rests[i] * rests[i - 1] : 0;
    }
    constexpr double mostAlike = 0.99;
    const double alike = squares > 0 ? std::clamp(products / squares, 0.0, mostAlike) : 0;
    return (1 - alike) / (1 + alike);
}

class Chooser {
public:
    Chooser(const Project& project, const SparkOutRecord& record, const std::stop_token& stop)
        : m_record(record), m_ratios(ratiosOf(project)), m_stop(stop) {}

    ForceLawChoice choose() {
        Readings readings(m_record);
        m_sources = fitSources(readings, m_ratios, m_stop);
        const std::vector<double> left = readings.residuals(m_sources.line);
        m_threshold = fitThreshold(readings, m_stop);
        const auto count = static_cast<double>(readings.count());
        const bool ofSources = m_sources.line.squares < m_threshold.line.squares;
        m_share = independentShare(ofSources ? left : readings.residuals(m_threshold.line));
        const double mean_mm2 = std::max(
            std::min(m_sources.line.squares, m_threshold.line.squares) / count, leastMean_mm2);
        m_variance = mean_mm2;
        ForceLawChoice choice;
        choice.readings = readings.count();
        choice.revolutions =
            static_cast<int>(std::lround(m_record.time_s.back() / m_record.revolution_s));
        choice.timeConstant_s = std::exp(m_threshold.first) * m_record.revolution_s;
        choice.sourcesRms_um = std::sqrt(m_sources.line.squares / count) * units::umPerMm;
        choice.thresholdRms_um = std::sqrt(m_threshold.line.squares / count) * units::umPerMm;
        choice.aicDifference =
            count * m_share
                * std::log(std::max(m_sources.line.squares / count, mean_mm2)
                           / std::max(m_threshold.line.squares / count, mean_mm2))
            + 2 * (sourcesParameters - thresholdParameters);
        if (choice.aicDifference >= decides) {
            choice.supported = SupportedLaw::threshold;
        } else if (choice.aicDifference <= -decides) {
            choice.supported = SupportedLaw::sources;
        } else {
            choice.revolutionsMore = revolutionsMore(choice.revolutions);
        }
        return choice;
    }

private:
    /// The record of a law with these values over this many revolutions, without noise.
    [[nodiscard]] SparkOutRecord continued(bool sources, int revolutions) const {
        const LawFit& fit = sources ? m_sources : m_threshold;
        const auto all = static_cast<std::size_t>(revolutions);
        const std::vector<double> curve =
            sources ? sourcesCurve(std::exp(fit.first), std::exp(fit.second), all)
                    : thresholdCurve(std::exp(fit.first), all);
        SparkOutRecord record{m_record.revolution_s, {}, {}};
        for (std::size_t m = 0; m < curve.size(); ++m) { // at whole revolutions
            record.time_s.push_back(static_cast<double>(m) * m_record.revolution_s);
            record.size_mm.push_back(fit.line.offset + fit.line.scale * curve[m]);
        }
        return record;
    }

    /// The expected difference of the criteria if one of the laws is true: by the residuals of the
    /// other, with the current number of independent readings per revolution.
    [[nodiscard]] double expected(bool sources, int revolutions) const {
        const SparkOutRecord record = continued(sources, revolutions);
        Readings readings(record);
        const Line line = sources ? fitThreshold(readings, m_stop).line
                                  : fitSources(readings, m_ratios, m_stop).line;
        const double mean = line.squares / static_cast<double>(readings.count());
        const double perRevolution = static_cast<double>(m_record.time_s.size()) * m_share
                                     / (m_record.time_s.back() / m_record.revolution_s);
        const double more = 2 * (sourcesParameters - thresholdParameters) * (sources ? -1 : 1);
        return perRevolution * revolutions * std::log1p(mean / m_variance) + more;
    }

    [[nodiscard]] std::optional<int> revolutionsMore(int revolutions) const {
        const auto isEnough = [&](int more) {
            return expected(true, revolutions + more) >= decides
                   && expected(false, revolutions + more) >= decides;
        };
        int enough = 1;
        while (enough < mostMore && !m_stop.stop_requested() && !isEnough(enough)) {
            enough *= 2;
        }
        if (m_stop.stop_requested() || (enough >= mostMore && !isEnough(mostMore))) {
            return std::nullopt;
        }
        int low = enough / 2, high = std::min(enough, mostMore);
        while (high - low > 1 && !m_stop.stop_requested()) {
            const int middle = low + (high - low) / 2;
            (isEnough(middle) ? high : low) = middle;
        }
        return high;
    }

    const SparkOutRecord& m_record;
    Ratios m_ratios;
    const std::stop_token& m_stop;
    LawFit m_sources, m_threshold;
    double m_share = 1, m_variance = 0;
};

} // namespace

std::optional<ForceLawChoice> chooseForceLaw(const Project& project, const SparkOutRecord& record,
                                             const std::stop_token& stop) {
    constexpr std::size_t fewest = 8;
    constexpr double fewestRevolutions = 4;
    const std::vector<double>& sizes = record.size_mm;
    if (sizes.size() < fewest || sizes.size() != record.time_s.size() || !(record.revolution_s > 0)
        || record.time_s.front() < 0
        || !(record.time_s.back() >= fewestRevolutions * record.revolution_s)
        || std::ranges::max(sizes) == std::ranges::min(sizes)) {
        return std::nullopt;
    }
    const ForceLawChoice choice = Chooser(project, record, stop).choose();
    return stop.stop_requested() ? std::nullopt : std::optional(choice);
}

std::optional<SparkOutRecord> sparkOutOf(const Project& project,
                                         const std::vector<int>& stepsByStage, double begin_s) {
    const std::vector<Stage>& stages = project.cycle->stages;
    if (project.operation->travels || stages.empty() || stages.back().feeds()
        || stepsByStage.size() != stages.size()) {
        return std::nullopt;
    }
    SparkOutRecord record{units::secondsPerMinute / project.machine->work_speed_rpm, {}, {}};
    int before = 0;
    for (std::size_t z = 0; z + 1 < stages.size(); ++z) {
        before += stepsByStage[z];
    }
    const double from_s = begin_s + before * record.revolution_s;
    const double end_s = from_s + stepsByStage.back() * record.revolution_s;
    const double sign = project.part->surface == Surface::external ? 1 : -1;
    for (const FitGroup& group : fitDataOf(project, {}, false).groups) {
        if (group.source != FitSource::size || group.place) {
            continue;
        }
        for (std::size_t i = 0; i < group.values.size(); ++i) {
            if (group.time_s[i] >= from_s && group.time_s[i] <= end_s) {
                record.time_s.push_back(group.time_s[i] - from_s);
                record.size_mm.push_back(sign * group.values[i]);
            }
        }
        break;
    }
    return record.time_s.empty() ? std::nullopt : std::optional(std::move(record));
}

} // namespace sparkout
