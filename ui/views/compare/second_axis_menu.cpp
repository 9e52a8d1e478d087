// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compare/second_axis_menu.h"

#include "ui/charts/compare_plot.h"
#include "ui/kit/theme_icon.h"
#include "ui/plot/plot_tools.h"
#include "ui/plot/quantity_colour.h"

#include <QActionGroup>

namespace sparkout {

SecondAxisMenu::SecondAxisMenu(ComparePlot& plot, QWidget* parent) : QMenu(parent), m_plot(plot) {
    setObjectName(QStringLiteral("secondAxis"));
    setIcon(themeIcon(u"second_axis"));
    for (std::size_t row = 0; row < CompareChart::rowCount; ++row) {
        addSeparator();
        addRow(row);
    }
}

void SecondAxisMenu::addRow(std::size_t row) {
    auto* group = new QActionGroup(this);
    for (const Quantity quantity : CompareChart::secondQuantities[row]) {
        QAction* action = addAction(QString());
        action->setObjectName(QStringLiteral("second%1").arg(static_cast<int>(quantity)));
        action->setCheckable(true);
        action->setChecked(m_plot.secondQuantity(row) == quantity);
        group->addAction(action);
        m_quantities.push_back(action);
        connect(action, &QAction::triggered, this, [this, row, quantity] {
            m_plot.setSecond(row, quantity);
            m_plot.replot(QCustomPlot::rpQueuedReplot);
            m_plot.tools()->navigation().forgetViews(); // its ranges belong to another quantity
        });
    }
}

void SecondAxisMenu::retranslate() {
    setTitle(tr("Right-hand axes"));
    menuAction()->setToolTip(
        tr("Right-hand axes: the second quantity of the upper and of the lower plot"));
    auto action = m_quantities.begin();
    for (std::size_t row = 0; row < CompareChart::rowCount; ++row) {
        for (const Quantity quantity : CompareChart::secondQuantities[row]) {
            (*action++)->setText(
                (row == 0 ? tr("Above: %1") : tr("Below: %1")).arg(quantityWithUnit(quantity)));
        }
    }
}

} // namespace sparkout
