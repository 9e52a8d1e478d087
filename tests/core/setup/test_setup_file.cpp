// SPDX-License-Identifier: GPL-3.0-or-later
// Files of one surface and of several.
#include "core/file/project_json.h"
#include "core/setup/setup.h"
#include "core/setup/split_project.h"
#include "tests/check_line.h"
#include "tests/core/setup/setup_samples.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"
#include "tests/whole_project.h"

namespace sparkout::test_setup_file {

using namespace setup_samples;
using nlohmann::json;

json twoSurfaces() {
    return setupOf({samples::sample("complete"), samples::sample("complete")});
}

bool names(const json& file, IssueCode code, const std::string& path) {
    const ReadSetup read = readSetup(file.dump());
    return !read.setup && std::ranges::any_of(read.issues, [&](const Issue& issue) {
        return issue.code == code && issue.path == path;
    });
}

/// Whether the only fault of a file is this one.
bool isRefused(const json& file, IssueCode code, const std::string& path) {
    const ReadSetup read = readSetup(file.dump());
    const auto errors = std::ranges::count(read.issues, Severity::error, &Issue::severity);
    return !read.setup && errors == 1 && std::ranges::any_of(read.issues, [&](const Issue& issue) {
        return issue.code == code && issue.path == path;
    });
}

class TestSetupFile : public QObject {
    Q_OBJECT

private slots:
    void aFileOfVersionOneIsOneSurface() {
        for (const std::string& name : samples::names()) {
            const std::string text = samples::text(name);
            const ReadResult project = readProject(text);
            const ReadSetup setup = readSetup(text);
            QVERIFY(setup.setup && setup.setup->surfaces.size() == 1);
            QVERIFY(setup.setup->surfaces.front().name.empty());
            QVERIFY(sameProject(setup.setup->surfaces.front().project, *project.project));
            QVERIFY(setup.issues == project.issues);
            QCOMPARE(writeSetup(*setup.setup), writeProject(*project.project));
        }
    }

    void whatIsSharedStandsOnce() {
        const json file = json::parse(writeSetup(*readSetup(twoSurfaces().dump()).setup));
        QCOMPARE(file.at("version").get<int>(), 2);
        for (const char* place : sharedPlaces) {
            const json::json_pointer pointer(place);
            for (const json& surface : file.at("surfaces")) {
                QVERIFY2(!surface.contains(pointer), place);
            }
        }
        QVERIFY(file.contains("wheel") && file.at("machine").contains("wheel_speed_m_s"));
        QVERIFY(!file.at("machine").contains("work_speed_rpm") && !file.contains("cycle"));
    }

    /// Every project of a set-up is that of its own file with what is shared of the first.
    void surfacesAreReadAsTheirOwnFilesWouldBe() {
        const json one = samples::sample("complete");
        json other = one;
        other["machine"]["work_speed_rpm"] = 111;
        other["part"]["stock_mm"] = 0.2;
        other["part"]["shaft"]["ground_from_mm"] = 3.5;
        other["cycle"]["stages"][0]["stock_mm"] =
            0.2 - other["cycle"]["stages"][1]["stock_mm"].get<double>();
        json otherWheel = other;
        otherWheel["wheel"]["diameter_mm"] = 333; // of a surface after the first it is not read
        const ReadSetup read = readSetup(setupOf({one, otherWheel}).dump());
        QVERIFY2(read.setup, samples::listed(read.issues).c_str());
        QVERIFY(sameProject(read.setup->surfaces[0].project, *readProject(one.dump()).project));
        QVERIFY(sameProject(read.setup->surfaces[1].project, *readProject(other.dump()).project));
        QCOMPARE(read.setup->surfaces[1].project.machine->work_speed_rpm, 111.0);
    }

    void randomSetupsAreWrittenAndReadAsTheSame() {
        const int seeds = samples::sized(300, 100, 1000);
        int several = 0;
        for (std::uint64_t seed = 0; seed < std::uint64_t(seeds); ++seed) {
            auto setup = randomSetup(seed);
            if (!setup) {
                continue;
            }
            setup->times.handling_s = static_cast<double>(seed % 7);
            setup->wear.grinding_ratio = 1.0 + static_cast<double>(seed);
            several += setup->surfaces.size() > 1;
            const std::string text = writeSetup(*setup);
            const ReadSetup again = readSetup(text);
            QVERIFY2(again.setup, samples::listed(again.issues).c_str());
            QCOMPARE(writeSetup(*again.setup), text);
            QCOMPARE(again.setup->surfaces.size(), setup->surfaces.size());
            for (std::size_t i = 0; i < setup->surfaces.size(); ++i) {
                QVERIFY(sameProject(again.setup->surfaces[i].project, setup->surfaces[i].project));
            }
        }
        QVERIFY2(10 * several > seeds, qPrintable(QString::number(several)));
    }

    /// Work in progress: rules between values are broken in one of the surfaces.
    void unfinishedWorkIsReadWithItsFaults() {
        json file = twoSurfaces();
        file["surfaces"][1]["part"]["lower_deviation_um"] = 9; // above the upper one
        const ReadSetup read = readSetup(file.dump());
        QVERIFY(!read.setup && read.unfinished && hasErrors(read.issues));
        QCOMPARE(read.unfinished->surfaces[1].project.part->lower_deviation_um, 9.0);
        const ReadSetup again = readSetup(writeSetup(*read.unfinished));
        QVERIFY(again.unfinished && sameSetup(*again.unfinished, *read.unfinished));
        json one = samples::sample("complete");
        one["part"]["lower_deviation_um"] = 9;
        const ReadSetup plain = readSetup(one.dump());
        QVERIFY(!plain.setup && plain.unfinished);
        file["surfaces"][0]["machine"]["work_speed_rpm"] = "fast";
        QVERIFY(!readSetup(file.dump()).unfinished);
        file = twoSurfaces();
        file["surfaces"][1]["part"]["lower_deviation_um"] = 9;
        file["surfaces"][1]["name"] = file["surfaces"][0]["name"];
        QVERIFY(!readSetup(file.dump()).unfinished);
    }

    /// Of a project in which each of them is another than usual.
    void everySharedMemberIsCopied() {
        Project from = samples::project("everything");
        from.part->shaft.youngs_modulus_gpa = 100;
        from.part->shaft.mounting = Mounting::chuck;
        from.part->shaft.steady_rests = {{}};
        from.part->shaft.quill = Quill{};
        from.machine->feed_change_delay_s = 1;
        from.machine->wheel_speed_m_s = 31;
        from.machine->geometric_runout_um = 2;
        from.machine->gauge_repeatability_um = 0.7;
        from.machine->gauge_drift_um_h = 1.5;
        from.machine->gauge_delay_s = 0.1;
        from.material->expansion_um_m_k = 12;
        from.machine->wheel_contact = WheelContact{{{{0, 50}, {200, 80}}}};
        Project to;
        const auto valueAt = [](const Project& project, std::string_view member) {
            const nlohmann::json shared = splitProject(projectJson(project)).shared;
            const nlohmann::json::json_pointer place{std::string(member)};
            return shared.contains(place) ? shared.at(place) : nlohmann::json();
        };
        for (const std::string_view member : sharedMembers()) {
            QVERIFY2(valueAt(from, member) != valueAt(to, member), std::string(member).c_str());
        }
        copyShared(from, to);
        for (const std::string_view member : sharedMembers()) {
            QVERIFY2(valueAt(from, member) == valueAt(to, member), std::string(member).c_str());
        }
    }

    void whatIsSharedIsCopiedAndNothingElse() {
        int differed = 0;
        for (std::uint64_t seed = 1; seed < 60; ++seed) {
            const auto from = readProject(randomProject(seed).dump()).project;
            auto to = readProject(randomProject(seed + 1000).dump()).project;
            if (!from || !to) {
                continue;
            }
            const auto own = [](const Project& project) {
                return splitProject(projectJson(project)).own;
            };
            const auto before = own(*to);
            differed += !haveSameShared(*from, *to);
            copyShared(*from, *to);
            QVERIFY(haveSameShared(*from, *to));
            QVERIFY(own(*to) == before);
        }
        QVERIFY(differed > 10);
    }

    void faultsAreNamedWhereTheyStand() {
        struct Fault {
            const char* at;
            json value;
            IssueCode code;
        };
        const json two = twoSurfaces();
        for (const auto& [at, value, code] : std::vector<Fault>{
                 {"/wheel/diameter_mm", -1, IssueCode::outOfRange}, // of both surfaces, said once
                 {"/surfaces/1/machine/work_speed_rpm", -1, IssueCode::outOfRange},
                 {"/surfaces/1/wheel", two["wheel"], IssueCode::sharedKey},
                 {"/surfaces/0/machine/wheel_speed_m_s", 30, IssueCode::sharedKey},
                 {"/machine/work_speed_rpm", 100, IssueCode::unknownKey},
                 {"/wheels", 1, IssueCode::unknownKey},
                 {"/surfaces/1/version", 1, IssueCode::sharedKey},
                 {"/part~1name", "x", IssueCode::unknownKey},
                 {"/surfaces/1/speed", 1, IssueCode::unknownKey},
                 {"/surfaces/1/name", two["surfaces"][0]["name"], IssueCode::sameName},
                 {"/surfaces/1/name", 7, IssueCode::wrongType},
                 {"/surfaces", json::array(), IssueCode::wrongCount},
                 {"/surfaces", std::vector<json>(21, two["surfaces"][0]), IssueCode::wrongCount},
                 {"/surfaces", 1, IssueCode::wrongType},
                 {"/times/batch_size", 0, IssueCode::outOfRange},
                 {"/wear/grinding_ratio", 0, IssueCode::outOfRange},
                 {"/version", 3, IssueCode::newerVersion}}) {
            json file = two;
            file[json::json_pointer(at)] = value;
            QVERIFY2(isRefused(file, code, at), at);
        }
        for (const auto& [at, value] :
             std::vector<std::pair<const char*, json>>{{"/machine", nullptr},
                                                       {"/part/shaft", json::array()},
                                                       {"/surfaces/1/part", 5},
                                                       {"/times", 5}}) {
            json file = two;
            file[json::json_pointer(at)] = value;
            QVERIFY2(names(file, IssueCode::wrongType, at), at);
        }
        json file = two;
        file["surfaces"][1].erase("name");
        QVERIFY(isRefused(file, IssueCode::missingKey, "/surfaces/1/name"));
        file.erase("surfaces");
        QVERIFY(isRefused(file, IssueCode::missingKey, "/surfaces"));
    }

    /// The wheel covers the first surface and not the second: that one is named.
    void aFaultBetweenSharedAndOwnNamesTheSurface() {
        const json plunge = samples::sample("smallest-plunge");
        json wide = plunge;
        wide["part"]["length_mm"] = plunge["wheel"]["width_mm"].get<double>() + 10;
        const json file = setupOf({plunge, wide});
        QVERIFY(names(file, IssueCode::wheelTooNarrow, "/surfaces/1/wheel/width_mm"));
        QVERIFY(!names(file, IssueCode::wheelTooNarrow, "/wheel/width_mm"));
        QVERIFY(!names(file, IssueCode::wheelTooNarrow, "/surfaces/0/wheel/width_mm"));
    }

    /// However many warnings come first.
    void anErrorIsNotLostBehindManyWarnings() {
        json file = setupOf(std::vector<json>(limits::surfaces, samples::sample("everything")));
        QVERIFY(readSetup(file.dump()).issues.size() > limits::issues / 2); // warnings alone
        QVERIFY(readSetup(file.dump()).setup);
        file["surfaces"].back()["cycle"] = 5;
        const ReadSetup read = readSetup(file.dump());
        QVERIFY(!read.setup && hasErrors(read.issues));
        QVERIFY(read.issues.size() <= limits::issues);
    }

    /// Who reads single surfaces alone says so, and does not call the file newer.
    void aReaderOfOneSurfaceNamesSeveral() {
        const ReadResult read = readProject(twoSurfaces().dump());
        QVERIFY(!read.project && read.issues.size() == 1);
        QVERIFY(read.issues.front().code == IssueCode::severalSurfaces);
    }

    void surfacesAreFoundByNameElseByNumber() {
        Setup setup;
        setup.surfaces = {{"journal", {}}, {"1", {}}, {"seat", {}}};
        QVERIFY(setup.find("seat") == std::size_t{2});
        QVERIFY(setup.find("1") == std::size_t{1}); // its name
        QVERIFY(setup.find("3") == std::size_t{2});
        QVERIFY(!setup.find("4") && !setup.find("0") && !setup.find("") && !setup.find("2x"));
    }
};

} // namespace sparkout::test_setup_file

SPARKOUT_TEST(test_setup_file, TestSetupFile)
#include "test_setup_file.moc"
