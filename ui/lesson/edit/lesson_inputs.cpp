// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/edit/lesson_inputs.h"

#include "core/project/leaves.h"
#include "core/project/member.h"
#include "core/project/validate.h"

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr double mostLevelsListed = 100; ///< for a range converted to a list or sets

std::vector<double> levelNumbers(const VariedInput& input) {
    std::vector<double> numbers;
    const double count = std::min(input.alternatives() == 1 ? input.levels() : 0, mostLevelsListed);
    for (std::size_t level = 0; static_cast<double>(level) < count; ++level) {
        const std::vector<InputValue> values = input.valuesAt(level);
        if (!values.empty() && values.front().number) {
            numbers.push_back(*values.front().number);
        }
    }
    return numbers;
}

} // namespace

std::vector<std::string> formInputs(const Project& project) {
    std::vector<std::string> paths;
    for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
        if (leaf.field->page == Page::none) {
            continue;
        }
        for (std::size_t end = 1; (end = leaf.path.find('/', end)) != std::string::npos; ++end) {
            std::string above = leaf.path.substr(0, end);
            if (std::ranges::find(paths, above) == paths.end()) {
                paths.push_back(std::move(above));
            }
        }
        if (std::ranges::find(paths, leaf.path) == paths.end()) {
            paths.push_back(leaf.path);
        }
    }
    return paths;
}

std::vector<std::string> inputsToPut(const Project& project, Puts puts) {
    std::vector<std::string> paths;
    const std::vector<NumberInput> numbers = numberInputs(project);
    for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
        if (leaf.field->page == Page::none || !leaf.owner) {
            continue;
        }
        if (leaf.field->kind == Kind::text || leaf.field->kind == Kind::choice) {
            if (puts == Puts::anything) {
                paths.push_back(leaf.path);
            }
            continue;
        }
        for (const NumberInput& number : numbers) { // a compliance has one for each place
            if (number.path == leaf.path || number.path.starts_with(leaf.path + '/')) {
                paths.push_back(number.path);
            }
        }
    }
    return paths;
}

InputValue valueIn(const Project& project, const std::string& path) {
    if (const auto input = numberInput(project, path)) {
        return {path, input->value.value_or(0), {}};
    }
    const ConstMember member = findMember(project, path);
    InputValue value{path, {}, {}};
    if (member && member.field->kind == Kind::text) {
        value.text = member.field->as<std::string>(member.owner);
    } else if (member && member.field->kind == Kind::choice) {
        const int index = member.field->getChoice(member.owner);
        value.text = member.field->choices[static_cast<std::size_t>(std::max(index, 0))].key;
    }
    return value;
}

VariedBy variedBy(const VariedInput& input) {
    return !input.sets.empty() ? VariedBy::sets : input.list ? VariedBy::list : VariedBy::range;
}

VariedInput variedAs(const VariedInput& input, VariedBy by, const Project& project) {
    VariedInput made;
    made.path = !input.sets.empty() && !input.sets.front().values.empty()
                    ? input.sets.front().values.front().path
                    : input.path;
    std::vector<double> numbers = levelNumbers(input);
    const InputValue now = valueIn(project, made.path);
    if (numbers.empty() && now.number) {
        numbers.push_back(*now.number);
    }
    switch (by) {
    case VariedBy::range:
        if (!numbers.empty()) {
            const auto [least, most] = std::ranges::minmax(numbers);
            made.from = least;
            made.to = most;
        }
        break;
    case VariedBy::list: made.list = std::move(numbers); break;
    case VariedBy::sets:
        for (const double number : numbers) {
            made.sets.push_back({numberText(number), {{made.path, number, {}}}});
        }
        if (made.sets.empty()) {
            made.sets.push_back({{}, {now}});
        }
        made.path.clear();
        break;
    }
    return made;
}

double variantCount(const VariantRules& rules) {
    double count = rules.inputs.empty() ? 0 : 1;
    for (const VariedInput& input : rules.inputs) {
        count *= input.alternatives() == 1 ? input.levels() : 0;
    }
    return count;
}

} // namespace sparkout
