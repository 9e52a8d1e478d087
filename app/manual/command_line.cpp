// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/command_line.h"

#include <algorithm>

namespace sparkout::manual {

namespace {

template <class Row>
const Row* named(const std::vector<Row>& rows, std::string_view name) {
    const auto row =
        std::find_if(rows.begin(), rows.end(), [name](const Row& r) { return name == r.name; });
    return row == rows.end() ? nullptr : &*row;
}

} // namespace

const Command* commandNamed(const Program& program, std::string_view name) {
    return named(program.commands, name);
}

const Option* optionNamed(const std::vector<Option>& options, std::string_view name) {
    return named(options, name);
}

} // namespace sparkout::manual
