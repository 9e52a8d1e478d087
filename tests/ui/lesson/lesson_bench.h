// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/safe_file.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/work.h"
#include "tests/core/lesson/class_samples.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/view.h"
#include "ui/form/number_field.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/lesson/answer_field.h"
#include "ui/lesson/lesson_desk.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/window/file_commands.h"
#include "ui/window/view_tabs.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

/// A window in which a student does a laboratory work, by mouse and keys.
namespace lesson_bench {

using namespace sparkout;

inline QString shippedLesson() {
    return QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/lessons/02-actual-feed.sparkout-lesson");
}

/// A work of one student, as it is given out.
inline samples::GivenOut givenOut(const QString& path = shippedLesson()) {
    const Lesson lesson =
        *readLesson(std::get<std::string>(readFile(path.toStdString(), 1u << 24))).lesson;
    return samples::giveOut(lesson, 1, 1);
}

struct Seat {
    explicit Seat(const QString& language = QStringLiteral("en"), Theme theme = Theme::light,
                  const QString& lesson = shippedLesson())
        : bench(language, theme), window(*bench.window), out(givenOut(lesson)) {
        desk().protect(folder.path());
    }

    [[nodiscard]] LessonDesk& desk() const { return window.lesson(); }
    [[nodiscard]] LessonRun& run() const { return desk().run(); }
    [[nodiscard]] LessonPanel& panel() const { return desk().panel(); }
    [[nodiscard]] QString file() const {
        return folder.filePath(QStringLiteral("work.sparkout-work"));
    }
    void writeWork(const Work& work) const {
        QVERIFY(!writeFileSafely(file().toStdString(), sparkout::writeWork(work)));
    }
    /// The work on the disk.
    [[nodiscard]] Work onDisk() const {
        run().flush();
        return *readWork(std::get<std::string>(readFile(file().toStdString(), 1u << 24))).work;
    }
    /// Opens the work as it was given out, or with predictions that were given before.
    void begin(const std::vector<std::size_t>& predicted = {}) {
        Work work = out.works.front();
        for (const std::size_t step : predicted) {
            samples::handIn(work, step, samples::scripted(out, 0, step, true),
                            "2026-11-26T10:00:00Z");
        }
        writeWork(work);
        window.files().openInstead(file());
        settle();
    }
    void settle() const {
        QVERIFY(QTest::qWaitFor([this] { return !window.runs().running(); }, 30'000));
        QTest::qWait(30);
        bench.settle();
    }
    void show(std::size_t step) const {
        desk().showStep(step);
        settle();
    }
    template <typename Widget>
    [[nodiscard]] Widget* part(const char* name) const {
        return panel().findChild<Widget*>(QString::fromLatin1(name));
    }
    /// A click as the windowing system sends it, with the part scrolled into sight.
    void click(QWidget& widget) const {
        for (QWidget* up = widget.parentWidget(); up; up = up->parentWidget()) {
            if (auto* area = qobject_cast<QScrollArea*>(up)) {
                area->ensureWidgetVisible(&widget);
            }
        }
        QTest::qWait(20);
        QTest::mouseClick(window.windowHandle(), Qt::LeftButton, Qt::NoModifier,
                          widget.mapTo(&window, widget.rect().center()));
    }
    void type(QWidget& field, const QString& text) const {
        field.setFocus();
        QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Tab);
    }
    void typeNumber(const char* name, double value) const {
        type(*part<NumberField>(name), QString::number(value, 'g', 5));
    }
    /// Types a number into a cell of the table of stages.
    void typeStage(int row, const char* key, double value) const {
        auto* table = window.inputs().findChild<QTableView*>(QStringLiteral("/cycle/stages"));
        window.inputs().focusPath("/cycle/stages/" + std::to_string(row) + "/" + key);
        QTest::qWait(20);
        table->setFocus();
        QTest::keyClick(table, Qt::Key_F2);
        auto* editor = table->findChild<NumberField*>();
        QVERIFY(editor);
        QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(editor, QString::number(value, 'g', 12));
        QTest::keyClick(editor, Qt::Key_Return);
        settle();
    }
    void handIn() const {
        click(*part<QPushButton>("lessonHandIn"));
        QVERIFY(QTest::qWaitFor(
            [this] { return run().mark(run().step()) != LessonRun::Mark::checked; }, 30'000));
        settle();
    }
    /// Answers the step in front as the script does, by mouse and keys.
    void answer(bool right = true) const {
        const std::size_t step = run().step();
        const Goal& goal = run().current().goal;
        const Answer wanted = samples::scripted(out, 0, step, right);
        if (goal.choice) {
            for (const double option : *wanted.chosen) {
                click(*part<QCheckBox>(qPrintable(QStringLiteral("option%1").arg(option))));
            }
        } else if (goal.text) {
            part<QPlainTextEdit>("answerText")->setFocus();
            QTest::keyClicks(part<QPlainTextEdit>("answerText"),
                             QString(30, u'a') + u' ' + QString(60, u'b'));
        } else if (goal.prediction) {
            typeNumber("predictedNumber", *wanted.number);
        } else if (goal.curve) {
            for (std::size_t i = 0; i < wanted.curve->size(); ++i) {
                typeNumber(qPrintable(QStringLiteral("curveValue%1").arg(i + 1)),
                           (*wanted.curve)[i][1]);
            }
        } else if (goal.order) {
            auto* list = part<QListWidget>("predictedOrder");
            for (std::size_t to = 0; to < wanted.order->size(); ++to) {
                int from = 0;
                while (list->item(from)->data(Qt::UserRole).toInt() != int((*wanted.order)[to])) {
                    ++from;
                }
                list->setCurrentRow(from);
                for (; from > int(to); --from) {
                    QTest::keyClick(list, Qt::Key_Up, Qt::ControlModifier);
                }
            }
        } else {
            const Setup setup = *readSetup(wanted.setup.text).setup;
            const auto& stages = setup.surfaces.front().project.cycle->stages;
            for (std::size_t i = 0; i < stages.size(); ++i) {
                const auto& now = window.document().project().cycle->stages[i];
                if (now.radial_feed_mm != stages[i].radial_feed_mm) {
                    typeStage(int(i), "radial_feed_mm", *stages[i].radial_feed_mm);
                }
                if (now.axial_feed_mm_min != stages[i].axial_feed_mm_min) {
                    typeStage(int(i), "axial_feed_mm_min", *stages[i].axial_feed_mm_min);
                }
                if (now.stock_mm != stages[i].stock_mm) {
                    typeStage(int(i), "stock_mm", stages[i].stock_mm);
                }
            }
        }
    }

    QTemporaryDir folder;
    Bench bench;
    MainWindow& window;
    samples::GivenOut out;
};

} // namespace lesson_bench
