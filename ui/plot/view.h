// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/cycle_cursor.h"

#include <QPointer>
#include <QWidget>

class QLabel;

#include <string>

namespace sparkout {

/// A tab of the window's middle: shows one outcome, the newest one wins. It draws once, later in
/// the event loop; a hidden one when it is shown. Where the cycle stands it takes from a cursor,
/// its own or one shared with the other views.
class View : public QWidget {
    Q_OBJECT
public:
    explicit View(QWidget* parent = nullptr);

    [[nodiscard]] virtual QString title() const = 0;                ///< in the present language
    [[nodiscard]] virtual QString brief() const { return title(); } ///< of the tab
    void setOutcome(sparkout::OutcomePtr outcome);
    /// Of the window's views, in place of its own; it is given the outcomes first.
    void shareCycle(CycleCursor* cycle);
    virtual void retranslate() = 0;
    [[nodiscard]] virtual bool busy() const { return false; } ///< with what it computes itself
    /// Whether it shows a moment of the cycle, which the playback moves.
    [[nodiscard]] virtual bool showsMoment() const { return false; }
    /// Another document comes, or surface. What is shown of the one before stays until this one has
    /// a result of its own, but not longer: where that is refused, it goes.
    void forget();

signals:
    void updated();                           ///< an outcome has been drawn
    void inputAsked(const std::string& path); ///< one that is missing

protected:
    virtual void showOutcome() = 0; ///< draws latest(), at the cycle's moment
    virtual void followCycle() {}   ///< the cycle stands at another moment
    [[nodiscard]] CycleCursor& cycle() const { return *m_cycle; }
    /// Null while it stands in another run than the one shown, or that was not recorded.
    [[nodiscard]] const CycleCursor* cycleIn(const OutcomePtr& shown) const;
    /// What was given last, maybe refused.
    [[nodiscard]] const OutcomePtr& latest() const { return m_latest; }
    static void setUpNotice(QLabel& label); ///< plain text, selectable, wrapped
    /// The same for the values under the mouse, which readOut() fills.
    void setUpReadout(QLabel& label, int lines = 2);
    void readOut(const QString& text = {}); ///< nothing: the hint
    /// What the read-out says while nothing is pointed at.
    [[nodiscard]] virtual QString hint() const = 0;
    virtual void dropStudies() {} ///< what was computed on demand: another document comes
    /// Whether no outcome of the present document has been given since forget().
    [[nodiscard]] bool isOfBefore() const { return m_ofBefore; }
    void keepOutcome() { m_ofBefore = false; } ///< what is shown is of the present document
    virtual void recolour() {} ///< what does not follow the palette by itself, as a legend
    /// Ends a constructor: gives the texts, then and whenever the language changes.
    void built();
    void redraw(); ///< now, if there is something new
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void onMoved();

    OutcomePtr m_latest;
    CycleCursor* m_ownCycle;
    QLabel* m_readout = nullptr;
    QPointer<CycleCursor> m_cycle;
    bool m_built = false;
    bool m_stale = false;
    bool m_queued = false;
    bool m_moved = false;
    bool m_ofBefore = false; ///< what is shown is of another document
};

} // namespace sparkout
