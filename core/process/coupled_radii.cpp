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

// The registers of a vector unit, as many as some thirds of a row need.
using Two [[gnu::vector_size(16)]] = double;
using Four [[gnu::vector_size(32)]] = double;
constexpr std::size_t third = CoupledRadii::third, across = CoupledRadii::sideBySide;
template <class Register, std::size_t thirds>
constexpr std::size_t registers = sizeof(double) * third* thirds / sizeof(Register);

template <class Register>
[[gnu::always_inline]] inline void load(Register& to, const double* row, std::size_t v) {
    std::memcpy(&to, row + v * (sizeof to / sizeof(double)), sizeof to);
}
template <class Register>
[[gnu::always_inline]] inline void store(double* row, const Register& from, std::size_t v) {
    std::memcpy(row + v * (sizeof from / sizeof(double)), &from, sizeof from);
}

/// L·Δ·Lᵀ of D + G, its forward substitution, and with it the forces and roots of Newton's step.
template <class Register, std::size_t thirds, std::size_t rank>
[[gnu::always_inline]] inline void eliminate(Balance& b, const Step& step) {
    const double *own = b.own.data(), *bkr = b.bkr.data();
    const double *twoBks = b.twoBks.data(), *halfBkr = b.halfBkr.data();
    const double *row = b.rows.data(), *column = b.columns.data();
    double *gains = b.gain[0].of + step.first, *forces = b.force[0].of + step.first;
    double *scales = b.scale[0].of + step.first, *inverses = b.inverse[0].of + step.first;
    const double *roots = step.root->of + step.first, *lags = step.lag->of + step.first;
    Register left[registers<Register, thirds>][rank] = {};
    // Σ Δ·gain·gainᵀ, its lower half
    Register carried[registers<Register, thirds>][rank][rank] = {};
    for (std::size_t j = 0, count = b.own.size(); j < count; ++j) {
#pragma GCC unroll 6
        for (std::size_t v = 0; v < registers<Register, thirds>; ++v) {
            Register u, h;
            load(u, roots + j * across, v);
            load(h, lags + j * across, v);
            const Register inverse = 1 / (twoBks[j] * u + bkr[j]);
            const Register added = (u + u) * inverse; // D
            Register pivot = added + own[j];
            Register f = h + added * (u * halfBkr[j]);
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
                f -= row[i] * left[v][i];
            }
            const Register scale = 1 / pivot;
#pragma GCC unroll 8
            for (std::size_t i = 0; i < rank; ++i) {
                const Register gain = rest[i] * scale;
                left[v][i] += gain * f;
#pragma GCC unroll 8
                for (std::size_t k = 0; k <= i; ++k) {
                    carried[v][i][k] += gain * rest[k];
                }
                store(gains + i * across, gain, v);
            }
            store(forces + j * across, Register(f * scale), v);
            store(scales + j * across, scale, v);
            store(inverses + j * across, inverse, v);
        }
        row += rank;
        column += rank;
        gains += rank * across;
    }
}

/// The results of a sweep over the sections for each radius.
template <class Register, std::size_t thirds>
struct Found {
    [[gnu::always_inline]] explicit Found(const Step& step) {
        for (std::size_t v = 0; v < registers<Register, thirds>; ++v) {
            load(moving[v], step.moving.of + step.first, v);
            least[v] = Register{} + std::numeric_limits<double>::max();
            most[v] = Register{};
        }
    }
    /// Adds the new u of a section and the size of its residual r.
    [[gnu::always_inline]] void add(double* root, const Register& from, const Register& to,
                                    const Register& off, std::size_t v) {
        const Register u = moving[v] > 0 ? to : from;
        // The comparison drops NaN here; it spreads through the sum to section 0, the last.
        least[v] = least[v] < u ? least[v] : u;
        most[v] = most[v] > off ? most[v] : off;
        store(root, u, v);
    }
    [[gnu::always_inline]] void put(Step& step) const {
        for (std::size_t v = 0; v < registers<Register, thirds>; ++v) {
            store(step.least.of + step.first, least[v], v);
            store(step.most.of + step.first, most[v], v);
        }
    }
    Register moving[registers<Register, thirds>], least[registers<Register, thirds>],
        most[registers<Register, thirds>];
};

/// f of a section from the result of the forward substitution; `sum` covers the sections to its
/// right and then includes it.
template <class Register, std::size_t rank>
[[gnu::always_inline]] inline void substituteBack(Register& f, Register (&sum)[rank],
                                                  const double* gains, const double* row,
                                                  std::size_t v) {
#pragma GCC unroll 8
    for (std::size_t i = 0; i < rank; ++i) {
        Register gain;
        load(gain, gains + i * across, v);
        f -= gain * sum[i];
    }
#pragma GCC unroll 8
    for (std::size_t i = 0; i < rank; ++i) {
        sum[i] += row[i] * f;
    }
}

template <class Register, std::size_t thirds, std::size_t rank>
[[gnu::always_inline]] inline void newtonStep(Balance& b, Step& step) {
    eliminate<Register, thirds, rank>(b, step);
    const double *bks = b.bks.data(), *row = b.rows.data();
    const double *gains = b.gain[0].of + step.first, *forces = b.force[0].of + step.first;
    const double* inverses = b.inverse[0].of + step.first;
    double *changes = b.change[0].of + step.first, *roots = step.root->of + step.first;
    Register sum[registers<Register, thirds>][rank] = {};
    Found<Register, thirds> found(step);
    for (std::size_t j = b.own.size(); j-- > 0;) {
#pragma GCC unroll 6
        for (std::size_t v = 0; v < registers<Register, thirds>; ++v) {
            Register u, f, inverse;
            load(u, roots + j * across, v);
            load(f, forces + j * across, v);
            load(inverse, inverses + j * across, v);
            substituteBack(f, sum[v], gains + j * rank * across, row + j * rank, v);
            const Register to = (u * u * bks[j] + f) * inverse;
            const Register du = to - u;
            store(changes + j * across, du, v);
            found.add(roots + j * across, u, to, du * du, v);
        }
    }
    found.put(step);
}

template <class Register, std::size_t thirds, std::size_t rank>
[[gnu::always_inline]] inline void correction(Balance& b, Step& step) {
    const double *bks = b.bks.data(), *bkr = b.bkr.data(), *row = b.rows.data();
    const double *gains = b.gain[0].of + step.first, *inverses = b.inverse[0].of + step.first;
    const double *scales = b.scale[0].of + step.first, *changes = b.change[0].of + step.first;
    double *forces = b.force[0].of + step.first, *roots = step.root->of + step.first;
    Register left[registers<Register, thirds>][rank] = {};
    for (std::size_t j = 0, count = b.own.size(); j < count; ++j) {
#pragma GCC unroll 6
        for (std::size_t v = 0; v < registers<Register, thirds>; ++v) {
            Register du, inverse, scale, gain;
            load(du, changes + j * across, v);
            load(inverse, inverses + j * across, v);
            load(scale, scales + j * across, v);
            Register f = du * du * bkr[j] * inverse; // y
#pragma GCC unroll 8
            for (std::size_t i = 0; i < rank; ++i) {
                f -= row[j * rank + i] * left[v][i];
            }
#pragma GCC unroll 8
            for (std::size_t i = 0; i < rank; ++i) {
                load(gain, gains + (j * rank + i) * across, v);
                left[v][i] += gain * f;
            }
            store(forces + j * across, Register(f * scale), v);
        }
    }
    Register sum[registers<Register, thirds>][rank] = {};
    Found<Register, thirds> found(step);
    for (std::size_t j = b.own.size(); j-- > 0;) {
#pragma GCC unroll 6
        for (std::size_t v = 0; v < registers<Register, thirds>; ++v) {
            Register u, du, f, inverse;
            load(u, roots + j * across, v);
            load(du, changes + j * across, v);
            load(f, forces + j * across, v);
            load(inverse, inverses + j * across, v);
            substituteBack(f, sum[v], gains + j * rank * across, row + j * rank, v);
            const Register less = (du * du * bks[j] + f) * inverse;
            const Register off = less * (less - 2 * du);
            found.add(roots + j * across, u, u - less, off > 0 ? off : -off, v);
        }
    }
    found.put(step);
}

// One source, compiled for each vector unit, as in the pass.
template <std::size_t thirds, std::size_t rank>
void newtonBaseline(Balance& b, Step& step) {
    newtonStep<Two, thirds, rank>(b, step);
}
template <std::size_t thirds, std::size_t rank>
[[gnu::target("avx2")]] void newtonAvx2(Balance& b, Step& step) {
    newtonStep<Four, thirds, rank>(b, step);
}
template <std::size_t thirds, std::size_t rank>
void correctionBaseline(Balance& b, Step& step) {
    correction<Two, thirds, rank>(b, step);
}
template <std::size_t thirds, std::size_t rank>
[[gnu::target("avx2")]] void correctionAvx2(Balance& b, Step& step) {
    correction<Four, thirds, rank>(b, step);
}

template <std::size_t rank>
CoupledRadii::Kernels kernels(VectorUnit unit) {
    if (unit == VectorUnit::avx2) {
        return {{newtonAvx2<1, rank>, newtonAvx2<2, rank>, newtonAvx2<3, rank>},
                {correctionAvx2<1, rank>, correctionAvx2<2, rank>, correctionAvx2<3, rank>}};
    }
    return {
        {newtonBaseline<1, rank>, newtonBaseline<2, rank>, newtonBaseline<3, rank>},
        {correctionBaseline<1, rank>, correctionBaseline<2, rank>, correctionBaseline<3, rank>}};
}

} // namespace

CoupledRadii::CoupledRadii(const SectionInfluence& influence, const std::vector<double>& widths_mm,
                           const ForceLaw& law, VectorUnit unit)
    : m_kernels(influence.rank() == 3   ? kernels<3>(unit)
                : influence.rank() == 4 ? kernels<4>(unit)
                                        : kernels<SectionInfluence::mostRank>(unit)) {
    assert(influence.isShort());
    const std::size_t sections = widths_mm.size();
    Balance& b = m_balance;
    b.rows = influence.rows();
    b.columns = influence.columns();
    for (std::size_t j = 0; j < sections; ++j) {
        b.own.push_back(influence.own(j));
        b.bks.push_back(widths_mm[j] * law.ks);
        b.bkr.push_back(widths_mm[j] * law.kr);
        b.twoBks.push_back(2 * b.bks[j]);
        b.halfBkr.push_back(b.bkr[j] / 2);
        double sum = 1;
        for (std::size_t l = 0; l < sections; ++l) {
            sum += std::abs(influence.of(j)[l]) * widths_mm[l] * law.ks;
        }
        m_leaves = std::max(m_leaves, sum);
    }
    for (std::vector<Row>* rows : {&b.force, &b.inverse, &b.scale, &b.change}) {
        rows->resize(sections);
    }
    b.gain.resize(sections * influence.rank());
}

CoupledRadii::Set CoupledRadii::solve(const Row* lag_mm, Row* root, Set asked) {
    Set solved, moving = asked;
    Step step{lag_mm, root};
    const auto take = [&](const Kernel* kernels) {
        std::size_t first = thirds, last = 0; // thirds in which a radius moves
        for (std::size_t k = 0; k < sideBySide; ++k) {
            step.moving.of[k] = moving[k] ? 1 : 0;
            if (moving[k]) {
                first = std::min(first, k / third);
                last = k / third;
            }
        }
        step.first = first * third;
        kernels[last - first](m_balance, step);
        for (std::size_t k = 0; k < sideBySide; ++k) {
            if (moving[k]) {
                const bool cuts = step.least.of[k] > 0;
                solved[k] = cuts && m_leaves * step.most.of[k] <= CoupledSections::tolerance_mm;
                moving[k] = cuts && !solved[k];
            }
        }
    };
    for (int steps = 0; steps < mostSteps && moving.any(); ++steps) {
        take(m_kernels.newton);
        if (moving.any()) {
            take(m_kernels.correction);
        }
    }
    return solved;
}

} // namespace sparkout
