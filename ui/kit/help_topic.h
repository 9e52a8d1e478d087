// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

class QHelpEvent;
class QWidget;

namespace sparkout {

/// Sets the help page of a widget and its contents: "verdict", "plots#keys".
void setHelpTopic(QWidget& widget, const QString& topic);

/// The topic of a widget or its nearest parent with one; empty if there is none.
[[nodiscard]] QString helpTopicOf(const QWidget* widget);

/// Shows the tool tips of the whole program: of widgets, cells and headings of tables, tabs and
/// menu entries, in lines of about sixty characters. Only the program's own hints are markup; any
/// other text, for instance from a file, is shown literally.
class ToolTips : public QObject {
    Q_OBJECT
public:
    static constexpr int lineLength = 60; ///< characters; a longer word takes a line of its own

    /// For the whole program; further calls have no effect.
    static void install();

    /// The text as passed to Qt.
    [[nodiscard]] static QString shown(const QString& text);
    /// The text for a label with markup, by the same rule; the label wraps it.
    [[nodiscard]] static QString markup(const QString& text);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    using QObject::QObject;
    static bool show(QWidget& widget, const QHelpEvent& event);
};

} // namespace sparkout
