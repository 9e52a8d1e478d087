// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/view_plot.h"

#include <QEvent>
#include <QLocale>

namespace sparkout {

void ViewPlot::setDimmed(bool dim) {
    if (m_dim != dim) {
        m_dim = dim;
        if (m_built) {
            restyle();
            emit contentChanged();
        }
    }
}

void ViewPlot::retranslate() {
    QLocale numbers;
    numbers.setNumberOptions(QLocale::OmitGroupSeparator);
    setLocale(numbers);
    setTexts();
}

void ViewPlot::takeLook(bool) {
    restyle();
}

void ViewPlot::pointAway() {
    emit pointed({});
}

// Here, because a parent learns of a new palette before its children.
void ViewPlot::changeEvent(QEvent* event) {
    QCustomPlot::changeEvent(event);
    const bool font = event->type() == QEvent::FontChange;
    if (m_built && (font || event->type() == QEvent::PaletteChange)) {
        takeLook(font);
        emit contentChanged();
        replot(rpQueuedReplot);
    }
}

void ViewPlot::leaveEvent(QEvent* event) {
    QCustomPlot::leaveEvent(event);
    pointAway();
}

} // namespace sparkout
