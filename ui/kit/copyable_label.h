// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QLabel;
class QWidget;

namespace sparkout {

/// A plain text that wraps and can be copied.
[[nodiscard]] QLabel* copyableLabel(QWidget* parent, const QString& text = {});

} // namespace sparkout
