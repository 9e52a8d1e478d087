// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

namespace sparkout {

/// A text the forms did not take: where, and why.
struct Refusal {
    std::string path;
    QString reason;
};

} // namespace sparkout
