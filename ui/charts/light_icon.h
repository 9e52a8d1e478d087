// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/judgement/judgement.h"
#include "core/quality/light.h"

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QPixmap>

#include <array>

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

} // namespace sparkout
