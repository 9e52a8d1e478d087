// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/theme.h"

#include <QIcon>
#include <QStringView>

#include <vector>

class QToolButton;
class QWidget;

/// Icons in the colours of the theme: each colour in an icon file represents a tone.
namespace sparkout {

/// An icon of resources/icons by its name without suffix, drawn in the current size and colours, so
/// that it follows a change of theme.
[[nodiscard]] QIcon themeIcon(QStringView name);

/// A colour in the icon files and its tone.
struct IconColour {
    const char* written; ///< "#rrggbb"
    Tone tone;
};
[[nodiscard]] const std::vector<IconColour>& iconColours();

/// A button of a bar that shows its frame under the pointer and is reached by Tab.
[[nodiscard]] QToolButton* flatButton(QWidget* parent, const char* name, const char16_t* icon);

} // namespace sparkout
