// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sweep/sweep_entries.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

std::vector<SweepEntry> sweepEntries(const SweepResult& sweep, bool each) {
    std::vector<SweepEntry> entries;
    const auto& all = sweep.quantities;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string& name = all[i].name;
        if (std::ranges::find(entries, name, &SweepEntry::key) != entries.end()) {
            continue;
        }
        SweepEntry entry{name, {}};
        for (std::size_t q = i; q < all.size(); ++q) {
            if (all[q].name == name) {
                entry.quantities.push_back(q);
            }
        }
        entries.push_back(entry);
        for (const std::size_t q : entry.quantities) {
            if (each && entry.quantities.size() > 1) {
                entries.push_back({name + ' ' + std::to_string(all[q].section), {q}});
            }
        }
    }
    return entries;
}

std::optional<std::size_t> worstAt(const SweepPoint& point, const SweepEntry& entry) {
    std::optional<std::size_t> worst;
    for (const std::size_t q : entry.quantities) {
        if (point.values.empty() || std::isnan(point.values[q].value)) {
            continue;
        }
        const SweepValue& value = point.values[q];
        const bool limited =
            worst && !std::isnan(value.margin) && !std::isnan(point.values[*worst].margin);
        if (!worst
            || (limited ? value.margin < point.values[*worst].margin
                        : value.value > point.values[*worst].value)) {
            worst = q;
        }
    }
    return worst;
}

bool changesNothing(const SweepResult& sweep) {
    const SweepPoint* first = nullptr;
    for (const SweepPoint& point : sweep.points) {
        if (point.status != SweepStatus::done) {
            return false;
        }
        first = first ? first : &point;
        const bool same =
            std::ranges::equal(point.values, first->values, [](const auto& a, const auto& b) {
                const auto equal = [](double x, double y) {
                    return x == y || (std::isnan(x) && std::isnan(y));
                };
                return equal(a.value, b.value) && equal(a.low, b.low) && equal(a.high, b.high);
            });
        if (!same) {
            return false;
        }
    }
    return sweep.points.size() > 1;
}

} // namespace sparkout
