// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Two ranks of inputs: the usual ones are seen, of the others those that say something here.
#include "core/project/material.h"
#include "core/project/measured.h"
#include "core/project/member.h"
#include "core/project/wheel.h"
#include "core/study/new_project.h"
#include "tests/registry.h"
#include "tests/whole_project.h"
#include "ui/fields/number_field.h"
#include "ui/inputs/forms/form_row.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/session/document.h"
#include "ui/session/settings.h"
#include "ui/text/texts.h"

#include <QToolButton>

#include <algorithm>
#include <set>

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

class TestInputRank : public QObject {
    Q_OBJECT

private slots:
    void aUsualSurfaceShowsAtMostFortyFields() {
        for (const char* name : {"plunge-shaft-two-stage", "shaft-30h6-factory"}) {
            Bench bench(samples::projectIn(
                (std::string("resources/examples/") + name + ".sparkout").c_str()));
            const auto shown = bench.shown({"/part/", "/wheel/", "/machine/"});
            qInfo("%s: %zu fields of part, wheel and machine", name, shown.size());
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
