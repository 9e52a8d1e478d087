// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace sparkout {

/// The folder that the program stands in, as the portable archive makes it.
class PortableFolder {
public:
    /// Before any font is looked for: fonts that stand beside the program come first.
    static void useItsFonts();
    /// The same where Qt looks for none: on Windows, once the application is there.
    static void addItsFonts();

    /// Where the program keeps what it remembers with --portable.
    [[nodiscard]] static QString settingsFile();
    [[nodiscard]] static QString stateFolder();

    /// Says so where nothing can be kept there.
    [[nodiscard]] static bool make();
};

} // namespace sparkout
