// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/pass_kernel.h"

#include <bit>
#include <cmath>

namespace sparkout {

void LaneCoefficients::set(std::size_t lane, double gamma, double bks, double bkr) {
    const double A = 1 + gamma * bks;
    const double c = gamma * bkr;
    C[lane] = c;
    C2[lane] = c * c;
    A4[lane] = 4 * A;
    inverse2A[lane] = 1 / (2 * A);
}

namespace {

enum class Root { multiplied, divided };

// The loop is written once; each wrapper compiles it for its vector unit. Every operation is an
// IEEE one, contraction is off, so the units differ in speed alone.
template <Root form>
[[gnu::always_inline]] inline double cutLanesBy(Lanes& lanes, const LaneCoefficients& coefficients,
                                                const PassFeed& feed, const PassRange& range) {
    double* __restrict depth = lanes.depth_mm.data() + range.first;
    double* __restrict root = lanes.root.data() + range.first;
    double* __restrict rootSum = lanes.rootSum.data() + range.first;
    double* __restrict peakForce = lanes.peakForce_n.data() + range.first;
    const double* __restrict share = lanes.share.data() + range.first;
    const double* __restrict C = coefficients.C.data() + range.first;
    const double* __restrict C2 = coefficients.C2.data() + range.first;
    const double* __restrict A4 = coefficients.A4.data() + range.first;
    const double* __restrict inverse2A = coefficients.inverse2A.data() + range.first;
    const double begin = feed.base + feed.offset, rate = feed.rate, most = feed.base + feed.cap;
    const double bks = range.bks, bkr = range.bkr;
    const std::size_t count = range.count;
    double largest = 0;
#pragma omp simd reduction(max : largest)
    for (std::size_t i = 0; i < count; ++i) {
        const double ramp = begin + rate * share[i];
        const double lag = (ramp < most ? ramp : most) - depth[i];
        const double h = lag > 0 ? lag : 0;
        const double q = std::sqrt(C2[i] + A4[i] * h);
        const double u =
            form == Root::multiplied ? (q - C[i]) * inverse2A[i] : (h + h) / (C[i] + q);
        const double a = u * u;
        const double force = bks * a + bkr * u;
        depth[i] += a;
        root[i] = u;
        rootSum[i] += u; // a sum a lane: the same in every unit
        peakForce[i] = force > peakForce[i] ? force : peakForce[i];
        largest = u > largest ? u : largest;
    }
    return largest;
}

/// Keeps the pass as the last cut of the lanes that it cut.
[[gnu::always_inline]] inline void keepLastCuts(Lanes& lanes, const PassRange& range) {
    const double* __restrict root = lanes.root.data() + range.first;
    double* __restrict lastRoot = lanes.lastRoot.data() + range.first;
    std::uint64_t* __restrict lastPass = lanes.lastPass.data() + range.first;
    const std::uint64_t number = range.number;
    const std::size_t count = range.count;
    // By masks: a choice would become a masked store, which takes thrice as long.
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t cut = root[i] > 0 ? ~std::uint64_t{0} : 0;
        const auto u = std::bit_cast<std::uint64_t>(root[i]);
        const auto before = std::bit_cast<std::uint64_t>(lastRoot[i]);
        lastRoot[i] = std::bit_cast<double>((u & cut) | (before & ~cut));
        lastPass[i] = (number & cut) | (lastPass[i] & ~cut);
    }
}

[[gnu::always_inline]] inline double cutLanes(Lanes& lanes, const LaneCoefficients& coefficients,
                                              const PassFeed& feed, const PassRange& range) {
    const double largest = range.bkr > multipliedFormLimit * range.bks
                               ? cutLanesBy<Root::divided>(lanes, coefficients, feed, range)
                               : cutLanesBy<Root::multiplied>(lanes, coefficients, feed, range);
    if (!lanes.lastRoot.empty()) {
        keepLastCuts(lanes, range);
    }
    return largest;
}

double cutBaseline(Lanes& lanes, const LaneCoefficients& coefficients, const PassFeed& feed,
                   const PassRange& range) {
    return cutLanes(lanes, coefficients, feed, range);
}

[[gnu::target("avx2")]] double cutAvx2(Lanes& lanes, const LaneCoefficients& coefficients,
                                       const PassFeed& feed, const PassRange& range) {
    return cutLanes(lanes, coefficients, feed, range);
}

[[gnu::target("avx512f,avx512vl,avx512dq,prefer-vector-width=512")]] double
cutAvx512(Lanes& lanes, const LaneCoefficients& coefficients, const PassFeed& feed,
          const PassRange& range) {
    return cutLanes(lanes, coefficients, feed, range);
}

} // namespace

bool isSupported(VectorUnit unit) {
    switch (unit) {
    case VectorUnit::baseline: return true;
    case VectorUnit::avx2: return __builtin_cpu_supports("avx2");
    case VectorUnit::avx512:
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")
               && __builtin_cpu_supports("avx512dq");
    }
    return false;
}

PassFunction passFunction(VectorUnit unit) {
    switch (unit) {
    case VectorUnit::avx512: return cutAvx512;
    case VectorUnit::avx2: return cutAvx2;
    case VectorUnit::baseline: break;
    }
    return cutBaseline;
}

PassFunction widestPassFunction() {
    for (const VectorUnit unit : {VectorUnit::avx512, VectorUnit::avx2}) {
        if (isSupported(unit)) {
            return passFunction(unit);
        }
    }
    return passFunction(VectorUnit::baseline);
}

} // namespace sparkout
