// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
#include "core/file/project_file.h"
#include "core/study/operation.h"
#include "core/study/search_edits.h"
#include "tests/registry.h"
#include "tests/ui/inputs/inputs_bench.h"
#include "tests/ui/support/typing.h"
#include "tests/ui/support/untitled.h"
#include "ui/inputs/form_page.h"
#include "ui/inputs/page_columns.h"
#include "ui/text/hint_text.h"
#include "ui/text/texts.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPointer>
#include <QTextDocumentFragment>

namespace sparkout::test_forms {

using namespace inputs_bench;
using inputs_bench::Bench;

/// Types into the widget of a row, whatever it is, so that its value changes.
void changeByHand(QWidget* widget, int places) {
    widget->setFocus();
    if (auto* number = qobject_cast<NumberField*>(widget)) {
        const QString before = number->text();
        QTest::keyClick(number, Qt::Key_Up);
        if (number->text() == before) {
            QTest::keyClick(number, Qt::Key_Down);
        }
        if (number->text() == before) { // empty: not given
            QTest::keyClicks(number, QStringLiteral("10"));
        }
        QTest::keyClick(number, Qt::Key_Return);
    } else if (auto* line = qobject_cast<QLineEdit*>(widget)) {
        const bool rows = line->objectName().endsWith(QStringLiteral("/n_um_at_n"));
        const bool zones = line->objectName().contains(QStringLiteral("/zone_"))
                           || line->objectName().contains(QStringLiteral("/form/"));
        const bool ends = line->objectName().endsWith(QStringLiteral("/wheel_width_mm"));
        if (ends) {
            line->selectAll();
        }
        QTest::keyClicks(line, rows    ? QStringLiteral("0 50; 200 80")
                               : ends  ? QStringLiteral("40; 80")
                               : zones ? QStringLiteral("0.001; ").repeated(places)
                                       : QStringLiteral("x"));
        QTest::keyClick(line, Qt::Key_Return);
    } else if (auto* text = qobject_cast<QPlainTextEdit*>(widget)) {
        QTest::keyClicks(text, QStringLiteral("x"));
    } else if (auto* choice = qobject_cast<QComboBox*>(widget)) {
        const bool last = choice->currentIndex() == choice->count() - 1;
        QTest::keyClick(choice, last ? Qt::Key_Up : Qt::Key_Down);
    } else if (auto* tick = qobject_cast<QCheckBox*>(widget)) {
        QTest::keyClick(tick, Qt::Key_Space);
    } else if (const auto numbers = widget->findChildren<NumberField*>(); numbers.size() == 3) {
        for (qsizetype i = 0; i < 3; ++i) { // lowest, highest, step
            numbers[i]->setFocus();
            numbers[i]->selectAll();
            QTest::keyClicks(numbers[i], QStringList{u"1"_qs, u"5"_qs, u"0.5"_qs}[i]);
            QTest::keyClick(numbers[i], Qt::Key_Return);
        }
    } else {
        QFAIL("no way to edit this widget");
    }
}

class TestForms : public QObject {
    Q_OBJECT

private slots:
    // Whoever enters a range compares it with the feed it is the range of.
    void theRangeOfAFeedHasTheUnitOfTheFeed() {
        const StructInfo& ranges = tableOf<MachineLimits>();
        const StructInfo& stage = tableOf<Stage>();
        const std::pair<const char*, const char*> pairs[] = {
            {"radial_feed_mm", "radial_feed_mm"},
            {"axial_feed_mm_min", "axial_feed_mm_min"},
            {"plunge_feed_mm_min", "radial_feed_mm_min"}};
        const auto limitsOf = [](const Field& field) {
            return QTextDocumentFragment::fromHtml(limitsMarkup(field)).toPlainText();
        };
        for (const auto& [range, feed] : pairs) {
            const QString unit = unitText(stage.find(feed)->unit);
            QCOMPARE(unitText(ranges.find(range)->unit), unit);
            QVERIFY2(limitsOf(*ranges.find(range)).contains(unit), range);
        }
    }

    void aColumnOfASpreadsheetBecomesAListOrIsRefusedWithItsCell() {
        QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
        Untitled document(withUsualSearch(newProject(Operation::traverse)));
        FormPage page(Page::search, document);
        page.show();
        auto* line = page.findChild<QLineEdit*>(QStringLiteral("/optimisation/radial_feed_mm"));
        QVERIFY(line);
        const auto stored = [&document] { return document.project().optimisation->radial_feed_mm; };
        const Levels before = stored();
        const auto paste = [line](const char* text) {
            QApplication::clipboard()->setText(QString::fromUtf8(text));
            line->setFocus();
            QTest::keySequence(line, QKeySequence::Paste);
        };
        const auto refusal = [&page] {
            for (const FormRow* row : page.rows()) {
                if (row->editor().path() == "/optimisation/radial_feed_mm") {
                    return row->editor().remark().reason;
                }
            }
            return QString();
        };
        paste("0,002\n0,003\nabc\n");
        QVERIFY2(refusal().contains(QStringLiteral("row 3: “abc” is not a number")),
                 qPrintable(refusal()));
        QCOMPARE(stored(), before);
        QVERIFY(!document.canUndo());
        QVERIFY2(page.refusals().empty(), "what stands in the field was not refused");
        Project edited = document.project();
        edited.title = "Another title";
        document.edit(edited, {"Edit", "Edit"});
        QVERIFY2(refusal().isEmpty(), qPrintable(refusal()));
        document.undo();
        paste("0,002\n7\n");
        QVERIFY2(refusal().contains(QStringLiteral("row 2: “7” is out of range; allowed: ")),
                 qPrintable(refusal()));
        paste("0,002\t0.003\t0,004\r\n");
        QCOMPARE(stored(), Levels(std::vector{0.002, 0.003, 0.004}));
        QCOMPARE(line->text(), QStringLiteral("0.002; 0.003; 0.004"));
        QVERIFY(refusal().isEmpty());
        document.undo();
        QCOMPARE(stored(), before);
        QVERIFY(!document.canUndo());
    }

    void aNumberOfSectionsTypedDigitByDigitKeepsTheirComplianceAndTheRuns() {
        Document document;
        Project project = newProject(Operation::plunge);
        project = withSections(std::move(project), 4);
        project.machine->compliance_mm_per_n = std::vector{6e-5, 7e-5, 8e-5, 9e-5};
        project.gauge->section = 3;
        project.runs = {{"kept", "2026-01-01T00:00:00Z", "1.0.0", {"{}"}, {"{}"}}};
        document.startUntitled(project);
        FormPage page(Page::cycle, document);
        page.show();
        NumberField* sections = nullptr;
        for (NumberField* field : page.findChildren<NumberField*>()) {
            if (field->objectName() == QStringLiteral("/sections")) {
                sections = field;
            }
        }
        QVERIFY(sections);
        typeOver(*sections, QStringLiteral("12"));
        QVERIFY(sameProject(document.project(), withSections(project, 12)));
        QCOMPARE(document.project().gauge->section, project.gauge->section);
        QVERIFY(document.project().runs == project.runs);
        document.undo();
        QVERIFY(sameProject(document.project(), project));
        QVERIFY(document.project().runs == project.runs);
    }

    void everyVisibleFieldOfEveryPageChangesTheProjectAndCanBeUndone_data() {
        QTest::addColumn<int>("operation");
        QTest::newRow("traverse") << int(Operation::traverse.index());
        QTest::newRow("plunge") << int(Operation::plunge.index());
    }

    void everyVisibleFieldOfEveryPageChangesTheProjectAndCanBeUndone() {
        QFETCH(int, operation);
        Document document;
        Project project = newProject(Operation::ofIndex(std::size_t(operation)));
        project.machine->stiffness_n_um.emplace();
        project.machine->wheel_contact.emplace();
        project.machine->form.emplace();
        project.wheel->force_recipe.emplace();
        project.wheel->measured_ra.emplace();
        project.wheel->runout.emplace().amplitude_um = 0.5;
        project.machine->work_speed_variation.emplace();
        resolveWaves(project);
        document.startUntitled(project);
        InputsPanel panel(document);
        panel.resize(360, 640);
        panel.show();
        document.startUntitled(project);
        int edited = 0;
        for (int page = 0; page < static_cast<int>(panel.pages().size()); ++page) {
            panel.showPage(page);
            for (const FormRow* row : panel.pages()[std::size_t(page)]->rows()) {
                QWidget* widget = row->editor().widget();
                if (!widget->isVisible()) {
                    continue;
                }
                ++edited;
                const QByteArray name = QByteArray::fromStdString(row->editor().path());
                if (name == "/wheel/roughness_factor") {
                    // Beside a measured Ra a 1 that is typed stands for the factor of that one.
                    Project without = document.project();
                    without.wheel->measured_ra.reset();
                    document.edit(without, {"Input", "Measured Ra"});
                }
                const std::string before = writeProject(document.project());
                changeByHand(widget, placeCount(document.project()));
                QVERIFY2(writeProject(document.project()) != before, name);
                document.undo();
                QVERIFY2(writeProject(document.project()) == before, name);
                if (name == "/wheel/roughness_factor") {
                    document.undo(); // measured again
                }
                QVERIFY2(!widget->accessibleName().isEmpty(), name);
                QVERIFY2(!widget->toolTip().isEmpty(), name);
            }
        }
        QVERIFY2(edited > 30, qPrintable(QString::number(edited)));
    }

    void rowsThatAreNoneAreRefusedAndStayInSight() {
        Document document;
        Project project = newProject(Operation::plunge);
        project.machine->wheel_contact.emplace();
        document.startUntitled(project);
        FormPage page(Page::machine, document);
        page.show();
        auto* line = page.findChild<QLineEdit*>(QStringLiteral("/machine/wheel_contact/n_um_at_n"));
        QVERIFY(line);
        for (const QString& text : {u"50"_qs, u"0 x"_qs, u"10 50; 5 80"_qs, u"0 0"_qs}) {
            typeOver(*line, text);
            QTest::keyClick(line, Qt::Key_Return);
            QCOMPARE(line->text(), text);
            QCOMPARE(page.refusals().size(), std::size_t(1));
            const NumberRows& kept = document.project().machine->wheel_contact->n_um_at_n;
            const NumberRows begun{{{10, 50}}}; // in order until it was typed on
            QVERIFY2(!kept || kept == begun, qPrintable(text));
        }
        line->selectAll();
        QTest::keyClicks(line, u"0 50,5; 200 80.25"_qs);
        QTest::keyClick(line, Qt::Key_Return);
        QVERIFY(page.refusals().empty());
        const NumberRows rows{{{0, 50.5}, {200, 80.25}}};
        QVERIFY(document.project().machine->wheel_contact->n_um_at_n == rows);
    }

    void everyFieldLeavesUndoToTheDocument() {
        Document document;
        Project project = newProject(Operation::plunge);
        project.machine->wheel_contact.emplace();
        document.startUntitled(project);
        int fields = 0;
        for (const Page page :
             {Page::part, Page::material, Page::wheel, Page::machine, Page::gauge, Page::cycle}) {
            FormPage form(page, document);
            form.show();
            QList<QWidget*> texts;
            for (QLineEdit* line : form.findChildren<QLineEdit*>()) {
                if (line->objectName().startsWith(u'/')) { // a member of the project
                    texts += line;
                }
            }
            for (QPlainTextEdit* text : form.findChildren<QPlainTextEdit*>()) {
                texts += text;
            }
            for (QWidget* text : texts) {
                QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
                undo.ignore();
                QCoreApplication::sendEvent(text, &undo);
                QVERIFY2(!undo.isAccepted(), qPrintable(text->objectName()));
                ++fields;
            }
        }
        QVERIFY(fields > 30);
    }

    // A field loses the focus while it goes, and its row would look at what is gone.
    void theRowsOfAPageGoBeforeTheirFields() {
        Document document;
        auto page = std::make_unique<FormPage>(Page::machine, document);
        page->build();
        int fields = 0, rowsLeft = 0;
        for (FormRow* row : page->rows()) {
            const QPointer<FormRow> alive(row);
            connect(row->editor().widget(), &QObject::destroyed, this, [&, alive] {
                ++fields;
                rowsLeft += !alive.isNull();
            });
        }
        const int rows = static_cast<int>(page->rows().size());
        QVERIFY(rows > 5);
        page.reset();
        QCOMPARE(fields, rows);
        QCOMPARE(rowsLeft, 0);
    }

    // The window begins with one page of eight.
    void aPageIsBuiltWhenItIsWantedWithWhatHoldsByThen() {
        Project project = newProject(Operation::traverse);
        project.part->diameter_mm = 41;
        project.part->radii_per_section = 35; // an odd number
        Bench bench(project);
        bench.showIssues();
        const auto diameter = QStringLiteral("/part/diameter_mm");
        QVERIFY(!bench.panel.findChild<NumberField*>(diameter));
        bench.panel.focusPath("/part/radii_per_section");
        auto* radii = bench.field("/part/radii_per_section");
        QVERIFY(radii && radii->isVisible());
        QCOMPARE(radii->remark().mark, Mark::error);
        QCOMPARE(bench.panel.findChild<NumberField*>(diameter)->value(), 41.0);
        project.part->diameter_mm = 42;
        bench.document.startUntitled(project);
        QCOMPARE(bench.panel.findChild<NumberField*>(diameter)->value(), 42.0);
        QVERIFY(!bench.field("/wheel/diameter_mm"));
        QCOMPARE(bench.panel.pages().size(), std::size_t{8});
        QVERIFY(bench.field("/wheel/diameter_mm"));
    }

    void typingInTheMiddleOfATextStaysThere() {
        Project project = newProject(Operation::traverse);
        project.title = "Shaft";
        Bench bench(project, partPage);
        auto* title = bench.find<QLineEdit>("/title");
        title->setFocus();
        QTest::keyClick(title, Qt::Key_Home);
        QTest::keyClicks(title, QStringLiteral("My "));
        QCOMPARE(bench.project().title, std::string("My Shaft"));
        bench.document.undo();
        QCOMPARE(title->text(), QStringLiteral("Shaft"));
    }

    void aMachineRangeIsTakenWhenAllThreeNumbersMakeOne() {
        Bench bench(machinePage);
        const auto* body = bench.find<QWidget>("/machine/limits/radial_feed_mm");
        QVERIFY(body);
        const auto numbers = body->findChildren<NumberField*>();
        QCOMPARE(numbers.size(), 3);
        const auto type = [&numbers](qsizetype i, const char* text) {
            numbers[i]->setFocus();
            numbers[i]->selectAll();
            QTest::keyClicks(numbers[i], QString::fromLatin1(text));
            QTest::keyClick(numbers[i], Qt::Key_Return);
        };
        const auto& range = bench.project().machine->limits.radial_feed_mm;
        type(0, "0.05");
        QVERIFY(!range);
        QCOMPARE(bench.panel.refusals().size(), 1u);
        type(1, "0.01");
        type(2, "0.0005");
        QVERIFY2(!range, "the lowest is above the highest");
        type(0, "0.001");
        QCOMPARE(range.value(), (std::vector<double>{0.001, 0.01, 0.0005}));
        QVERIFY(bench.panel.refusals().empty());
        type(1, "x");
        QCOMPARE(numbers[1]->text(), QStringLiteral("x"));
        QCOMPARE(range.value()[1], 0.01);
        QCOMPARE(bench.panel.refusals().size(), 1u);
        QVERIFY(bench.panel.dropNewestRefusal());
        QCOMPARE(numbers[1]->text(), QLocale().toString(0.01));
    }

    void rowsOfTheOtherOperationAreHidden() {
        Bench bench(newProject(Operation::plunge), machinePage);
        QVERIFY(!bench.find<QWidget>("/machine/dwell_entry_s")->isVisible());
        bench.document.startUntitled(newProject(Operation::traverse));
        QVERIFY(bench.find<QWidget>("/machine/dwell_entry_s")->isVisible());
    }

    void switchingTheOperationIsOneUndoableEditThatGivesAValidProject() {
        Bench bench(newProject(Operation::traverse), cyclePage);
        const std::string before = writeProject(bench.project());
        auto* box = bench.find<QComboBox>("/operation");
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Down);
        QCOMPARE(bench.project().operation, Operation::plunge);
        QVERIFY(!hasErrors(validate(bench.project())));
        bench.document.undo();
        QVERIFY(!bench.document.canUndo());
        QCOMPARE(writeProject(bench.project()), before);
    }

    void eachValueOfTheComplianceIsEditable() {
        Bench bench(machinePage);
        auto* nz = bench.field("/machine/compliance_mm_per_n/nz");
        QVERIFY(nz && nz->isVisible());
        typeOver(*nz, QStringLiteral("2,5e-4"));
        const auto zones = std::get<ZoneCompliance>(bench.project().machine->compliance_mm_per_n);
        QCOMPARE(zones.nz, 2.5e-4);
        QCOMPARE(nz->accessibleName(), QStringLiteral("Compliance of NZ, mm/N"));
        bench.document.startUntitled(withSections(newProject(Operation::plunge), 6));
        for (int section = 0; section < 6; ++section) {
            auto* field = bench.panel.findChild<NumberField*>(
                QStringLiteral("/machine/compliance_mm_per_n/%1").arg(section));
            QVERIFY(field);
            QTRY_VERIFY(field->isVisible()); // a layout shows what it is given later
        }
        QApplication::clipboard()->setText(QStringLiteral("0.0002\n0.0003\n"));
        auto* second = bench.field("/machine/compliance_mm_per_n/1");
        second->setFocus();
        QTest::keySequence(second, QKeySequence::Paste); // from here on
        const auto pasted =
            std::get<std::vector<double>>(bench.project().machine->compliance_mm_per_n);
        QCOMPARE(pasted[1], 2e-4);
        QCOMPARE(pasted[2], 3e-4);
    }

    void theComplianceCanBeLeftToStiffnessAndShaftAndTakenBack() {
        Project project = newProject(Operation::traverse);
        project.machine->stiffness_n_um.emplace();
        project.part->shaft.segments = {{200, 30}};
        Bench bench(project, machinePage);
        auto* tick = bench.panel.findChild<ComplianceBox*>()->findChild<QCheckBox*>();
        QVERIFY(tick && tick->isVisible());
        QTest::keyClick(tick, Qt::Key_Space);
        QVERIFY(
            std::holds_alternative<std::monostate>(bench.project().machine->compliance_mm_per_n));
        QVERIFY(!hasErrors(validate(bench.project())));
        QTest::keyClick(tick, Qt::Key_Space);
        QVERIFY(
            std::holds_alternative<ZoneCompliance>(bench.project().machine->compliance_mm_per_n));
    }

    void issuesMarkTheirFieldAndRefusedTextsAreListed() {
        Project project = newProject(Operation::traverse);
        project.part->radii_per_section = 35;
        Bench bench(project, partPage);
        bench.showIssues();
        auto* radii = bench.field("/part/radii_per_section");
        QCOMPARE(radii->remark().mark, Mark::error);
        auto* diameter = bench.field("/part/diameter_mm");
        typeOver(*diameter, QStringLiteral("abc"));
        QCOMPARE(bench.panel.refusals().size(), 1u);
        QCOMPARE(bench.panel.refusals().front().path, std::string("/part/diameter_mm"));
        QCOMPARE(bench.project().part->diameter_mm, project.part->diameter_mm);
        bench.panel.focusPath("/cycle/stages/1/stock_mm");
        QVERIFY(!diameter->isVisible());
        bench.panel.focusPath("/part/diameter_mm");
        QVERIFY(diameter->isVisible());
        bench.document.startUntitled(project); // another document: the refused text goes
        QVERIFY(bench.panel.refusals().empty());
        QCOMPARE(diameter->text(), QStringLiteral("30"));
    }
};

} // namespace sparkout::test_forms

SPARKOUT_TEST(test_forms, TestForms)
#include "test_forms.moc"
