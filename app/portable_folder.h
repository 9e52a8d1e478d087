// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace sparkout {

/// The folder of the program in the portable archive.
class PortableFolder {
public:
    /// Makes fonts beside the program preferred; call before any font is used.
    static void useItsFonts();
    /// Adds these fonts where Qt does not look for any, on Windows; call once the application
    /// exists.
    static void addItsFonts();

    /// The file in which the program stores its settings with --portable.
    [[nodiscard]] static QString settingsFile();
    [[nodiscard]] static QString stateFolder();

    /// Creates the folder of that file; reports a failure and returns false.
    [[nodiscard]] static bool make();
};

} // namespace sparkout
