// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The stiffness of a machine from the catalogue is offered, with its effect, not just taken.
#include "core/file/project_file.h"
#include "core/study/outcome.h"
#include "tests/registry.h"
#include "tests/ui/support/catalogue_bench.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/whole_project.h"
#include "ui/text/names.h"

#include <QCheckBox>
#include <QTreeWidget>

#include <algorithm>
#include <optional>
#include <variant>
#include <vector>

namespace sparkout::test_stiffness_offer {

using namespace catalogue_bench;

/// A shaft whose compliance follows from stiffness and steps.
QString slenderShaft() {
    const QStringList paths = examplePaths();
    return *std::ranges::find_if(
        paths, [](const QString& path) { return nameOf(path) == u"slender-shaft"; });
}

/// Chooses a machine by its name and looks at the offer before it answers.
QString choose(Window& window, const QString& answer,
               const std::function<void(QCheckBox&, QLabel&, QDialog&)>& look) {
    DialogAnswers answers({answer});
    answers.seen = [&look](QDialog& dialog) {
        child<QLineEdit>(dialog, "catalogueSearch")->setText(QStringLiteral("3У12"));
        look(*child<QCheckBox>(dialog, "takeStiffness"), *child<QLabel>(dialog, "stiffnessEffect"),
             dialog);
    };
    window.press("fromCatalogue");
    return answers.fault();
}

int stiffnessRows(const QDialog& dialog) {
    const auto* preview = child<QTreeWidget>(dialog, "cataloguePreview");
    return int(preview->findItems(QStringLiteral("stiffness"), Qt::MatchContains).size());
}

class TestStiffnessOffer : public QObject {
    Q_OBJECT

private slots:
    void itsEffectIsThatOfTheEngine() {
        Window window(machinePage);
        QVERIFY(window.bench.open(slenderShaft()));
        window.bench.window->inputs().showPage(machinePage);
        const Project before = window.document().project();
        QString effect;
        const auto look = [&effect](QCheckBox& take, QLabel& shown, QDialog& dialog) {
            QVERIFY(take.isVisible() && take.isChecked());
            QTRY_VERIFY_WITH_TIMEOUT(shown.text().contains(u'→'), 20'000);
            effect = shown.text();
            QCOMPARE(stiffnessRows(dialog), 3);
        };
        QCOMPARE(choose(window, QStringLiteral("Enter"), look), QString());
        const Project& after = window.document().project();
        QCOMPARE(after.machine->name, std::string("3У12"));
        QCOMPARE(after.machine->stiffness_n_um->headstock, 40.0);
        Project without = after;
        without.machine->stiffness_n_um = before.machine->stiffness_n_um;
        for (const Project& project : {without, after}) {
            const OutcomePtr outcome = evaluate(project, {});
            const QString time = Names::fixed(outcome->result.time_s / 60, 3);
            QVERIFY2(effect.contains(time), qPrintable(effect + u' ' + time));
            const auto& sections = outcome->result.sections;
            QVERIFY(effect.contains(Names::significant(1e6 * sections.front().compliance_mm_per_n))
                    || sections.size() > 3);
        }
        QVERIFY2(effect.contains(QStringLiteral(" nm/N")), qPrintable(effect)); // as Compliance
        window.document().undo();
        QCOMPARE(window.document().project().machine->name, before.machine->name);
    }

    void withoutItTheRestOfTheMachineIsTaken() {
        Window window(machinePage);
        QVERIFY(window.bench.open(slenderShaft()));
        window.bench.window->inputs().showPage(machinePage);
        const Stiffness own = *window.document().project().machine->stiffness_n_um;
        const auto look = [](QCheckBox& take, QLabel&, QDialog& dialog) {
            take.setFocus();
            QTest::keyClick(&take, Qt::Key_Space);
            QVERIFY(!take.isChecked());
            QCOMPARE(stiffnessRows(dialog), 0);
        };
        QCOMPARE(choose(window, QStringLiteral("Enter"), look), QString());
        const Machine& machine = *window.document().project().machine;
        QCOMPARE(machine.name, std::string("3У12"));
        QCOMPARE(machine.wheel_drive_kw, std::optional(5.5));
        QCOMPARE(machine.stiffness_n_um->headstock, own.headstock);
        QCOMPARE(machine.stiffness_n_um->wheel_head, own.wheel_head);
    }

    void aGivenComplianceGoesOnlyIfThatIsChosen() {
        for (const bool chosen : {false, true}) {
            Window window(machinePage);
            QVERIFY(window.bench.open(slenderShaft()));
            Project project = window.document().project();
            project.machine->compliance_mm_per_n =
                project.operation->travels
                    ? GivenCompliance(ZoneCompliance{1e-4, 1e-4, 1e-4})
                    : GivenCompliance(std::vector<double>(std::size_t(project.sections), 1e-4));
            window.document().startUntitled(project);
            window.bench.window->inputs().showPage(machinePage);
            window.bench.settle();
            const auto look = [chosen](QCheckBox& take, QLabel& shown, QDialog&) {
                QVERIFY(take.isVisible() && !take.isChecked());
                QTRY_VERIFY_WITH_TIMEOUT(shown.text().contains(u'→'), 20'000);
                QVERIFY(shown.text().contains(Names::significant(1e6 * 1e-4)));
                if (chosen) {
                    take.setFocus();
                    QTest::keyClick(&take, Qt::Key_Space);
                }
            };
            QCOMPARE(choose(window, QStringLiteral("Enter"), look), QString());
            const Machine& machine = *window.document().project().machine;
            QCOMPARE(machine.name, std::string("3У12"));
            QCOMPARE(std::holds_alternative<std::monostate>(machine.compliance_mm_per_n), chosen);
            window.document().undo();
            QVERIFY(sameProject(window.document().project(), project));
        }
    }
};

} // namespace sparkout::test_stiffness_offer

SPARKOUT_TEST(test_stiffness_offer, TestStiffnessOffer)
#include "test_stiffness_offer.moc"
