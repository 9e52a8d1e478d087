// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/intervals.h"

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

double tailOf(double confidence) {
    return (1 - confidence) / 2;
}

} // namespace

Interval studentInterval(double mean, double deviation, std::int64_t count, double confidence) {
    const auto n = static_cast<double>(count);
    const double t = boost::math::quantile(
        boost::math::complement(boost::math::students_t(n - 1), tailOf(confidence)));
    const double half = t * deviation / std::sqrt(n);
    return {mean - half, mean + half};
}

Interval clopperPearson(std::int64_t hits, std::int64_t count, double confidence) {
    const auto k = static_cast<double>(hits), n = static_cast<double>(count);
    const double tail = tailOf(confidence);
    Interval found{0, 1};
    if (hits > 0) {
        found.low = boost::math::quantile(boost::math::beta_distribution<>(k, n - k + 1), tail);
    }
    if (hits < count) {
        found.high = boost::math::quantile(
            boost::math::complement(boost::math::beta_distribution<>(k + 1, n - k), tail));
    }
    return found;
}

// With B the number of values below the quantile, x_(r) is above it if B < r, x_(s) below it if B ≥
// s: r is the greatest with P(B < r) ≤ tail, s the least with P(B ≥ s) ≤ tail.
std::optional<Ranks> quantileRanks(std::int64_t count, double order, double confidence) {
    const double tail = tailOf(confidence);
    const boost::math::binomial below(static_cast<double>(count), order);
    const auto least = [&](auto&& holds) { // the first of 0…count+1 with a monotonic property
        std::int64_t low = 0, high = count + 1;
        while (low < high) {
            const std::int64_t middle = low + (high - low) / 2;
            holds(middle) ? high = middle : low = middle + 1;
        }
        return low;
    };
    const auto cdf = [&](std::int64_t k) {
        return k < 0 ? 0.0 : k >= count ? 1.0 : boost::math::cdf(below, static_cast<double>(k));
    };
    const auto upper = [&](std::int64_t k) {
        return k < 0 ? 1.0
               : k >= count
                   ? 0.0
                   : boost::math::cdf(boost::math::complement(below, static_cast<double>(k)));
    };
    const std::int64_t r = least([&](std::int64_t k) { return cdf(k - 1) > tail; }) - 1;
    const std::int64_t s = least([&](std::int64_t k) { return upper(k - 1) <= tail; });
    if (r < 1 || s > count) {
        return std::nullopt;
    }
    return Ranks{r, s};
}

Interval ppInterval(double pp, std::int64_t count, double confidence) {
    const auto freedom = static_cast<double>(count - 1);
    const boost::math::chi_squared chi(freedom);
    const double tail = tailOf(confidence);
    return {pp * std::sqrt(boost::math::quantile(chi, tail) / freedom),
            pp * std::sqrt(boost::math::quantile(boost::math::complement(chi, tail)) / freedom)};
}

Interval ppkInterval(double ppk, std::int64_t count, double confidence) {
    const auto n = static_cast<double>(count);
    const double half =
        -normalQuantile(tailOf(confidence)) * std::sqrt(1 / (9 * n) + ppk * ppk / (2 * (n - 1)));
    return {ppk - half, ppk + half};
}

double normalQuantile(double p) {
    return boost::math::quantile(boost::math::normal(), p);
}

double normalShare(double z) {
    return boost::math::cdf(boost::math::normal(), z);
}

double studentQuantile(double p, double freedom) {
    return boost::math::quantile(boost::math::students_t(freedom), p);
}

double fisherQuantile(double p, double freedom, double otherFreedom) {
    return boost::math::quantile(boost::math::fisher_f(freedom, otherFreedom), p);
}

VarianceRatio varianceRatio(double deviation, std::int64_t count, double other,
                            std::int64_t otherCount, double confidence) {
    VarianceRatio test;
    test.ratio = deviation * deviation / (other * other);
    test.freedom = count - 1;
    test.otherFreedom = otherCount - 1;
    const boost::math::fisher_f law(static_cast<double>(test.freedom),
                                    static_cast<double>(test.otherFreedom));
    const double tail = (1 - confidence) / 2;
    test.low = boost::math::quantile(law, tail);
    test.high = boost::math::quantile(boost::math::complement(law, tail));
    test.probability =
        std::min(1.0, 2
                          * std::min(boost::math::cdf(law, test.ratio),
                                     boost::math::cdf(boost::math::complement(law, test.ratio))));
    return test;
}

// Welch's degrees of freedom: (v₁ + v₂)²/(v₁²/(n₁−1) + v₂²/(n₂−1)), v = s²/n.
Interval welchInterval(const SampleMean& one, const SampleMean& other, double confidence) {
    const auto shareOf = [](const SampleMean& sample) {
        return sample.deviation * sample.deviation / static_cast<double>(sample.count);
    };
    const double v1 = shareOf(one), v2 = shareOf(other);
    const double freedom = (v1 + v2) * (v1 + v2)
                           / (v1 * v1 / static_cast<double>(one.count - 1)
                              + v2 * v2 / static_cast<double>(other.count - 1));
    const double half = studentQuantile((1 + confidence) / 2, freedom) * std::sqrt(v1 + v2);
    const double difference = one.mean - other.mean;
    return {difference - half, difference + half};
}

} // namespace sparkout
