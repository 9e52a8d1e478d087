// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>

/// The marks of refused, unusual or missing values in all inputs.
namespace sparkout {

enum class Mark {
    none,
    warning,
    missing, ///< not given yet, which is not a fault
    error
};

/// A mark and the sentence with its reason.
struct Remark {
    Mark mark = Mark::none;
    QString reason;
};

[[nodiscard]] QColor markColor(Mark mark, const QPalette& palette);
[[nodiscard]] QIcon markIcon(Mark mark);
[[nodiscard]] Mark markOf(const Issue& issue); ///< for a project being typed

/// The worst issue at a path or below it.
[[nodiscard]] Remark remarkFor(const Issues& issues, const std::string& path);

/// The worst issue at a path itself.
[[nodiscard]] Remark remarkAt(const Issues& issues, const std::string& path);

} // namespace sparkout
