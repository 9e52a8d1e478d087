// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/project_file.h"
#include "core/measured/calibrated_inputs.h"
#include "core/project/wheel.h"
#include "core/quality/roughness.h"
#include "core/setup/setup_file.h"
#include "core/study/new_project.h"
#include "core/study/operation.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/ui/support/on_disk.h"
#include "tests/ui/support/untitled.h"
#include "tests/whole_project.h"
#include "ui/session/document.h"

#include "core/project/validate.h"

#include "tests/registry.h"
#include "words/issue_words.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace sparkout::test_document {

constexpr EditText editText{"Input", "Diameter"};

Project withDiameter(Project project, double diameter_mm) {
    project.part->diameter_mm = diameter_mm;
    return project;
}

QByteArray hashOf(const Document& document) {
    return QCryptographicHash::hash(QByteArray::fromStdString(writeProject(document.project())),
                                    QCryptographicHash::Sha256);
}

Setup threeSurfaces() {
    Setup setup;
    for (const char* name : {"journal", "seat", "end"}) {
        setup.surfaces.push_back({name, newProject(Operation::traverse)});
    }
    return setup;
}

QStringList examplePaths() {
    const QDir folder(QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/examples"));
    QStringList list;
    for (const QString& name : folder.entryList({QStringLiteral("*.sparkout")})) {
        list += folder.filePath(name);
    }
    return list;
}

class TestDocument : public QObject {
    Q_OBJECT

private slots:
    /// What is undone since a save is as unsaved as what is done.
    void anEditUndoneAfterASaveIsNamed() {
        Untitled document(newProject(Operation::traverse));
        Project project = document.project();
        project.part->diameter_mm += 1;
        document.edit(project, EditText{"Input", "Diameter"});
        document.markSaved(QStringLiteral("/tmp/part.sparkout"), "hash");
        QVERIFY(document.unsavedEdits().isEmpty());
        document.undo();
        QCOMPARE(document.unsavedEdits().size(), 1);
        document.redo();
        QVERIFY(document.unsavedEdits().isEmpty());
    }

    /// Typing that goes on after a step back is a step of its own.
    void noEditIsJoinedOverAStepOfTheHistory() {
        Untitled document(newProject(Operation::traverse));
        const QString key = QStringLiteral("/part/diameter_mm");
        Project first = document.project();
        first.part->diameter_mm += 1;
        document.edit(first, EditText{"Input", "Diameter"}, key);
        document.undo();
        document.redo();
        Project second = first;
        second.part->diameter_mm += 1;
        document.edit(second, EditText{"Input", "Diameter"}, key);
        document.undo();
        QCOMPARE(document.project().part->diameter_mm, first.part->diameter_mm);
    }

    void undoAndRedoAcrossASaveGiveTheSameTextAndModifiedState() {
        const QTemporaryDir folder;
        Untitled document(newProject(Operation::traverse));
        QVERIFY(!document.modified());
        const QByteArray first = hashOf(document);
        document.edit(withDiameter(document.project(), 31), editText);
        const QByteArray second = hashOf(document);
        QVERIFY(!document.saveAs(folder.filePath(QStringLiteral("a.sparkout"))));
        QVERIFY(!document.modified());
        document.edit(withDiameter(document.project(), 32), editText);
        const QByteArray third = hashOf(document);
        QVERIFY(document.modified());

        document.undo();
        QCOMPARE(hashOf(document), second);
        QVERIFY(!document.modified());
        document.undo();
        QCOMPARE(hashOf(document), first);
        QVERIFY(document.modified());
        QVERIFY(!document.canUndo());
        document.redo();
        document.redo();
        QCOMPARE(hashOf(document), third);
        QVERIFY(!document.canRedo());
    }

    void typingInOneFieldIsOneStepUntilTheFieldIsLeft() {
        Untitled document(newProject(Operation::traverse));
        const QString key = QStringLiteral("/part/diameter_mm");
        document.edit(withDiameter(document.project(), 4), editText, key);
        document.edit(withDiameter(document.project(), 45), editText, key);
        document.endMerge();
        document.edit(withDiameter(document.project(), 46), editText, key);
        document.undo();
        QCOMPARE(document.project().part->diameter_mm, 45.0);
        document.undo();
        QCOMPARE(document.project().part->diameter_mm, 30.0);
        QVERIFY(!document.canUndo());
    }

    void typingAndTypingBackLeavesNothingToUndo() {
        Untitled document(newProject(Operation::traverse));
        const QString key = QStringLiteral("/part/diameter_mm");
        document.edit(withDiameter(document.project(), 3), editText, key);
        document.edit(withDiameter(document.project(), 30), editText, key);
        QVERIFY(!document.canUndo());
        QVERIFY(!document.modified());
    }

    void editsThatJoinKeepTheRuns() {
        Project project = withSections(newProject(Operation::plunge), 4);
        project.runs = {{"kept", "2026-01-01T00:00:00Z", "1.0.0", {"{}"}, {"{}"}}};
        Untitled document(project);
        const QString key = QStringLiteral("/sections");
        for (const int sections : {1, 12}) {
            document.edit(withSections(document.beforeEditsOf(key), sections), editText, key);
            QVERIFY(document.project().runs == project.runs);
        }
        QVERIFY(sameProject(document.project(), withSections(project, 12)));
        document.undo();
        QVERIFY(sameProject(document.project(), project));
        QVERIFY(document.project().runs == project.runs);
        QVERIFY(!document.canUndo());
    }

    void anEditThatChangesNothingIsNoStep() {
        Untitled document(newProject(Operation::traverse));
        QSignalSpy changed(&document, &Document::changed);
        document.edit(document.project(), editText);
        QCOMPARE(changed.count(), 0);
        QVERIFY(!document.canUndo());
    }

    void everyExampleSurvivesOpenSaveOpen_data() {
        QTest::addColumn<QString>("path");
        for (const QString& path : examplePaths()) {
            QTest::newRow(path.section(u'/', -1).toUtf8().constData()) << path;
        }
    }

    void everyExampleSurvivesOpenSaveOpen() {
        QFETCH(QString, path);
        const QTemporaryDir folder;
        const QString copy = folder.filePath(QStringLiteral("копия.sparkout"));
        Document document;
        QVERIFY(document.open(path).opened());
        QCOMPARE(document.filePath(), path);
        const Project before = document.project();
        QVERIFY(!document.saveAs(copy));
        Document again;
        QVERIFY(again.open(copy).opened());
        QVERIFY(sameProject(before, again.project()));
    }

    void aRefusedFileListsItsFaultsAndLeavesTheDocumentAlone() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("bad.sparkout"));
        on_disk::write(
            path,
            R"({"format":"sparkout-project","version":1,"nonsense":2,"operation":"traverse"})");
        Untitled document(newProject(Operation::plunge));
        document.edit(withDiameter(document.project(), 33), editText);
        const QByteArray before = hashOf(document);
        const OpenResult result = document.open(path);
        QVERIFY(!result.opened());
        QVERIFY(result.issues.size() > 1);
        QCOMPARE(hashOf(document), before);
        QVERIFY(document.canUndo());
        QVERIFY(document.filePath().isEmpty());
    }

    // A rule between values is broken half-way through many an edit; saving then must lose nothing.
    void unfinishedWorkIsSavedAndOpenedAgainWithItsFaults() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("unfinished.sparkout"));
        Untitled document(newProject(Operation::traverse));
        Project odd = document.project();
        odd.part->radii_per_section = 35;
        odd.part->lower_deviation_um = odd.part->upper_deviation_um + 1;
        odd.part->profile = ProfileForm::measured; // chosen, not read yet
        document.edit(odd, editText);
        QVERIFY(!document.saveAs(path));
        Document again;
        const OpenResult result = again.open(path);
        QVERIFY(result.opened());
        QVERIFY(hasErrors(result.issues));
        QVERIFY(sameProject(again.project(), odd));
    }

    // What the forms never let in must not come in by a file either.
    void aValueOutOfItsRangeIsNotOpened() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("dull.sparkout"));
        Project dull = newProject(Operation::traverse);
        dull.wheel->dullness = 1.5;
        on_disk::write(path, QByteArray::fromStdString(writeProject(dull)));
        Document document;
        QVERIFY(!document.open(path).opened());
        document.startUntitled(dull);
        QVERIFY2(document.saveAs(path).has_value(), "what cannot be opened is not written");
    }

    void aFileThatIsNotThereIsAnError() {
        Document document;
        const OpenResult result = document.open(QStringLiteral("/nowhere/at/all.sparkout"));
        QVERIFY(result.error.has_value());
        QVERIFY(!result.opened());
    }

    void aFailedSaveKeepsTheDocumentModifiedAndItsPath() {
        Untitled document(newProject(Operation::traverse));
        document.edit(withDiameter(document.project(), 33), editText);
        QVERIFY(document.saveAs(QStringLiteral("/nowhere/at/all.sparkout")).has_value());
        QVERIFY(document.modified());
        QVERIFY(document.filePath().isEmpty());
    }

    void newProjectsOfBothOperationsAreInOrder() {
        for (const Operation operation : {Operation::traverse, Operation::plunge}) {
            const Issues issues = validate(newProject(operation));
            QVERIFY2(issues.empty(), issues.empty() ? "" : issueSentence(issues.front()).c_str());
        }
    }

    void theFirstDifferenceIsFoundByItsPath() {
        const Project project = newProject(Operation::traverse);
        QCOMPARE(firstDifference(project, project), std::string());
        Project other = withDiameter(project, 31);
        QCOMPARE(firstDifference(project, other), std::string("/part/diameter_mm"));
        other = project;
        other.cycle->stages.back().stock_mm += 1;
        QCOMPARE(firstDifference(project, other),
                 "/cycle/stages/" + std::to_string(project.cycle->stages.size() - 1) + "/stock_mm");
        other.cycle->stages.push_back({});
        QCOMPARE(firstDifference(project, other), std::string("/cycle/stages"));
        other = project;
        other.batch.emplace(); // an object that appears, or goes
        QCOMPARE(firstDifference(project, other), std::string("/batch"));
        QCOMPARE(firstDifference(other, project), std::string("/batch"));
        const Project same = other;
        other.batch->seed += 1;
        QCOMPARE(firstDifference(same, other), std::string("/batch/seed"));
    }

    void aListedComplianceFollowsTheNumberOfSections() {
        const Project plunge = newProject(Operation::plunge);
        const Project more = withSections(plunge, 7);
        QCOMPARE(std::get<std::vector<double>>(more.machine->compliance_mm_per_n).size(), 7u);
        QVERIFY(!hasErrors(validate(more)));
        QVERIFY(!hasErrors(validate(withSections(more, 1))));
    }

    // --- several surfaces ---------------------------------------------------------------------

    /// Of a shared input, not of one that each surface has for itself.
    void aCalibrationOfASharedInputIsRecordedWithEverySurface() {
        Untitled document(threeSurfaces());
        document.showSurface(1);
        Project project = document.project();
        project.wheel->dullness = 0.031;
        Measured& measured = project.measured.emplace();
        measured.calibrations = {{"/wheel/dullness", 0.031, 0.03, 0.032, "cycle.csv", 90, {}},
                                 {"/part/initial_runout_mm", 0.02, {}, {}, "cycle.csv", 90, {}}};
        document.edit(project, editText);
        for (std::size_t i = 0; i < 3; ++i) {
            document.showSurface(i);
            const Calibration* const dullness =
                calibrationOf(document.project(), "/wheel/dullness");
            QVERIFY(dullness && hasCalibratedValue(document.project(), *dullness));
            QCOMPARE(calibrationOf(document.project(), "/part/initial_runout_mm") != nullptr,
                     i == 1);
        }
        // The same value found again from other data.
        project = document.project();
        project.measured->calibrations.front().data = "cycle-2.csv";
        document.edit(project, editText);
        for (const GroundSurface& surface : document.setup().surfaces) {
            QCOMPARE(calibrationOf(surface.project, "/wheel/dullness")->data,
                     std::string("cycle-2.csv"));
        }
        // A set-up that has it with one surface alone, as older files do.
        Setup older = document.setup();
        older.surfaces[0].project.measured.reset();
        older.surfaces[2].project.measured.reset();
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("older.sparkout"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        const QByteArray text = QByteArray::fromStdString(writeSetup(older));
        file.write(text);
        file.close();
        Document opened;
        opened.take(older, path, QCryptographicHash::hash(text, QCryptographicHash::Sha256), false);
        for (const GroundSurface& surface : opened.setup().surfaces) {
            QVERIFY(calibrationOf(surface.project, "/wheel/dullness"));
        }
    }

    void whatIsSharedChangesInEverySurface() {
        Untitled document(threeSurfaces());
        document.showSurface(1);
        const SurfaceStatePtr first = document.state().surfaces[0];
        Project project = document.project();
        project.part->stock_mm = 0.2;
        document.edit(project, editText);
        QCOMPARE(document.state().surfaces[0], first); // is not touched
        project.wheel->width_mm = 55;
        document.edit(project, editText);
        for (const GroundSurface& surface : document.setup().surfaces) {
            QCOMPARE(surface.project.wheel->width_mm, 55.0);
        }
        QVERIFY(document.setup().surfaces[0].project.part->stock_mm != 0.2);
        QCOMPARE(document.setup().surfaces[1].project.part->stock_mm, 0.2);
        document.undo();
        for (const GroundSurface& surface : document.setup().surfaces) {
            QVERIFY(surface.project.wheel->width_mm != 55.0);
        }
    }

    /// Typing is one step, with the law that follows; a law stays under a gate and where a whole
    /// project is restored.
    void lawOfTheBatchFollowsItsInputInTheSameStep() {
        using Ends = std::vector<double>;
        Untitled document(fixtures::shaftBatch(20));
        const QString key = QStringLiteral("/part/stock_mm");
        const auto edit = [&](double stock_mm, const QString& merge, Document::Laws laws) {
            Project project = document.project();
            project.part->stock_mm = stock_mm;
            document.edit(project, editText, merge, laws);
        };
        const auto ends = [&document] {
            return *document.project().batch->factors.stock_mm->uniform;
        };
        edit(0.2, key, Document::Laws::move);
        edit(0.25, key, Document::Laws::move);
        QCOMPARE(ends(), (Ends{0.23, 0.27}));
        QCOMPARE(document.movedLaws(), std::vector{FactorKind::stock});
        document.undo();
        QCOMPARE(document.project().part->stock_mm, 0.15);
        QCOMPARE(ends(), (Ends{0.13, 0.17}));
        QVERIFY(!document.canUndo());
        edit(0.2, {}, Document::Laws::stay);
        QCOMPARE(ends(), (Ends{0.13, 0.17}));
        QVERIFY(document.movedLaws().empty());
        document.setGate([](const SetupState&) { return true; });
        edit(0.25, {}, Document::Laws::move);
        QCOMPARE(document.project().part->stock_mm, 0.25);
        QCOMPARE(ends(), (Ends{0.13, 0.17}));
    }

    void lawsOfEverySurfaceFollowASharedInput() {
        Setup setup = threeSurfaces();
        for (GroundSurface& surface : setup.surfaces) {
            surface.project.batch = Batch{};
            surface.project.batch->factors.wheel_diameter_mm = fixtures::uniform(400, 500);
            surface.project.wheel->diameter_mm = 500;
        }
        Untitled document(setup);
        Project project = document.project();
        project.wheel->diameter_mm = 450;
        document.edit(project, editText);
        for (const GroundSurface& surface : document.setup().surfaces) {
            QCOMPARE(*surface.project.batch->factors.wheel_diameter_mm->uniform,
                     (std::vector<double>{360, 450}));
        }
        QCOMPARE(document.movedLaws(), std::vector{FactorKind::wheelDiameter});
        document.undo();
        for (const GroundSurface& surface : document.setup().surfaces) {
            QCOMPARE(surface.project.batch->factors.wheel_diameter_mm->uniform->front(), 400.0);
        }
    }

    /// Whatever surface is in front when Ra is typed: as when a file with that Ra is opened.
    void aMeasuredRaGivesTheSharedWheelOneFactor() {
        Setup setup = threeSurfaces();
        for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
            setup.surfaces[i].project.part->diameter_mm = 30 + 10 * static_cast<double>(i);
            setup.surfaces[i].project.wheel->roughness_factor = 1;
        }
        Untitled edited(setup);
        edited.showSurface(2);
        Project project = edited.project();
        project.wheel->measured_ra = MeasuredRa{0.6, {}, {}};
        edited.edit(project, editText);
        for (GroundSurface& surface : setup.surfaces) {
            surface.project.wheel->measured_ra = MeasuredRa{0.6, {}, {}};
        }
        Untitled opened(setup);
        const double factor = factorOfMeasuredRa(setup.surfaces[0].project).value();
        QVERIFY(factor != factorOfMeasuredRa(setup.surfaces[2].project).value());
        for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
            QCOMPARE(edited.setup().surfaces[i].project.wheel->roughness_factor, factor);
            QCOMPARE(opened.setup().surfaces[i].project.wheel->roughness_factor, factor);
        }
    }

    /// A step that changes another surface than the one in front, as accepted cycles of a search of
    /// all do, shows that one.
    void undoShowsASurfaceThatItChanges() {
        Untitled document(threeSurfaces());
        SetupState changed = document.state();
        auto last = std::make_shared<SurfaceState>(*changed.surfaces[2]);
        last->project.part->diameter_mm = 33;
        changed.surfaces[2] = last;
        document.editSetup(changed, editText);
        QCOMPARE(document.surface(), std::size_t{0});
        std::string path;
        connect(&document, &Document::stepped, this,
                [&path](const std::string& stepped) { path = stepped; });
        document.undo();
        QCOMPARE(document.surface(), std::size_t{2});
        QCOMPARE(document.project().part->diameter_mm, 30.0);
        QCOMPARE(path, std::string("/part/diameter_mm"));
        document.showSurface(0);
        document.redo();
        QCOMPARE(document.surface(), std::size_t{2});
        QCOMPARE(document.project().part->diameter_mm, 33.0);
    }

    void undoBringsTheSurfaceToTheFrontThatItConcerns() {
        Untitled document(threeSurfaces());
        document.showSurface(1);
        QVERIFY(!document.modified() && !document.canUndo()); // that is no edit
        document.edit(withDiameter(document.project(), 31), editText);
        document.showSurface(2);
        document.edit(withDiameter(document.project(), 32), editText);
        document.showSurface(0);
        QSignalSpy shown(&document, &Document::projectReplaced);
        std::string path;
        connect(&document, &Document::stepped, this,
                [&path](const std::string& stepped) { path = stepped; });
        document.undo();
        QCOMPARE(document.surface(), std::size_t{2});
        QCOMPARE(path, std::string("/part/diameter_mm"));
        QCOMPARE(shown.count(), 1);
        document.undo();
        QCOMPARE(document.surface(), std::size_t{1});
        QCOMPARE(document.project().part->diameter_mm, 30.0);
        document.showSurface(2);
        document.redo();
        QCOMPARE(document.surface(), std::size_t{1});
        QCOMPARE(document.project().part->diameter_mm, 31.0);
    }

    void typingInTwoSurfacesIsTwoSteps() {
        Untitled document(threeSurfaces());
        const QString key = QStringLiteral("/part/diameter_mm");
        document.edit(withDiameter(document.project(), 31), editText, key);
        document.showSurface(1);
        const Project before = document.beforeEditsOf(key);
        QCOMPARE(before.part->diameter_mm, 30.0);
        document.edit(withDiameter(document.project(), 32), editText, key);
        document.undo();
        QCOMPARE(document.setup().surfaces[0].project.part->diameter_mm, 31.0);
        QCOMPARE(document.setup().surfaces[1].project.part->diameter_mm, 30.0);
    }

    void aSetupIsSavedAndOpenedAsAWhole() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("three.sparkout"));
        Untitled document(threeSurfaces());
        document.showSurface(2);
        Project project = withDiameter(document.project(), 33);
        project.part->lower_deviation_um = project.part->upper_deviation_um + 1; // unfinished
        document.edit(project, editText);
        QVERIFY(!document.saveAs(path));
        QVERIFY(!document.modified());
        Document again;
        const OpenResult opened = again.open(path);
        QVERIFY(opened.opened() && hasErrors(opened.issues));
        QCOMPARE(again.surface(), std::size_t{0});
        QVERIFY(sameSetup(again.setup(), document.setup()));
        again.showSurface(2);
        QCOMPARE(again.project().part->diameter_mm, 33.0);
    }

    /// Of a set-up that was edited and undone not a byte differs.
    void everySampleOfASetupIsSavedAsItWasRead() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("setup.sparkout"));
        Setup setup = threeSurfaces();
        setup.times.handling_s = 30;
        setup.wear.dulling_per_mm2 = 1e-5;
        const std::string text = writeSetup(setup);
        Untitled document(setup);
        document.showSurface(1);
        document.edit(withDiameter(document.project(), 31), editText);
        document.undo();
        QVERIFY(!document.saveAs(path));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll().toStdString(), text);
    }

    void aReloadKeepsTheSurfaceInFrontAndCanBeUndone() {
        Untitled document(threeSurfaces());
        document.showSurface(2);
        Setup shorter = threeSurfaces();
        shorter.surfaces.pop_back();
        document.reload(shorter, "hash");
        QCOMPARE(document.surfaceCount(), std::size_t{2});
        QCOMPARE(document.surface(), std::size_t{1});
        QVERIFY(!document.modified());
        document.undo();
        QCOMPARE(document.surfaceCount(), std::size_t{3});
        QCOMPARE(document.surface(), std::size_t{2});
    }

    void openInputsOfASurfaceAreRecoveredWithIt() {
        Document document;
        document.recover(threeSurfaces(), {}, {}, false,
                         {"/part/length_mm", "/surfaces/2/part/diameter_mm", "/surfaces/7/part"});
        QCOMPARE(document.openInputs(), std::vector<std::string>{"/part/length_mm"});
        document.showSurface(1);
        QVERIFY(document.openInputs().empty());
        document.showSurface(2);
        QVERIFY(document.isOpen("/part/diameter_mm"));
        const std::vector<std::string> all{"/part/length_mm", "/surfaces/2/part/diameter_mm"};
        QCOMPARE(document.allOpenInputs(), all);
    }
};

} // namespace sparkout::test_document

SPARKOUT_TEST(test_document, TestDocument)
#include "test_document.moc"
