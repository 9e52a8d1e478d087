// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Goals of the shipped lessons as the window states them.
#include "ui/text/goal_text.h"

#include "core/lesson/lesson_file.h"
#include "tests/registry.h"
#include "ui/text/language.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>

namespace sparkout::test_goal_text {

QList<Lesson> lessons() {
    const QDir folder(QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/lessons"));
    QList<Lesson> read;
    for (const QString& name : folder.entryList({QStringLiteral("*.sparkout-lesson")})) {
        QFile file(folder.filePath(name));
        if (file.open(QIODevice::ReadOnly)) {
            read << readLesson(file.readAll().toStdString()).lesson.value();
        }
    }
    return read;
}

class TestGoalText : public QObject {
    Q_OBJECT

private slots:
    void questionsAreRussianInARussianWindow() {
        Language language;
        language.apply(QStringLiteral("ru"));
        static const QRegularExpression words(QStringLiteral("[A-Za-z]{4,}|\\{"));
        int questions = 0;
        for (const Lesson& lesson : lessons()) {
            for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
                const QString asked =
                    GoalText::asked(lesson.steps[step].goal, projectOf(lesson, step));
                QVERIFY2(asked.endsWith(u'.') && !asked.contains(words), qPrintable(asked));
                ++questions;
            }
        }
        QVERIFY(questions > 50);
        language.apply(QStringLiteral("en"));
    }

    void resultIsASentenceInTheWindowsNumbers() {
        Goal goal;
        goal.time.emplace();
        GoalResult result;
        result.finding = Finding::failed;
        result.value = 2.61;
        result.asked = 2.5;
        result.failing = {ConstraintKind::roundness};
        Language language;
        language.apply(QStringLiteral("ru"));
        QCOMPARE(GoalText::found(goal, result, {}, false),
                 QStringLiteral("Не выполнено: время цикла 2,610 мин, предел 2,500 мин; "
                                "не выполнено: отклонение от круглости."));
        language.apply(QStringLiteral("en"));
        QCOMPARE(GoalText::found(goal, result, {}, false),
                 QStringLiteral("Not passed: cycle time 2.610 min, limit 2.500 min; "
                                "not met: roundness."));
    }
};

} // namespace sparkout::test_goal_text

SPARKOUT_TEST(test_goal_text, TestGoalText)
#include "test_goal_text.moc"
