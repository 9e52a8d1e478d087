// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/comparison.h"

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

namespace sparkout {

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
