// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/number_input.h"

#include <array>
#include <cmath>
#include <functional>

namespace sparkout {

namespace {

/// Receives a number, the struct that holds its member, and the index within the member.
using NumberVisit = std::function<void(NumberInput&&, const void* owner, std::size_t part)>;

class NumberWalk {
public:
    NumberWalk(const Project& project, NumberVisit visit)
        : m_project(project), m_visit(std::move(visit)) {}

    void walkProject() {
        for (const Field& field : tableOf<Project>().fields) {
            const std::string_view key = field.key;
            if (key != "card" && key != "batch" && key != "optimisation" && key != "sweep"
                && key != "measured" && key != "runs") {
                walkField(field, &m_project, {});
            }
        }
    }

private:
    void walkStruct(const StructInfo& table, const void* owner, const std::string& path) {
        for (const Field& field : table.fields) {
            walkField(field, owner, path);
        }
    }

    void walkField(const Field& field, const void* owner, const std::string& above) {
        if (field.relevant && !field.relevant(m_project, owner)) {
            return;
        }
        const std::string path = above + '/' + field.key;
        if (field.kind == Kind::objectList) {
            for (std::size_t i = 0; i < field.size(owner); ++i) {
                walkStruct(*field.nested, field.itemIn(owner, i), path + '/' + std::to_string(i));
            }
        } else if (field.nested) {
            if (const void* const object = field.objectIn(owner)) {
                walkStruct(*field.nested, object, path);
            }
        } else {
            walkNumbers(field, owner, path);
        }
    }

    void walkNumbers(const Field& field, const void* owner, const std::string& path) {
        const auto add = [&](const std::string& at, std::optional<double> value, bool integer,
                             std::size_t part = 0) {
            m_visit({at, &field, field.allowed(m_project, owner), integer, value}, owner, part);
        };
        switch (field.kind) {
        case Kind::number: add(path, field.as<double>(owner), false); break;
        case Kind::optionalNumber: add(path, field.as<std::optional<double>>(owner), false); break;
        case Kind::integer: add(path, field.as<int>(owner), true); break;
        case Kind::optionalInteger: {
            const auto& value = field.as<std::optional<int>>(owner);
            add(path, value ? std::optional<double>(*value) : std::nullopt, true);
            break;
        }
        case Kind::countOrWord:
            if (const int* count = field.wholeNumber(owner)) {
                add(path, *count, true);
            }
            break;
        case Kind::compliance: {
            const auto& given = field.as<GivenCompliance>(owner);
            if (const auto* zones = std::get_if<ZoneCompliance>(&given)) {
                add(path + "/rz1", zones->rz1, false, 0);
                add(path + "/nz", zones->nz, false, 1);
                add(path + "/rz2", zones->rz2, false, 2);
            } else if (const auto* sections = std::get_if<std::vector<double>>(&given)) {
                for (std::size_t i = 0; i < sections->size(); ++i) {
                    add(path + '/' + std::to_string(i), (*sections)[i], false, i);
                }
            }
            break;
        }
        default: break;
        }
    }

    const Project& m_project;
    NumberVisit m_visit;
};

/// `owner` is a struct of a project that may be written to.
void store(const Field& field, void* owner, std::size_t part, double value) {
    const auto whole = static_cast<int>(std::lround(value));
    switch (field.kind) {
    case Kind::number: field.as<double>(owner) = value; break;
    case Kind::optionalNumber: field.as<std::optional<double>>(owner) = value; break;
    case Kind::integer:
    case Kind::countOrWord: *field.wholeNumber(owner) = whole; break;
    case Kind::optionalInteger: field.as<std::optional<int>>(owner) = whole; break;
    case Kind::compliance: {
        auto& given = field.as<GivenCompliance>(owner);
        if (auto* const zones = std::get_if<ZoneCompliance>(&given)) {
            (part == 0 ? zones->rz1 : part == 1 ? zones->nz : zones->rz2) = value;
        } else if (auto* const sections = std::get_if<std::vector<double>>(&given)) {
            (*sections)[part] = value;
        }
        break;
    }
    default: break;
    }
}

} // namespace

std::vector<NumberInput> numberInputs(const Project& project) {
    std::vector<NumberInput> inputs;
    NumberWalk(project, [&inputs](NumberInput&& input, const void*, std::size_t) {
        inputs.push_back(std::move(input));
    }).walkProject();
    return inputs;
}

std::optional<NumberInput> numberInput(const Project& project, std::string_view path) {
    std::optional<NumberInput> found;
    NumberWalk(project, [&](NumberInput&& input, const void*, std::size_t) {
        if (input.path == path) {
            found = std::move(input);
        }
    }).walkProject();
    return found;
}

bool setNumberInput(Project& project, std::string_view path, double value) {
    std::function<void()> set;
    NumberWalk(project, [&](NumberInput&& input, const void* owner, std::size_t part) {
        if (input.path == path) {
            set = [field = input.field, owner = const_cast<void*>(owner), part, value] {
                store(*field, owner, part, value); // the project is not const
            };
        }
    }).walkProject();
    if (set) {
        set();
    }
    return static_cast<bool>(set);
}

} // namespace sparkout
