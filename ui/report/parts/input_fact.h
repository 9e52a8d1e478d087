// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <QString>

#include <utility>

/// Inputs with their names, for every document.
namespace sparkout::report {

/// The ground size as on a drawing, in millimetres: "⌀30h6(−0.016)". The tolerance field is the one
/// with these limits, otherwise the one in the part's name; a deviation of 0 is not written.
[[nodiscard]] QString drawnSize(const Part& part);
/// An input by its path: its name in the form, with the symbol, and its value with the unit.
[[nodiscard]] std::pair<QString, QString> inputFact(const Project& project, const char* path);

} // namespace sparkout::report
