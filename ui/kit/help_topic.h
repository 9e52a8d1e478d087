// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace sparkout {

/// Says which page of the help tells of a widget and of what stands in it: "verdict", "plots#keys".
void setHelpTopic(QWidget& widget, const QString& topic);

/// The topic set nearest to a widget, of it or of its parents; empty when there is none.
[[nodiscard]] QString helpTopicOf(const QWidget* widget);

} // namespace sparkout
