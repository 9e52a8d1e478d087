// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/catalogue/catalogue.h"

#include "core/catalogue/catalogue_check.h"
#include "core/file/project_file.h"
#include "core/file/strict_json.h"
#include "core/file/struct_json.h"
#include "core/project/conditions.h"
#include "core/text.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

namespace sparkout {

namespace {

template <class Entry>
constexpr const char* catalogueKind() {
    return std::is_same_v<Entry, MaterialEntry> ? "materials"
           : std::is_same_v<Entry, WheelEntry>  ? "wheels"
                                                : "machines";
}

/// Letters that look alike, and their common form.
constexpr std::array<std::pair<std::string_view, char>, 24> alikeLetters{
    {{"А", 'a'}, {"В", 'b'}, {"Е", 'e'}, {"К", 'k'}, {"М", 'm'}, {"Н", 'h'},
     {"О", 'o'}, {"Р", 'p'}, {"С", 'c'}, {"Т", 't'}, {"Х", 'x'}, {"У", 'y'},
     {"а", 'a'}, {"в", 'b'}, {"е", 'e'}, {"к", 'k'}, {"м", 'm'}, {"н", 'h'},
     {"о", 'o'}, {"р", 'p'}, {"с", 'c'}, {"т", 't'}, {"х", 'x'}, {"×", 'x'}}};

/// The form of a name for comparison.
std::string comparable(std::string_view text) {
    std::string letters;
    while (!text.empty()) {
        const auto* const alike = std::ranges::find_if(
            alikeLetters, [&](const auto& each) { return text.starts_with(each.first); });
        if (alike != alikeLetters.end()) {
            letters += alike->second;
            text.remove_prefix(alike->first.size());
            continue;
        }
        const char c = text.front();
        if (c != ' ') {
            letters += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        }
        text.remove_prefix(1);
    }
    return letters;
}

} // namespace

template <class Entry>
const std::vector<Entry>& shippedEntries() {
    static const std::vector<Entry> entries = [] {
        auto read = readCatalogue<Entry>(shippedCatalogueText(catalogueKind<Entry>()));
        assert(read.entries); // checked by a test
        return std::move(read.entries).value_or(std::vector<Entry>());
    }();
    return entries;
}

template <class Entry>
std::vector<const Entry*> entriesMeant(const std::vector<Entry>& entries, std::string_view text) {
    const std::string wanted = comparable(text);
    std::vector<const Entry*> parts;
    for (const Entry& entry : entries) {
        const std::string name = comparable(entry.name);
        if (name == wanted) {
            return {&entry};
        }
        if (!wanted.empty() && name.find(wanted) != std::string::npos) {
            parts.push_back(&entry);
        }
    }
    return parts;
}

template <class Entry>
const Entry* entryMeant(const std::vector<Entry>& entries, std::string_view text) {
    const std::vector<const Entry*> meant = entriesMeant(entries, text);
    return meant.size() == 1 ? meant.front() : nullptr;
}

#define SPARKOUT_SHIPPED(Entry)                                                                    \
    template const std::vector<Entry>& shippedEntries<Entry>();                                    \
    template std::vector<const Entry*> entriesMeant<Entry>(const std::vector<Entry>&,              \
                                                           std::string_view);                      \
    template const Entry* entryMeant<Entry>(const std::vector<Entry>&, std::string_view)
SPARKOUT_SHIPPED(MaterialEntry);
SPARKOUT_SHIPPED(WheelEntry);
SPARKOUT_SHIPPED(MachineEntry);
#undef SPARKOUT_SHIPPED

namespace {

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

std::size_t digitsFrom(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && isDigit(text[end]))
        ++end;
    return end - at;
}

int letterAt(std::string_view text, std::size_t at) {
    return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

} // namespace

int naturalOrder(std::string_view a, std::string_view b) {
    const auto differ = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    const auto at = static_cast<std::size_t>(differ.first - a.begin());
    if (at == a.size() && at == b.size())
        return 0;
    std::size_t begin = at; // start of the number in which they differ
    while (begin > 0 && isDigit(a[begin - 1]))
        --begin;
    const int byLetter = letterAt(a, at) - letterAt(b, at);
    const std::size_t longA = digitsFrom(a, at), longB = digitsFrom(b, at);
    const bool decimals = letterAt(a, begin) == '0' || letterAt(b, begin) == '0';
    if (!decimals) {
        // Both are numbers, or become numbers here: the longer one is greater.
        const bool numbers = digitsFrom(a, begin) > 0 && digitsFrom(b, begin) > 0;
        return numbers && longA != longB ? (longA > longB ? 1 : -1) : byLetter;
    }
    // After zeros only, more digits precede none: 00 < 0.
    const bool zerosOnly = a.substr(begin, at - begin).find_first_not_of('0') == a.npos;
    if (begin < at && zerosOnly && (longA > 0) != (longB > 0))
        return longA > 0 ? -1 : 1;
    return byLetter;
}

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

Row nameRow() {
    return {.label = SPARKOUT_NOOP("Input", "Name"),
            .required = conditions::always,
            .hint = SPARKOUT_NOOP("Input", "Name used in searches.")};
}

Row noteRow() {
    return {.label = SPARKOUT_NOOP("Input", "Note"),
            .hint = SPARKOUT_NOOP("Input",
                                  "Use of the entry, or the conditions for which it is valid.")};
}

Row russianNoteRow() {
    return {.label = SPARKOUT_NOOP("Input", "Note in Russian"),
            .hint = SPARKOUT_NOOP("Input", "The note in the Russian window.")};
}

Row sourcesRow() {
    return {.label = SPARKOUT_NOOP("Input", "Sources"),
            .hint = SPARKOUT_NOOP("Input", "Source of each number.")};
}

/// The rows that all kinds of entries share.
template <class Entry>
auto entryRows(const char* valueLabel) {
    return std::array{
        makeField<&Entry::name>("name", nameRow()), makeField<&Entry::note>("note", noteRow()),
        makeField<&Entry::note_ru>("note_ru", russianNoteRow()),
        makeField<&Entry::value>("value", Row{.label = valueLabel, .required = conditions::always}),
        makeField<&Entry::sources>("sources", sourcesRow())};
}

using namespace catalogue;

constexpr const char* catalogueFormat = "sparkout-catalogue";

/// Properties of a kind of catalogue: its name in the file, and its value in a project.
template <class Entry>
struct Kindred;
template <>
struct Kindred<MaterialEntry> {
    static constexpr const char* name = "materials";
    static constexpr const char* key = "material";
    static constexpr auto member = &Project::material;
};
template <>
struct Kindred<WheelEntry> {
    static constexpr const char* name = "wheels";
    static constexpr const char* key = "wheel";
    static constexpr auto member = &Project::wheel;
};
template <>
struct Kindred<MachineEntry> {
    static constexpr const char* name = "machines";
    static constexpr const char* key = "machine";
    static constexpr auto member = &Project::machine;
};

template <class Entry>
const StructInfo& valueTable() {
    return tableOf<decltype(Entry::value)>();
}

/// Checks the header; returns the list of entries, if there is one.
const json* checkHeader(const json& root, const char* kind, Issues& issues) {
    const auto refuse = [&](IssueCode code, const char* path, Detail value, Detail limit) {
        issues.push_back({code, Severity::error, path, std::move(value), std::move(limit)});
    };
    if (!root.is_object()) {
        refuse(IssueCode::wrongType, "", quoted(root), Phrase::object);
        return nullptr;
    }
    for (const auto& [key, value] : root.items()) {
        if (key != "format" && key != "version" && key != "kind" && key != "entries") {
            refuse(IssueCode::unknownKey, ("/" + pathStep(key)).c_str(), quoted(json(key)),
                   Keys{{"format", "version", "kind", "entries"}});
        }
    }
    const auto expect = [&](const char* key, const json& expected, IssueCode wrong) {
        const auto found = root.find(key);
        const std::string path = std::string("/") + key;
        if (found == root.end()) {
            refuse(IssueCode::missingKey, path.c_str(), {}, quoted(expected));
        } else if (*found != expected) {
            refuse(wrong, path.c_str(), quoted(*found), quoted(expected));
        }
    };
    expect("format", catalogueFormat, IssueCode::notOneOf);
    expect("version", catalogueVersion, IssueCode::notOneOf);
    expect("kind", kind, IssueCode::notOneOf);
    const auto entries = root.find("entries");
    if (entries == root.end() || !entries->is_array()) {
        refuse(entries == root.end() ? IssueCode::missingKey : IssueCode::wrongType, "/entries",
               entries == root.end() ? Detail() : quoted(*entries), Phrase::listOfObjects);
        return nullptr;
    }
    return &*entries;
}

template <class Entry>
void readEntry(const json& text, const std::string& path, Entry& entry, Issues& issues) {
    const std::size_t before = issues.size();
    std::vector<MissingKey> missing;
    readByTable(text, tableOf<Entry>(), &entry, path, issues, missing);
    for (const char* key : {"name", "value"}) {
        if (text.is_object() && !text.contains(key)) {
            issues.push_back(
                {IssueCode::missingKey, Severity::error, path + "/" + key, {}, Keys{{key}}});
        }
    }
    if (issues.size() == before) {
        checkSources(text.at("value"), valueTable<Entry>(), entry.sources, path, issues);
        Project project;
        *(project.*Kindred<Entry>::member) = entry.value;
        checkLimits(project, Kindred<Entry>::key, entry.sources, path, issues);
        if constexpr (std::is_same_v<Entry, MaterialEntry>) {
            if (entry.thermal) {
                checkThermal(*entry.thermal, path + "/thermal", issues);
            }
        }
    }
}

/// Interpolates between the rows [x, y], whose x rise; empty outside.
std::optional<double> between(const NumberRows& rows, double x) {
    for (std::size_t i = 0; rows && i + 1 < rows->size(); ++i) {
        const auto& a = (*rows)[i];
        const auto& b = (*rows)[i + 1];
        if (a.size() == 2 && b.size() == 2 && a[0] <= x && x <= b[0] && a[0] < b[0]) {
            return a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
        }
    }
    return std::nullopt;
}

} // namespace

template <>
const StructInfo& tableOf<ValueSource>() {
    static const std::array rows{
        SPARKOUT_FIELD(ValueSource, key, .label = SPARKOUT_NOOP("Input", "Value"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Key of the number.")),
        SPARKOUT_FIELD(ValueSource, source, .label = SPARKOUT_NOOP("Input", "Source"),
                       .hint = SPARKOUT_NOOP("Input", "Key of the source; empty: an estimate, to "
                                                      "be calibrated.")),
        SPARKOUT_FIELD(ValueSource, range, .label = SPARKOUT_NOOP("Input", "Plausible range"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "not stated"), .count = 2,
                       .hint = SPARKOUT_NOOP("Input", "Minimum and maximum value to expect.")),
        makeField<&ValueSource::note>("note", noteRow()),
        makeField<&ValueSource::note_ru>("note_ru", russianNoteRow()),
    };
    static const StructInfo info =
        makeTable<ValueSource>(SPARKOUT_NOOP("Struct", "Source of a value"), rows);
    return info;
}

template <>
const StructInfo& tableOf<ThermalData>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            ThermalData, at_c, .label = SPARKOUT_NOOP("Input", "Temperature"), .symbol = "T",
            .unit = "°C", .hard = {-200, 1500},
            .hint = SPARKOUT_NOOP(
                "Input",
                "Temperature for which the entry's conductivity and diffusivity are given.")),
        SPARKOUT_FIELD(ThermalData, density_kg_m3, .label = SPARKOUT_NOOP("Input", "Density"),
                       .symbol = "ρ", .unit = "kg/m³", .hard = {100, 30000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not stated"),
                       .hint = SPARKOUT_NOOP("Input", "At room temperature.")),
        SPARKOUT_FIELD(ThermalData, conductivity_w_mk_at_c,
                       .label = SPARKOUT_NOOP("Input", "Conductivity over temperature"),
                       .symbol = "λ", .unit = "°C, W/(m·K)", .hard = {-200, 3000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not stated"), .count = 2,
                       .hint = SPARKOUT_NOOP("Input", "Rows of temperature and conductivity.")),
        SPARKOUT_FIELD(ThermalData, heat_capacity_j_kgk_at_c,
                       .label = SPARKOUT_NOOP("Input", "Heat capacity over temperature"),
                       .symbol = "c", .unit = "°C, J/(kg·K)", .hard = {-200, 10000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not stated"), .count = 2,
                       .hint = SPARKOUT_NOOP("Input", "Rows of temperature and heat capacity.")),
        SPARKOUT_FIELD(ThermalData, source, .label = SPARKOUT_NOOP("Input", "Source"),
                       .hint = SPARKOUT_NOOP("Input", "Key of the source.")),
    };
    static const StructInfo info =
        makeTable<ThermalData>(SPARKOUT_NOOP("Struct", "Heat data"), rows);
    return info;
}

template <>
const StructInfo& tableOf<MaterialEntry>() {
    static const auto rows = [] {
        const auto shared = entryRows<MaterialEntry>(SPARKOUT_NOOP("Input", "Material"));
        return std::array{
            shared[0],
            shared[1],
            shared[2],
            shared[3],
            shared[4],
            SPARKOUT_FIELD(MaterialEntry, thermal,
                           .label = SPARKOUT_NOOP("Input", "Heat data over temperature"),
                           .nullMeaning = SPARKOUT_NOOP("Input", "not stated"))};
    }();
    static const StructInfo info =
        makeTable<MaterialEntry>(SPARKOUT_NOOP("Struct", "Material of the catalogue"), rows);
    return info;
}

template <>
const StructInfo& tableOf<WheelEntry>() {
    static const auto rows = entryRows<WheelEntry>(SPARKOUT_NOOP("Input", "Wheel"));
    static const StructInfo info =
        makeTable<WheelEntry>(SPARKOUT_NOOP("Struct", "Wheel of the catalogue"), rows);
    return info;
}

template <>
const StructInfo& tableOf<MachineEntry>() {
    static const auto rows = entryRows<MachineEntry>(SPARKOUT_NOOP("Input", "Machine"));
    static const StructInfo info =
        makeTable<MachineEntry>(SPARKOUT_NOOP("Struct", "Machine of the catalogue"), rows);
    return info;
}

const ValueSource* sourceOf(const std::vector<ValueSource>& sources, std::string_view key) {
    const auto found = std::find_if(sources.begin(), sources.end(),
                                    [&](const ValueSource& source) { return source.key == key; });
    return found == sources.end() ? nullptr : &*found;
}

template <class Entry>
CatalogueRead<Entry> readCatalogue(std::string_view text) {
    CatalogueRead<Entry> read;
    const auto root = parseStrictly(text, read.issues);
    if (!root) {
        return read;
    }
    const json* list = checkHeader(*root, Kindred<Entry>::name, read.issues);
    std::vector<Entry> entries(list ? list->size() : 0);
    for (std::size_t i = 0; i < entries.size() && read.issues.size() < limits::issues; ++i) {
        readEntry((*list)[i], "/entries/" + std::to_string(i), entries[i], read.issues);
    }
    if (!hasErrors(read.issues)) {
        read.entries = std::move(entries);
    }
    return read;
}

template <class Entry>
std::string writeCatalogue(const std::vector<Entry>& entries) {
    ordered_json root = {
        {"format", catalogueFormat}, {"version", catalogueVersion}, {"kind", Kindred<Entry>::name}};
    ordered_json& list = root["entries"] = ordered_json::array();
    for (const Entry& entry : entries) {
        ordered_json text = writeByTable(tableOf<Entry>(), &entry);
        text["value"] = givenPart(text["value"], valueTable<Entry>(), entry.sources);
        list.push_back(std::move(text));
    }
    return printJson(root);
}

template <class Entry>
std::variant<std::string, Issues> checkedCatalogue(const std::vector<Entry>& entries) {
    std::string text = writeCatalogue(entries);
    CatalogueRead<Entry> again = readCatalogue<Entry>(text);
    if (!again.entries || writeCatalogue(*again.entries) != text) {
        return std::move(again.issues);
    }
    return text;
}

template <class Entry>
std::vector<Entry> mergedEntries(const std::vector<Entry>& shipped, const std::vector<Entry>& own) {
    std::vector<Entry> all = own;
    for (const Entry& entry : shipped) {
        const bool replaced = std::any_of(
            own.begin(), own.end(), [&](const Entry& mine) { return mine.name == entry.name; });
        if (!replaced) {
            all.push_back(entry);
        }
    }
    std::sort(all.begin(), all.end(), [](const Entry& a, const Entry& b) {
        return naturalOrder(a.name, b.name) < 0; // 50×… before 400×…
    });
    return all;
}

/// A wheel in a catalogue is new: its radius is not worn.
template <class Value>
void compensate(Value& value) {
    if constexpr (std::is_same_v<Value, Wheel>) {
        value.radius_wear_um = 0;
    }
}

template <class Entry>
void applyEntry(const Entry& entry, Project& project) {
    auto& target = *(project.*Kindred<Entry>::member);
    const ordered_json given = appliedPart(writeByTable(valueTable<Entry>(), &entry.value),
                                           valueTable<Entry>(), entry.sources);
    Issues issues;
    std::vector<MissingKey> missing;
    readByTable(json(given), valueTable<Entry>(), &target, {}, issues, missing);
    compensate(target);
}

template <class Entry>
Entry entryOf(const Project& project, const std::string& name) {
    Entry entry;
    entry.name = name;
    entry.value = *(project.*Kindred<Entry>::member);
    compensate(entry.value);
    const ordered_json value = writeByTable(valueTable<Entry>(), &entry.value);
    eachValue(value, valueTable<Entry>(), {}, [&](const std::string& key, const ordered_json&) {
        ValueSource source;
        source.key = key;
        entry.sources.push_back(std::move(source));
    });
    return entry;
}

std::optional<ThermalPoint> thermalAt(const ThermalData& data, double celsius) {
    const auto conductivity = between(data.conductivity_w_mk_at_c, celsius);
    const auto capacity = between(data.heat_capacity_j_kgk_at_c, celsius);
    if (!conductivity || !capacity || !data.density_kg_m3) {
        return std::nullopt;
    }
    constexpr double mm2PerM2 = units::mmPerM * units::mmPerM;
    return ThermalPoint{*conductivity,
                        *conductivity / (*data.density_kg_m3 * *capacity) * mm2PerM2};
}

#define SPARKOUT_CATALOGUE(Entry)                                                                  \
    template CatalogueRead<Entry> readCatalogue<Entry>(std::string_view);                          \
    template std::string writeCatalogue<Entry>(const std::vector<Entry>&);                         \
    template std::variant<std::string, Issues> checkedCatalogue<Entry>(const std::vector<Entry>&); \
    template std::vector<Entry> mergedEntries<Entry>(const std::vector<Entry>&,                    \
                                                     const std::vector<Entry>&);                   \
    template void applyEntry<Entry>(const Entry&, Project&);                                       \
    template Entry entryOf<Entry>(const Project&, const std::string&)
SPARKOUT_CATALOGUE(MaterialEntry);
SPARKOUT_CATALOGUE(WheelEntry);
SPARKOUT_CATALOGUE(MachineEntry);
#undef SPARKOUT_CATALOGUE

} // namespace sparkout
