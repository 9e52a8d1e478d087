// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Sections and parts are counted from 1 on screen and on paper, from 0 in the file.
#include "core/batch/sweep_run.h"
#include "core/file/project_file.h"
#include "core/project/validate.h"
#include "core/study/new_project.h"
#include "core/study/operation.h"
#include "tests/ui/support/typing.h"
#include "tests/ui/support/untitled.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/form/number_field.h"
#include "ui/inputs/form_page.h"
#include "ui/report/cycle_card.h"
#include "ui/report/format/report_text.h"
#include "ui/results/run_table.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/study/sweep_shown.h"

#include "tests/registry.h"

#include <QLocale>

#include <algorithm>
#include <optional>
#include <variant>

namespace sparkout::test_section_numbers {

Project fourSections(std::optional<int> gauged) {
    Project project = withSections(newProject(Operation::plunge), 4);
    project.gauge->section = gauged;
    return project;
}

class TestSectionNumbers : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }

    void theFirstSectionIsOne() {
        QCOMPARE(Names::zone(Zone::section, 0), QStringLiteral("Section 1"));
        QCOMPARE(Names::zoneFull(Zone::section, 3), QStringLiteral("Section 4"));
        QCOMPARE(Names::part(0), QStringLiteral("1"));
        QCOMPARE(locationText("/machine/compliance_mm_per_n/0").section(QStringLiteral(" › "), -1),
                 QStringLiteral("Section 1"));
    }

    void theFieldOfTheGaugeTakesANumberFromOne() {
        Untitled document(fourSections(3));
        FormPage page(Page::gauge, document);
        page.show();
        auto* field = page.findChild<NumberField*>(QStringLiteral("/gauge/section"));
        QVERIFY(field && field->isVisible());
        QCOMPARE(field->text(), QStringLiteral("4"));
        QVERIFY2(field->toolTip().contains(QStringLiteral("1 to 200")),
                 qPrintable(field->toolTip()));

        const auto type = [field](const QString& text) {
            typeOver(*field, text);
            QTest::keyClick(field, Qt::Key_Return);
        };
        type(QStringLiteral("1"));
        QCOMPARE(document.project().gauge->section, std::optional(0));
        QVERIFY(writeProject(document.project()).find("\"section\": 0") != std::string::npos);
        QTest::keyClick(field, Qt::Key_Up);
        QCOMPARE(field->text(), QStringLiteral("2"));
        QCOMPARE(document.project().gauge->section, std::optional(1));
        type(QStringLiteral("1+2"));
        QCOMPARE(field->text(), QStringLiteral("3"));
        QCOMPARE(document.project().gauge->section, std::optional(2));
        type(QStringLiteral("0"));
        QVERIFY(field->refused());
        QVERIFY2(field->refusal().contains(QStringLiteral("1 to 200")),
                 qPrintable(field->refusal()));
        QCOMPARE(document.project().gauge->section, std::optional(2));
        QTest::keyClick(field, Qt::Key_Escape);
        QCOMPARE(field->text(), QStringLiteral("3"));
        document.undo();
        QVERIFY(document.project().gauge->section != std::optional(2));
    }

    void aMessageCountsAsTheFieldDoes() {
        const Issues issues = validate(fourSections(4));
        const auto found = std::ranges::find(issues, "/gauge/section", &Issue::path);
        QVERIFY(found != issues.end());
        const QString text = issueText(*found);
        QVERIFY2(text.startsWith(u'5') && text.contains(QStringLiteral("1…4")), qPrintable(text));
    }

    void anInputInATableCountsAsTheFieldDoes() {
        const CsvTable table = inputTable(fourSections(0));
        const auto row = std::ranges::find_if(table.rows, [](const auto& cells) {
            const auto* key = std::get_if<QString>(&cells.back());
            return key && *key == u"/gauge/section";
        });
        QVERIFY(row != table.rows.end());
        QCOMPARE(std::get<double>((*row)[3]), 1.0);
        SweptInput swept;
        swept.axis.input = "/gauge/section";
        QCOMPARE(SweepText::inputValue(0, swept), QStringLiteral("1"));
    }

    void theCardHasTheFirstSectionAsOne() {
        Project project = fourSections(0);
        const OutcomePtr outcome = evaluate(project, {});
        QVERIFY(outcome->ran());
        const auto card =
            report::CycleCard::write(outcome, QStringLiteral("a.sparkout"), QDate(2026, 11, 22));
        const QString text = QString::fromUtf8(bytesOf(card, report::Format::markdown));
        QVERIFY(text.contains(QStringLiteral("Section 1")));
        QVERIFY(!text.contains(QStringLiteral("Section 0")));
        QVERIFY2(text.contains(QStringLiteral("; 1: 0")), qPrintable(text)); // of the sketch
    }
};

} // namespace sparkout::test_section_numbers

SPARKOUT_TEST(test_section_numbers, TestSectionNumbers)
#include "test_section_numbers.moc"
