// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/unlike.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sparkout {

namespace {

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
