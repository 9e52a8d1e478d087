// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

#include <vector>

namespace sparkout {

class ComparePlot;

/// The quantities on the right-hand axes of the compared curves, the upper and the lower, chosen
/// from one menu.
class SecondAxisMenu : public QMenu {
    Q_OBJECT
public:
    explicit SecondAxisMenu(ComparePlot& plot, QWidget* parent = nullptr);

    void retranslate();

private:
    void addRow(std::size_t row);

    ComparePlot& m_plot;
    std::vector<QAction*> m_quantities; ///< actions row by row
};

} // namespace sparkout
