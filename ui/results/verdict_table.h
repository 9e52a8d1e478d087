// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/judgement.h"
#include "core/quality/verdict.h"
#include "core/simulation/result.h"
#include "core/study/outcome.h"
#include "ui/table/value_table.h"

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QPixmap>
#include <QString>

#include <array>
#include <string>
#include <vector>

class QAbstractItemView;

namespace sparkout {

/// By light.
using LightIcons = std::array<QIcon, 4>;

[[nodiscard]] QColor lightColour(Light light, const QPalette& palette);

/// Circle, triangle or square in the light's colour of the current theme, distinct also without
/// colour.
[[nodiscard]] QPixmap lightPixmap(Light light, int size, qreal ratio, bool grey);
/// The mark of a judgement: a grey ring if nothing was computed, a dashed green one for the nominal
/// part alone or where the batch was not run, otherwise the light: fails, undecided or close, or
/// meets.
[[nodiscard]] QPixmap judgedPixmap(JudgedState state, int size, qreal ratio, bool grey);
/// For the cells of a table, light by light, each in the middle of a line of text: in a cell of
/// several lines, at its top, it stands on the first. Sets the table's size of icons.
[[nodiscard]] LightIcons lightIcons(QAbstractItemView& table, bool grey);

[[nodiscard]] QString lightName(Light light); ///< "holds", "close to the limit", "fails"
/// As the light has it, or why nothing is decided: strips are left and the value is not of the
/// whole surface, or the machine is not known.
[[nodiscard]] QString lightName(const ConstraintResult& constraint);

enum class VerdictColumn { requirement, value, limit, margin };

/// The requirements, zone by zone, then those of the part, of the passes and of the settings; null:
/// a group heading.
[[nodiscard]] std::vector<const ConstraintResult*> verdictRows(const Outcome& outcome);

/// The same as a table with their lights. It is copied with zone and light in columns of their own.
/// Without an outcome (null) the table has its heads only.
[[nodiscard]] ValueTable verdictTable(const Outcome* outcome, const LightIcons& icons);

} // namespace sparkout

namespace sparkout::verdict {

/// Explains the value of a requirement in a sentence or two with the numbers: for a diameter the
/// parts of its deviation, for a form error the remainder of the blank's, for a limit on passes its
/// worst place.
[[nodiscard]] QString why(const Outcome& outcome, const ConstraintResult& requirement);

/// JSON pointer of the input limited by a requirement on a setting; empty for the others.
[[nodiscard]] std::string inputPath(const ConstraintResult& requirement);

/// The most important requirement of the verdict: the worst unmet, otherwise the closest; null
/// without any.
[[nodiscard]] const ConstraintResult* worst(const Outcome& outcome);

// The texts of the verdict, plain.

[[nodiscard]] QString time(const SimulationResult& result);   ///< "2.41 min (144.6 s)"
[[nodiscard]] QString status(const SimulationResult& result); ///< including a shortfall of size

} // namespace sparkout::verdict
