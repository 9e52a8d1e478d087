// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/goal_check.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/make_variants.h"
#include "core/lesson/work.h"
#include "core/project/cycle.h"
#include "core/quality/run_summary.h"
#include "core/setup/setup_file.h"
#include "core/study/outcome.h"
#include "tests/ui/support/languages.h"
#include "tests/ui/support/report_reading.h"
#include "ui/report/course_papers.h"
#include "ui/report/format/pages.h"
#include "ui/report/format/report_text.h"
#include "ui/report/lab_report.h"
#include "ui/report/worksheet.h"
#include "ui/text/language.h"

#include <QDate>
#include <QDir>
#include <QFile>
#include <QTest>

#include <string>
#include <variant>
#include <vector>

/// The lessons that are shipped, works of a student who knows the engine's answers, and the papers
/// that are made from them.
namespace sparkout::course_bench {

using report::Report;

inline Lesson lessonIn(const QString& path) {
    QFile file(path);
    ReadLesson read;
    if (file.open(QIODevice::ReadOnly)) {
        read = readLesson(file.readAll().toStdString());
    }
    return read.lesson.value_or(Lesson());
}

inline QStringList lessonFiles() {
    const QDir folder(QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/lessons"));
    QStringList paths;
    for (const QString& name : folder.entryList({QStringLiteral("*.sparkout-lesson")})) {
        paths << folder.filePath(name);
    }
    return paths;
}

inline void addLessons() {
    addFilesAndLanguages(lessonFiles());
}

/// The first levels of all inputs that are varied.
inline Work givenOut(const Lesson& lesson) {
    constexpr double best_min = 100; // any cycle is quick beside it
    return newWork(lesson, VariantLevels(levelCounts(lesson).size(), 0), best_min, 7, "Иванов Пётр",
                   "ТМ-31");
}

inline Answer answerTo(const Lesson& lesson, std::size_t step) {
    const Goal& goal = lesson.steps[step].goal;
    Answer answer;
    if (goal.choice) {
        answer.chosen = {{1}};
    } else if (goal.text) {
        answer.text = "Зона с большим числом проходов меньше.";
    } else if (isMetBySetting(goal.kind())) {
        answer.setup.text = writeSetup(setupOf(lesson, step));
    } else {
        const GoalResult engine = checkStep(lesson, step, {});
        answer.number = goal.prediction ? engine.value : std::nullopt;
        if (goal.curve) {
            answer.curve.emplace();
            for (const ComparedPoint& point : engine.curve) {
                answer.curve->push_back({point.at, point.value});
            }
        }
        if (goal.order) {
            answer.order.emplace(engine.order.begin(), engine.order.end());
        }
    }
    return answer;
}

inline void handIn(Work& work, std::size_t step) {
    WorkEntry entry;
    entry.event =
        isPrediction(work.lesson.steps[step].goal) ? WorkEvent::prediction : WorkEvent::attempt;
    entry.step = static_cast<int>(step) + 1;
    entry.when = "2026-11-26T10:00:00Z";
    entry.answer = answerTo(work.lesson, step);
    addEntry(work, std::move(entry));
}

inline void keep(Work& work, const Project& project, const char* name) {
    const OutcomePtr outcome = evaluate(project, {});
    WorkEntry entry;
    entry.event = WorkEvent::run;
    entry.step = static_cast<int>(work.lesson.steps.size());
    entry.when = "2026-11-26T11:00:00Z";
    entry.run = keptRun(outcome->result,
                        summarise(outcome->result, outcome->accuracy, outcome->constraints), name,
                        entry.when);
    addEntry(work, std::move(entry));
}

/// Every step answered, and a run kept with half the stock in the first stage fed twice as slowly.
inline Work finished(const Lesson& lesson) {
    Work work = givenOut(lesson);
    for (std::size_t i = 0; i < work.lesson.steps.size(); ++i) {
        handIn(work, i);
    }
    Project project = work.lesson.base.surfaces.front().project;
    auto& feed = project.cycle->stages.front().*project.operation->radial().value;
    if (feed) {
        feed = *feed / 2;
    }
    keep(work, project, "медленнее");
    return work;
}

inline report::PaperWish wish() {
    report::PaperWish wish;
    wish.institution.ministry = "Министерство науки и высшего образования РФ";
    wish.institution.university = "Южный университет";
    wish.institution.department = "Кафедра технологии машиностроения";
    wish.institution.discipline = "Технология шлифования";
    wish.institution.accepted = "доцент Петров П. П.";
    wish.institution.place = "Челябинск";
    wish.file = QStringLiteral("/tmp/work.sparkout-work");
    wish.date = QDate(2026, 11, 26);
    return wish;
}

inline QStringList headingsOf(const Report& report) {
    QStringList headings;
    for (const report::Block& block : report.blocks) {
        if (const auto* heading = std::get_if<report::Heading>(&block)) {
            headings << heading->text;
        }
    }
    return headings;
}

/// All cells of all tables but their heads.
inline QStringList cellsOf(const Report& report) {
    QStringList cells;
    for (const report::Block& block : report.blocks) {
        if (const auto* table = std::get_if<report::Table>(&block)) {
            for (const QStringList& row : table->rows) {
                cells << row;
            }
        } else if (const auto* facts = std::get_if<report::Facts>(&block)) {
            for (const auto& [name, value] : facts->facts) {
                cells << value;
            }
        }
    }
    return cells;
}

/// The text of the web page, without figures' texts.
inline QString textOf(const Report& report) {
    Report plain = report;
    std::erase_if(plain.blocks, [](const report::Block& block) {
        return std::holds_alternative<report::Figure>(block);
    });
    return reading::textOfHtml(bytesOf(plain, report::Format::html));
}

/// The papers of a lesson, and of a work of it that is done.
inline std::vector<Report> allPapers(const Lesson& lesson) {
    const Work work = finished(lesson);
    return {report::labReport(work, wish()), report::worksheet(work, wish()),
            report::worksheetKey(lesson, wish()), report::methodicalGuide(lesson, wish())};
}

} // namespace sparkout::course_bench
