// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
#include "core/file/project_file.h"
#include "core/study/operation.h"
#include "tests/registry.h"
#include "tests/ui/inputs/inputs_bench.h"
#include "ui/inputs/list_table.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>

namespace sparkout::test_shaft_form {

using namespace inputs_bench;

struct Bench : inputs_bench::Bench {
    explicit Bench(Project project, int page = partPage)
        : inputs_bench::Bench(std::move(project), page) {}
    [[nodiscard]] QTableView& table(const char* path) const { return *find<QTableView>(path); }
    [[nodiscard]] const std::vector<ShaftSegment>& segments() const {
        return part().shaft.segments;
    }
    void type(QTableView& view, int row, int column, const char* text) {
        view.setFocus();
        view.setCurrentIndex(view.model()->index(row, column));
        QTest::keyClick(&view, Qt::Key_F2);
        auto* editor = view.findChild<NumberField*>();
        QVERIFY(editor);
        editor->selectAll();
        QTest::keyClicks(editor, QString::fromLatin1(text));
        QTest::keyClick(editor, Qt::Key_Return);
    }
};

Project withShaft() {
    Project project = newProject(Operation::traverse);
    project.part->shaft.segments = {{60, 28}, {92, 30}};
    project.part->shaft.ground_from_mm = 60;
    return project;
}

Project bore() {
    Project project = newProject(Operation::plunge);
    project.part->surface = Surface::internal;
    project.part->diameter_mm = 60;
    project.wheel->diameter_mm = 45;
    return project;
}

/// The tick of the compliance box.
QCheckBox* computedTick(const Bench& bench) {
    for (auto* box : bench.panel.findChildren<QGroupBox*>()) {
        if (auto* tick = box->findChild<QCheckBox*>(QString(), Qt::FindDirectChildrenOnly)) {
            return tick;
        }
    }
    return nullptr;
}

QString writeCsv(const QTemporaryDir& dir, const QByteArray& text) {
    const QString path = dir.filePath(QStringLiteral("profile.csv"));
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? path : QString();
}

/// Types a path into the file dialog that opens next.
void answerFileDialog(const QString& path) {
    auto* poll = new QTimer(qApp);
    QObject::connect(poll, &QTimer::timeout, poll, [poll, path] {
        if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
            dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
            auto* open = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
            if (open->isEnabled()) {
                poll->deleteLater();
                QTest::mouseClick(open, Qt::LeftButton);
            }
        }
    });
    poll->start(50);
}

class TestShaftForm : public QObject {
    Q_OBJECT

private slots:
    void aSegmentIsEditedInPlaceAndUndone() {
        Bench bench(withShaft());
        QTableView& view = bench.table("/part/shaft/segments");
        QVERIFY(view.isVisible());
        bench.type(view, 1, 0, "92,5");
        QCOMPARE(bench.segments()[1].length_mm, 92.5);
        bench.document.undo();
        QCOMPARE(bench.segments()[1].length_mm, 92.0);
        QVERIFY(!bench.document.canUndo());
    }

    void rowsAreAddedMovedAndRemovedByKeys() {
        Bench bench(withShaft());
        QTableView& view = bench.table("/part/shaft/segments");
        view.setFocus();
        view.setCurrentIndex(view.model()->index(0, 1));
        QTest::keyClick(&view, Qt::Key_Insert);
        QCOMPARE(bench.segments().size(), 3u);
        QCOMPARE(bench.segments()[1].diameter_mm, 28.0); // a copy of the row it follows
        QCOMPARE(view.currentIndex().row(), 1);
        QTest::keyClick(&view, Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(bench.segments()[1].diameter_mm, 30.0);
        QCOMPARE(bench.segments()[2].diameter_mm, 28.0);
        QCOMPARE(view.currentIndex().row(), 2);
        QTest::keyClick(&view, Qt::Key_Down, Qt::ControlModifier); // the last stays the last
        QCOMPARE(view.currentIndex().row(), 2);
        QTest::keyClick(&view, Qt::Key_Delete, Qt::ControlModifier);
        QCOMPARE(bench.segments().size(), 2u);
        for (int step = 0; step < 3; ++step) {
            bench.document.undo();
        }
        QVERIFY(!bench.document.canUndo());
        QCOMPARE(writeProject(bench.document.project()), writeProject(withShaft()));
    }

    void anEmptyListOffersOnlyItsAddButtonAndTakesItsFirstRow() {
        Bench bench(withShaft());
        QTableView& view = bench.table("/part/shaft/steady_rests");
        QVERIFY(!view.isVisible());
        auto* add = view.parentWidget()->findChild<QToolButton*>();
        QVERIFY(add && add->isVisible() && !add->accessibleName().isEmpty());
        add->setFocus();
        QTest::keyClick(add, Qt::Key_Space);
        QCOMPARE(bench.part().shaft.steady_rests.size(), 1u);
        QVERIFY(view.isVisible());
        bench.type(view, 0, 0, "75");
        QCOMPARE(bench.part().shaft.steady_rests[0].position_mm, 75.0);
        view.setFocus();
        QTest::keyClick(&view, Qt::Key_Delete, Qt::ControlModifier);
        QVERIFY(bench.part().shaft.steady_rests.empty());
        QVERIFY(!view.isVisible());
    }

    void aRefusedTextAndAnIssueOfAListAreMarkedAndNamed() {
        Project project = withShaft();
        project.machine->compliance_mm_per_n = std::monostate{};
        project.machine->stiffness_n_um.emplace();
        project.part->shaft.segments[1].length_mm = 50;
        Bench bench(project);
        bench.showIssues();
        QTableView& view = bench.table("/part/shaft/segments");
        const auto labels = view.parentWidget()->findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->isVisible() && label->text().contains(QStringLiteral("110 mm"));
        }));
        bench.type(view, 0, 0, "abc");
        QCOMPARE(bench.segments()[0].length_mm, 60.0);
        QTRY_COMPARE(bench.panel.refusals().size(), 1u);
        QCOMPARE(bench.panel.refusals().front().path,
                 std::string("/part/shaft/segments/0/length_mm"));
        QVERIFY(!view.model()->index(0, 0).data(Qt::DecorationRole).isNull());
        bench.panel.showPage(machinePage);
        bench.panel.focusPath("/part/shaft/segments/1/diameter_mm");
        QVERIFY(view.isVisible());
        QCOMPARE(view.currentIndex(), view.model()->index(1, 1));
    }

    void theQuillIsShownForABoreAndTheShaftForAnExternalSurface() {
        Bench bench(bore());
        QVERIFY(!bench.table("/part/shaft/segments").parentWidget()->isVisible());
        auto* length = bench.find<NumberField>("/part/shaft/quill/length_mm");
        auto* box = qobject_cast<QGroupBox*>(length->parentWidget());
        QVERIFY(length->isVisible() && box && box->isCheckable() && !box->isChecked());
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Space);
        QVERIFY(bench.part().shaft.quill.has_value());
        bench.document.undo();
        QVERIFY(!bench.part().shaft.quill.has_value() && !box->isChecked());
        bench.document.startUntitled(withShaft());
        QVERIFY(!length->isVisible());
        QVERIFY(bench.table("/part/shaft/segments").isVisible());
    }

    void tickingTheComplianceGivesWhatItNeedsInOneEdit_data() {
        QTest::addColumn<Project>("project");
        QTest::newRow("traverse") << newProject(Operation::traverse);
        QTest::newRow("plunge") << newProject(Operation::plunge);
        QTest::newRow("internal") << bore();
        Project chuck = newProject(Operation::traverse);
        chuck.part->shaft.mounting = Mounting::chuck;
        chuck.part->shaft.steady_rests = {{500, 50}};
        QTest::newRow("chuck with a rest") << chuck;
        QTest::newRow("shaft given") << withShaft();
    }
    void tickingTheComplianceGivesWhatItNeedsInOneEdit() {
        QFETCH(Project, project);
        Bench bench(project, machinePage);
        QCheckBox* tick = computedTick(bench);
        QVERIFY(tick && tick->isVisible() && !tick->isChecked());
        tick->setFocus();
        QTest::keyClick(tick, Qt::Key_Space);
        const Project& computed = bench.document.project();
        QVERIFY(std::holds_alternative<std::monostate>(computed.machine->compliance_mm_per_n));
        const Issues issues = validate(computed);
        QVERIFY2(issues.empty(), issues.empty() ? "" : issues.front().path.c_str());
        QVERIFY(computed.machine->stiffness_n_um.has_value());
        QCOMPARE(computed.part->shaft.quill.has_value(),
                 project.part->surface == Surface::internal);
        if (!project.part->shaft.segments.empty()) { // what is given stays
            QCOMPARE(bench.segments().size(), project.part->shaft.segments.size());
            QCOMPARE(bench.part().shaft.ground_from_mm, project.part->shaft.ground_from_mm);
        }
        bench.document.undo();
        QVERIFY(!bench.document.canUndo());
        QCOMPARE(writeProject(bench.document.project()), writeProject(project));
    }

    void measuredWithoutValuesIsMarkedWithItsReason() {
        Bench bench(newProject(Operation::traverse));
        auto* form = bench.find<QComboBox>("/part/profile");
        QCOMPARE(form->count(), 4);
        form->setFocus();
        QTest::keyClick(form, Qt::Key_End);
        QCOMPARE(bench.part().profile, ProfileForm::measured);
        auto* row = bench.find<QWidget>("/part/radii_um");
        QVERIFY(row->isVisible());
        bench.showIssues();
        const FormRow* found = nullptr;
        for (const FormRow* each : bench.panel.pages()[partPage]->rows()) {
            found = each->editor().path() == "/part/radii_um" ? each : found;
        }
        QCOMPARE(found->editor().remark().mark, Mark::error);
        bench.document.undo();
        QVERIFY(!row->isVisible());
    }

    void aProfileIsReadFromAFileInOneEditAndCleared() {
        const QTemporaryDir dir;
        const QString path = writeCsv(dir, "angle;radius\n0;0\n90;-1,5\n180;-3\n270;-12\n");
        Project project = newProject(Operation::traverse);
        project.part->profile = ProfileForm::measured;
        Bench bench(project);
        auto* row = bench.find<QWidget>("/part/radii_um");
        const auto buttons = row->findChildren<QPushButton*>();
        QCOMPARE(buttons.size(), 2);
        QVERIFY(!buttons[1]->isEnabled());
        answerFileDialog(path);
        QTest::mouseClick(buttons[0], Qt::LeftButton);
        QCOMPARE(bench.part().radii_um.value(), (std::vector<double>{0, -1.5, -3, -12}));
        QCOMPARE(bench.part().radii_per_section, 4);
        QVERIFY(!hasErrors(validate(bench.document.project())));
        QCOMPARE(row->findChild<QLabel*>()->text(), QStringLiteral("4 values, −12…0 µm"));
        bench.document.undo();
        QCOMPARE(bench.part().radii_per_section, 36);
        QVERIFY(!bench.document.canUndo());
        bench.document.redo();
        buttons[1]->setFocus();
        QTest::keyClick(buttons[1], Qt::Key_Space);
        QVERIFY(!bench.part().radii_um.has_value());
        bench.document.undo();
        QCOMPARE(bench.part().radii_um->size(), 4u);
    }

    void aFileThatCannotBeReadLeavesTheProfileAndSaysWhyBesideIt() {
        const QTemporaryDir dir;
        const QString path = writeCsv(dir, "0\n-1,5\noops\n-2\n");
        Project project = newProject(Operation::traverse);
        project = withRadii(std::move(project), std::vector<double>(36, -1.0));
        Bench bench(project);
        auto* row = bench.find<QWidget>("/part/radii_um");
        answerFileDialog(path);
        QTest::mouseClick(row->findChild<QPushButton*>(), Qt::LeftButton);
        QVERIFY(!bench.document.canUndo());
        const auto labels = row->parentWidget()->findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->isVisible() && label->text().contains(QStringLiteral("profile.csv"))
                   && label->text().contains(QStringLiteral("line 3"))
                   && label->text().contains(QStringLiteral("oops"));
        }));
    }
};

} // namespace sparkout::test_shaft_form

SPARKOUT_TEST(test_shaft_form, TestShaftForm)
#include "test_shaft_form.moc"
