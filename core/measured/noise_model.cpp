// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/noise_model.h"

#include "core/measured/identifiability.h"
#include "core/statistics/intervals.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

constexpr double leastDrift_mm_min = 1e-5;
constexpr double leastDelay_s = 1e-4; ///< resolution of a recorder's clock
/// Less than the time constant of any gauge or filter. The model has one size a revolution, T
/// apart, and a straight line between; where the size approaches its end with a time constant t_c,
/// that line is as far off as a lag of T²/(8·t_c), some milliseconds, would put it.
constexpr double leastLag_s = 5e-3;

bool hasTimes(const FitGroup& group) {
    return !group.time_s.empty();
}

/// Whether the data have the delayed quantity, and another one as its reference.
bool isOfData(FittedKind kind, const FitData& data) {
    if (kind == FittedKind::time_shift) {
        return std::ranges::any_of(data.groups, hasTimes);
    }
    if (kind == FittedKind::gauge_lag || kind == FittedKind::gauge_drift) {
        return data.has(FitSource::size);
    }
    if (kind == FittedKind::power_lag || kind == FittedKind::force_lag) {
        return data.has(kind == FittedKind::power_lag ? FitSource::power : FitSource::force);
    }
    const FitSource source = kind == FittedKind::power_delay ? FitSource::power : FitSource::force;
    return data.has(source) && std::ranges::any_of(data.groups, [source](const FitGroup& group) {
               return hasTimes(group) && group.source != source;
           });
}

/// RMS of each group; `weights` of a robust loss lessen outliers.
std::vector<double> noiseByGroup(const FitData& data, const std::vector<double>& differences,
                                 const std::vector<double>& weights,
                                 const std::vector<double>& before) {
    constexpr double leastShare = 1e-9;
    std::vector<double> noise;
    std::size_t at = 0;
    for (std::size_t g = 0; g < data.groups.size(); ++g) {
        double squares = 0;
        const std::size_t count = data.groups[g].values.size();
        for (std::size_t i = 0; i < count; ++i, ++at) {
            const double left = differences[at] * (weights.empty() ? 1 : weights[at]);
            squares += left * left;
        }
        noise.push_back(
            std::max(std::sqrt(squares / static_cast<double>(count)), leastShare * before[g]));
    }
    return noise;
}

/// The greatest inflation of the groups recorded over time.
double inflationOf(const FitData& data, const std::vector<double>& differences) {
    double most = 1;
    std::span<const double> left(differences);
    for (const FitGroup& group : data.groups) {
        if (hasTimes(group)) {
            most = std::max(most, inflation(firstAutocorrelation(left.first(group.values.size()))));
        }
        left = left.subspan(group.values.size());
    }
    return most;
}

/// A fit with an additional time.
class WiderFit {
public:
    WiderFit(const Project& project, const FitData& data, const FitProblem& fitted, FittedKind kind,
             const std::stop_token& stop)
        : m_list(withTime(fitted.list(), kind))
        , m_data(data)
        , m_problem(project, data, m_list, stop) {
        m_problem.setSteps(fitted.steps());
        m_problem.setNoise(fitted.noise());
        m_problem.setWeights(fitted.weights());
    }

    /// Adds the result, unless the time is 0 as far as the data determine it.
    void find(const LeastSquares& best, const std::vector<double>& errors, LeftOut& leftOut) {
        std::vector<double> from = best.q, begin = best.q;
        from.push_back(0);
        const FittedKind kind = m_list.back().kind;
        const double begin_s = isLag(kind) ? startOfLag(m_list, kind) : 0;
        begin.push_back(FitProblem::coordinateOf(kind, begin_s));
        if (begin_s == 0 && !isWorthAFit(from)) {
            return;
        }
        const std::vector<bool> free(m_list.size(), false);
        LeastSquares wider = minimise(m_problem, begin, free);
        std::vector<double> differences;
        if (!m_problem.differences(wider.q, differences)) {
            return;
        }
        m_problem.setNoise(
            noiseByGroup(m_data, differences, m_problem.weights(), m_problem.noise()));
        wider = minimise(m_problem, wider.q, free);
        if (!wider.converged || m_problem.isStopped()
            || !m_problem.differences(wider.q, differences)) {
            return;
        }
        const Identifiability told = identifiabilityAt(m_problem, m_data, wider);
        if (!told.unidentified.empty() || told.covariance.empty()) {
            return;
        }
        OutOfStep found;
        found.kind = m_list.back().kind;
        found.amount = FitProblem::valueOf(found.kind, wider.q.back());
        const double wide = std::sqrt(inflationOf(m_data, differences));
        // A filter beside a fitted delay acts by its square: its error alone says too little.
        const double gain = (criterionAt(from) - wider.criterion) / (wide * wide);
        found.error = FitProblem::valueOf(found.kind, std::sqrt(told.covariance.back())) * wide;
        if (!isCertain(found) || gain < certainDelay * certainDelay) {
            if (std::abs(found.amount) > possibleDelay * found.error
                && gain > possibleDelay * possibleDelay) {
                LeftOut::Possible& one = leftOut.possible.emplace_back();
                for (std::size_t i = 0; i < best.q.size(); ++i) {
                    one.q.push_back(wider.q[i]);
                    one.errors.push_back(std::sqrt(told.covariance[i * wider.q.size() + i]) * wide);
                }
            }
            return;
        }
        double most = 0;
        for (std::size_t i = 0; i < best.q.size(); ++i) {
            const double moved = std::abs(wider.q[i] - best.q[i]) / errors[i];
            if (moved > most) {
                most = moved;
                found.parameter = i;
            }
        }
        found.value = FitProblem::valueOf(m_list[found.parameter].kind, wider.q[found.parameter]);
        leftOut.certain.push_back(found);
    }

    /// Adds fits with the time held at an amount, if they fit about as well as the best.
    void findHeld(const LeastSquares& best, const std::vector<double>& errors, double amount,
                  LeftOut& leftOut) {
        std::vector<double> from = best.q, differences;
        from.push_back(0);
        const double least = criterionAt(from);
        if (!std::isfinite(least)) {
            return;
        }
        from.back() = FitProblem::coordinateOf(m_list.back().kind, amount);
        std::vector<bool> fixed(m_list.size(), false);
        fixed.back() = true;
        LeastSquares held = minimise(m_problem, from, fixed);
        if (!held.converged || !m_problem.differences(held.q, differences)) {
            return;
        }
        const auto freedom = static_cast<double>(m_problem.values() - best.q.size());
        const double most =
            least * (1 + flatRise * inflationOf(m_data, differences) / std::max(freedom, 1.0));
        if (held.criterion <= most) {
            held.q.pop_back();
            leftOut.possible.push_back({std::move(held.q), errors});
        }
    }

private:
    [[nodiscard]] double criterionAt(const std::vector<double>& q) {
        std::vector<double> residuals;
        return m_problem.evaluate(q, residuals)
                   ? std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0)
                   : std::numeric_limits<double>::infinity();
    }

    /// Whether the residuals of the fit support the time by enough standard errors, to first order:
    /// for J = Q·R the last element of Qᵀr, since the last column of R is orthogonal to the other
    /// ones.
    bool isWorthAFit(const std::vector<double>& q) {
        std::vector<std::size_t> all(q.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        std::vector<double> columns, residuals;
        if (!derivatives(m_problem, q, all, columns) || !m_problem.evaluate(q, residuals)) {
            return false;
        }
        const auto rows = static_cast<Eigen::Index>(residuals.size());
        const auto count = static_cast<Eigen::Index>(q.size());
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(
            Eigen::Map<const Eigen::MatrixXd>(columns.data(), rows, count));
        Eigen::VectorXd turned = Eigen::Map<const Eigen::VectorXd>(residuals.data(), rows);
        turned.applyOnTheLeft(qr.householderQ().adjoint());
        return std::abs(turned[count - 1]) > possibleDelay;
    }

    static std::vector<FittedParameter> withTime(std::vector<FittedParameter> list,
                                                 FittedKind kind) {
        list.push_back({kind, {}, {}});
        return list;
    }

    std::vector<FittedParameter> m_list;
    const FitData& m_data;
    FitProblem m_problem;
};

} // namespace

double firstAutocorrelation(std::span<const double> residuals) {
    double squares = 0, products = 0;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        squares += residuals[i] * residuals[i];
        products += i > 0 ? residuals[i] * residuals[i - 1] : 0;
    }
    return squares > 0 ? products / squares : 0;
}

double inflation(double autocorrelation) {
    const double rho = std::clamp(autocorrelation, 0.0, 0.99);
    return (1 + rho) / (1 - rho);
}

bool isCertain(const OutOfStep& found) {
    const double least = found.kind == FittedKind::gauge_drift ? leastDrift_mm_min
                         : isLag(found.kind)                   ? leastLag_s
                                                               : leastDelay_s;
    const double amount = isLag(found.kind) ? found.amount : std::abs(found.amount);
    return amount >= std::max(least, certainDelay * found.error);
}

std::vector<OutOfStep> clearest(std::vector<OutOfStep> found) {
    const auto keepOne = [&](FittedKind delay, FittedKind filter) {
        const auto a = std::ranges::find(found, delay, &OutOfStep::kind);
        const auto b = std::ranges::find(found, filter, &OutOfStep::kind);
        if (a != found.end() && b != found.end()) {
            found.erase(std::abs(a->amount) * b->error < std::abs(b->amount) * a->error ? a : b);
        }
    };
    keepOne(FittedKind::power_delay, FittedKind::power_lag);
    keepOne(FittedKind::force_delay, FittedKind::force_lag);
    return found;
}

std::vector<FittedKind> timesLeftOut(const FitData& data,
                                     const std::vector<FittedParameter>& fitted) {
    std::vector<FittedKind> left;
    for (const FittedKind kind :
         {FittedKind::time_shift, FittedKind::power_delay, FittedKind::force_delay,
          FittedKind::gauge_lag, FittedKind::power_lag, FittedKind::force_lag,
          FittedKind::gauge_drift}) {
        if (std::ranges::find(fitted, kind, &FittedParameter::kind) == fitted.end()
            && isOfData(kind, data)) {
            left.push_back(kind);
        }
    }
    return left;
}

LeftOut outOfStep(const Project& project, const FitData& data, const FitProblem& fitted,
                  const LeastSquares& best, const std::vector<double>& errors,
                  const std::stop_token& stop) {
    LeftOut found;
    for (const FittedKind kind : timesLeftOut(data, fitted.list())) {
        if (stop.stop_requested()) {
            break;
        }
        WiderFit wider(project, data, fitted, kind, stop);
        wider.find(best, errors, found);
        if (kind == FittedKind::gauge_lag) {
            for (const double lag_s : {usualLag_s, 2 * usualLag_s}) {
                WiderFit(project, data, fitted, kind, stop).findHeld(best, errors, lag_s, found);
            }
        }
    }
    found.certain = clearest(std::move(found.certain));
    return found;
}

namespace {

/// ½·mean (r_{t+k} − r_t)², k from 1.
std::vector<double> variogramOf(std::span<const double> residuals, std::size_t most) {
    std::vector<double> found;
    for (std::size_t k = 1; k <= most; ++k) {
        double sum = 0;
        for (std::size_t i = k; i < residuals.size(); ++i) {
            const double difference = residuals[i] - residuals[i - k];
            sum += difference * difference;
        }
        found.push_back(sum / (2 * static_cast<double>(residuals.size() - k)));
    }
    return found;
}

/// The least squares of w and s ≥ 0 for a given φ; returns their sum of squares.
double fitFor(double phi, const std::vector<double>& variogram, TraceNoise& noise) {
    double n = 0, x = 0, xx = 0, y = 0, xy = 0, power = 1;
    for (const double value : variogram) {
        power *= phi;
        const double rise = 1 - power;
        n += 1;
        x += rise;
        xx += rise * rise;
        y += value;
        xy += rise * value;
    }
    const double det = n * xx - x * x;
    double s = det > 0 ? (n * xy - x * y) / det : 0;
    double w = (y - s * x) / n;
    if (w < 0) {
        w = 0;
        s = xy / xx;
    }
    if (!(s > 0)) {
        s = 0;
        w = y / n;
    }
    noise = {w, s, phi};
    double left = 0;
    power = 1;
    for (const double value : variogram) {
        power *= phi;
        const double off = value - w - s * (1 - power);
        left += off * off;
    }
    return left;
}

using Values = std::vector<double>;

/// The reduction of the residuals' squares by removing their part along the centred regressor.
double takenBy(Values regressor, std::span<const double> residuals) {
    const double mean = std::reduce(regressor.begin(), regressor.end())
                        / static_cast<double>(std::max<std::size_t>(regressor.size(), 1));
    double product = 0, square = 0;
    for (std::size_t i = 0; i < regressor.size(); ++i) {
        const double x = regressor[i] - mean;
        product += x * residuals[i];
        square += x * x;
    }
    return square > 0 ? product * product / square : 0;
}

Values slopeOf(std::span<const double> time_s, const Values& values) {
    Values slope(values.size(), 0);
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        const double over_s = time_s[i + 1] - time_s[i - 1];
        slope[i] = over_s > 0 ? (values[i + 1] - values[i - 1]) / over_s : 0;
    }
    return slope;
}

} // namespace

double TraceNoise::varianceOfMean(std::size_t count) const {
    const auto n = static_cast<double>(count);
    const double correlated = (1 + phi) / (1 - phi) / n
                              - 2 * phi * (1 - std::pow(phi, n)) / ((1 - phi) * (1 - phi) * n * n);
    return white / n + following * correlated + held;
}

TraceNoise traceNoiseOf(std::span<const double> residuals, double step) {
    constexpr std::size_t mostLags = 12;
    constexpr double twelve = 12, share = 25;
    const std::size_t count = residuals.size();
    const std::vector<double> variogram =
        variogramOf(residuals, std::clamp<std::size_t>(count / 4, 1, mostLags));
    const double most = std::exp(-share / static_cast<double>(count));
    TraceNoise best;
    double least = fitFor(0, variogram, best);
    constexpr int tried = 40;
    for (int k = 1; k <= tried; ++k) {
        TraceNoise noise;
        const double left = fitFor(most * k / tried, variogram, noise);
        if (left < least) {
            least = left;
            best = noise;
        }
    }
    if (step > 0) {
        const double rounding = step * step / twelve;
        const double rounded = std::max(0.0, best.variance() - rounding);
        best.held =
            rounding * std::exp(-4 * std::numbers::pi * std::numbers::pi * rounded / (step * step));
        best.white += std::max(0.0, rounding - best.variance());
    }
    return best;
}

LackOfFit lackOfFit(std::span<const double> residuals, const TraceNoise& noise,
                    double parametersOfGroup) {
    constexpr std::size_t longest = 24, fewest = 8;
    constexpr double confidence = 0.99, ofNoise = 30;
    LackOfFit found;
    const std::size_t blocks = std::clamp<std::size_t>(residuals.size() / 10, fewest, longest);
    if (residuals.size() < 2 * blocks || !(noise.variance() > 0)) {
        return {.ratio = 1, .freedom = 1, .most = std::numeric_limits<double>::infinity()};
    }
    double sum = 0;
    for (std::size_t b = 0; b < blocks; ++b) {
        const std::size_t from = residuals.size() * b / blocks;
        const std::size_t to = residuals.size() * (b + 1) / blocks;
        const auto part = residuals.subspan(from, to - from);
        const double mean =
            std::reduce(part.begin(), part.end()) / static_cast<double>(part.size());
        sum += mean * mean / noise.varianceOfMean(part.size());
    }
    found.freedom = std::max(1.0, static_cast<double>(blocks) - parametersOfGroup);
    found.ratio = sum / found.freedom;
    found.most = fisherQuantile(confidence, found.freedom, ofNoise);
    return found;
}

void addFollowing(const Derivatives& derivatives, std::size_t first, std::size_t end,
                  const std::vector<std::size_t>& stages, const TraceNoise& noise,
                  std::vector<double>& sum) {
    constexpr double hardly = 0.01;
    const std::size_t parameters = derivatives.parameters();
    for (std::size_t lag = 0; first + lag < end; ++lag) {
        const double rho =
            lag == 0 ? 1 : noise.share() * std::pow(noise.phi, static_cast<double>(lag));
        if (rho < hardly) {
            break;
        }
        for (std::size_t i = 0; i < parameters; ++i) {
            for (std::size_t k = 0; k < parameters; ++k) {
                double products = 0;
                for (std::size_t row = first + lag; row < end; ++row) {
                    products +=
                        derivatives.at(i, row) * derivatives.at(k, row - lag)
                        + (lag > 0 ? derivatives.at(i, row - lag) * derivatives.at(k, row) : 0);
                }
                sum[i * parameters + k] += rho * products;
            }
        }
    }
    if (!(noise.held > 0)) {
        return;
    }
    std::vector<std::size_t> ends = stages;
    ends.push_back(end);
    std::size_t from = first;
    for (const std::size_t to : ends) {
        std::vector<double> sums(parameters, 0);
        for (std::size_t i = 0; i < parameters; ++i) {
            for (std::size_t row = from; row < std::min(to, end); ++row) {
                sums[i] += derivatives.at(i, row);
            }
        }
        for (std::size_t i = 0; i < parameters; ++i) {
            for (std::size_t k = 0; k < parameters; ++k) {
                sum[i * parameters + k] += noise.held / noise.variance() * sums[i] * sums[k];
            }
        }
        from = std::max(from, to);
    }
}

std::vector<std::size_t> overRange(std::span<const double> values,
                                   std::span<const double> residuals) {
    constexpr std::size_t fewest = 20, ofSoMany = 50, mostInARow = 2;
    std::vector<std::size_t> found;
    if (values.size() < fewest) {
        return found;
    }
    const std::size_t lone = std::max<std::size_t>(values.size() / ofSoMany, 1);
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    const double low = sorted[lone], high = sorted[sorted.size() - 1 - lone], range = high - low;
    const auto isOver = [&](std::size_t i) {
        return range > 0 && std::abs(residuals[i]) > range
               && (values[i] > high + range || values[i] < low - range);
    };
    for (std::size_t i = 0; i < values.size();) {
        std::size_t end = i;
        while (end < values.size() && isOver(end)) {
            ++end;
        }
        for (std::size_t k = i; end - i <= mostInARow && k < end; ++k) {
            found.push_back(k);
        }
        i = std::max(end, i + 1);
    }
    return found;
}

UnlikeCycle unlikeOf(std::span<const double> time_s, std::span<const double> predicted,
                     std::span<const double> residuals, double noiseVariance,
                     const std::vector<double>& stageEnds_s) {
    const auto count = static_cast<double>(residuals.size());
    const double squares =
        std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
    const double excess = squares - count * noiseVariance;
    constexpr double leastShare = 0.4, farOut = 5;
    UnlikeCycle found;
    double most = leastShare * std::max(excess, 0.0);
    const auto offer = [&](Unlike kind, int stage, double taken) {
        if (taken > most) {
            most = taken;
            found = {kind, stage};
        }
    };
    double spikes = 0;
    for (const double residual : residuals) {
        const bool isFar = residual * residual > farOut * farOut * noiseVariance;
        spikes += isFar ? residual * residual : 0;
    }
    const auto far = std::ranges::count_if(residuals, [&](double residual) {
        return residual * residual > farOut * farOut * noiseVariance;
    });
    constexpr double fewShare = 0.05;
    if (static_cast<double>(far) <= std::max(1.0, fewShare * count)) {
        offer(Unlike::spike, -1, spikes);
    }
    offer(Unlike::drift, -1, takenBy({time_s.begin(), time_s.end()}, residuals));
    const Values slope = slopeOf(time_s, {predicted.begin(), predicted.end()});
    offer(Unlike::lag, -1, takenBy(slope, residuals));
    offer(Unlike::lag, -1, takenBy(slopeOf(time_s, slope), residuals));
    double from_s = -INFINITY;
    for (std::size_t z = 0; z < stageEnds_s.size(); ++z) {
        Values inside;
        for (const double time : time_s) {
            inside.push_back(time > from_s && time <= stageEnds_s[z] ? 1 : 0);
        }
        offer(Unlike::stage, static_cast<int>(z), takenBy(std::move(inside), residuals));
        from_s = stageEnds_s[z];
    }
    return found;
}

} // namespace sparkout
