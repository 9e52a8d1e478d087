// SPDX-License-Identifier: GPL-3.0-or-later
// Looks at all texts of a window, whatever it is made of.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

class QObject;
class QWidget;

namespace sparkout {

/// A text a person reads or hears, and where it stands.
struct ShownText {
    QString text;
    QString where;
};

/// Object names, or classes, from the window down.
[[nodiscard]] QString pathOf(const QObject* object);

/// Texts, titles, tooltips and accessible names of a window and all that is in it, hidden or not;
/// of plots and legends what is drawn.
[[nodiscard]] QList<ShownText> textsOf(const QWidget& window);

/// English words in a text that should be Russian: three Latin letters or more that are no name,
/// key, unit or symbol.
[[nodiscard]] QString englishIn(QString text);

/// Visible texts that have no room: cut by their widget or by what it stands in, or elided. What
/// can be scrolled into sight has room. A busy machine lays out after a while: for a second it is
/// looked at again.
[[nodiscard]] QStringList textsWithoutRoom(const QWidget& window);

/// Widgets one can use, by mouse or keyboard; without the parts Qt makes widgets of.
[[nodiscard]] QList<QWidget*> interactiveWidgets(const QWidget& window);

} // namespace sparkout
