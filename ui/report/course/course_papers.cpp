// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course/course_papers.h"

#include "ui/report/course/methodical_guide.h"
#include "ui/report/course/worksheet.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <iterator>

namespace sparkout::report {

namespace {

constexpr std::array allPapers{
    PaperRow{Paper::labReport, "lab-report", QT_TRANSLATE_NOOP("Paper", "Laboratory &report"), true,
             false, false, false},
    PaperRow{Paper::worksheet, "worksheet", QT_TRANSLATE_NOOP("Paper", "Wor&ksheet"), true, true,
             true, true},
    PaperRow{Paper::worksheetKey, "worksheet-key",
             QT_TRANSLATE_NOOP("Paper", "Key to the &worksheet"), false, true, true, true},
    PaperRow{Paper::guide, "guide", QT_TRANSLATE_NOOP("Paper", "Methodical &guide"), false, true,
             false, false},
};

std::vector<PaperRow> papersThat(bool PaperRow::*takes) {
    std::vector<PaperRow> rows;
    std::ranges::copy_if(allPapers, std::back_inserter(rows), takes);
    return rows;
}

} // namespace

std::span<const PaperRow> papers() {
    return allPapers;
}

std::vector<PaperRow> papersOfWorks() {
    return papersThat(&PaperRow::takesWork);
}

std::vector<PaperRow> papersOfLessons() {
    return papersThat(&PaperRow::takesLesson);
}

const PaperRow& rowOf(Paper paper) {
    return *std::ranges::find(allPapers, paper, &PaperRow::paper);
}

std::optional<Paper> paperOf(const QString& key) {
    const auto row = std::ranges::find_if(
        allPapers, [&key](const PaperRow& r) { return key == QLatin1StringView(r.key); });
    return row == allPapers.end() ? std::nullopt : std::optional(row->paper);
}

QString menuText(Paper paper) {
    return QCoreApplication::translate("Paper", rowOf(paper).menu);
}

Report makePaper(Paper paper, const Work& work, const PaperWish& wish) {
    return paper == Paper::labReport ? labReport(work, wish) : worksheet(work, wish);
}

Report makePaper(Paper paper, const Lesson& lesson, const PaperWish& wish) {
    switch (paper) {
    case Paper::worksheetKey: return worksheetKey(lesson, wish);
    case Paper::guide: return methodicalGuide(lesson, wish);
    default: return worksheet(lesson, wish);
    }
}

} // namespace sparkout::report
