// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

#include <memory>

/// A class of tests under the name of its ctest entry. Many are linked into one program, so that
/// what they share is compiled once; each run of it carries out the one it is given by name.
struct TestEntry {
    using Maker = std::unique_ptr<QObject> (*)();
    TestEntry(const char* name, Maker maker);
};

/// Runs the test named by the first argument, with the others as Qt Test's options. Returns the
/// number of failures; without a known name it lists the names and returns 1.
int runTest(int argc, char** argv);

/// The columns of a table of data: their types, and their names in the same order.
template <class... Values, class... Names>
void addColumns(Names... names) {
    (QTest::addColumn<Values>(names), ...);
}

/// A row of it: its name and its values, texts of the source as QString.
template <class... Values>
void addRow(const char* name, const Values&... values) {
    (QTest::newRow(name) << ... << values);
}

/// The class of a namespace of the test's own name, in that of what is tested.
#define SPARKOUT_TEST(NAME, CLASS)                                                                 \
    namespace sparkout {                                                                           \
    static const TestEntry NAME##_entry(#NAME, []() -> std::unique_ptr<QObject> {                  \
        return std::make_unique<NAME::CLASS>();                                                    \
    });                                                                                            \
    }
