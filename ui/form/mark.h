// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <QColor>
#include <QIcon>
#include <QLabel>
#include <QPalette>
#include <QString>

#include <string>

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

/// A text refused by the forms: its place and the reason.
struct Refusal {
    std::string path;
    QString reason;
};

/// The reason of a mark in the mark's colour; hidden if there is none.
class ReasonLabel : public QLabel {
    Q_OBJECT

public:
    explicit ReasonLabel(QWidget* parent = nullptr);

    void showRemark(const Remark& remark);
};

} // namespace sparkout
