// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/setup.h"

#include "core/format/strict_json.h"
#include "core/format/table_writer.h"
#include "core/project/range_check.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace sparkout {

bool Setup::isPlain() const {
    const auto isDefault = [](const StructInfo& table, const void* owner) {
        return writeByTable(table, owner) == writeByTable(table, table.defaults);
    };
    return surfaces.size() == 1 && surfaces.front().name.empty()
           && isDefault(tableOf<SetupTimes>(), &times) && isDefault(tableOf<WheelWear>(), &wear);
}

std::optional<std::size_t> Setup::find(std::string_view nameOrNumber) const {
    const auto named = std::ranges::find(surfaces, nameOrNumber, &GroundSurface::name);
    if (named != surfaces.end()) {
        return static_cast<std::size_t>(named - surfaces.begin());
    }
    std::size_t number = 0;
    const char* const last = nameOrNumber.data() + nameOrNumber.size();
    const auto [end, error] = std::from_chars(nameOrNumber.data(), last, number);
    const bool isNumber = error == std::errc() && end == last;
    return isNumber && number >= 1 && number <= surfaces.size() ? std::optional(number - 1)
                                                                : std::nullopt;
}

std::string surfacePath(std::size_t surface) {
    return "/surfaces/" + std::to_string(surface);
}

Setup plainSetup(Project project) {
    Setup setup;
    setup.surfaces.push_back({{}, std::move(project)});
    return setup;
}

Issues checkSetup(const Setup& setup) {
    Issues issues = checkRanges(tableOf<SetupTimes>(), &setup.times, "/times");
    const Issues wear = checkRanges(tableOf<WheelWear>(), &setup.wear, "/wear");
    issues.insert(issues.end(), wear.begin(), wear.end());
    if (setup.surfaces.size() < 2) {
        return issues; // the name does not matter
    }
    for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
        const std::string& name = setup.surfaces[i].name;
        const std::string path = "/surfaces/" + std::to_string(i) + "/name";
        const auto first = std::ranges::find(setup.surfaces, name, &GroundSurface::name);
        const auto at = static_cast<std::size_t>(first - setup.surfaces.begin());
        if (name.empty()) {
            issues.push_back({IssueCode::missingKey, Severity::error, path, {}, Phrase::text});
        } else if (at < i) {
            issues.push_back({IssueCode::sameName, Severity::error, path,
                              quoted(nlohmann::json(name)), countOf(at + 1)});
        }
    }
    return issues;
}

} // namespace sparkout
