// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QMainWindow;

namespace sparkout {

/// The keys of a window as HTML: those of its menus, of the pages of the inputs and of the plots,
/// with the current assignments.
[[nodiscard]] QString shortcutsHtml(const QMainWindow& window);

} // namespace sparkout
