// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/pass_kernel.h"

#include <cmath>

namespace sparkout {

void LaneCoefficients::set(std::size_t first, double gamma, double bks, double bkr,
                           std::size_t count) {
    const LaneBalance balance(gamma, bks, bkr);
    const auto put = [&](std::vector<double>& numbers, double number) {
        std::fill_n(numbers.begin() + static_cast<std::ptrdiff_t>(first), count, number);
    };
    put(C, balance.C);
    put(C2, balance.C2);
    put(A4, balance.A4);
    put(inverse2A, balance.inverse2A);
}

namespace {

enum class Root { multiplied, divided };
enum class Drift { none, some }; ///< drift of the infeed; it costs time and few cycles have one
enum class Wave { none, some };  ///< wave of a wheel out of true, likewise

// The loop has one source; each wrapper compiles it for its vector unit. Every operation is an IEEE
// one without contraction, so the units differ only in speed.
template <Root form, Drift drifts, Wave waves>
[[gnu::always_inline]] inline double cutLanesBy(Lanes& lanes, const LaneCoefficients& coefficients,
                                                const PassFeed& feed, const PassRange& range) {
    double* __restrict depth = lanes.depth_mm.data() + range.first;
    double* __restrict root = lanes.root.data() + range.first;
    double* __restrict rootSum = lanes.rootSum.data() + range.first;
    double* __restrict peakRoot = lanes.peakRoot.data() + range.first;
    const double* __restrict share = lanes.share.data() + range.first;
    const double* __restrict C = coefficients.C.data() + range.first;
    const double* __restrict C2 = coefficients.C2.data() + range.first;
    const double* __restrict A4 = coefficients.A4.data() + range.first;
    const double* __restrict inverse2A = coefficients.inverse2A.data() + range.first;
    const double begin = feed.base + feed.offset, rate = feed.rate, most = feed.base + feed.cap;
    const double drift = feed.drift, end = feed.most;
    const double* __restrict waveCos = lanes.waveCos.data();
    const double* __restrict waveSin = lanes.waveSin.data();
    if constexpr (waves == Wave::some) {
        waveCos += range.first;
        waveSin += range.first;
    }
    const double cosine = feed.waveCos_mm, sine = feed.waveSin_mm;
    const std::size_t count = range.count;
    double largest = 0;
#pragma omp simd reduction(max : largest)
    for (std::size_t i = 0; i < count; ++i) {
        const double ramp = begin + rate * share[i];
        double fed = ramp < most ? ramp : most;
        if constexpr (drifts == Drift::some) {
            const double further = fed + drift * share[i];
            fed = further < end ? further : end;
        }
        if constexpr (waves == Wave::some) {
            fed = fed + (cosine * waveCos[i] + sine * waveSin[i]);
        }
        const double lag = fed - depth[i];
        const double h = lag > 0 ? lag : 0;
        const double q = std::sqrt(C2[i] + A4[i] * h);
        const double u =
            form == Root::multiplied ? (q - C[i]) * inverse2A[i] : (h + h) / (C[i] + q);
        depth[i] += u * u;
        root[i] = u;
        rootSum[i] += u; // one sum per lane: the same in every unit
        peakRoot[i] = u > peakRoot[i] ? u : peakRoot[i];
        largest = u > largest ? u : largest;
    }
    return largest;
}

template <Root form, Drift drifts>
[[gnu::always_inline]] inline double cutLanesBy(Lanes& lanes, const LaneCoefficients& coefficients,
                                                const PassFeed& feed, const PassRange& range) {
    return lanes.waveCos.empty()
               ? cutLanesBy<form, drifts, Wave::none>(lanes, coefficients, feed, range)
               : cutLanesBy<form, drifts, Wave::some>(lanes, coefficients, feed, range);
}

template <Root form>
[[gnu::always_inline]] inline double cutLanesBy(Lanes& lanes, const LaneCoefficients& coefficients,
                                                const PassFeed& feed, const PassRange& range) {
    return feed.drift != 0 ? cutLanesBy<form, Drift::some>(lanes, coefficients, feed, range)
                           : cutLanesBy<form, Drift::none>(lanes, coefficients, feed, range);
}

[[gnu::always_inline]] inline double cutLanes(Lanes& lanes, const LaneCoefficients& coefficients,
                                              const PassFeed& feed, const PassRange& range) {
    return range.bkr > multipliedFormLimit * range.bks
               ? cutLanesBy<Root::divided>(lanes, coefficients, feed, range)
               : cutLanesBy<Root::multiplied>(lanes, coefficients, feed, range);
}

double cutBaseline(Lanes& lanes, const LaneCoefficients& coefficients, const PassFeed& feed,
                   const PassRange& range) {
    return cutLanes(lanes, coefficients, feed, range);
}

[[gnu::target("avx2")]] double cutAvx2(Lanes& lanes, const LaneCoefficients& coefficients,
                                       const PassFeed& feed, const PassRange& range) {
    return cutLanes(lanes, coefficients, feed, range);
}

} // namespace

double PeakForces::of(const Lanes& lanes, std::size_t section) const {
    const double* const root = lanes.peakRoot.data() + section * m_radii;
    double u = 0;
#pragma omp simd reduction(max : u)
    for (std::size_t k = 0; k < m_radii; ++k) {
        u = root[k] > u ? root[k] : u;
    }
    const Section& at = m_sections[section];
    if (!lanes.rubbing.empty()) {
        const auto first =
            lanes.peakRubbing.begin() + static_cast<std::ptrdiff_t>(section * m_radii);
        const double v = *std::max_element(first, first + static_cast<std::ptrdiff_t>(m_radii));
        return std::max(at.peak_n, at.bks * (u * u) + at.bkr * v);
    }
    return std::max(at.peak_n, at.bks * (u * u) + at.bkr * u);
}

void PeakForces::turnTo(Lanes& lanes, const PassRange& range, std::size_t section) {
    m_sections[section] = {range.bks, range.bkr, of(lanes, section)};
    const auto first = static_cast<std::ptrdiff_t>(section * m_radii);
    std::fill_n(lanes.peakRoot.begin() + static_cast<std::ptrdiff_t>(section * m_radii), m_radii,
                0.0);
    if (!lanes.peakRubbing.empty()) {
        std::fill_n(lanes.peakRubbing.begin() + first, m_radii, 0.0);
    }
}

bool isSupported(VectorUnit unit) {
    return unit == VectorUnit::baseline || __builtin_cpu_supports("avx2");
}

PassFunction passFunction(VectorUnit unit) {
    return unit == VectorUnit::avx2 ? cutAvx2 : cutBaseline;
}

VectorUnit widestUnit() {
    return isSupported(VectorUnit::avx2) ? VectorUnit::avx2 : VectorUnit::baseline;
}

PassFunction widestPassFunction() {
    return passFunction(widestUnit());
}

} // namespace sparkout
