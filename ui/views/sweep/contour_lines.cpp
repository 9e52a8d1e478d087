// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/contour_lines.h"

#include <array>
#include <cmath>
#include <optional>

namespace sparkout {

namespace {

/// A corner of a cell and the value there.
struct Corner {
    QPointF at;
    double value;
    [[nodiscard]] bool above() const { return value >= 0; }
};

std::optional<QPointF> crossing(const Corner& a, const Corner& b) {
    if (a.above() == b.above()) {
        return std::nullopt;
    }
    return a.at + (b.at - a.at) * (a.value / (a.value - b.value));
}

/// Corners in turn around the cell.
void addCell(const std::array<Corner, 4>& corners, std::vector<QLineF>& lines) {
    std::vector<QPointF> ends;
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (std::isnan(corners[i].value)) {
            return;
        }
        sum += corners[i].value;
        if (const auto at = crossing(corners[i], corners[(i + 1) % corners.size()])) {
            ends.push_back(*at);
        }
    }
    if (ends.size() == 2) {
        lines.emplace_back(ends[0], ends[1]);
    } else if (ends.size() == 4) { // the middle belongs to the first corner's side, or not
        const std::size_t shift = (sum >= 0) == corners[0].above() ? 0 : 3;
        lines.emplace_back(ends[shift], ends[(shift + 1) % 4]);
        lines.emplace_back(ends[(shift + 2) % 4], ends[(shift + 3) % 4]);
    }
}

} // namespace

std::vector<QLineF> zeroLines(const std::vector<double>& across, const std::vector<double>& up,
                              const std::function<double(std::size_t, std::size_t)>& at) {
    std::vector<QLineF> lines;
    const auto corner = [&](std::size_t i, std::size_t j) {
        return Corner{{across[i], up[j]}, at(i, j)};
    };
    for (std::size_t j = 0; j + 1 < up.size(); ++j) {
        for (std::size_t i = 0; i + 1 < across.size(); ++i) {
            addCell({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)},
                    lines);
        }
    }
    return lines;
}

} // namespace sparkout
