// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/theme.h"

#include <QIcon>
#include <QStringView>

#include <vector>

/// Icons in the colours of the theme: the colours an icon is written in stand for tones.
namespace sparkout {

/// An icon of resources/icons by its name without ending: drawn at the size and in the colours of
/// the moment, so a change of theme needs no new icon.
[[nodiscard]] QIcon themeIcon(QStringView name);

/// A colour the icons are written in, and what it stands for.
struct IconColour {
    const char* written; ///< "#rrggbb"
    Tone tone;
};
[[nodiscard]] const std::vector<IconColour>& iconColours();

} // namespace sparkout
