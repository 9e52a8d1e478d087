// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sparkout::fixtures {

/// Smallest value of f found by Nelder and Mead's simplex from `start` on, begun anew from its own
/// result until that gains nothing: slow, plain, and knows nothing of what f is.
template <std::size_t N, class Function>
double downhill(const Function& f, std::array<double, N> start, double size) {
    using Point = std::array<double, N>;
    double best = f(start);
    for (int round = 0; round < 20; ++round) {
        std::array<std::pair<double, Point>, N + 1> corners;
        corners[0] = {best, start};
        for (std::size_t i = 0; i < N; ++i) {
            Point p = start;
            p[i] += round % 2 == 0 ? size : -size;
            corners[i + 1] = {f(p), p};
        }
        for (int step = 0; step < 60 * int(N); ++step) {
            std::sort(corners.begin(), corners.end());
            auto& worst = corners[N];
            const auto along = [&](double share) {
                Point p{};
                for (std::size_t i = 0; i < N; ++i) {
                    double centre = 0;
                    for (std::size_t m = 0; m < N; ++m) {
                        centre += corners[m].second[i] / double(N);
                    }
                    p[i] = centre + share * (worst.second[i] - centre);
                }
                return std::pair{f(p), p};
            };
            auto tried = along(-1);
            if (tried.first < corners[0].first) {
                tried = std::min(tried, along(-2));
            } else if (tried.first >= corners[N - 1].first) {
                tried = std::min(along(0.5), along(-0.5));
            }
            if (tried.first < worst.first) {
                worst = tried;
                continue;
            }
            for (std::size_t m = 1; m <= N; ++m) {
                for (std::size_t i = 0; i < N; ++i) {
                    corners[m].second[i] = (corners[m].second[i] + corners[0].second[i]) / 2;
                }
                corners[m].first = f(corners[m].second);
            }
        }
        std::sort(corners.begin(), corners.end());
        const double gain = best - corners[0].first;
        best = std::min(best, corners[0].first);
        start = corners[0].second;
        size /= 2;
        if (round > 3 && gain <= 1e-13) {
            break;
        }
    }
    return best;
}

} // namespace sparkout::fixtures
