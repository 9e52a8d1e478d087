// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/outcome.h"

#include <QWidget>

namespace sparkout {

/// A tab of the window's middle: shows one outcome, the newest one wins.
class View : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

    [[nodiscard]] virtual QString title() const = 0; ///< of the tab, in the present language
    virtual void setOutcome(sparkout::OutcomePtr outcome) = 0;
    virtual void retranslate() = 0;

signals:
    void updated(); ///< an outcome has been drawn
};

} // namespace sparkout
