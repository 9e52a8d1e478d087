// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/cycle_cursor.h"

#include <QPointer>
#include <QWidget>

class QLabel;

#include <string>

namespace sparkout {

/// A tab in the middle of the window that shows the newest outcome. It draws later in the event
/// loop; if hidden, when it is shown. The moment of the cycle comes from a cursor, its own or one
/// shared with the other views.
class View : public QWidget {
    Q_OBJECT
public:
    explicit View(QWidget* parent = nullptr);

    [[nodiscard]] virtual QString title() const = 0;                ///< translated
    [[nodiscard]] virtual QString brief() const { return title(); } ///< title of the tab
    void setOutcome(sparkout::OutcomePtr outcome);
    /// Replaces its own cursor by that of the window's views, which receives the outcomes first.
    void shareCycle(CycleCursor* cycle);
    virtual void retranslate() = 0;
    [[nodiscard]] virtual bool busy() const { return false; } ///< with computations of its own
    /// Whether it shows a moment of the cycle, which the playback changes.
    [[nodiscard]] virtual bool showsMoment() const { return false; }
    /// Called before another document or surface is shown. The old content stays until the new one
    /// has a result, and is removed if that is refused.
    void forget();

signals:
    void updated();                           ///< an outcome has been drawn
    void inputAsked(const std::string& path); ///< a missing input

protected:
    virtual void showOutcome() = 0; ///< draws latest(), at the cycle's moment
    virtual void followCycle() {}   ///< the moment of the cycle has changed
    [[nodiscard]] CycleCursor& cycle() const { return *m_cycle; }
    /// Null if the cursor belongs to another run than the one shown, or to an unrecorded one.
    [[nodiscard]] const CycleCursor* cycleIn(const OutcomePtr& shown) const;
    /// The last outcome, possibly refused.
    [[nodiscard]] const OutcomePtr& latest() const { return m_latest; }
    static void setUpNotice(QLabel& label); ///< plain text, selectable, wrapped
    /// Sets up the label for the values under the mouse, which readOut() fills.
    void setUpReadout(QLabel& label, int lines = 2);
    void readOut(const QString& text = {}); ///< empty: shows the hint
    /// The text shown while the mouse points at nothing.
    [[nodiscard]] virtual QString hint() const = 0;
    virtual void dropStudies() {} ///< drops results computed on demand, before another document
    /// Whether the current document has had no outcome since forget().
    [[nodiscard]] bool isOfBefore() const { return m_ofBefore; }
    void keepOutcome() { m_ofBefore = false; } ///< it belongs to the current document
    virtual void recolour() {}                 ///< updates parts that do not follow the palette
    /// Call at the end of a constructor: sets the texts, now and whenever the language changes.
    void built();
    void redraw(); ///< at once, if anything is new
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
    bool m_ofBefore = false; ///< the content belongs to another document
};

} // namespace sparkout
