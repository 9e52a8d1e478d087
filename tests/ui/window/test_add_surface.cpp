// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog that adds a surface, and what comes of it in the document.
#include "core/project/cycle.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/study/new_project.h"
#include "tests/registry.h"
#include "tests/ui/support/untitled.h"
#include "ui/session/surface_edits.h"
#include "ui/window/dialogs/add_surface_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QTest>

#include <string>
#include <vector>

namespace sparkout::test_add_surface {

class TestAddSurface : public QObject {
    Q_OBJECT

private slots:
    /// A surface begins with a drawing of its own; a copy asks what of the other's comes along, and
    /// keeps its cycle.
    void aCopiedSurfaceAsksWhatComesAlong() {
        Setup setup = plainSetup(newProject(Operation::plunge));
        Part& part = *setup.surfaces.front().project.part;
        part.gaps.push_back({.from_deg = 0, .width_deg = 30});
        part.tolerance.roundness_um = 4;
        Untitled document(setup);
        const auto isFree = [](const QString&) { return true; };
        AddSurfaceDialog dialog(document.state(), QStringLiteral("second"), isFree, std::nullopt);
        QVERIFY(!dialog.isCopy());
        QCOMPARE(dialog.openInputs(), drawingInputs());
        auto* begin = dialog.findChild<QComboBox*>(QStringLiteral("begin"));
        begin->setCurrentIndex(0);
        QVERIFY(dialog.isCopy());
        const auto box = [&dialog](const char* name) {
            return dialog.findChild<QCheckBox*>(QString::fromLatin1(name));
        };
        QVERIFY(!box("copyGaps")->isChecked() && box("copyDeviations")->isChecked()
                && box("copyTolerances")->isChecked());
        const auto made = [&dialog] {
            const Project project = dialog.project();
            return *project.part;
        };
        QVERIFY(dialog.openInputs().empty());
        QVERIFY(made().gaps.empty());
        QVERIFY(made().tolerance.roundness_um == 4.0);
        box("copyGaps")->setChecked(true);
        box("copyTolerances")->setChecked(false);
        QCOMPARE(made().gaps.size(), 1U);
        QVERIFY(!made().tolerance.roundness_um);
        box("copyDeviations")->setChecked(false);
        const std::vector<std::string> deviations{"/part/upper_deviation_um",
                                                  "/part/lower_deviation_um"};
        QCOMPARE(dialog.openInputs(), deviations);
        SurfaceEdits edits(document);
        edits.add(dialog.project(), dialog.name(), dialog.openInputs(), dialog.startsWhenDrawn());
        const std::vector<Stage> stages = document.project().cycle->stages;
        Project given = document.project();
        given.part->upper_deviation_um = part.upper_deviation_um; // the very same is given, too
        given.part->lower_deviation_um = part.lower_deviation_um;
        document.edit(given, {"Input", "Deviations"});
        QVERIFY(document.openInputs().empty() && !document.followsDrawing());
        QCOMPARE(document.project().cycle->stages.size(), stages.size());
        QCOMPARE(document.project().cycle->stages.front().radial_feed_mm_min,
                 stages.front().radial_feed_mm_min);
    }

    /// The part has one wheel: where it leaves a greater Ra than the copy requires, the dialog
    /// names the wheel of the catalogue that suits, and leaves it to the user.
    void aWheelTooCoarseForTheRequiredRaIsNamedAndKept() {
        auto drawing = *drawingOf(*parseSizeDesignation("40h6"));
        drawing.length_mm = 40;
        drawing.stock_mm = 0.15;
        drawing.tolerance.roughness_ra_um = 0.5;
        Issues issues;
        const auto entries = *startingEntries({{}, "14А F36 N", {}}, drawing, issues);
        const StartingEntries usual = *startingEntries({}, drawing, issues);
        const QString suits = QString::fromStdString(usual.wheel.name);
        Untitled document(plainSetup(drawnProject(drawing, entries).start->project));
        const auto isFree = [](const QString&) { return true; };
        AddSurfaceDialog dialog(document.state(), QStringLiteral("second"), isFree, std::nullopt);
        auto* const wheel = dialog.findChild<QLabel*>(QStringLiteral("wheelFact"));
        const QString marking = QString::fromStdString(entries.wheel.value.marking);
        QVERIFY(wheel->text().startsWith(marking));
        QVERIFY(!wheel->text().contains(suits)); // without a drawing no Ra is known
        dialog.findChild<QComboBox*>(QStringLiteral("begin"))->setCurrentIndex(0);
        QVERIFY2(wheel->text().contains(suits), qPrintable(wheel->text()));
        dialog.findChild<QCheckBox*>(QStringLiteral("copyTolerances"))->setChecked(false);
        QVERIFY(!wheel->text().contains(suits));
        dialog.findChild<QCheckBox*>(QStringLiteral("copyTolerances"))->setChecked(true);
        SurfaceEdits edits(document);
        edits.add(dialog.project(), dialog.name(), dialog.openInputs(), dialog.startsWhenDrawn());
        QCOMPARE(document.surfaceCount(), std::size_t{2});
        QCOMPARE(document.project().wheel->marking, entries.wheel.value.marking);
    }

    /// As the surface itself would.
    void aDuplicateThatIsYetToBeDrawnGetsItsCycleThen() {
        Document document;
        document.startIncomplete(undrawnProject(Operation::plunge), drawingInputs());
        const auto isFree = [](const QString&) { return true; };
        AddSurfaceDialog dialog(document.state(), QStringLiteral("second"), isFree, std::nullopt);
        dialog.onlyDuplicate();
        QVERIFY(dialog.startsWhenDrawn());
        QCOMPARE(dialog.openInputs(), drawingInputs());
    }
};

} // namespace sparkout::test_add_surface

SPARKOUT_TEST(test_add_surface, TestAddSurface)
#include "test_add_surface.moc"
