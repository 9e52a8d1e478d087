// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/coupled_radii.h"

#include "core/process/coupled_sections.h"
#include "core/process/section_influence.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

namespace sparkout {

namespace {

using Row = CoupledRadii::Row;
using Balance = CoupledRadii::Balance;
using Step = CoupledRadii::Step;

// The registers of a vector unit, and how many of them hold a row.
using Two [[gnu::vector_size(16)]] = double;
using Four [[gnu::vector_size(32)]] = double;
template <class Register>
constexpr std::size_t registers = sizeof(Row) / sizeof(Register);

template <class Register>
[[gnu::always_inline]] inline void load(Register& to, const Row& from, std::size_t v) {
    std::memcpy(&to, from.of + v * (sizeof to / sizeof(double)), sizeof to);
}
template <class Register>
[[gnu::always_inline]] inline void store(Row& to, const Register& from, std::size_t v) {
    std::memcpy(to.of + v * (sizeof from / sizeof(double)), &from, sizeof from);
}

/// r as far as the forces right of a section and its own make it, and f.
template <class Register, std::size_t rank>
[[gnu::always_inline]] inline void beginFromTheRight(Balance& b, const Step& step) {
    const double *own = b.own.data(), *bks = b.bks.data(), *bkr = b.bkr.data();
    const double *row = b.rows.data(), *column = b.columns.data();
    Row* rest = b.rest.data();
    Register right[registers<Register>][rank] = {};
    for (std::size_t j = b.own.size(); j-- > 0;) {
#pragma GCC unroll 4
        for (std::size_t v = 0; v < registers<Register>; ++v) {
            Register u, h;
            load(u, step.root[j], v);
            load(h, step.lag[j], v);
            const Register f = u * (bks[j] * u + bkr[j]);
            Register r = u * u + own[j] * f - h;
#pragma GCC unroll 8
            for (std::size_t i = 0; i < rank; ++i) {
                r += column[j * rank + i] * right[v][i];
                right[v][i] += row[j * rank + i] * f;
            }
            store(rest[j], r, v);
        }
    }
}

/// The forces left of each section, and L·Δ·Lᵀ with its forward substitution: L_jl = row_j·gain_l.
template <class Register, std::size_t rank>
[[gnu::always_inline]] inline void eliminate(Balance& b, const Step& step) {
    const double *own = b.own.data(), *bks = b.bks.data(), *bkr = b.bkr.data();
    const double *row = b.rows.data(), *column = b.columns.data();
    Row *gains = b.gain.data(), *rests = b.rest.data(), *inverses = b.inverse.data();
    Register left[registers<Register>][rank] = {};          // of the forces and of the step
    Register carried[registers<Register>][rank][rank] = {}; // Σ pivot·gain·gainᵀ, its lower half
    for (std::size_t j = 0; j < b.own.size(); ++j, row += rank, column += rank, gains += rank) {
#pragma GCC unroll 4
        for (std::size_t v = 0; v < registers<Register>; ++v) {
            Register u, r;
            load(u, step.root[j], v);
            load(r, rests[j], v);
            const Register f = u * (bks[j] * u + bkr[j]);
            const Register inverse = 1 / (2 * bks[j] * u + bkr[j]);
            Register pivot = (u + u) * inverse + own[j];
            Register rest[rank];
#pragma GCC unroll 8
            for (std::size_t i = 0; i < rank; ++i) {
                Register shared = carried[v][i][0] * row[0];
#pragma GCC unroll 8
                for (std::size_t k = 1; k < rank; ++k) {
                    shared += (k <= i ? carried[v][i][k] : carried[v][k][i]) * row[k];
                }
                rest[i] = column[i] - shared;
                pivot -= row[i] * shared;
                r += row[i] * left[v][i];
            }
            const Register scale = 1 / pivot;
#pragma GCC unroll 8
            for (std::size_t i = 0; i < rank; ++i) {
                const Register gain = rest[i] * scale;
                left[v][i] += column[i] * f - gain * r;
#pragma GCC unroll 8
                for (std::size_t k = 0; k <= i; ++k) {
                    carried[v][i][k] += gain * rest[k];
                }
                store(gains[i], gain, v);
            }
            store(rests[j], Register(r * scale), v);
            store(inverses[j], inverse, v);
        }
    }
}

template <class Register, std::size_t rank>
[[gnu::always_inline]] inline void substituteBack(const Balance& b, Step& step) {
    const double* row = b.rows.data();
    const Row *gains = b.gain.data(), *rest = b.rest.data(), *inverses = b.inverse.data();
    Register sum[registers<Register>][rank] = {};
    Register moving[registers<Register>], least[registers<Register>] = {},
                                          most[registers<Register>] = {};
    for (std::size_t v = 0; v < registers<Register>; ++v) {
        load(moving[v], step.moving, v);
        least[v] += std::numeric_limits<double>::max();
    }
    for (std::size_t j = b.own.size(); j-- > 0;) {
#pragma GCC unroll 4
        for (std::size_t v = 0; v < registers<Register>; ++v) {
            Register u, df, inverse, gain; // df: less δf
            load(u, step.root[j], v);
            load(df, rest[j], v);
            load(inverse, inverses[j], v);
#pragma GCC unroll 8
            for (std::size_t i = 0; i < rank; ++i) {
                load(gain, gains[j * rank + i], v);
                df += gain * sum[v][i];
            }
#pragma GCC unroll 8
            for (std::size_t i = 0; i < rank; ++i) {
                sum[v][i] -= row[j * rank + i] * df;
            }
            const Register du = df * inverse;
            const Register square = du * du;
            u = moving[v] > 0 ? u - du : u;
            // What is no number spreads by the sum up to section 0, the last, and so is left here.
            least[v] = least[v] < u ? least[v] : u;
            most[v] = most[v] > square ? most[v] : square;
            store(step.root[j], u, v);
        }
    }
    for (std::size_t v = 0; v < registers<Register>; ++v) {
        store(step.least, least[v], v);
        store(step.most, most[v], v);
    }
}

template <class Register, std::size_t rank>
[[gnu::always_inline]] inline void newtonStep(Balance& b, Step& step) {
    beginFromTheRight<Register, rank>(b, step);
    eliminate<Register, rank>(b, step);
    substituteBack<Register, rank>(b, step);
}

// Written once, compiled for each vector unit, as in the pass.
template <std::size_t rank>
void newtonBaseline(Balance& b, Step& step) {
    newtonStep<Two, rank>(b, step);
}
template <std::size_t rank>
[[gnu::target("avx2")]] void newtonAvx2(Balance& b, Step& step) {
    newtonStep<Four, rank>(b, step);
}

template <std::size_t rank>
auto newton(VectorUnit unit) {
    return unit == VectorUnit::avx2 ? newtonAvx2<rank> : newtonBaseline<rank>;
}

} // namespace

CoupledRadii::CoupledRadii(const SectionInfluence& influence, const std::vector<double>& widths_mm,
                           const ForceLaw& law, VectorUnit unit)
    : m_step(influence.rank() == 3   ? newton<3>(unit)
             : influence.rank() == 4 ? newton<4>(unit)
                                     : newton<SectionInfluence::mostRank>(unit)) {
    assert(influence.isShort());
    const std::size_t sections = widths_mm.size();
    Balance& b = m_balance;
    b.rows = influence.rows();
    b.columns = influence.columns();
    for (std::size_t j = 0; j < sections; ++j) {
        b.own.push_back(influence.own(j));
        b.bks.push_back(widths_mm[j] * law.ks);
        b.bkr.push_back(widths_mm[j] * law.kr);
        double sum = 1;
        for (std::size_t l = 0; l < sections; ++l) {
            sum += std::abs(influence.of(j)[l]) * widths_mm[l] * law.ks;
        }
        m_leaves = std::max(m_leaves, sum);
    }
    b.rest.resize(sections);
    b.inverse.resize(sections);
    b.gain.resize(sections * influence.rank());
}

CoupledRadii::Set CoupledRadii::solve(const Row* lag_mm, Row* root, Set asked) {
    Set solved, moving = asked;
    Step step{lag_mm, root};
    for (int steps = 0; steps < mostSteps && moving.any(); ++steps) {
        for (std::size_t k = 0; k < sideBySide; ++k) {
            step.moving.of[k] = moving[k] ? 1 : 0;
        }
        m_step(m_balance, step);
        for (std::size_t k = 0; k < sideBySide; ++k) {
            const bool cuts = step.least.of[k] > 0;
            const bool isLast = cuts && m_leaves * step.most.of[k] <= CoupledSections::tolerance_mm;
            solved[k] = moving[k] ? isLast : solved[k];
            moving[k] = moving[k] && cuts && !isLast;
        }
    }
    return solved;
}

} // namespace sparkout
