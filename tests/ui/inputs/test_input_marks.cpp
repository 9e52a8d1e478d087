// SPDX-License-Identifier: GPL-3.0-or-later
// What the inputs say of themselves: hints, marks of changes, refused texts and undo.
#include "core/file/project_file.h"
#include "tests/registry.h"
#include "tests/ui/inputs/inputs_bench.h"
#include "ui/form/input_marks.h"
#include "ui/inputs/stage_table.h"
#include "ui/text/field_text.h"
#include "ui/text/hint_text.h"
#include "ui/text/texts.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QTableView>

#include <functional>

namespace sparkout::test_input_marks {

using namespace inputs_bench;
using inputs_bench::Bench;

void typeOver(QWidget& widget, const QString& text) {
    widget.setFocus();
    QTest::keySequence(&widget, QKeySequence::SelectAll);
    QTest::keyClicks(&widget, text);
}

/// The menu that the Menu key opens on a widget.
QMenu* menuByKey(QWidget& widget) {
    widget.setFocus();
    QContextMenuEvent event(QContextMenuEvent::Keyboard, widget.rect().center(),
                            widget.mapToGlobal(widget.rect().center()));
    QApplication::sendEvent(&widget, &event);
    return qobject_cast<QMenu*>(QApplication::activePopupWidget());
}

void eachField(const StructInfo& table, const std::function<void(const Field&)>& visit) {
    for (const Field& field : table.fields) {
        visit(field);
        if (field.nested) {
            eachField(*field.nested, visit);
        }
    }
}

class TestInputMarks : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void everySourceOfAnInputHasAName() {
        eachField(tableOf<Project>(), [](const Field& field) {
            QVERIFY2(!*field.source || !sourceText(field.source).isEmpty(), field.source);
            QVERIFY(!hintMarkup(field).contains(
                QRegularExpression(QStringLiteral("MODEL-|[A-Z]{4,}[0-9]{4}"))));
        });
        QFile sources(QStringLiteral(SPARKOUT_SOURCE_DIR "/core/SOURCES.md"));
        QVERIFY(sources.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(sources.readAll());
        QRegularExpression line(QStringLiteral("^\\| ([A-Z][A-Z0-9]+(?:-1)?) "),
                                QRegularExpression::MultilineOption);
        int count = 0;
        for (auto it = line.globalMatch(text); it.hasNext(); ++count) {
            const QString key = it.next().captured(1);
            QVERIFY2(!sourceText(key.toStdString()).isEmpty(), qPrintable(key));
        }
        QVERIFY(count > 5);
        QVERIFY(sourceText("NOBODY1900").isEmpty());
    }

    void messagesNameOtherInputsAsTheFormsDo() {
        std::vector<Project> faulty;
        const auto add = [&faulty](Operation operation, auto change) {
            change(faulty.emplace_back(newProject(operation)));
        };
        add(Operation::plunge, [](Project& p) { p.part->length_mm = 2 * p.wheel->width_mm; });
        add(Operation::plunge, [](Project& p) { p.gauge->position_mm = p.part->length_mm + 1; });
        add(Operation::plunge, [](Project& p) {
            p.machine->compliance_mm_per_n = std::vector<double>(std::size_t(p.sections) + 1, 1e-4);
        });
        add(Operation::plunge, [](Project& p) { p.sections_coupled = true; });
        add(Operation::plunge, [](Project& p) { // a bore as large as the wheel
            p.part->surface = Surface::internal;
            p.machine->compliance_mm_per_n = std::monostate{};
            p.machine->stiffness_n_um.emplace();
        });
        add(Operation::traverse,
            [](Project& p) { p.machine->overrun_entry_mm = p.wheel->width_mm + 1; });
        add(Operation::traverse, [](Project& p) { p.part->length_mm = p.wheel->width_mm; });
        add(Operation::traverse,
            [](Project& p) { p.machine->compliance_mm_per_n = std::monostate{}; });
        add(Operation::traverse, [](Project& p) {
            p.machine->compliance_mm_per_n = std::monostate{};
            p.machine->stiffness_n_um.emplace();
        });
        add(Operation::traverse, [](Project& p) {
            p.part->profile = ProfileForm::measured;
            p.part->radii_um = std::vector<double>(4, 1.0);
        });
        const QRegularExpression raw(QStringLiteral("[A-Za-z]_[A-Za-z0-9]|\\(/|part\\."));
        QString all;
        for (const Project& project : faulty) {
            const Issues issues = validate(project);
            QVERIFY(hasErrors(issues));
            for (const Issue& issue : issues) {
                const QString text = issueText(issue);
                QVERIFY2(!text.contains(raw), qPrintable(text));
                all += text + u'\n';
            }
        }
        for (const char* named : {"(Ground length Lₚ)", "(Wheel width B)", "2·B − o₁ − o₂"}) {
            QVERIFY2(all.contains(QString::fromUtf8(named)), named);
        }
    }

    // A key that somebody is to type is no symbol.
    void keysStandInAMessageAsTheyAreTyped() {
        Issue issue;
        issue.code = IssueCode::unknownKey;
        issue.path = "/part";
        for (const char* key : {"diameter_mm", "spark_out", "stock_mm", "d_mm_x", "at_mm"}) {
            issue.value = Quoted{key};
            issue.limit = Keys{{key}};
            const QString text = issueText(issue);
            QVERIFY2(text.contains(QString::fromLatin1(key)), qPrintable(text));
        }
    }

    // The place is given in numbers, the words around them are translated.
    void theFaultOfAFileThatIsNoJsonNamesLineAndColumn() {
        const Issues issues = parseProject("{\n  \"part\": }").issues;
        QCOMPARE(issues.size(), std::size_t(1));
        QCOMPARE(issues[0].code, IssueCode::notJson);
        QCOMPARE(issues[0].value, Detail(Count{2}));
        QCOMPARE(issues[0].limit, Detail(Count{11}));
        QVERIFY(issueText(issues[0]).endsWith(QStringLiteral("line 2, column 11")));
    }

    void aHintTellsMeaningFormulaRangesDefaultAndSource() {
        const QString hint = hintMarkup(*tableOf<Material>().find("friction"));
        QVERIFY2(hint.contains(QStringLiteral("Coefficient of friction")), qPrintable(hint));
        QVERIFY2(hint.contains(QStringLiteral("P<sub>z</sub>")), qPrintable(hint));
        QVERIFY2(hint.contains(QStringLiteral("Allowed: 0 to 2")), qPrintable(hint));
        QVERIFY2(hint.contains(QStringLiteral("Usual: 0.1 to 0.6")), qPrintable(hint));
        QVERIFY2(hint.contains(QStringLiteral("Default: 0.3")), qPrintable(hint));
        QVERIFY2(hint.contains(QStringLiteral("Source: model page")), qPrintable(hint));
    }

    void aScreenReaderHearsTheHintAndTheReasonOfAMarkFirst() {
        Bench bench(materialPage);
        NumberField& friction = *bench.field("/material/friction");
        QVERIFY(friction.accessibleDescription().contains(QStringLiteral("Allowed: 0 to 2")));
        typeOver(friction, QStringLiteral("0.9"));
        QTest::keyClick(&friction, Qt::Key_Return);
        QVERIFY(friction.accessibleDescription().startsWith(QStringLiteral("unusual")));
        QVERIFY(friction.accessibleDescription().contains(QStringLiteral("Coefficient")));
    }

    void theStripBelowThePagesFollowsTheFocus() {
        Bench bench(materialPage);
        QApplication::setActiveWindow(&bench.panel);
        auto* strip = bench.panel.findChild<QWidget*>(QStringLiteral("hintStrip"));
        QVERIFY(strip);
        const auto* text = strip->findChild<QLabel*>();
        bench.field("/material/friction")->setFocus();
        QTRY_VERIFY(text->text().contains(QStringLiteral("default 0.3")));
        bench.panel.showPage(5);
        auto& table = bench.panel.findChild<StageTable*>()->view();
        table.setFocus();
        table.setCurrentIndex(table.model()->index(0, 1));
        QTRY_VERIFY2(text->text().contains(QStringLiteral("Table speed")),
                     qPrintable(text->text()));
    }

    // Every place of a page that takes the focus by Tab, also those that are no input themselves.
    void theStripFollowsTheFocusIntoTheToleranceClass() {
        Bench bench(partPage);
        QApplication::setActiveWindow(&bench.panel);
        const auto* text =
            bench.panel.findChild<QWidget*>(QStringLiteral("hintStrip"))->findChild<QLabel*>();
        bench.field("/part/length_mm")->setFocus();
        QTRY_VERIFY(text->text().contains(QStringLiteral("Length of the ground surface")));
        bench.panel.findChild<QWidget*>(QStringLiteral("sizeField"))->setFocus();
        QTRY_VERIFY2(text->text().contains(QStringLiteral("30h6 fills diameter and limits")),
                     qPrintable(text->text()));
        bench.field("/part/tolerance/roundness_um")->setFocus();
        QTRY_VERIFY2(text->text().contains(hintMarkup(*tableOf<Tolerance>().find("roundness_um"))
                                               .section(u'<', 2, 2)
                                               .section(u'>', 1)),
                     qPrintable(text->text()));
        bench.panel.findChild<QWidget*>(QStringLiteral("sizeField"))->setFocus();
        QTRY_VERIFY(text->text().contains(QStringLiteral("30h6 fills")));
        bench.panel.retranslate();
        QVERIFY(text->text().contains(QStringLiteral("30h6 fills")));
        bench.panel.showPage(1); // the field is out of sight
        QTRY_VERIFY(!text->text().contains(QStringLiteral("30h6 fills")));
    }

    void aDesignationTypedIntoTheDiameterFillsItsLimits() {
        Bench bench(partPage);
        NumberField* const diameter = bench.field("/part/diameter_mm");
        typeOver(*diameter, QStringLiteral("35k6"));
        QTest::keyClick(diameter, Qt::Key_Return);
        const Part& part = *bench.document.project().part;
        QCOMPARE(part.diameter_mm, 35.0);
        QCOMPARE(part.upper_deviation_um, 18.0);
        QCOMPARE(part.lower_deviation_um, 2.0);
        QVERIFY(bench.row("/part/diameter_mm")->editor().refusal().isEmpty());
        const auto* const size = bench.panel.findChild<QWidget*>(QStringLiteral("sizeField"));
        QVERIFY(size->mapTo(&bench.panel, QPoint()).y()
                < diameter->mapTo(&bench.panel, QPoint()).y());
        typeOver(*diameter, QStringLiteral("35zz6"));
        QTest::keyClick(diameter, Qt::Key_Return);
        QVERIFY(!bench.row("/part/diameter_mm")->editor().refusal().isEmpty());
        QCOMPARE(bench.document.project().part->diameter_mm, 35.0);
    }

    void onlyInputsWithADefaultAreMarkedAndAClickTakesThemBack() {
        Bench bench(materialPage);
        FormRow& friction = *bench.row("/material/friction");
        QVERIFY(friction.resetMark() && !friction.resetMark()->isVisible());
        QVERIFY2(!bench.row("/material/flow_stress_mpa")->resetMark(), "required: the user's own");
        typeOver(*friction.editor().widget(), QStringLiteral("0.4"));
        QVERIFY(friction.resetMark()->isVisible());
        QVERIFY(friction.resetMark()->toolTip().contains(QStringLiteral("0.3")));
        QTest::mouseClick(friction.resetMark(), Qt::LeftButton);
        QCOMPARE(bench.document.project().material->friction, 0.3);
        QVERIFY(!friction.resetMark()->isVisible());
        bench.document.undo();
        QCOMPARE(bench.document.project().material->friction, 0.4);
        QVERIFY(friction.resetMark()->isVisible());
    }

    void theMarkTellsTheDefaultWithItsUnitOrWhatNotGivenMeans() {
        Bench bench;
        QVERIFY(bench.row("/part/shaft/youngs_modulus_gpa")
                    ->resetMark()
                    ->toolTip()
                    .contains(QStringLiteral("210\u00a0GPa")));
        QVERIFY(bench.row("/part/target_diameter_mm")
                    ->resetMark()
                    ->toolTip()
                    .contains(QStringLiteral("middle of the tolerance band")));
        QVERIFY(bench.row("/part/shaft/mounting")
                    ->resetMark()
                    ->toolTip()
                    .contains(QStringLiteral("between centres")));
    }

    void theMenuKeyOffersTheReset_data() {
        addColumns<int, QString>("page", "path");
        QTest::newRow("number") << 1 << QStringLiteral("/material/friction");
        QTest::newRow("choice") << 0 << QStringLiteral("/part/shaft/mounting");
        QTest::newRow("given or not") << 0 << QStringLiteral("/part/target_diameter_mm");
    }
    void theMenuKeyOffersTheReset() {
        QFETCH(int, page);
        QFETCH(QString, path);
        Bench bench;
        bench.panel.showPage(page);
        Project changed = bench.document.project();
        changed.material->friction = 0.5;
        changed.part->shaft.mounting = Mounting::chuck;
        changed.part->target_diameter_mm = 29.995;
        bench.document.startUntitled(changed);
        FormRow& row = *bench.row(path.toStdString());
        QVERIFY(row.resetMark()->isVisible());
        QMenu* menu = menuByKey(*row.editor().widget());
        QVERIFY(menu);
        QAction* reset = menu->actions().constLast();
        QCOMPARE(reset->text(), row.resetMark()->menuText());
        QVERIFY(reset->isEnabled());
        reset->trigger();
        menu->close();
        QVERIFY(!row.editor().changedFromDefault());
        QVERIFY(!row.resetMark()->isVisible());
        bench.document.undo();
        QVERIFY(row.resetMark()->isVisible());
    }

    void undoDropsTheTextRefusedLastBeforeItUndoesAnything() {
        Settings settings = Settings::transient();
        Language language;
        language.apply(QStringLiteral("en"));
        MainWindow window(settings, language);
        window.resize(1200, 700);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        window.document().startUntitled(newProject(Operation::traverse));
        auto* panel = window.findChild<InputsPanel*>();
        panel->showPage(1);
        auto* friction = panel->findChild<NumberField*>(QStringLiteral("/material/friction"));
        auto* stress = panel->findChild<NumberField*>(QStringLiteral("/material/flow_stress_mpa"));
        typeOver(*friction, QStringLiteral("0.5"));
        QTest::keyClick(friction, Qt::Key_Return);
        typeOver(*friction, QStringLiteral("slippery"));
        typeOver(*stress, QStringLiteral("much"));
        panel->showPage(0); // neither is in sight
        QCOMPARE(panel->refusals().size(), 2u);
        auto* undo = actionByKeys(window, QKeySequence::Undo);
        QVERIFY(undo);
        QTRY_VERIFY(undo->text().contains(QStringLiteral("invalid")));
        undo->trigger();
        QCOMPARE(stress->text(), QStringLiteral("2000"));
        QCOMPARE(friction->text(), QStringLiteral("slippery"));
        undo->trigger();
        QCOMPARE(friction->text(), QStringLiteral("0.5"));
        QVERIFY(panel->refusals().empty());
        QCOMPARE(window.document().project().material->friction, 0.5);
        undo->trigger();
        QCOMPARE(window.document().project().material->friction, 0.3);
        window.document().startUntitled(
            newProject(Operation::traverse)); // closes without a question
    }

    void aRefusedTextAloneCanBeUndone() {
        Settings settings = Settings::transient();
        Language language;
        language.apply(QStringLiteral("en"));
        MainWindow window(settings, language);
        window.show();
        window.document().startUntitled(newProject(Operation::traverse));
        auto* panel = window.findChild<InputsPanel*>();
        auto* undo = actionByKeys(window, QKeySequence::Undo);
        QVERIFY(!undo->isEnabled());
        auto& table = panel->findChild<StageTable*>()->view();
        table.setFocus();
        table.setCurrentIndex(table.model()->index(0, 0));
        QTest::keyClick(&table, Qt::Key_X);
        auto* editor = table.findChild<NumberField*>();
        QVERIFY(editor);
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(undo->isEnabled());
        undo->trigger();
        QVERIFY(panel->refusals().empty());
        QCOMPARE(table.model()->index(0, 0).data().toString(), QStringLiteral("0.004"));
        QTRY_VERIFY(!undo->isEnabled());
    }

    void notesThatAreTooLongStayInSightMarkedAndTheLastOnesAreKept() {
        Bench bench(partPage);
        auto* notes = bench.panel.findChild<QPlainTextEdit*>(QStringLiteral("/notes"));
        QVERIFY(notes);
        notes->setFocus();
        QTest::keyClicks(notes, QStringLiteral("short"));
        const QString tooLong(int(limits::stringBytes) + 1, u'x');
        notes->insertPlainText(tooLong);
        QCOMPARE(bench.document.project().notes, std::string("short"));
        QVERIFY(notes->toPlainText().size() > tooLong.size());
        QCOMPARE(bench.panel.refusals().size(), 1u);
        QCOMPARE(bench.panel.refusals().front().path, std::string("/notes"));
        QCOMPARE(bench.row("/notes")->editor().remark().mark, Mark::error);
        Project other = bench.document.project();
        other.material->friction = 0.2;
        bench.document.edit(other, {});
        QVERIFY2(notes->toPlainText().size() > tooLong.size(), "an edit elsewhere leaves it");
        QVERIFY(bench.panel.dropNewestRefusal());
        QCOMPARE(notes->toPlainText(), QStringLiteral("short"));
        QVERIFY(bench.panel.refusals().empty());
        notes->insertPlainText(tooLong);
        typeOver(*notes, QStringLiteral("again"));
        QCOMPARE(bench.document.project().notes, std::string("again"));
        QVERIFY(bench.panel.refusals().empty());
    }

private:
    static QAction* actionByKeys(const MainWindow& window, QKeySequence::StandardKey keys) {
        for (QAction* action : window.findChildren<QAction*>()) {
            if (action->shortcuts().contains(QKeySequence(keys))) {
                return action;
            }
        }
        return nullptr;
    }
};

} // namespace sparkout::test_input_marks

SPARKOUT_TEST(test_input_marks, TestInputMarks)
#include "test_input_marks.moc"
