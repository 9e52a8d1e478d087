// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/setup_file.h"

#include "core/file/project_json.h"
#include "core/file/strict_json.h"
#include "core/file/struct_json.h"
#include "core/setup/setup.h"
#include "core/setup/split_project.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* surfacesKey = "surfaces";
constexpr const char* nameKey = "name";
constexpr const char* timesKey = "times";
constexpr const char* wearKey = "wear";

/// Reads the parts of a file of version 2 and gives each fault its path in the file.
class SetupReader {
public:
    SetupReader(const json& root, Issues found, std::stop_token stop)
        : m_root(root), m_stop(std::move(stop)) {
        m_read.issues = std::move(found);
    }

    ReadSetup read() {
        m_shared = m_root;
        for (const char* key : {"format", "version", surfacesKey, timesKey, wearKey}) {
            m_shared.erase(key);
        }
        keepShared(m_shared, {});
        Setup setup;
        readStruct(timesKey, tableOf<SetupTimes>(), &setup.times);
        readStruct(wearKey, tableOf<WheelWear>(), &setup.wear);
        readSurfaces(setup);
        if (m_stop.stop_requested()) {
            return {};
        }
        for (Issue& issue : checkSetup(setup)) {
            if (std::ranges::find(m_read.issues, issue.path, &Issue::path) == m_read.issues.end()) {
                add(std::move(issue));
            }
        }
        if (!m_hasErrors && !hasErrors(m_read.issues)) {
            m_read.setup = std::move(setup);
        } else if (m_isReadable && !hasErrors(checkSetup(setup))) {
            m_read.unfinished = std::move(setup);
        }
        return std::move(m_read);
    }

private:
    /// Lists an issue once; in a full list an error replaces a warning.
    void add(Issue issue) {
        const bool isError = issue.severity == Severity::error;
        m_hasErrors = m_hasErrors || isError;
        const bool isFull = m_read.issues.size() >= limits::issues;
        if ((isFull && !isError)
            || std::ranges::find(m_read.issues, issue) != m_read.issues.end()) {
            return;
        }
        if (isFull) {
            const auto warning =
                std::ranges::find(m_read.issues, Severity::warning, &Issue::severity);
            if (warning == m_read.issues.end()) {
                return;
            }
            m_read.issues.erase(warning);
        }
        m_read.issues.push_back(std::move(issue));
    }

    /// Removes and reports keys of the surfaces, unknown keys and non-objects.
    void keepShared(json& object, const std::string& path) {
        std::vector<std::string> strange;
        for (auto& [key, value] : object.items()) {
            const std::string at = path + '/' + pathStep(key);
            if (holdsShared(at) && value.is_object()) {
                keepShared(value, at);
            } else if (!isShared(at)) {
                strange.push_back(key);
            }
        }
        const Keys allowed = keysBelow(path);
        for (const std::string& key : strange) {
            const std::string at = path + '/' + pathStep(key);
            add(holdsShared(at) ? Issue{IssueCode::wrongType, Severity::error, at,
                                        quoted(object.at(key)), Phrase::object}
                                : Issue{IssueCode::unknownKey, Severity::error, at,
                                        quoted(json(key)), allowed});
            object.erase(key);
        }
    }

    /// The keys allowed at the top of the file, or in one of its objects.
    static Keys keysBelow(const std::string& path) {
        Keys keys;
        for (const std::string_view member : sharedMembers()) {
            if (!member.starts_with(path + '/')) {
                continue;
            }
            const std::string_view rest = member.substr(path.size() + 1);
            std::string key(rest.substr(0, rest.find('/')));
            if (std::ranges::find(keys.keys, key) == keys.keys.end()) {
                keys.keys.push_back(std::move(key));
            }
        }
        if (path.empty()) {
            keys.keys.insert(keys.keys.end(), {timesKey, wearKey, surfacesKey});
        }
        return keys;
    }

    void readStruct(const char* key, const StructInfo& table, void* owner) {
        if (const auto found = m_root.find(key); found != m_root.end()) {
            std::vector<MissingKey> missing; // none of them is required
            readByTable(*found, table, owner, std::string("/") + key, m_read.issues, missing);
        }
    }

    void readSurfaces(Setup& setup) {
        const auto found = m_root.find(surfacesKey);
        const std::string path = std::string("/") + surfacesKey;
        if (found == m_root.end()) {
            add({IssueCode::missingKey, Severity::error, path, {}, Phrase::listOfObjects});
            return;
        }
        if (!found->is_array()
            || !std::ranges::all_of(*found, [](const json& each) { return each.is_object(); })) {
            add({IssueCode::wrongType, Severity::error, path, quoted(*found),
                 Phrase::listOfObjects});
            return;
        }
        if (found->empty() || found->size() > limits::surfaces) {
            add({IssueCode::wrongCount, Severity::error, path, countOf(found->size()),
                 Bounds{{1, static_cast<double>(limits::surfaces)}}});
            return;
        }
        m_isReadable = true;
        for (std::size_t i = 0; i < found->size() && !m_stop.stop_requested(); ++i) {
            setup.surfaces.push_back(readSurface((*found)[i], path + '/' + std::to_string(i)));
        }
        m_isReadable = m_isReadable && !m_hasErrors && !hasErrors(m_read.issues);
        addFound(path);
    }

    /// A fault of a shared value that every surface has is listed at that value; one that only some
    /// surfaces have is listed at these, since it depends on their own values.
    void addFound(const std::string& surfaces) {
        for (std::size_t i = 0; i < m_found.size(); ++i) {
            for (const Issue& issue : m_found[i]) {
                const bool isOfAll =
                    isShared(issue.path) && std::ranges::all_of(m_found, [&](const Issues& others) {
                        return std::ranges::find(others, issue) != others.end();
                    });
                Issue placed = issue;
                if (!isOfAll) {
                    placed.path = surfaces + '/' + std::to_string(i) + issue.path;
                }
                add(std::move(placed));
            }
        }
    }

    GroundSurface readSurface(json own, const std::string& path) {
        GroundSurface surface;
        if (const auto name = own.find(nameKey); name != own.end()) {
            if (name->is_string()) {
                surface.name = name->get<std::string>();
            } else {
                add({IssueCode::wrongType, Severity::error, path + '/' + nameKey, quoted(*name),
                     Phrase::text});
            }
            own.erase(nameKey);
        }
        strikeShared(own, {}, path);
        for (const char* key : {"format", "version"}) { // of the file alone
            if (own.erase(key) > 0) {
                add({IssueCode::sharedKey,
                     Severity::error,
                     path + '/' + key,
                     quoted(json(key)),
                     {}});
            }
        }
        ReadResult read = readProjectJson(joinProject(m_shared, own), {}, m_stop);
        m_found.push_back(std::move(read.issues));
        std::optional<Project>& project = read.project ? read.project : read.unfinished;
        if (project) {
            surface.project = std::move(*project);
        } else {
            m_isReadable = false;
        }
        return surface;
    }

    /// Removes and reports values in a surface that are shared by all.
    void strikeShared(json& object, const std::string& path, const std::string& surface) {
        std::vector<std::string> strange;
        for (auto& [key, value] : object.items()) {
            const std::string at = path + '/' + pathStep(key);
            if (isShared(at)) {
                strange.push_back(key);
            } else if (holdsShared(at) && value.is_object()) {
                strikeShared(value, at, surface);
            }
        }
        for (const std::string& key : strange) {
            std::string at = surface;
            at.append(path).append("/").append(pathStep(key));
            add({IssueCode::sharedKey, Severity::error, at, quoted(json(key)), {}});
            object.erase(key);
        }
    }

    const json& m_root;
    std::stop_token m_stop;
    json m_shared;
    ReadSetup m_read;
    std::vector<Issues> m_found; ///< issues by surface
    bool m_hasErrors = false;    ///< including issues that are not listed
    bool m_isReadable = false;   ///< no errors other than missing inputs
};

ReadSetup asSetup(ReadResult read) {
    ReadSetup result{std::nullopt, std::nullopt, std::move(read.issues)};
    if (read.project) {
        result.setup = plainSetup(std::move(*read.project));
    } else if (read.unfinished) {
        result.unfinished = plainSetup(std::move(*read.unfinished));
    }
    return result;
}

} // namespace

ReadSetup readSetup(std::string_view text, const std::stop_token& stop) {
    Issues issues;
    const auto root = parseStrictly(text, issues, stop);
    if (stop.stop_requested()) {
        return {};
    }
    if (!root) {
        constexpr std::string_view blanks =
            "\xEF\xBB\xBF \t\r\n"; // plus the byte order mark of UTF-8
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
        for (Issue& issue : issues) {
            if (issue.code == IssueCode::notJson && !text.starts_with('{')) {
                issue.code = IssueCode::notAProject;
            }
        }
        return {std::nullopt, std::nullopt, std::move(issues)};
    }
    if (const Issues header = checkHeader(*root, newestVersion); !header.empty()) {
        issues.insert(issues.end(), header.begin(), header.end());
        return {std::nullopt, std::nullopt, std::move(issues)};
    }
    return root->at("version") == newestVersion
               ? SetupReader(*root, std::move(issues), stop).read()
               : asSetup(readProjectJson(*root, std::move(issues), stop));
}

std::string writeSetup(const Setup& setup) {
    if (setup.isPlain()) {
        return writeProject(setup.surfaces.front().project);
    }
    ordered_json root = {{"format", projectFormat}, {"version", newestVersion}};
    ordered_json surfaces = ordered_json::array();
    for (const GroundSurface& surface : setup.surfaces) {
        SplitProject parts = splitProject(projectJson(surface.project));
        if (surfaces.empty()) {
            root.update(parts.shared);
        }
        ordered_json own = ordered_json::object();
        if (!surface.name.empty()) {
            own[nameKey] = surface.name;
        }
        own.update(parts.own);
        surfaces.push_back(std::move(own));
    }
    root[timesKey] = writeByTable(tableOf<SetupTimes>(), &setup.times);
    root[wearKey] = writeByTable(tableOf<WheelWear>(), &setup.wear);
    root[surfacesKey] = std::move(surfaces);
    return printJson(root);
}

bool sameSetup(const Setup& a, const Setup& b) {
    const auto isSame = [](const GroundSurface& one, const GroundSurface& other) {
        return one.name == other.name && sameProject(one.project, other.project);
    };
    return std::ranges::equal(a.surfaces, b.surfaces, isSame) && a.times == b.times
           && a.wear == b.wear;
}

} // namespace sparkout
