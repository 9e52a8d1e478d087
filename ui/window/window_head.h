// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QMenuBar;
class QToolBar;

namespace sparkout {

/// The head of the window: menus and tools on one line. The tools have names beside their icons if
/// all fit.
class WindowHead : public QWidget {
    Q_OBJECT

public:
    explicit WindowHead(QWidget* parent);

    [[nodiscard]] QMenuBar& menus() { return *m_menus; }
    [[nodiscard]] QToolBar& tools() { return *m_tools; }
    void fitNames(); ///< after a change of the texts

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void fit();

    QMenuBar* m_menus;
    QToolBar* m_tools;
    int m_named = 0; ///< width of the tools with their names
};

} // namespace sparkout
