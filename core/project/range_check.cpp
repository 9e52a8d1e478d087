// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/range_check.h"

#include "core/project/validate.h"

#include <charconv>
#include <cmath>
#include <optional>

namespace sparkout {

namespace {

class RangeCheck {
public:
    explicit RangeCheck(const Project& project) : m_project(project) {}

    void checkObject(const StructInfo& table, const void* owner, const std::string& path) {
        for (const Field& field : table.fields) {
            const bool relevant =
                (!field.relevant || field.relevant(m_project, owner)) && !isLeftOut(field, owner);
            checkField(field, owner, path + "/" + field.key, relevant);
        }
    }

    Issues issues;

private:
    /// A feed of 0 is not unusual where another feed replaces it.
    [[nodiscard]] bool isLeftOut(const Field& field, const void* owner) const {
        return field.kind == Kind::optionalNumber && field.exempt
               && field.as<std::optional<double>>(owner) == 0.0 && field.exempt(m_project, owner);
    }

    /// A feed that may retract the wheel is checked against the hard limits alone.
    [[nodiscard]] bool isDrawnBack(const Field& field, const void* owner, double value) const {
        return value < 0 && field.exempt && field.exempt(m_project, owner);
    }

    void checkNumber(const Field& field, double value, const std::string& path, bool relevant) {
        if (!std::isfinite(value) || !field.hard.contains(value)) {
            add(IssueCode::outOfRange, Severity::error, path, Amount{value, field.unit},
                Bounds{field.hard, field.unit});
        } else if (relevant && !field.soft.contains(value)) {
            add(IssueCode::unusual, Severity::warning, path, Amount{value, field.unit},
                Bounds{field.soft, field.unit});
        }
    }

    /// A list may have a million faults; only as many as are listed are kept.
    void add(IssueCode code, Severity severity, const std::string& path, Detail value,
             Detail limit) {
        std::size_t& count = severity == Severity::error ? m_errors : m_warnings;
        if (++count <= limits::issues) {
            issues.push_back({code, severity, path, std::move(value), std::move(limit)});
        }
    }

    void checkNumbers(const Field& field, const std::vector<double>& values,
                      const std::string& path, bool relevant) {
        checkCount(field, values.size(), path);
        for (std::size_t i = 0; i < values.size(); ++i) {
            checkNumber(field, values[i], path + "/" + std::to_string(i), relevant);
        }
    }

    void checkCount(const Field& field, std::size_t count, const std::string& path) {
        if (field.count != 0 && count != field.count) {
            add(IssueCode::wrongCount, Severity::error, path, countOf(count), countOf(field.count));
        }
    }

    void checkCompliance(const Field& field, const void* owner, const std::string& path,
                         bool relevant) {
        const auto& given = field.as<GivenCompliance>(owner);
        if (const auto* zones = std::get_if<ZoneCompliance>(&given)) {
            checkNumber(field, zones->rz1, path + "/rz1", relevant);
            checkNumber(field, zones->nz, path + "/nz", relevant);
            checkNumber(field, zones->rz2, path + "/rz2", relevant);
        } else if (const auto* sections = std::get_if<std::vector<double>>(&given)) {
            checkNumbers(field, *sections, path, relevant);
        }
    }

    void checkLevels(const Field& field, const void* owner, const std::string& path) {
        const auto& levels = field.as<Levels>(owner);
        if (const auto* stepped = std::get_if<SteppedLevels>(&levels)) {
            checkNumber(field, stepped->from, path + "/from", false);
            checkNumber(field, stepped->to, path + "/to", false);
            checkNumber(field, stepped->step, path + "/step", false);
        } else if (const auto* list = std::get_if<std::vector<double>>(&levels)) {
            checkNumbers(field, *list, path, false);
        }
    }

    void checkRows(const Field& field, const void* owner, const std::string& path) {
        const auto& rows = field.as<NumberRows>(owner);
        for (std::size_t i = 0; rows && i < rows->size(); ++i) {
            checkNumbers(field, (*rows)[i], path + "/" + std::to_string(i), false);
        }
    }

    /// Checks tens of thousands of samples; builds a path only for a fault.
    void checkSamples(const Field& field, const void* owner, const std::string& path) {
        const std::vector<double>& values = field.as<Samples>(owner).values();
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!std::isfinite(values[i]) || !field.hard.contains(values[i])) {
                checkNumber(field, values[i], path + "/" + std::to_string(i), false);
            }
        }
    }

    void checkItems(const Field& field, const void* owner, const std::string& path) {
        const std::size_t size = field.size(owner);
        if (!field.hard.unbounded() && !field.hard.contains(static_cast<double>(size))) {
            add(IssueCode::wrongCount, Severity::error, path, countOf(size), Bounds{field.hard});
        }
        for (std::size_t i = 0; i < size; ++i) {
            checkObject(*field.nested, field.itemIn(owner, i), path + "/" + std::to_string(i));
        }
    }

    void checkField(const Field& field, const void* owner, const std::string& path, bool relevant) {
        switch (field.kind) {
        case Kind::number: checkNumber(field, field.as<double>(owner), path, relevant); break;
        case Kind::optionalNumber:
            if (const auto& value = field.as<std::optional<double>>(owner)) {
                checkNumber(field, *value, path, relevant && !isDrawnBack(field, owner, *value));
            }
            break;
        case Kind::integer:
        case Kind::optionalInteger:
        case Kind::countOrWord:
            if (const int* number = field.wholeNumber(owner)) {
                checkNumber(field, *number, path, relevant);
            }
            break;
        case Kind::numberList:
            checkNumbers(field, field.as<std::vector<double>>(owner), path, relevant);
            break;
        case Kind::optionalNumberList:
            if (const auto& list = field.as<std::optional<std::vector<double>>>(owner)) {
                checkNumbers(field, *list, path, relevant);
            }
            break;
        case Kind::object:
        case Kind::optionalObject:
            if (const void* object = field.objectIn(owner)) {
                checkObject(*field.nested, object, path);
            }
            break;
        case Kind::objectList: checkItems(field, owner, path); break;
        case Kind::compliance: checkCompliance(field, owner, path, relevant); break;
        case Kind::levels: checkLevels(field, owner, path); break;
        case Kind::numberRows: checkRows(field, owner, path); break;
        case Kind::samples: checkSamples(field, owner, path); break;
        case Kind::boolean:
        case Kind::text:
        case Kind::choice:
        case Kind::jsonText: break;
        }
    }

    const Project& m_project;
    std::size_t m_errors = 0;
    std::size_t m_warnings = 0;
};

} // namespace

Issues checkRanges(const Project& project) {
    RangeCheck check(project);
    check.checkObject(tableOf<Project>(), &project, {});
    return std::move(check.issues);
}

Issues checkRanges(const StructInfo& table, const void* owner, const std::string& path) {
    const Project none;
    RangeCheck check(none);
    check.checkObject(table, owner, path);
    return std::move(check.issues);
}

std::string numberText(double value) {
    char buffer[64];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
    return {buffer, end};
}

std::string rangeText(const Range& range, const char* unit,
                      const std::function<std::string(double)>& number) {
    const std::string suffix = *unit ? " " + std::string(unit) : std::string();
    const bool below = std::isfinite(range.low);
    const bool above = std::isfinite(range.high);
    if (below && above && range.low == range.high) {
        return number(range.low) + suffix;
    }
    if (below && above) {
        return (range.lowOpen ? "> " : "") + number(range.low) + "…" + number(range.high) + suffix;
    }
    if (below) {
        return (range.lowOpen ? "> " : "≥ ") + number(range.low) + suffix;
    }
    return above ? "≤ " + number(range.high) + suffix : std::string();
}

Detail allowedIn(const Field& field) {
    switch (field.kind) {
    case Kind::number:
    case Kind::optionalNumber:
    case Kind::integer:
    case Kind::optionalInteger:
        return field.hard.unbounded() ? Detail(Phrase::number) : Bounds{field.hard, field.unit};
    case Kind::boolean: return Keys{{"true", "false"}};
    case Kind::text: return Phrase::text;
    case Kind::choice: {
        Keys choices{{}, Keys::Kind::choices};
        for (const Choice& choice : field.choices) {
            choices.keys.emplace_back(choice.key);
        }
        return choices;
    }
    case Kind::objectList: return Phrase::listOfObjects;
    case Kind::object:
    case Kind::optionalObject:
    case Kind::jsonText: return Phrase::object;
    default: return Bounds{field.hard, field.unit};
    }
}

} // namespace sparkout
