// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The form of a struct that has a table: its rows give names, units, hints and ranges.
#include "ui/form/struct_form.h"

#include "core/lesson/lesson.h"
#include "core/setup/setup.h"
#include "tests/registry.h"
#include "ui/session/settings.h"
#include "ui/text/hint_text.h"
#include "ui/text/texts.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QWheelEvent>

namespace sparkout::test_struct_form {

void typeOver(QLineEdit& line, const QString& text) {
    line.selectAll();
    QTest::keyClick(&line, Qt::Key_Delete);
    QTest::keyClicks(&line, text);
}

class TestStructForm : public QObject {
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void theRowsGiveNamesUnitsAndHints() {
        SetupTimes times;
        times.approach_s = 3;
        QWidget page;
        const StructForm* const form = StructForm::over(times, &page);
        QStringList labels;
        for (const QLabel* label : form->findChildren<QLabel*>()) {
            labels += label->text();
        }
        for (const Field& field : tableOf<SetupTimes>().fields) {
            const auto* number =
                form->findChild<NumberField*>(u'/' + QString::fromLatin1(field.key));
            QVERIFY2(number, field.key);
            const QString unit =
                *field.unit ? QStringLiteral(", ") + unitText(field.unit) : QString();
            QCOMPARE(number->accessibleName(), inputText(field.label) + unit);
            QCOMPARE(number->toolTip(), hintMarkup(field));
            QVERIFY2(number->accessibleDescription().contains(inputText(field.hint)), field.key);
            QVERIFY2(labels.contains(labelMarkup(field) + unit), field.key);
        }
        QCOMPARE(form->findChild<NumberField*>(QStringLiteral("/approach_s"))->text(),
                 QStringLiteral("3"));
        QCOMPARE(form->findChild<NumberField*>(QStringLiteral("/main_min"))->placeholderText(),
                 inputText("the sum of the cycles"));
    }

    void valuesAreTakenAndTextsOutOfRangeAreNot() {
        SetupTimes times;
        times.approach_s = 3;
        QWidget page;
        const StructForm* const form = StructForm::over(times, &page);
        QSignalSpy edited(form, &StructForm::edited);
        auto* approach = form->findChild<NumberField*>(QStringLiteral("/approach_s"));
        typeOver(*approach, QStringLiteral("4000"));
        QCOMPARE(times.approach_s, 3.0);
        const std::vector<Refusal> refused = StructForm::refusals(page);
        QCOMPARE(refused.size(), std::size_t(1));
        QCOMPARE(refused.front().path, std::string("/approach_s"));
        const QString range = rangeShown(tableOf<SetupTimes>().find("approach_s")->hard, "s");
        QVERIFY2(refused.front().reason.contains(range), qPrintable(refused.front().reason));
        edited.clear();
        typeOver(*approach, QStringLiteral("4"));
        QCOMPARE(times.approach_s, 4.0);
        QVERIFY(StructForm::refusals(page).empty());
        QVERIFY(!edited.isEmpty());
        auto* main = form->findChild<NumberField*>(QStringLiteral("/main_min"));
        typeOver(*main, QStringLiteral("2.5"));
        QCOMPARE(times.main_min, std::optional(2.5));
        typeOver(*main, {});
        QVERIFY(!times.main_min);
        typeOver(*form->findChild<NumberField*>(QStringLiteral("/batch_size")),
                 QStringLiteral("12"));
        QCOMPARE(times.batch_size, 12);
    }

    void aTextIsNoLongerThanItsRowAllows() {
        CompanyTexts texts;
        texts.approved = "Громов";
        QWidget page;
        const StructForm* const form = StructForm::over(texts, &page);
        auto* name = form->findChild<QLineEdit*>(QStringLiteral("/name"));
        QCOMPARE(name->maxLength(), 200);
        QCOMPARE(name->accessibleName(), inputText("Company"));
        QVERIFY(name->toolTip().isEmpty());
        typeOver(*name, QStringLiteral("Stankomash"));
        QCOMPARE(texts.name, std::string("Stankomash"));
        QCOMPARE(form->findChild<QLineEdit*>(QStringLiteral("/approved"))->text(),
                 QStringLiteral("Громов"));
    }

    void aListIsNumbersWithSemicolonsAsInTheInputs() {
        VariedInput input;
        input.list = std::vector{1.0, 2.0};
        QWidget page;
        const StructForm* const form = StructForm::over(input, &page);
        auto* list = form->findChild<QLineEdit*>(QStringLiteral("/list"));
        QCOMPARE(list->text(), QStringLiteral("1; 2"));
        typeOver(*list, QStringLiteral("1; 2.5; 4"));
        QCOMPARE(input.list, std::optional(std::vector{1.0, 2.5, 4.0}));
        QVERIFY(StructForm::refusals(page).empty());
        typeOver(*list, QStringLiteral("1; x"));
        QCOMPARE(StructForm::refusals(page).front().path, std::string("/list"));
        typeOver(*list, {});
        QVERIFY2(input.list && !StructForm::refusals(page).empty(), "it is a list still");
    }

    void theWheelChangesNoChoice() {
        LessonStep step;
        QWidget page;
        const StructForm* const form = StructForm::over(step, &page);
        auto* others = form->findChild<QComboBox*>(QStringLiteral("/others"));
        QVERIFY(others && others->count() > 1 && !others->toolTip().isEmpty());
        const int chosen = others->currentIndex();
        for (const int turn : {-120, 120}) {
            QWheelEvent wheel({1, 1}, others->mapToGlobal(QPointF(1, 1)), {}, {0, turn},
                              Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(others, &wheel);
            QCOMPARE(others->currentIndex(), chosen);
        }
    }
};

} // namespace sparkout::test_struct_form

SPARKOUT_TEST(test_struct_form, TestStructForm)
#include "test_struct_form.moc"
