// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/marks_table.h"

#include "ui/lesson/lesson_text.h"
#include "words/lesson_words.h"

#include <QCoreApplication>
#include <QLocale>

#include <utility>

namespace sparkout {

namespace {

struct MarksTable {
    Q_DECLARE_TR_FUNCTIONS(MarksTable)
};

std::vector<ValueHead> headsOf(const Lesson& lesson) {
    std::vector<ValueHead> heads{
        {.text = MarksTable::tr("Student"), .key = "student", .isText = true},
        {.text = MarksTable::tr("Group"), .key = "group", .isText = true},
        {.text = MarksTable::tr("Variant"), .key = "variant"}};
    for (std::size_t i = 1; i <= lesson.steps.size(); ++i) {
        heads.push_back({.text = QString::number(i), .name = MarksTable::tr("Step %1").arg(i)});
    }
    heads.push_back({.text = MarksTable::tr("Points"), .key = "points"});
    heads.push_back({.text = MarksTable::tr("of"), .key = "most"});
    heads.push_back({.text = MarksTable::tr("To be marked"), .key = "pending"});
    heads.push_back({.text = MarksTable::tr("Time, min"), .key = "time"});
    heads.push_back({.text = MarksTable::tr("Remarks"), .key = "remarks", .isText = true});
    return heads;
}

ValueCell pointsCell(double points) {
    return {.text = LessonText::points(points), .value = points};
}

ValueCell variantCell(const GradedWork& work) {
    return work.variant > 0
               ? ValueCell{.text = QString::number(work.variant), .value = double(work.variant)}
               : ValueCell();
}

ValueCell timeCell(const GradedWork& work) {
    constexpr int decimals = 3;
    return work.time_min ? ValueCell{.text = QLocale().toString(*work.time_min, 'f', decimals),
                                     .value = *work.time_min}
                         : ValueCell();
}

std::vector<ValueCell> cellsOf(const GradedWork& work, std::size_t steps) {
    std::vector<ValueCell> cells{
        {.text = QString::fromStdString(work.name.empty() ? work.file : work.name)},
        {.text = QString::fromStdString(work.group)},
        variantCell(work)};
    for (std::size_t i = 0; i < steps; ++i) {
        cells.push_back(i < work.steps.size()
                            ? pointsCell(work.steps[i].points)
                            : ValueCell{.text = QStringLiteral("—"), .value = QString()});
    }
    cells.push_back(pointsCell(work.points));
    cells.push_back(pointsCell(work.most));
    cells.push_back(work.pending > 0 ? pointsCell(work.pending) : ValueCell{.value = work.pending});
    cells.push_back(timeCell(work));
    cells.push_back({.text = workRemarks(work)});
    return cells;
}

} // namespace

QString workRemarks(const GradedWork& work) {
    QStringList texts;
    for (const WorkFlag flag : work.flags) {
        QString text = QCoreApplication::translate("Grading", flagText(flag));
        if (flag == WorkFlag::copied && !work.copiedFrom.empty()) {
            QStringList others;
            for (const std::string& other : work.copiedFrom) {
                others += QString::fromStdString(other);
            }
            text = MarksTable::tr("%1: %2").arg(text, others.join(QStringLiteral(", ")));
        }
        texts += text;
    }
    return texts.join(QStringLiteral("; "));
}

ValueTable marksTable(const Lesson& lesson, const std::vector<GradedWork>& works) {
    ValueTable table{.isList = true};
    if (works.empty()) {
        return table;
    }
    table.columns = headsOf(lesson);
    for (const GradedWork& work : works) {
        std::vector<ValueCell> cells = cellsOf(work, lesson.steps.size());
        const QString name = cells.front().text;
        table.addRow({.text = name}, std::move(cells));
    }
    return table;
}

} // namespace sparkout
