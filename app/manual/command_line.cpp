// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/command_line.h"

#include <algorithm>

namespace sparkout::manual {

std::string_view Command::lastWord() const {
    const std::string_view all = name;
    return all.substr(all.rfind(' ') + 1);
}

const Command* commandNamed(const Command& among, std::string_view lastWord) {
    const auto row = std::ranges::find(among.commands, lastWord, &Command::lastWord);
    return row == among.commands.end() ? nullptr : &*row;
}

const Option* optionNamed(const Command& command, std::string_view name) {
    const auto row = std::ranges::find_if(
        command.options, [name](const Option& option) { return option.isNamed(name); });
    return row != command.options.end() ? &*row : helpOption.isNamed(name) ? &helpOption : nullptr;
}

std::vector<Option> optionsOf(const Command& command) {
    std::vector<Option> options = command.options;
    options.push_back(helpOption);
    return options;
}

std::vector<const Command*> withAllBelow(const Command& command) {
    std::vector<const Command*> all{&command};
    for (const Command& each : command.commands) {
        const auto below = withAllBelow(each);
        all.insert(all.end(), below.begin(), below.end());
    }
    return all;
}

std::vector<std::string_view> wordsOf(std::string_view text) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        words.push_back(text.substr(0, text.find(' ')));
        text.remove_prefix(std::min(words.back().size() + 1, text.size()));
    }
    return words;
}

std::string valueShown(const Option& option) {
    std::string shown = option.value.shown;
    if (shown.empty()) {
        shown = option.value.choices;
        std::ranges::replace(shown, ' ', '|');
    }
    return shown;
}

std::string asTyped(const Option& option) {
    const std::string shown = valueShown(option);
    return shown.empty() ? option.name : option.name + (' ' + shown);
}

} // namespace sparkout::manual
