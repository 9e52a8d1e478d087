// SPDX-License-Identifier: GPL-3.0-or-later
// Catalogues: read strictly, used in a project, saved as one's own.
#include "core/catalogue/catalogue.h"
#include "core/file/struct_json.h"

#include "tests/core/catalogue/shipped_catalogues.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_catalogue {

using namespace catalogues;
using fixtures::close;
using nlohmann::json;

/// One material as small as it may be.
json smallest() {
    return {{"format", "sparkout-catalogue"},
            {"version", 1},
            {"kind", "materials"},
            {"entries",
             {{{"name", "40Х"},
               {"value", {{"grade", "40Х"}, {"conductivity_w_mk", 38.5}}},
               {"sources", {{{"key", "conductivity_w_mk"}, {"source", "ALORO40X"}}}}}}}};
}

class TestCatalogue : public QObject {
    Q_OBJECT

private slots:
    // --- reading, strictly ----------------------------------------------------------------------

    void smallestCatalogueIsRead() {
        const auto read = readCatalogue<MaterialEntry>(smallest().dump());
        QVERIFY(read.entries && read.entries->size() == 1 && read.issues.empty());
        QCOMPARE(read.entries->front().value.conductivity_w_mk, 38.5);
        QVERIFY(!isEstimate(*sourceOf(read.entries->front().sources, "conductivity_w_mk")));
        QVERIFY(!sourceOf(read.entries->front().sources, "friction"));
    }

    void faultsAreRefusedWithTheirPath_data() {
        addColumns<QByteArray, QString, int>("text", "path", "code");
        const auto row = [](const char* name, const json& text, const char* path, IssueCode code) {
            QTest::newRow(name) << QByteArray::fromStdString(text.dump()) << path << int(code);
        };
        const auto with = [](const char* pointer, const json& value) {
            json text = smallest();
            text[json::json_pointer(pointer)] = value;
            return text;
        };
        row("not an object", json::array(), "", IssueCode::wrongType);
        row("another format", with("/format", "sparkout-project"), "/format", IssueCode::notOneOf);
        row("newer", with("/version", 2), "/version", IssueCode::notOneOf);
        row("another kind", with("/kind", "wheels"), "/kind", IssueCode::notOneOf);
        row("unknown key", with("/author", "x"), "/author", IssueCode::unknownKey);
        row("entries", with("/entries", 1), "/entries", IssueCode::wrongType);
        row("entry", with("/entries/0", 1), "/entries/0", IssueCode::wrongType);
        row("unknown key of an entry", with("/entries/0/colour", "red"), "/entries/0/colour",
            IssueCode::unknownKey);
        row("unknown value", with("/entries/0/value/weight_kg", 1), "/entries/0/value/weight_kg",
            IssueCode::unknownKey);
        row("text for a number", with("/entries/0/value/conductivity_w_mk", "38"),
            "/entries/0/value/conductivity_w_mk", IssueCode::wrongType);
        row("number outside the limits", with("/entries/0/value/conductivity_w_mk", -1),
            "/entries/0/value/conductivity_w_mk", IssueCode::outOfRange);
        row("number without a source", with("/entries/0/value/friction", 0.3),
            "/entries/0/value/friction", IssueCode::sourceMissing);
        row("source without a number", with("/entries/0/sources/1", {{"key", "friction"}}),
            "/entries/0/sources/1/key", IssueCode::unknownKey);
        row("reference of what is not known",
            with("/entries/0/sources/1", {{"key", "burn_rise_k"}, {"source", "ALORO40X"}}),
            "/entries/0/sources/1/key", IssueCode::unknownKey);
        row("range of what is not known",
            with("/entries/0/sources/1", {{"key", "burn_rise_k"}, {"range", {1, 2}}}),
            "/entries/0/value/burn_rise_k", IssueCode::missingKey);
        row("two sources", with("/entries/0/sources/1", {{"key", "conductivity_w_mk"}}),
            "/entries/0/sources/1/key", IssueCode::duplicateKey);
        row("outside its own range", with("/entries/0/sources/0/range", {40, 50}),
            "/entries/0/value/conductivity_w_mk", IssueCode::outOfRange);
        row("half a range", with("/entries/0/sources/0/range", {40}), "/entries/0/sources/0/range",
            IssueCode::wrongCount);
        row("falling temperatures",
            with("/entries/0/thermal", {{"conductivity_w_mk_at_c", {{100, 40}, {50, 41}}}}),
            "/entries/0/thermal/conductivity_w_mk_at_c/1/0", IssueCode::outOfRange);
        row("no conductivity",
            with("/entries/0/thermal", {{"conductivity_w_mk_at_c", {{100, 0}, {150, 41}}}}),
            "/entries/0/thermal/conductivity_w_mk_at_c/0/1", IssueCode::outOfRange);
        json nameless = smallest();
        nameless["entries"][0].erase("name");
        row("no name", nameless, "/entries/0/name", IssueCode::missingKey);
        json headless = smallest();
        headless.erase("format");
        row("no format", headless, "/format", IssueCode::missingKey);
    }
    void faultsAreRefusedWithTheirPath() {
        QFETCH(QByteArray, text);
        QFETCH(QString, path);
        QFETCH(int, code);
        const auto read = readCatalogue<MaterialEntry>(text.toStdString());
        QVERIFY(!read.entries);
        const auto found = std::ranges::find(read.issues, path.toStdString(), &Issue::path);
        QVERIFY2(found != read.issues.end(), samples::listed(read.issues).c_str());
        QCOMPARE(int(found->code), code);
        QVERIFY(!issueSentence(*found).empty());
    }

    void damagedTextIsAnswered() {
        const std::string text = shippedText("machines");
        for (std::size_t at = 0; at < text.size(); at += 211) {
            const auto cut = readCatalogue<MachineEntry>(text.substr(0, at));
            QVERIFY(!cut.entries && !cut.issues.empty());
            std::string flipped = text;
            flipped[at] = static_cast<char>(flipped[at] ^ 0x15);
            const auto read = readCatalogue<MachineEntry>(flipped);
            QVERIFY(read.entries.has_value() != hasErrors(read.issues));
        }
    }

    // --- using ----------------------------------------------------------------------------------

    void entryChangesOnlyWhatItGives() {
        Project project = fixtures::plunge();
        project.material->friction = 0.41;
        project.material->heat_share = 0.8;
        const Project before = project;
        applyEntry(readCatalogue<MaterialEntry>(smallest().dump()).entries->front(), project);
        QCOMPARE(project.material->grade, std::string("40Х"));
        QCOMPARE(project.material->conductivity_w_mk, 38.5);
        QCOMPARE(project.material->friction, 0.41);
        project.material = before.material;
        QVERIFY(sameProject(project, before));
    }

    void whatIsNotKnownIsTakenOut() {
        Project project = fixtures::plunge();
        project.material->burn_rise_k = 700;
        project.material->hardness_hrc = 60;
        json text = smallest();
        text["entries"][0]["sources"][1] = {{"key", "burn_rise_k"}, {"note", "nowhere found"}};
        const auto read = readCatalogue<MaterialEntry>(text.dump());
        QVERIFY2(read.entries, samples::listed(read.issues).c_str());
        const MaterialEntry& entry = read.entries->front();
        applyEntry(entry, project);
        QVERIFY(!project.material->burn_rise_k);
        QCOMPARE(*project.material->hardness_hrc, 60.0); // of which it says nothing
        const auto again = readCatalogue<MaterialEntry>(writeCatalogue<MaterialEntry>({entry}));
        QVERIFY(again.entries && sourceOf(again.entries->front().sources, "burn_rise_k"));
    }

    void machineGivesItsUnitsAndRanges() {
        Project project = fixtures::plunge();
        project.machine->dwell_entry_s = 0.7;
        const auto machines = shipped<MachineEntry>();
        const auto found = std::ranges::find(machines, "3М151", &MachineEntry::name);
        QVERIFY(found != machines.end());
        applyEntry(*found, project);
        QCOMPARE(project.machine->name, std::string("3М151"));
        QVERIFY(project.machine->stiffness_n_um && project.machine->wheel_drive_kw);
        QCOMPARE(project.machine->stiffness_n_um->tailstock,
                 found->value.stiffness_n_um->tailstock);
        QCOMPARE(project.machine->dwell_entry_s, 0.7);
        QVERIFY(std::holds_alternative<std::vector<double>>(project.machine->compliance_mm_per_n));
    }

    /// An internal grinder has no seat of 305 mm, and none of the other limits of the machine that
    /// stood in the project before it.
    void limitsOfTheMachineBeforeDoNotStay() {
        Project project = fixtures::plunge();
        const auto machines = shipped<MachineEntry>();
        for (const MachineEntry& before : machines) {
            for (const MachineEntry& entry : machines) {
                applyEntry(before, project);
                applyEntry(entry, project);
                QCOMPARE(writeByTable(tableOf<MachineLimits>(), &project.machine->limits).dump(),
                         writeByTable(tableOf<MachineLimits>(), &entry.value.limits).dump());
            }
        }
        // One's own machine may have none, and a form of which the lobes are not known.
        Project mine = fixtures::plunge();
        mine.machine->limits = {};
        mine.machine->form.emplace().roundness_um = std::vector<double>{1, 1, 1, 1};
        const MachineEntry entry = entryOf<MachineEntry>(mine, "mine");
        project.machine->form.emplace().lobes = 5;
        applyEntry(entry, project);
        QVERIFY(!project.machine->limits.wheel_bore_mm && !project.machine->limits.part_length_mm);
        QVERIFY(project.machine->form && !project.machine->form->lobes);
    }

    void everyMachineHasItsAccuracyAndItsSpeeds() {
        for (const MachineEntry& entry : shipped<MachineEntry>()) {
            const Machine& machine = entry.value;
            QVERIFY2(machine.geometric_runout_um > 0 && machine.gauge_repeatability_um
                         && machine.gauge_drift_um_h && machine.gauge_delay_s
                         && machine.limits.wheel_speed_m_s && machine.limits.work_speed_rpm,
                     entry.name.c_str());
            QVERIFY2(*machine.limits.wheel_speed_m_s >= machine.wheel_speed_m_s,
                     entry.name.c_str());
        }
    }

    void ownEntryTakesThePlaceOfTheShippedOne() {
        MaterialEntry mine = entryOf<MaterialEntry>(fixtures::plunge(), "45");
        MaterialEntry other = mine;
        other.name = "Сталь 10";
        MaterialEntry third = mine;
        third.name = "Сталь 9";
        const auto all = mergedEntries(shipped<MaterialEntry>(), {mine, other, third});
        QCOMPARE(all.size(), shipped<MaterialEntry>().size() + 2);
        const auto found = std::ranges::find(all, "45", &MaterialEntry::name);
        QCOMPARE(found->value.flow_stress_mpa, 2000.0);
        QVERIFY(std::ranges::find(all, third.name, &MaterialEntry::name)
                < std::ranges::find(all, other.name, &MaterialEntry::name));
        const auto again = mergedEntries(shipped<MaterialEntry>(), {third, mine, other});
        QVERIFY(std::ranges::equal(all, again, {}, &MaterialEntry::name, &MaterialEntry::name));
    }

    void savedAsMineComesBackWhole() {
        Project project = fixtures::traverse();
        project.material->hardness_hrc = 57;
        project.machine->stiffness_n_um = Stiffness{11, 12, 13};
        project.machine->wheel_contact = WheelContact{{{{10, 5}, {20, 9}}}};
        project.wheel->marking = "25А F60 L 6 V";
        QVERIFY(writtenAndRead<MaterialEntry>(project, [](const Project& a, const Project& b) {
            return a.material->hardness_hrc == b.material->hardness_hrc
                   && a.material->friction == b.material->friction;
        }));
        QVERIFY(writtenAndRead<WheelEntry>(project, [](const Project& a, const Project& b) {
            return a.wheel->marking == b.wheel->marking && a.wheel->dullness == b.wheel->dullness;
        }));
        QVERIFY(writtenAndRead<MachineEntry>(project, [](const Project& a, const Project& b) {
            return a.machine->stiffness_n_um->wheel_head == b.machine->stiffness_n_um->wheel_head
                   && a.machine->wheel_contact->n_um_at_n == b.machine->wheel_contact->n_um_at_n
                   && a.machine->compliance_mm_per_n == b.machine->compliance_mm_per_n;
        }));
    }

    void whatCannotBeReadAgainIsRefused() {
        auto entries = shipped<MaterialEntry>();
        QVERIFY(std::holds_alternative<std::string>(checkedCatalogue(entries)));
        for (const double refused : {-5.0, std::nan("")}) {
            entries[0].value.conductivity_w_mk = refused;
            QVERIFY(std::holds_alternative<Issues>(checkedCatalogue(entries)));
        }
    }

    // λ/(ρ·c) by hand, between two rows, and nothing where no row is.
    void heatDataAreInterpolated() {
        ThermalData data;
        data.density_kg_m3 = 7800;
        data.conductivity_w_mk_at_c = {{{100, 46}, {300, 42}, {500, 36}}};
        data.heat_capacity_j_kgk_at_c = {{{100, 470}, {500, 590}}};
        const auto at = thermalAt(data, 200);
        QVERIFY(at && close(at->conductivity_w_mk, 44, 1e-15));
        QVERIFY(close(at->diffusivity_mm2_s, 44 / (7800 * 500.0) * 1e6, 1e-14));
        QVERIFY(thermalAt(data, 100) && thermalAt(data, 500));
        QVERIFY(!thermalAt(data, 99) && !thermalAt(data, 501));
        data.density_kg_m3.reset();
        QVERIFY(!thermalAt(data, 200));
        QVERIFY(!thermalAt(ThermalData{}, 400));
    }

private:
    template <class Entry>
    static bool writtenAndRead(const Project& project, auto same) {
        const std::vector<Entry> mine{entryOf<Entry>(project, "моё")};
        const auto text = checkedCatalogue(mine);
        if (!std::holds_alternative<std::string>(text)) {
            return false;
        }
        const auto read = readCatalogue<Entry>(std::get<std::string>(text));
        Project other;
        if (read.entries) {
            applyEntry(read.entries->front(), other);
        }
        return read.entries && read.entries->front().name == "моё" && same(project, other);
    }
};

} // namespace sparkout::test_catalogue

SPARKOUT_TEST(test_catalogue, TestCatalogue)
#include "test_catalogue.moc"
