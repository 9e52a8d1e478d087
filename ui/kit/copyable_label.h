// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QLabel;
class QWidget;

namespace sparkout {

/// A plain text that wraps.
[[nodiscard]] QLabel* plainLabel(const QString& text, QWidget* parent);
/// The same, that can be copied.
[[nodiscard]] QLabel* copyableLabel(QWidget* parent, const QString& text = {});

} // namespace sparkout
