// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QToolButton;
class QWidget;

namespace sparkout {

/// A button of a bar that shows its frame under the pointer and is reached by Tab.
[[nodiscard]] QToolButton* flatButton(QWidget* parent, const char* name, const char16_t* icon);

} // namespace sparkout
