// SPDX-License-Identifier: GPL-3.0-or-later
// What the operation card has beside the cycle: in the file, in a set-up, and the mass of a shaft.
#include "core/project/number_input.h"
#include "core/setup/setup_file.h"
#include "core/simulation/simulate.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"
#include "tests/whole_project.h"

namespace sparkout::test_card_entries {

using nlohmann::json;

json withEntries() {
    json project = samples::sample("complete");
    project["card"] = {{"part_number", "7716-03.021"}, {"document_number", "АБВГ.60141.00012"},
                       {"operation_number", "045"},    {"letter", "А"},
                       {"program", "O1204"},           {"mass_kg", 2.25},
                       {"blank", "Круг 50 ГОСТ 2590"}, {"blank_mass_kg", 4.9}};
    return project;
}

class TestCardEntries : public QObject {
    Q_OBJECT

private slots:
    void aFileKeepsThem() {
        const json file = withEntries();
        const ReadResult read = readProject(file.dump());
        QVERIFY2(read.project, samples::listed(read.issues).c_str());
        const CardEntries& entries = *read.project->card;
        QCOMPARE(entries.part_number, std::string("7716-03.021"));
        QCOMPARE(entries.program, std::string("O1204"));
        QCOMPARE(entries.mass_kg, 2.25);
        QCOMPARE(entries.blank_mass_kg, 4.9);
        QVERIFY(json::parse(writeProject(*read.project))["card"] == file["card"]);
    }

    void whatIsNotGivenIsNotWritten() {
        json file = samples::sample("complete");
        file.erase("card");
        Project project = *readProject(file.dump()).project;
        QVERIFY(!json::parse(writeProject(project)).contains("card"));
        project.card->letter = "А";
        QVERIFY(json::parse(writeProject(project))["card"] == json({{"letter", "А"}}));
    }

    void faultsNameTheirPlace() {
        const auto faultAt = [](const char* key, const json& value) {
            json file = withEntries();
            file["card"][key] = value;
            const ReadResult read = readProject(file.dump());
            return read.project || read.issues.empty() ? std::string() : read.issues.front().path;
        };
        QCOMPARE(faultAt("mass_kg", 0), std::string("/card/mass_kg"));
        QCOMPARE(faultAt("blank_mass_kg", "heavy"), std::string("/card/blank_mass_kg"));
        QCOMPARE(faultAt("blank", 7), std::string("/card/blank"));
        QCOMPARE(faultAt("colour", "red"), std::string("/card/colour"));
    }

    /// The surfaces of a set-up share them, as its card is one.
    void aSetUpHasThemOnce() {
        Setup setup = *readSetup(withEntries().dump()).setup;
        setup.surfaces.push_back(setup.surfaces.front());
        setup.surfaces.front().name = "A";
        setup.surfaces.back().name = "B";
        const json written = json::parse(writeSetup(setup));
        QVERIFY(written["card"] == withEntries()["card"]);
        QVERIFY(!written["surfaces"][0].contains("card"));
        const auto again = readSetup(written.dump()).setup;
        QVERIFY(again && sameSetup(*again, setup));
        QCOMPARE(again->surfaces.back().project.card->mass_kg, 2.25);
        json wrong = written;
        wrong["surfaces"][1]["card"] = {{"letter", "О"}};
        const ReadSetup refused = readSetup(wrong.dump());
        QVERIFY(!refused.setup);
        QCOMPARE(refused.issues.front().path, std::string("/surfaces/1/card"));
    }

    /// No cycle reads them: nothing to sweep, the same result.
    void noCycleReadsThem() {
        const Project project = *readProject(withEntries().dump()).project;
        QVERIFY(!numberInput(project, "/card/mass_kg"));
        QVERIFY(std::ranges::none_of(numberInputs(project), [](const NumberInput& input) {
            return input.path.starts_with("/card");
        }));
        Project bare = project;
        *bare.card = {};
        QCOMPARE(simulate(project).time_s, simulate(bare).time_s);
    }

    /// π/4·(30²·100 + 50²·40)·7.85e-6 kg, by hand: 0.55488 + 0.61654 = 1.17142 kg.
    void aShaftWeighsWhatItsSegmentsDo() {
        Shaft shaft;
        QVERIFY(!steelMass_kg(shaft));
        shaft.segments = {{100, 30}, {40, 50}};
        QCOMPARE(steelMass_kg(shaft), 1.17);
        shaft.segments = {{1000, 100}}; // 61.65 kg
        QCOMPARE(steelMass_kg(shaft), 61.7);
        shaft.segments = {{10, 2}}; // 0.2466 g
        QCOMPARE(steelMass_kg(shaft), 0.000247);
    }
};

} // namespace sparkout::test_card_entries

SPARKOUT_TEST(test_card_entries, TestCardEntries)
#include "test_card_entries.moc"
