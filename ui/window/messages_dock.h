// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>

class QDockWidget;
class QStatusBar;
class QToolButton;

namespace sparkout {

class MessagesPanel;

/// The panel of messages, which takes room only while something is said: it opens by itself with a
/// new message and closes with the last one. A button in the status bar says how many there are.
class MessagesDock : public QObject {
    Q_OBJECT

public:
    MessagesDock(QDockWidget& dock, MessagesPanel& panel, QStatusBar& bar);

    void showOrHide(); ///< as the messages of now want it, whatever was before
    void retranslate();

private:
    void follow(); ///< the messages are others

    QDockWidget& m_dock;
    MessagesPanel& m_panel;
    QToolButton* m_button;
    QTimer m_later;     ///< not while something is dragged
    QStringList m_seen; ///< inputs
};

} // namespace sparkout
