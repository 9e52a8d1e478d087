// SPDX-License-Identifier: GPL-3.0-or-later
// The exit status of a cycle that misses its size or a requirement.
#include "core/quality/constraints.h"
#include "core/simulation/simulate.h"
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"

namespace test_cli_check {

using namespace sparkout;
using namespace cli;
using nlohmann::json;

class TestCliCheck : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void cannotReachSizeExits3() {
        const ProcessOutcome outcome = run({"simulate", m_stuck, "--json"});
        QCOMPARE(outcome.status, 3);
        QVERIFY(json::parse(outcome.out).at("status") == json("cannot_reach_size"));
        QVERIFY(has(outcome.err, "cannot reach size"));
    }

    void checkExits4WhenARequirementFails() {
        QCOMPARE(run({"simulate", m_strict, "--check"}).status, 4);
        QCOMPARE(run({"simulate", m_strict}).status, 0);
        json loose = samples::sample("complete");
        loose["part"]["lower_deviation_um"] = -200;
        loose["part"]["upper_deviation_um"] = 200;
        loose["part"]["tolerance"]["radial_runout_um"] = 900;
        QCOMPARE(run({"simulate", save("loose.sparkout", loose.dump()), "--check"}).status, 0);
    }

    void wavinessIsStatedWhereTheWheelIsKnown() {
        json file = samples::sample("complete");
        const auto answer = [&] {
            return run({"simulate", save("wavy.sparkout", file.dump())}).out;
        };
        QVERIFY(!has(answer(), "waviness"));
        file["wheel"]["runout"] = {{"amplitude_um", 2}};
        file["part"]["radii_per_section"] = 36;
        QVERIFY(has(run({"simulate", save("few.sparkout", file.dump())}).err,
                    "36 radii do not resolve the waves that the wheel prints"));
        file["part"]["radii_per_section"] = 72;
        QVERIFY(has(answer(), ", most of order "));
    }

    void checkExits4ForEachRequirement_data() {
        addColumns<QString, QString, double, double>("name", "path", "holds", "fails");
        QStringList named;
        const auto row = [&named](const char* name, const char* path, double holds, double fails) {
            QTest::newRow(name) << name << path << holds << fails;
            named += name;
        };
        row("diameter_min", "/part/lower_deviation_um", -200, 100);
        row("diameter_max", "/part/upper_deviation_um", 200, -100);
        row("radial_runout", "/part/tolerance/radial_runout_um", 50, 1e-9);
        row("roundness", "/part/tolerance/roundness_um", 50, 1e-9);
        row("cylindricity", "/part/tolerance/cylindricity_um", 50, 1e-9);
        row("total_runout", "/part/tolerance/total_runout_um", 50, 1e-9);
        row("waviness", "/part/tolerance/waviness_um", 50, 1e-3);
        row("roughness", "/part/tolerance/roughness_ra_um", 50, 1e-6);
        row("burn", "/material/burn_rise_k", 3000, 50);
        row("self_sharpening", "/wheel/grains_per_mm2", 1000, 0.01);
        row("wheel_power", "/machine/wheel_drive_kw", 100, 0.001);
        row("work_power", "/machine/work_drive_kw", 100, 0.00001);
        row("range_radial_feed", "/machine/limits/radial_feed_mm/1", 0.02, 0.002);
        row("range_axial_feed", "/machine/limits/axial_feed_mm_min/1", 5000, 400);
        row("range_plunge_feed", "/machine/limits/plunge_feed_mm_min/1", 5, 0.1);
        row("range_continuous_feed", "/machine/limits/continuous_feed_mm_min/1", 1, 0.01);
        row("range_work_speed", "/machine/limits/work_speed_rpm/1", 500, 100);
        row("gauge_commands", "/gauge/commands", 5, 1);
        row("overlap", "/cycle/stages/0/axial_feed_mm_min", 900, 9100);
        row("least_overlap", "/least_overlap", 1, 900);
        row("least_overlap_last", "/least_overlap_last", 1, 900);
        row("least_steps", "/least_steps", 1, 900);
        for (int kind = 0; kind < constraintKinds; ++kind) {
            QVERIFY(named.contains(requirementOf(static_cast<ConstraintKind>(kind)).key));
        }
    }

    void checkExits4ForEachRequirement() {
        QFETCH(QString, name);
        QFETCH(QString, path);
        QFETCH(double, holds);
        QFETCH(double, fails);
        for (const double limit : {holds, fails}) {
            const QString saved = save("one.sparkout", withOneRequirement(path, limit).dump());
            const ProcessOutcome outcome = run({"simulate", saved, "--check", "--json"});
            QCOMPARE(outcome.status, limit == holds ? 0 : 4);
            bool listed = false;
            int unknown = 0;
            const bool strips = name == QStringLiteral("overlap") && limit == fails;
            const json answer = json::parse(outcome.out);
            for (const json& constraint : answer.at("constraints")) {
                const bool found = constraint.at("name") == name.toStdString();
                listed = listed || found;
                const bool known = !constraint.at("value").is_null(); // of the whole surface
                QVERIFY(known || (strips && !found));
                QVERIFY(constraint.at("ok") == (known && (!found || limit == holds)));
                unknown += known ? 0 : 1;
            }
            QVERIFY(listed);
            QCOMPARE(answer.contains("strips_uncut"), strips);
            QCOMPARE(unknown > 0, strips);
            if (strips) {
                QVERIFY(answer.at("zones").at("nz").at("diameter_deviation_um").is_null());
                const std::string text = run({"simulate", saved}).out;
                QVERIFY(has(text, "strips stay uncut"));
                QVERIFY(has(text, "not known: strips uncut"));
                for (const char* word :
                     {"deviations", "cylindricity, µm", "taper", "total runout, µm"}) {
                    QVERIFY2(!has(text, word), word);
                }
            }
        }
    }

private:
    static bool isWhole(const QString& path) {
        return path == "/gauge/commands" || path == "/least_steps";
    }

    /// A project in which one requirement may fail, at the limit given.
    static json withOneRequirement(const QString& path, double limit) {
        json file = samples::sample("complete");
        file["part"]["lower_deviation_um"] = -200;
        file["part"]["upper_deviation_um"] = 200;
        file["part"]["target_diameter_mm"] = 30;
        file["part"]["tolerance"] = json::object();
        file["material"]["burn_rise_k"] = nullptr;
        file["machine"]["wheel_drive_kw"] = nullptr;
        const json limits = file["machine"]["limits"];
        file["machine"]["limits"] = json::object();
        if (path.endsWith("waviness_um")) {
            file["wheel"]["runout"] = {{"amplitude_um", 2}};
            file["part"]["radii_per_section"] = 72;
        }
        if (path.startsWith("/machine/limits/")) {
            const std::string range = path.section('/', 3, 3).toStdString();
            const bool isContinuous = range == "continuous_feed_mm_min";
            file["machine"]["limits"][range] =
                isContinuous ? json::array({0.001, 1, 0.001}) : limits.at(range);
            if (isContinuous) {
                file["cycle"]["stages"][0][range] = 0.02;
            }
        }
        if (path.startsWith("/wheel/")) {
            for (const auto& [key, value] :
                 {std::pair("grain_surface_energy_j_m2", 20.0),
                  std::pair("grain_modulus_gpa", 380.0), std::pair("bond_surface_energy_j_m2", 5.0),
                  std::pair("bond_modulus_gpa", 70.0)}) {
                file["wheel"][key] = value;
            }
        }
        json& place = file[json::json_pointer(path.toStdString())];
        if (isWhole(path)) {
            place = static_cast<int>(limit);
        } else {
            place = limit;
        }
        return file;
    }

    const QString m_stuck = save("stuck.sparkout", stuckProject().dump());
    const QString m_strict = save("strict.sparkout", strictProject().dump());
};

} // namespace test_cli_check

SPARKOUT_TEST(test_cli_check, TestCliCheck)
#include "test_cli_check.moc"
