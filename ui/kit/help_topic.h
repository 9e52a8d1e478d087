// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace sparkout {

/// Sets the help page of a widget and its contents: "verdict", "plots#keys".
void setHelpTopic(QWidget& widget, const QString& topic);

/// The topic of a widget or its nearest parent with one; empty if there is none.
[[nodiscard]] QString helpTopicOf(const QWidget* widget);

} // namespace sparkout
