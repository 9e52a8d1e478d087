// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/intervals.h"

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

namespace sparkout {

namespace {

/// c₀ + c₁·x + c₂·x² + …
double polynomial(std::initializer_list<double> coefficients, double x) {
    double sum = 0;
    for (auto c = coefficients.end(); c != coefficients.begin();) {
        sum = sum * x + *--c;
    }
    return sum;
}

/// The upper tail of the standard normal distribution, accurate also far out.
double shareAbove(double z) {
    return std::erfc(z / std::numbers::sqrt2) / 2;
}

// a of W = (Σ a_i·x_(i))²/Σ(x − mean)²: the two outermost by Royston's polynomials in 1/√n, the
// others as the normal scores m_i = Φ⁻¹((i − 3/8)/(n + 1/4)).
std::vector<double> weightsOf(std::size_t count) {
    const auto n = static_cast<double>(count);
    std::vector<double> a(count);
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        a[i] = normalQuantile((static_cast<double>(i) + 1 - 0.375) / (n + 0.25));
        squares += a[i] * a[i];
    }
    const double m1 = a[count - 1], m2 = a[count - 2], root = std::sqrt(squares);
    const double u = 1 / std::sqrt(n);
    const double a1 =
        polynomial({m1 / root, 0.221157, -0.147981, -2.071190, 4.434685, -2.706056}, u);
    const double a2 =
        polynomial({m2 / root, 0.042981, -0.293762, -1.752461, 5.682633, -3.582633}, u);
    const double scale =
        std::sqrt((squares - 2 * m1 * m1 - 2 * m2 * m2) / (1 - 2 * a1 * a1 - 2 * a2 * a2));
    for (double& weight : a) {
        weight /= scale;
    }
    a[count - 1] = a1;
    a[count - 2] = a2;
    a[0] = -a1;
    a[1] = -a2;
    return a;
}

// ln(1 − W), of 11 values and fewer −ln(γ − ln(1 − W)), is roughly normal.
double shapiroWilkProbability(double oneLessW, std::size_t count) {
    const auto n = static_cast<double>(count);
    double y = std::log(oneLessW), mean = 0, deviation = 1;
    if (count <= 11) {
        const double gamma = polynomial({-2.273, 0.459}, n);
        if (y >= gamma) {
            return 0;
        }
        y = -std::log(gamma - y);
        mean = polynomial({0.5440, -0.39978, 0.025054, -6.714e-4}, n);
        deviation = std::exp(polynomial({1.3822, -0.77857, 0.062767, -0.0020322}, n));
    } else {
        const double u = std::log(n);
        mean = polynomial({-1.5861, -0.31082, -0.083751, 0.0038915}, u);
        deviation = std::exp(polynomial({-0.4803, -0.082676, 0.0030302}, u));
    }
    return shareAbove((y - mean) / deviation);
}

/// A² = −n − (1/n)·Σ [(2i − 1)·ln Φ(z_i) + (2(n − i) + 1)·ln(1 − Φ(z_i))] over the values in rising
/// order; Σ(2i − 1) between two ranks is the difference of the ranks' squares, so equal values can
/// be taken together.
class AndersonDarling {
public:
    AndersonDarling(double count, double mean, double deviation)
        : m_count(count), m_mean(mean), m_deviation(deviation) {}

    void add(double value, double parts) {
        const double z = (value - m_mean) / m_deviation;
        const double from = m_before, to = m_before + parts;
        m_sum += (to * to - from * from) * logOf(shareAbove(-z));
        m_sum += ((m_count - from) * (m_count - from) - (m_count - to) * (m_count - to))
                 * logOf(shareAbove(z));
        m_before = to;
    }

    [[nodiscard]] Normality result() const {
        const double statistic = -m_count - m_sum / m_count;
        return {NormalityTest::andersonDarling, statistic,
                andersonDarlingProbability(statistic, m_count)};
    }

private:
    static double logOf(double share) { return std::log(std::max(share, 1e-300)); }

    double m_count, m_mean, m_deviation;
    double m_before = 0, m_sum = 0;
};

} // namespace

Normality shapiroWilk(std::span<const double> sorted) {
    assert(sorted.size() >= 6 && sorted.size() <= mostForShapiroWilk);
    const std::vector<double> a = weightsOf(sorted.size());
    double mean = 0;
    for (const double x : sorted) {
        mean += x / static_cast<double>(sorted.size());
    }
    double weighted = 0, squares = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        weighted += a[i] * (sorted[i] - mean);
        squares += (sorted[i] - mean) * (sorted[i] - mean);
    }
    const double W = std::min(weighted * weighted / squares, 1.0);
    return {NormalityTest::shapiroWilk, W,
            shapiroWilkProbability(std::max(1 - W, 1e-19), sorted.size())};
}

// Beyond the end of the table the probability is 0.
double andersonDarlingProbability(double statistic, double count) {
    const double a = statistic * (1 + 0.75 / count + 2.25 / (count * count));
    constexpr double end = 13;
    return a >= end    ? 0
           : a >= 0.6  ? std::exp(polynomial({1.2937, -5.709, 0.0186}, a))
           : a >= 0.34 ? std::exp(polynomial({0.9177, -4.279, -1.38}, a))
           : a >= 0.2  ? 1 - std::exp(polynomial({-8.318, 42.796, -59.938}, a))
                       : 1 - std::exp(polynomial({-13.436, 101.14, -223.73}, a));
}

Normality andersonDarling(const ValueBins& bins, double resolution, std::int64_t count, double mean,
                          double deviation) {
    constexpr int pieces = 4;
    const double width = bins.width(resolution);
    AndersonDarling test(static_cast<double>(count), mean, deviation);
    for (const auto& [number, bin] : bins.bins()) {
        for (int i = 0; i < pieces; ++i) {
            test.add((static_cast<double>(number) + (i + 0.5) / pieces) * width,
                     static_cast<double>(bin.count) / pieces);
        }
    }
    return test.result();
}

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
