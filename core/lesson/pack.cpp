// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/pack.h"

#include "core/file/strict_json.h"
#include "core/file/struct_json.h"
#include "core/lesson/lesson_json.h"

#include <algorithm>
#include <array>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::array memberKeys = {"format", "version", "title",     "note",   "machines",
                                   "wheels", "company", "materials", "lessons"};
constexpr const char* logoKey = "logo";
constexpr std::size_t logoLine = 4096; ///< letters of base64 in a line of the file

void refuse(Issues& issues, IssueCode code, const std::string& path, Detail value, Detail limit) {
    addIssue(issues, {code, Severity::error, path, std::move(value), std::move(limit)});
}

/// Reads a text of at most this many bytes; empty if missing.
std::string readText(const json& object, const char* key, std::size_t most, const std::string& path,
                     Issues& issues) {
    const auto found = object.find(key);
    if (found == object.end()) {
        return {};
    }
    const std::string at = path + "/" + pathStep(key);
    if (!found->is_string()) {
        refuse(issues, IssueCode::wrongType, at, quoted(*found), Phrase::text);
        return {};
    }
    const auto& text = found->get_ref<const std::string&>();
    if (text.size() > most) {
        refuse(issues, IssueCode::stringTooLong, at, countOf(text.size(), "bytes"),
               countOf(most, "bytes"));
    }
    return text;
}

/// The value of a key, if it has the right kind; otherwise reports a fault.
const json* memberOf(const json& root, const char* key, json::value_t type, Phrase expected,
                     Issues& issues) {
    const auto found = root.find(key);
    if (found == root.end()) {
        return nullptr;
    }
    if (found->type() != type) {
        refuse(issues, IssueCode::wrongType, std::string("/") + key, quoted(*found), expected);
        return nullptr;
    }
    return &*found;
}

/// Reads a catalogue below its key like its own file.
template <class Entry>
std::vector<Entry> readEntries(const json& root, const char* key, Issues& issues) {
    const json* object = memberOf(root, key, json::value_t::object, Phrase::object, issues);
    if (!object) {
        return {};
    }
    const std::string path = std::string("/") + key;
    CatalogueRead<Entry> read = readCatalogue<Entry>(object->dump());
    for (Issue& issue : read.issues) {
        issue.path = path + issue.path;
        addIssue(issues, std::move(issue));
    }
    std::vector<Entry> entries = std::move(read.entries).value_or(std::vector<Entry>());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto first = std::ranges::find(entries, entries[i].name, &Entry::name);
        if (static_cast<std::size_t>(first - entries.begin()) < i) {
            refuse(issues, IssueCode::nameTwice, path + "/entries/" + std::to_string(i) + "/name",
                   quoted(json(entries[i].name)), {});
        }
    }
    return entries;
}

bool isBase64(std::string_view text) {
    const std::size_t end = std::min(text.find('='), text.size());
    return text.size() % 4 == 0 && text.size() - end <= 2
           && std::ranges::all_of(text.substr(0, end),
                                  [](char letter) {
                                      return (letter >= 'A' && letter <= 'Z')
                                             || (letter >= 'a' && letter <= 'z')
                                             || (letter >= '0' && letter <= '9') || letter == '+'
                                             || letter == '/';
                                  })
           && std::ranges::all_of(text.substr(end), [](char letter) { return letter == '='; });
}

/// Base64 in a list of lines.
std::string readLogo(const json& company, Issues& issues) {
    const auto found = company.find(logoKey);
    if (found == company.end()) {
        return {};
    }
    const std::string path = std::string("/company/") + logoKey;
    std::string logo;
    const bool lines = found->is_array() && std::ranges::all_of(*found, [](const json& line) {
                           return line.is_string();
                       });
    if (lines) {
        for (const json& line : *found) {
            logo += line.get_ref<const std::string&>();
        }
    }
    if (!lines || !isBase64(logo)) {
        refuse(issues, IssueCode::wrongType, path, quoted(*found), Phrase::linesOfBase64);
        return {};
    }
    if (logo.size() > limits::logoText) {
        refuse(issues, IssueCode::stringTooLong, path, countOf(logo.size(), "bytes"),
               countOf(limits::logoText, "bytes"));
    }
    return logo;
}

void readCompany(const json& root, Pack& pack, Issues& issues) {
    const json* company = memberOf(root, "company", json::value_t::object, Phrase::object, issues);
    if (!company) {
        return;
    }
    for (const auto& [key, value] : company->items()) {
        if (key != logoKey) {
            pack.company[key] =
                readText(*company, key.c_str(), limits::packText, "/company", issues);
        }
    }
    pack.logo = readLogo(*company, issues);
}

void readLessons(const json& root, Pack& pack, Issues& issues) {
    const json* list = memberOf(root, "lessons", json::value_t::object, Phrase::object, issues);
    if (!list) {
        return;
    }
    if (list->size() > limits::packLessons) {
        refuse(issues, IssueCode::wrongCount, "/lessons", countOf(list->size()),
               Bounds{{0, static_cast<double>(limits::packLessons)}});
        return;
    }
    for (const auto& [file, object] : list->items()) {
        const std::string path = "/lessons/" + pathStep(file);
        if (!isLessonFileName(file)) {
            refuse(issues, IssueCode::notAFileName, path, quoted(json(file)),
                   Phrase::nameOfLessonFile);
            continue;
        }
        // A lesson for a class lacks the right answers, which a teacher's must have.
        ReadLesson read = readLessonJson(object, LessonOf::teacher, {}, {});
        if (!read.lesson) {
            ReadLesson students = readLessonJson(object, LessonOf::student, {}, {});
            if (students.lesson) {
                read = std::move(students);
            }
        }
        for (Issue& issue : read.issues) {
            issue.path = path + issue.path;
            addIssue(issues, std::move(issue));
        }
        if (read.lesson) {
            pack.lessons.push_back({file, std::move(*read.lesson)});
        }
    }
}

template <class Entry>
void writeEntries(ordered_json& root, const char* key, const std::vector<Entry>& entries) {
    if (!entries.empty()) {
        root[key] = ordered_json::parse(writeCatalogue(entries));
    }
}

} // namespace

std::size_t Pack::count() const {
    const std::size_t heads = company.empty() && logo.empty() ? 0 : 1;
    return machines.size() + wheels.size() + materials.size() + lessons.size() + heads;
}

bool isLessonFileName(std::string_view name) {
    constexpr std::string_view ending = ".sparkout-lesson";
    constexpr std::string_view refused = "/\\<>:\"|?*";
    constexpr std::size_t longest = 120;
    return name.size() > ending.size() && name.size() <= longest && name.ends_with(ending)
           && name.front() != '.' && name.front() != ' '
           && std::ranges::none_of(name, [&](char letter) {
                  const auto code = static_cast<unsigned char>(letter);
                  return code < 0x20 || code == 0x7f || refused.find(letter) != refused.npos;
              });
}

ReadPack readPack(std::string_view text) {
    ReadPack read;
    Issues& issues = read.issues;
    const auto root = parseStrictly(text, issues);
    if (!root) {
        return read;
    }
    if (const Issues header = checkFileHeader(*root, packFormat, packVersion); !header.empty()) {
        issues.insert(issues.end(), header.begin(), header.end());
        return read;
    }
    for (const auto& [key, value] : root->items()) {
        if (std::ranges::find(memberKeys, key) == memberKeys.end()) {
            refuse(issues, IssueCode::unknownKey, "/" + pathStep(key), quoted(json(key)),
                   Keys{{memberKeys.begin(), memberKeys.end()}});
        }
    }
    Pack pack;
    pack.title = readText(*root, "title", limits::packText, {}, issues);
    pack.note = readText(*root, "note", limits::packNote, {}, issues);
    pack.machines = readEntries<MachineEntry>(*root, "machines", issues);
    pack.wheels = readEntries<WheelEntry>(*root, "wheels", issues);
    pack.materials = readEntries<MaterialEntry>(*root, "materials", issues);
    readCompany(*root, pack, issues);
    readLessons(*root, pack, issues);
    if (!hasErrors(issues)) {
        read.pack = std::move(pack);
    }
    return read;
}

std::string writePack(const Pack& pack) {
    ordered_json root = {{"format", packFormat}, {"version", packVersion}};
    const auto put = [&root](const char* key, const std::string& text) {
        if (!text.empty()) {
            root[key] = text;
        }
    };
    put("title", pack.title);
    put("note", pack.note);
    writeEntries(root, "machines", pack.machines);
    writeEntries(root, "wheels", pack.wheels);
    writeEntries(root, "materials", pack.materials);
    for (const auto& [key, text] : pack.company) {
        root["company"][key] = text;
    }
    for (std::size_t at = 0; at < pack.logo.size(); at += logoLine) {
        root["company"][logoKey].push_back(pack.logo.substr(at, logoLine));
    }
    for (const PackedLesson& lesson : pack.lessons) {
        root["lessons"][lesson.file] = lessonJson(lesson.lesson);
    }
    return printJson(root);
}

} // namespace sparkout
