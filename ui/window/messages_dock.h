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

/// The panel of messages: it opens by itself with a new message and closes with the last one. A
/// button in the status bar shows their number.
class MessagesDock : public QObject {
    Q_OBJECT

public:
    MessagesDock(QDockWidget& dock, MessagesPanel& panel, QStatusBar& bar);

    void showOrHide(); ///< according to the current messages
    void retranslate();

private:
    void follow(); ///< the messages are others

    QDockWidget& m_dock;
    MessagesPanel& m_panel;
    QToolButton* m_button;
    QTimer m_later;     ///< delays it during a drag
    QStringList m_seen; ///< inputs
};

} // namespace sparkout
