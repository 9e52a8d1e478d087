// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/io/cli_surfaces.h"

#include "app/io/cli_io.h"
#include "app/io/stop_signals.h"
#include "core/format/strict_json.h"
#include "core/printable.h"
#include "core/setup/worn_project.h"

#include <numeric>
#include <utility>

namespace sparkout::cli {

Surfaces::Surfaces(const manual::Given& given, BatchFaults faults)
    : m_given(given), m_file(given.operands.front()) {
    const std::string& surface = given.text("--surface");
    auto setup = loadSetup(m_file, faults);
    m_status = setup ? done : refused;
    if (!setup) {
        return;
    }
    m_setup = std::move(*setup);
    m_chosen.resize(m_setup.surfaces.size());
    std::iota(m_chosen.begin(), m_chosen.end(), std::size_t{0});
    m_isWhole = !m_setup.isPlain();
    if (const auto found = m_setup.find(surface)) {
        m_chosen = {*found};
        m_isWhole = false;
        return;
    }
    if (surface.empty() || surface == "all") {
        return;
    }
    std::string names;
    for (std::size_t i = 0; i < m_setup.surfaces.size(); ++i) {
        constexpr std::size_t most = 40; // greatest number of letters shown of a name
        const std::string name = m_setup.surfaces[i].name.substr(0, most);
        names += (i > 0 ? ", " : "") + std::to_string(i + 1) + (name.empty() ? "" : " " + name);
    }
    m_status = usageError(m_file + " has no surface " + surface + "; it has: " + names);
}

bool Surfaces::isWhole() const {
    return m_isWhole;
}

int Surfaces::oneFor(std::initializer_list<const char*> options) const {
    for (const char* option : options) {
        if (isWhole() && m_given.has(option)) {
            return usageError(std::string(option) + " needs one surface: name it by --surface");
        }
    }
    return done;
}

std::string Surfaces::nameOf(std::size_t surface) const {
    const std::string& name = m_setup.surfaces[surface].name;
    return m_setup.isPlain() ? m_file
                             : m_file + ": surface " + std::to_string(surface + 1) + ' ' + name;
}

std::string Surfaces::heading(std::size_t surface) const {
    return (surface > 0 ? "\n" : "") + std::string("surface ") + std::to_string(surface + 1) + "  "
           + printable(m_setup.surfaces[surface].name) + "\n\n";
}

int Surfaces::runOne(const Setup& setup, const Command& command, std::size_t surface) const {
    WornProject worn = wornProject(setup, surface);
    if (!worn.issues.empty()) {
        printIssues(nameOf(worn.surface), worn.issues);
        return refused;
    }
    return command(std::move(worn.project), surface, nameOf(surface));
}

int Surfaces::run(const Command& command) const {
    return run(m_setup, command);
}

int Surfaces::run(const Setup& setup, const Command& command) const {
    const bool json = m_given.has("--json");
    if (!isWhole()) {
        return runOne(setup, command, m_chosen.front());
    }
    int status = done;
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const std::size_t surface : m_chosen) {
        int one = done;
        if (json) {
            const CapturedOutput output;
            one = runOne(setup, command, surface);
            const auto object = nlohmann::ordered_json::parse(output.text(), nullptr, false);
            nlohmann::ordered_json entry = {{"name", m_setup.surfaces[surface].name}};
            entry.update(object.is_object() ? object : nlohmann::ordered_json::object());
            entry["exit_status"] = one;
            all.push_back(std::move(entry));
        } else {
            print(stdout, heading(surface));
            one = runOne(setup, command, surface);
        }
        status = status == done ? one : status;
        if (caughtSignal() != 0) {
            break;
        }
    }
    if (json) {
        print(stdout, printJson({{"surfaces", std::move(all)}}));
    }
    return status;
}

} // namespace sparkout::cli
