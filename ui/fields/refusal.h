// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

namespace sparkout {

/// A text refused by the forms: its place and the reason.
struct Refusal {
    std::string path;
    QString reason;
};

} // namespace sparkout
