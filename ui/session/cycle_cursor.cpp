// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/cycle_cursor.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace sparkout {

void CycleCursor::setOutcome(OutcomePtr outcome) {
    if (outcome && !outcome->ran()) {
        return;
    }
    const bool other = m_outcome && outcome
                       && m_outcome->result.project.operation != outcome->result.project.operation;
    const bool wasEnd = atEnd() || other;
    const int number = stroke();
    const long long within = number > 0 ? m_position - startOf(number) : 0;
    const bool usable =
        outcome && !outcome->trajectory.passes.empty() && outcome->trajectory.radii > 0;
    m_outcome = usable ? std::move(outcome) : nullptr;
    findMoments();
    if (wasEnd || number >= static_cast<int>(endsOf(CursorUnit::stroke).size()) + 1) {
        m_position = count();
    } else if (number > 0) {
        m_position = std::min(startOf(number) + within, endOf(number));
    } else {
        m_position = 0;
    }
    emit moved();
}

void CycleCursor::findMoments() {
    m_moments.clear();
    m_ends = {};
    if (!m_outcome) {
        return;
    }
    const std::vector<Pass>& passes = m_outcome->trajectory.passes;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const auto together = [](const Pass& a, const Pass& b) {
            return a.start_s == b.start_s && a.duration_s == b.duration_s
                   && a.place.cycleCount == b.place.cycleCount;
        };
        if (i == 0 || !together(passes[i - 1], passes[i])) {
            m_moments.push_back(i);
        }
    }
    const std::size_t moments = m_moments.size();
    m_moments.push_back(passes.size());
    const auto K = static_cast<long long>(m_outcome->trajectory.radii);
    for (std::size_t moment = 0; moment < moments; ++moment) {
        for (std::size_t unit = 0; unit < m_ends.size(); ++unit) {
            if (ends(cursorUnits[unit], moment)) {
                m_ends[unit].push_back(static_cast<long long>(moment + 1) * K);
            }
        }
    }
}

bool CycleCursor::ends(CursorUnit unit, std::size_t moment) const {
    if (unit == CursorUnit::revolution || moment + 2 >= m_moments.size()) {
        return true;
    }
    const Place &now = passAt(moment).place, &next = passAt(moment + 1).place;
    switch (unit) {
    case CursorUnit::stage: return now.stage != next.stage;
    case CursorUnit::stroke: return now.cycleCount != next.cycleCount;
    default: break;
    }
    const auto step = [](const Place& at) { return std::tuple(at.cycleCount, at.zone, at.step); };
    return step(now) != step(next);
}

const std::vector<long long>& CycleCursor::endsOf(CursorUnit unit) const {
    return m_ends[static_cast<std::size_t>(unit)];
}

long long CycleCursor::count() const {
    return m_outcome ? endsOf(CursorUnit::revolution).back() : 0;
}

long long CycleCursor::startOf(int stroke) const {
    return stroke > 1 ? endOf(stroke - 1) : 0;
}

long long CycleCursor::endOf(int stroke) const {
    return stroke > 0 ? endsOf(CursorUnit::stroke)[static_cast<std::size_t>(stroke - 1)] : 0;
}

// --- moving -------------------------------------------------------------------------------------

void CycleCursor::setPosition(long long position) {
    position = std::clamp(position, 0LL, count());
    if (position != m_position) {
        m_position = position;
        emit moved();
    }
}

void CycleCursor::step(CursorUnit unit, int by) {
    if (!m_outcome || by == 0) {
        return;
    }
    if (unit == CursorUnit::radius) {
        setPosition(m_position + by);
        return;
    }
    // The blank is an end, too: the one before the first.
    const std::vector<long long>& all = endsOf(unit);
    const auto past = by > 0 ? std::ranges::upper_bound(all, m_position)
                             : std::ranges::lower_bound(all, m_position);
    const long long from = (past - all.begin()) - (by > 0 ? 1 : 0);
    const long long to = std::min(from + by, static_cast<long long>(all.size()) - 1);
    setPosition(to < 0 ? 0 : all[static_cast<std::size_t>(to)]);
}

void CycleCursor::toStroke(int stroke) {
    const int last = static_cast<int>(endsOf(CursorUnit::stroke).size());
    setPosition(endOf(std::clamp(stroke, 0, last)));
}

void CycleCursor::toTime(double time_s) {
    if (!m_outcome) {
        return;
    }
    const std::vector<Pass>& passes = m_outcome->trajectory.passes;
    const auto next =
        std::partition_point(m_moments.begin(), m_moments.end() - 1,
                             [&](std::size_t i) { return passes[i].start_s <= time_s; });
    if (next == m_moments.begin()) {
        setPosition(0);
        return;
    }
    const auto moment = std::prev(next) - m_moments.begin();
    const Pass& pass = passAt(static_cast<std::size_t>(moment));
    const auto K = static_cast<long long>(m_outcome->trajectory.radii);
    const double share = pass.duration_s > 0 ? (time_s - pass.start_s) / pass.duration_s : 1;
    const auto done = static_cast<long long>(std::floor(share * double(K) + 1e-9));
    setPosition(moment * K + std::clamp(done, 0LL, K));
}

// --- position -----------------------------------------------------------------------------------

std::size_t CycleCursor::moment() const {
    return static_cast<std::size_t>((m_position - 1) / m_outcome->trajectory.radii);
}

const Pass& CycleCursor::passAt(std::size_t moment) const {
    return m_outcome->trajectory.passes[m_moments[moment]];
}

const Pass* CycleCursor::pass() const {
    return m_position > 0 ? &passAt(moment()) : nullptr;
}

int CycleCursor::stroke() const {
    const std::vector<long long>& all = endsOf(CursorUnit::stroke);
    return m_position > 0
               ? static_cast<int>(std::ranges::lower_bound(all, m_position) - all.begin()) + 1
               : 0;
}

bool CycleCursor::strokeDone() const {
    return m_position == endOf(stroke());
}

int CycleCursor::radius() const {
    return m_position > 0 ? static_cast<int>((m_position - 1) % m_outcome->trajectory.radii) : 0;
}

double CycleCursor::time_s() const {
    return m_outcome ? timeOf(m_outcome->trajectory, progress()) : 0;
}

Progress CycleCursor::progress() const {
    return m_position > 0 ? Progress{m_moments[moment()], m_moments[moment() + 1], radius()}
                          : Progress{};
}

} // namespace sparkout
