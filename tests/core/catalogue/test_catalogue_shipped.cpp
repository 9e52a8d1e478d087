// SPDX-License-Identifier: GPL-3.0-or-later
// What is shipped: whole, sourced, told in both languages, and good for a project.
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "tests/core/catalogue/shipped_catalogues.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

#include <regex>
#include <set>

namespace sparkout::test_catalogue_shipped {

using namespace catalogues;
using fixtures::close;

/// The keys that core/SOURCES.md explains.
std::set<std::string> sourceKeys() {
    std::set<std::string> keys;
    std::istringstream lines(samples::readText(samples::sourcePath("core/SOURCES.md")));
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_search(line, match, std::regex("^\\| ([A-Z0-9]+) \\|"))) {
            keys.insert(match[1]);
        }
    }
    for (int section = 1; section <= 11; ++section) {
        keys.insert("MODEL-" + std::to_string(section));
    }
    return keys;
}

/// Whether an entry has this number; else it says that it is not known.
template <class Entry>
bool isGiven(const Entry& entry, const std::string& key) {
    const StructInfo& table = tableOf<decltype(entry.value)>();
    const Field* const field = table.find(key.substr(0, key.find('/')));
    return field->kind != Kind::optionalNumber
           || field->as<std::optional<double>>(&entry.value).has_value();
}

template <class Entry>
std::string every(const std::vector<Entry>& entries, auto fault) {
    if (entries.empty()) {
        return "there are none";
    }
    for (const Entry& entry : entries) {
        for (const ValueSource& source : entry.sources) {
            const std::string text = fault(entry, source);
            if (!text.empty()) {
                return entry.name + ", " + source.key + ": " + text;
            }
        }
    }
    return {};
}

class TestCatalogueShipped : public QObject {
    Q_OBJECT

private slots:
    void shippedCataloguesAreReadAndWrittenUnchanged() {
        QVERIFY(shippedRoundTrips<MaterialEntry>());
        QVERIFY(shippedRoundTrips<WheelEntry>());
        QVERIFY(shippedRoundTrips<MachineEntry>());
    }

    void shippedCataloguesHoldWhatTheShopAsksFor() {
        std::set<std::string> names;
        for (const MaterialEntry& entry : shipped<MaterialEntry>()) {
            names.insert(entry.name);
        }
        QVERIFY(names.size() >= 12);
        for (const char* grade : {"40Х", "45", "ШХ15", "18ХГТ", "12ХН3А", "20Х", "38Х2МЮА", "У8",
                                  "Р6М5", "9ХС", "30ХГСА"}) {
            QVERIFY2(names.count(grade), grade);
        }
        std::set<int> grits;
        for (const WheelEntry& entry : shipped<WheelEntry>()) {
            grits.insert(readWheelMarking(entry.value.marking)->grit);
        }
        for (const int grit : {36, 46, 54, 60, 80, 100, 120}) {
            QVERIFY2(grits.count(grit), std::to_string(grit).c_str());
        }
        names.clear();
        for (const MachineEntry& entry : shipped<MachineEntry>()) {
            names.insert(entry.name);
        }
        QVERIFY(names.size() >= 8);
        for (const char* model : {"3М151", "3М132", "3У10"}) {
            QVERIFY2(names.count(model), model);
        }
    }

    void everyShippedValueSaysWhereItComesFrom() {
        const std::set<std::string> known = sourceKeys();
        QVERIFY(known.count("ALORO40X") && !known.count("NOBODY"));
        const auto fault = [&](const auto& entry, const ValueSource& source) -> std::string {
            if (!isEstimate(source)) {
                return known.count(source.source) ? "" : "source " + source.source;
            }
            if (!isGiven(entry, source.key)) {
                return source.range ? "a range of what is not known" : "";
            }
            if (source.note.rfind("estimate, to be calibrated", 0) != 0) {
                return "is not called an estimate";
            }
            const bool list = source.key.rfind("limits/", 0) == 0;
            return source.range || list ? "" : "has no plausible range";
        };
        QCOMPARE(every(shipped<MaterialEntry>(), fault), std::string());
        QCOMPARE(every(shipped<WheelEntry>(), fault), std::string());
        QCOMPARE(every(shipped<MachineEntry>(), fault), std::string());
        for (const MaterialEntry& entry : shipped<MaterialEntry>()) {
            QVERIFY2(!entry.thermal || known.count(entry.thermal->source), entry.name.c_str());
        }
    }

    void everyShippedNoteIsInBothLanguages() {
        const auto fault = [](const auto& entry, const ValueSource& source) -> std::string {
            const std::regex cyrillic("[а-яё]|HRC");
            if (entry.note.empty() || !std::regex_search(entry.note_ru, std::regex("[а-яё]"))) {
                return "the entry's note";
            }
            return source.note.empty() == source.note_ru.empty()
                           && (source.note.empty() || std::regex_search(source.note_ru, cyrillic))
                       ? ""
                       : "note " + source.note;
        };
        QCOMPARE(every(shipped<MaterialEntry>(), fault), std::string());
        QCOMPARE(every(shipped<WheelEntry>(), fault), std::string());
        QCOMPARE(every(shipped<MachineEntry>(), fault), std::string());
    }

    // What has no public source is never claimed to have one.
    void flowStressDullnessAndStiffnessAreEstimates() {
        for (const MaterialEntry& entry : shipped<MaterialEntry>()) {
            QVERIFY(isEstimate(*sourceOf(entry.sources, "flow_stress_mpa")));
        }
        for (const WheelEntry& entry : shipped<WheelEntry>()) {
            QVERIFY(isEstimate(*sourceOf(entry.sources, "dullness")));
            for (const char* key : {"grain_surface_energy_j_m2", "grain_modulus_gpa",
                                    "bond_surface_energy_j_m2", "bond_modulus_gpa"}) {
                QVERIFY2(sourceOf(entry.sources, key) && !isGiven(entry, key), key);
            }
        }
        for (const MachineEntry& entry : shipped<MachineEntry>()) {
            QVERIFY(isEstimate(*sourceOf(entry.sources, "stiffness_n_um/wheel_head")));
            QVERIFY(!sourceOf(entry.sources, "compliance_mm_per_n"));
        }
    }

    void heatDataAgreeWithTheValuesTakenFromThem() {
        int withData = 0;
        for (const MaterialEntry& entry : shipped<MaterialEntry>()) {
            if (!entry.thermal) {
                continue;
            }
            ++withData;
            const auto at = thermalAt(*entry.thermal, entry.thermal->at_c);
            QVERIFY2(at, entry.name.c_str());
            QVERIFY(close(entry.value.conductivity_w_mk, at->conductivity_w_mk, 1e-12));
            QVERIFY(close(entry.value.diffusivity_mm2_s, at->diffusivity_mm2_s, 1e-3));
        }
        QVERIFY(withData >= 4);
    }

    void everyShippedEntryMakesAValidProject() {
        for (const MaterialEntry& entry : shipped<MaterialEntry>()) {
            Project project = fixtures::plunge();
            applyEntry(entry, project);
            QVERIFY2(!hasErrors(validate(project)), entry.name.c_str());
            // One grade may stand there in several heat treatments: "40Х 28 HRC".
            QCOMPARE(project.material->grade, entry.name.substr(0, entry.name.find(' ')));
        }
        for (const MachineEntry& entry : shipped<MachineEntry>()) {
            Project project = fixtures::plunge();
            applyEntry(entry, project);
            QVERIFY2(!hasErrors(validate(project)), entry.name.c_str());
            const auto& speeds = *project.machine->limits.work_speed_rpm;
            QVERIFY(speeds[0] < speeds[1] && speeds[2] > 0 && speeds[2] < speeds[1] - speeds[0]);
        }
    }

    void wheelsAreWhatTheirMarkingsSay() {
        for (const WheelEntry& entry : shipped<WheelEntry>()) {
            const auto marking = readWheelMarking(entry.value.marking);
            QVERIFY2(marking, entry.name.c_str());
            QCOMPARE(markingText(*marking), entry.value.marking);
            QCOMPARE(entry.name, entry.value.marking);
            Wheel wheel;
            applyMarking(*marking, wheel);
            QCOMPARE(entry.value.diameter_mm, wheel.diameter_mm);
            QCOMPARE(entry.value.width_mm, wheel.width_mm);
            QCOMPARE(entry.value.grain_mm, wheel.grain_mm);
            QVERIFY(close(entry.value.grain_share, wheel.grain_share, 1e-12));
            QVERIFY(entry.value.grain_share + entry.value.bond_share < 0.9); // pores remain
        }
    }

private:
    template <class Entry>
    static bool shippedRoundTrips() {
        const std::string text = shippedText(kindOf<Entry>());
        const auto read = readCatalogue<Entry>(text);
        for (const Issue& issue : read.issues) {
            qWarning("%s %s", issue.path.c_str(), issueSentence(issue).c_str());
        }
        return read.entries && !read.entries->empty() && writeCatalogue(*read.entries) == text;
    }
};

} // namespace sparkout::test_catalogue_shipped

SPARKOUT_TEST(test_catalogue_shipped, TestCatalogueShipped)
#include "test_catalogue_shipped.moc"
