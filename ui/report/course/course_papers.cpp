// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course/course_papers.h"

#include <algorithm>
#include <array>

namespace sparkout::report {

namespace {

constexpr std::array allPapers{
    PaperRow{Paper::labReport, "lab-report", true, false, false, false},
    PaperRow{Paper::worksheet, "worksheet", true, true, true, true},
    PaperRow{Paper::worksheetKey, "worksheet-key", false, true, true, true},
    PaperRow{Paper::guide, "guide", false, true, false, false},
};

} // namespace

std::span<const PaperRow> papers() {
    return allPapers;
}

const PaperRow& rowOf(Paper paper) {
    return *std::ranges::find(allPapers, paper, &PaperRow::paper);
}

std::optional<Paper> paperOf(const QString& key) {
    const auto row = std::ranges::find_if(
        allPapers, [&key](const PaperRow& r) { return key == QLatin1StringView(r.key); });
    return row == allPapers.end() ? std::nullopt : std::optional(row->paper);
}

} // namespace sparkout::report
