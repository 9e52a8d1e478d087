// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/catalogue/catalogue.h"
#include "tests/core/support/project_samples.h"

#include <QtGlobal>

#include <string>
#include <type_traits>
#include <vector>

/// The catalogues that come with the program.
namespace sparkout::catalogues {

inline std::string shippedText(const char* kind) {
    return samples::readText(
        samples::sourcePath(std::string("resources/catalogue/") + kind + ".json"));
}

template <class Entry>
constexpr const char* kindOf() {
    return std::is_same_v<Entry, MaterialEntry> ? "materials"
           : std::is_same_v<Entry, WheelEntry>  ? "wheels"
                                                : "machines";
}

template <class Entry>
std::vector<Entry> shipped() {
    auto read = readCatalogue<Entry>(shippedText(kindOf<Entry>()));
    if (!read.entries || read.entries->empty()) {
        qFatal("the shipped %s are not read", kindOf<Entry>());
    }
    return *read.entries;
}

} // namespace sparkout::catalogues
