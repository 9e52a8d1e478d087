// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/handout/exercise_sheet.h"

#include "ui/text/names.h"

#include <cmath>

namespace sparkout::report {

namespace {

constexpr int percent = 100;

/// The change in per cent, as far as the printed numbers determine it.
QString change(const ExerciseAnswer& answer) {
    const QString before = askedNumber(answer.asked, answer.before);
    if (before == askedNumber(answer.asked, answer.after)) {
        return QStringLiteral("0");
    }
    if (before == askedNumber(answer.asked, 0)) {
        return QStringLiteral("–");
    }
    const double percents = percent * (answer.after - answer.before) / std::abs(answer.before);
    return (percents > 0 ? QStringLiteral("+") : QString())
           + Names::significant(percents).replace(u'-', QChar(0x2212));
}

} // namespace

std::vector<Block> ExerciseSheet::questions(const std::vector<Exercise>& exercises) {
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        blocks.emplace_back(
            Paragraph{QStringLiteral("%1. %2").arg(QString::number(i + 1), exercises[i].question)});
    }
    return blocks;
}

std::vector<Block> ExerciseSheet::answers(const std::vector<Exercise>& exercises,
                                          Operation operation) {
    std::vector<Block> blocks;
    blocks.emplace_back(Paragraph{
        tr("Computed by the engine, which ran the whole cycle with only that input changed.")});
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        const Exercise& exercise = exercises[i];
        blocks.emplace_back(
            Paragraph{QStringLiteral("%1. %2").arg(QString::number(i + 1), exercise.reason)});
        Table table;
        table.head = {tr("Asked for"), tr("Before"), tr("Changed"), tr("Difference, %")};
        table.texts = {true};
        for (const ExerciseAnswer& answer : exercise.answers) {
            table.rows.push_back({askedName(answer.asked, operation),
                                  askedNumber(answer.asked, answer.before),
                                  askedNumber(answer.asked, answer.after), change(answer)});
        }
        blocks.emplace_back(table);
    }
    return blocks;
}

} // namespace sparkout::report
