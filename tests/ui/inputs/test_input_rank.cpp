// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Two ranks of inputs: the usual ones are seen, of the others those that say something here.
#include "core/lesson/lesson.h"
#include "core/project/iso286.h"
#include "core/project/material.h"
#include "core/project/measured.h"
#include "core/project/member.h"
#include "core/project/wheel.h"
#include "core/study/new_project.h"
#include "core/study/starting_project.h"
#include "tests/registry.h"
#include "tests/ui/support/examples.h"
#include "tests/whole_project.h"
#include "ui/form/number_field.h"
#include "ui/inputs/form_row.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/session/document.h"
#include "ui/session/settings.h"
#include "ui/text/texts.h"

#include <QToolButton>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sparkout::test_input_rank {

struct Bench {
    explicit Bench(const Project& project) {
        settings.setAllInputs(false);
        panel = std::make_unique<InputsPanel>(document, nullptr, &settings);
        panel->resize(360, 640);
        panel->show();
        document.startUntitled(project);
        (void)panel->pages();
    }
    [[nodiscard]] std::set<std::string> shown(std::initializer_list<const char*> sections) {
        std::set<std::string> paths;
        for (const FormPage* page : panel->pages()) {
            for (const FormRow* row : page->rows()) {
                const std::string& path = row->editor().path();
                const bool isIn = std::ranges::any_of(
                    sections, [&path](const char* section) { return path.starts_with(section); });
                if (isIn && row->isShown()) {
                    paths.insert(path);
                }
            }
        }
        return paths;
    }
    [[nodiscard]] bool shows(const std::string& path) {
        return shown({path.c_str()}).contains(path);
    }
    [[nodiscard]] QToolButton* foot(Page page) {
        return panel->pages()[static_cast<std::size_t>(page)]->findChild<QToolButton*>(
            QStringLiteral("allInputs"));
    }
    Settings settings = Settings::transient();
    Document document;
    std::unique_ptr<InputsPanel> panel;
};

/// A bore 60H7 of a length, as a new project is begun.
Project startingBore(double length_mm) {
    StartingDrawing drawing = *drawingOf(*parseSizeDesignation("60H7"));
    drawing.length_mm = length_mm;
    drawing.stock_mm = 0.15;
    Issues issues;
    return drawnProject(drawing, *startingEntries({}, drawing, issues)).start->project;
}

class TestInputRank : public QObject {
    Q_OBJECT

private slots:
    /// Also a bore, and a new project that is not touched.
    void aUsualSurfaceShowsAtMostFortyFields() {
        std::vector<std::pair<std::string, Project>> projects{
            {"new plunge", undrawnProject(Operation::plunge)},
            {"new traverse", undrawnProject(Operation::traverse)},
            {"short bore", startingBore(30)},
            {"long bore", startingBore(70)}};
        for (const char* name : {"plunge-shaft-two-stage", "shaft-30h6-factory"}) {
            projects.emplace_back(name, exampleProject(name));
        }
        for (const auto& [name, project] : projects) {
            Bench bench(project);
            const auto shown = bench.shown({"/part/", "/wheel/", "/machine/"});
            qInfo("%s: %zu fields of part, wheel and machine", name.c_str(), shown.size());
            for (const std::string& path : shown) {
                qDebug("%s", path.c_str());
            }
            QVERIFY(shown.size() <= 40);
        }
    }

    void aChangedInputShowsAndItsDefaultHidesIt() {
        Bench bench(newProject(Operation::plunge));
        const char* const path = "/material/friction";
        QVERIFY(!bench.shows(path));
        Project changed = bench.document.project();
        changed.material->friction += 0.05;
        bench.document.edit(changed, {});
        QVERIFY(bench.shows(path));
        bench.document.undo();
        QVERIFY(!bench.shows(path));
    }

    void aLessonShowsWhatItSets() {
        Bench bench(newProject(Operation::plunge));
        const char* const path = "/wheel/grain_tip_angle_deg";
        QVERIFY(!bench.shows(path));
        LessonStep step;
        step.inputs = {{path, Access::free}};
        bench.panel->setAccess(std::make_shared<const FormAccess>(step, false));
        QVERIFY(bench.shows(path));
        bench.panel->setAccess(std::make_shared<const FormAccess>());
        QVERIFY(!bench.shows(path));
        Project project = bench.document.project(); // what the lesson's project sets stays in sight
        project.wheel->grain_tip_angle_deg += 5;
        bench.document.startUntitled(project);
        QVERIFY(bench.shows(path));
    }

    void aCalibratedInputShows() {
        Project project = newProject(Operation::plunge);
        const char* const path = "/material/friction";
        Calibration record;
        record.input = path;
        record.value = project.material->friction;
        project.measured.emplace().calibrations.push_back(record);
        Bench bench(project);
        QVERIFY(bench.shows(path));
    }

    void theSearchAndAMessageShowWhatTheyName() {
        Bench bench(newProject(Operation::plunge));
        const char* const path = "/wheel/grain_tip_angle_deg";
        QVERIFY(!bench.shows(path));
        bench.panel->focusPath(path);
        QVERIFY(bench.shows(path));
        bench.document.startUntitled(newProject(Operation::plunge));
        QVERIFY(!bench.shows(path));
    }

    void theFootShowsAllOnEveryPageAndIsRemembered() {
        Bench bench(newProject(Operation::plunge));
        QToolButton* const foot = bench.foot(Page::wheel);
        QVERIFY(foot && foot->text().contains(QLatin1Char('(')));
        foot->click();
        QVERIFY(bench.settings.allInputs());
        QVERIFY(bench.shows("/wheel/grain_tip_angle_deg"));
        QVERIFY(bench.shows("/material/shear_factor"));
        QVERIFY(bench.foot(Page::material)->isChecked());
        bench.foot(Page::material)->click();
        QVERIFY(!bench.settings.allInputs());
        QVERIFY(!bench.shows("/wheel/grain_tip_angle_deg"));
    }
};

} // namespace sparkout::test_input_rank

SPARKOUT_TEST(test_input_rank, TestInputRank)
#include "test_input_rank.moc"
