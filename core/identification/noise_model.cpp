// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/noise_model.h"

#include "core/statistics/intervals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace sparkout {

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
