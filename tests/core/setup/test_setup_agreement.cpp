// SPDX-License-Identifier: GPL-3.0-or-later
// Set-ups of several surfaces against the second implementation: the wheel that goes on from one to
// the next, and the times. SPARKOUT_QUICK=1: 20 of them (sanitizers). SPARKOUT_LONG=1: 1,000.
#include "core/setup/setup_run.h"
#include "tests/core/setup/setup_samples.h"
#include "tests/core/support/reference_difference.h"
#include "tests/core/support/reference_setup.h"
#include "tests/registry.h"

#include <map>

namespace sparkout::test_setup_agreement {

using namespace setup_samples;
using nlohmann::json;

int setups() {
    return qEnvironmentVariableIsSet("SPARKOUT_QUICK")  ? 20
           : qEnvironmentVariableIsSet("SPARKOUT_LONG") ? 1'000
                                                        : 60;
}

/// A number of a seed, from 0 to 1: of each purpose another.
double share(std::uint64_t seed, std::uint64_t purpose) {
    std::uint64_t z = (seed * 31 + purpose + 1) * 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/// Random surfaces with wear and times, of which some are given as a whole.
json randomFile(std::uint64_t seed) {
    std::vector<json> projects;
    for (std::uint64_t i = 0; i < 1 + seed % 5; ++i) {
        projects.push_back(randomProject(seed * 11 + i));
    }
    json file = setupOf(projects);
    json wear = json::object(), times = json::object();
    if (share(seed, 0) < 0.7) {
        wear["dulling_per_mm2"] = 1e-6 * std::pow(100, share(seed, 1));
        if (share(seed, 60) < 0.5) {
            wear["dulling_exponent"] = 0.6 + 0.6 * share(seed, 61);
        }
    }
    if (share(seed, 2) < 0.7) {
        wear["grinding_ratio"] = std::pow(100, share(seed, 3));
    }
    const std::pair<const char*, double> most[] = {
        {"approach_s", 8},    {"retreat_s", 4},        {"gauging_s", 20}, {"positioning_s", 15},
        {"handling_s", 90},   {"service_percent", 12}, {"main_min", 9},   {"preparation_min", 40},
        {"auxiliary_min", 3}, {"piece_min", 20}};
    std::uint64_t purpose = 4;
    for (const auto& [key, upTo] : most) {
        const bool isWhole = std::string(key).ends_with("_min");
        if (share(seed, ++purpose) < (isWhole ? 0.2 : 0.7)) {
            times[key] = upTo * share(seed, ++purpose + 100);
        }
    }
    times["batch_size"] = 1 + static_cast<int>(60 * share(seed, 50));
    file["wear"] = wear;
    file["times"] = times;
    return file;
}

/// What differs in the times of the part.
QString timeDifference(const PieceTime& engine, const reference::SetupResult& second) {
    const std::tuple<const char*, double, double> all[] = {
        {"main", engine.main_min, second.main_min},
        {"auxiliary", engine.auxiliary_min, second.auxiliary_min},
        {"piece", engine.piece_min, second.piece_min},
        {"preparation", engine.preparation_min, second.preparation_min},
        {"calculation", engine.calculation_min, second.calculation_min}};
    for (const auto& [what, a, b] : all) {
        if (!fixtures::close(a, b, 1e-12)) {
            return QString("%1 time: engine %2, reference %3")
                .arg(what)
                .arg(a, 0, 'g', 17)
                .arg(b, 0, 'g', 17);
        }
    }
    return {};
}

/// What differs between the runs of a set-up; empty when nothing does.
QString difference(const Setup& setup, const SetupRun& engine,
                   const reference::SetupResult& second) {
    for (std::size_t i = 0; i < second.surfaces.size(); ++i) {
        const SurfaceRun& surface = engine.surfaces.at(i);
        const reference::SurfaceResult& other = second.surfaces[i];
        const json& wheel = other.project["wheel"];
        const QString where = QString("surface %1: ").arg(i + 1);
        if (!fixtures::close(surface.result.project.wheel->diameter_mm, wheel["diameter_mm"], 1e-12)
            || !fixtures::close(surface.result.project.wheel->dullness, wheel["dullness"], 1e-9)) {
            return where + "the wheel that comes to it";
        }
        if (!fixtures::close(surface.removed_mm3, other.removed_mm3, 1e-9)) {
            return where + "volume removed";
        }
        const QString found = reference::difference(surface.result, other.result,
                                                    other.project["part"]["diameter_mm"]);
        if (!found.isEmpty()) {
            return where + found;
        }
    }
    if (engine.isCompleted(setup) != second.completed) {
        return "completed";
    }
    return second.completed ? timeDifference(engine.time, second) : QString();
}

class TestSetupAgreement : public QObject {
    Q_OBJECT

private slots:
    void engineAgreesWithTheSecondImplementation() {
        int compared = 0;
        for (std::uint64_t seed = 1; compared < setups(); ++seed) {
            const json file = randomFile(seed);
            const auto setup = readSetup(file.dump()).setup;
            if (!setup) { // its surfaces do not fit what they share
                continue;
            }
            const SetupRun engine = runSetup(*setup);
            if (engine.surfaces.size() < setup->surfaces.size()) {
                ++m_kinds["a wheel that is worn out"];
                continue;
            }
            const reference::SetupResult second = reference::simulateSetup(file);
            const QString found = difference(*setup, engine, second);
            QVERIFY2(found.isEmpty(),
                     qPrintable(QString("seed %1, %2").arg(qulonglong(seed)).arg(found)));
            count(file, *setup, second);
            ++compared;
        }
        qInfo("%d set-ups", compared);
    }

    void setUpsOfEveryKindWereCompared() {
        if (m_kinds.empty()) {
            QSKIP("nothing was compared in this run");
        }
        for (const char* kind :
             {"completed", "not completed", "1 surfaces", "2 surfaces", "3 surfaces",
              "traverse and plunge", "the wheel dulls", "it dulls by a power", "the wheel wears",
              "times as sums", "times given"}) {
            QVERIFY2(m_kinds[kind] >= setups() / 30,
                     qPrintable(QString("%1: %2").arg(kind).arg(m_kinds[kind])));
        }
    }

private:
    void count(const json& file, const Setup& setup, const reference::SetupResult& second) {
        ++m_kinds[second.completed ? "completed" : "not completed"];
        ++m_kinds[std::to_string(setup.surfaces.size()) + " surfaces"];
        const auto travels = [](const GroundSurface& surface) {
            return surface.project.operation->travels;
        };
        const bool some = std::ranges::any_of(setup.surfaces, travels);
        m_kinds["traverse and plunge"] += some && !std::ranges::all_of(setup.surfaces, travels);
        const bool several = setup.surfaces.size() > 1;
        m_kinds["it dulls by a power"] += several && file["wear"].contains("dulling_exponent");
        m_kinds["the wheel dulls"] += several && file["wear"].contains("dulling_per_mm2");
        m_kinds["the wheel wears"] += several && file["wear"].contains("grinding_ratio");
        const bool given = file["times"].contains("main_min")
                           || file["times"].contains("auxiliary_min")
                           || file["times"].contains("piece_min");
        m_kinds["times given"] += second.completed && given;
        m_kinds["times as sums"] += second.completed && !given;
    }

    std::map<std::string, int> m_kinds;
};

} // namespace sparkout::test_setup_agreement

SPARKOUT_TEST(test_setup_agreement, TestSetupAgreement)
#include "test_setup_agreement.moc"
