// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/registry.h"

#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace {

std::map<std::string, TestEntry::Maker>& entries() {
    static std::map<std::string, TestEntry::Maker> all;
    return all;
}

} // namespace

TestEntry::TestEntry(const char* name, Maker maker) {
    entries().emplace(name, maker);
}

int runTest(int argc, char** argv) {
    const auto entry = argc > 1 ? entries().find(argv[1]) : entries().end();
    if (entry == entries().end()) {
        std::fprintf(stderr, "usage: %s TEST [QT TEST OPTIONS], where TEST is one of\n", argv[0]);
        for (const auto& [name, maker] : entries()) {
            std::fprintf(stderr, "  %s\n", name.c_str());
        }
        return 1;
    }
    std::vector<char*> rest(argv, argv + argc + 1); // with the null at the end
    rest.erase(rest.begin() + 1);
    return QTest::qExec(entry->second().get(), argc - 1, rest.data());
}
