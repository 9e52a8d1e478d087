// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/outcome.h"

#include <QWidget>

class QLabel;

namespace sparkout {

/// A tab of the window's middle: shows one outcome, the newest one wins. It draws once, later in
/// the event loop; a hidden one when it is shown.
class View : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

    [[nodiscard]] virtual QString title() const = 0; ///< of the tab, in the present language
    void setOutcome(sparkout::OutcomePtr outcome);
    virtual void retranslate() = 0;

signals:
    void updated(); ///< an outcome has been drawn

protected:
    virtual void showOutcome() = 0; ///< draws latest()
    /// What was given last, maybe refused.
    [[nodiscard]] const OutcomePtr& latest() const { return m_latest; }
    static void setUpNotice(QLabel& label);  ///< plain text, selectable, wrapped
    static void setUpReadout(QLabel& label); ///< the same for values, two lines high
    void redraw();                           ///< now, if there is something new
    void showEvent(QShowEvent* event) override;

private:
    OutcomePtr m_latest;
    bool m_stale = false;
    bool m_queued = false;
};

} // namespace sparkout
