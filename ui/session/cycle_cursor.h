// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/progress.h"
#include "core/study/outcome.h"

#include <QObject>

#include <array>
#include <vector>

namespace sparkout {

/// By what the cursor steps: a stage, a double stroke (plunge: a revolution), a step E1…E5 of it, a
/// revolution or stroke of the wheel over the zone, one radius.
enum class CursorUnit { stage, stroke, step, revolution, radius };
inline constexpr std::array cursorUnits{CursorUnit::stage, CursorUnit::stroke, CursorUnit::step,
                                        CursorUnit::revolution, CursorUnit::radius};

/// Up to where the cycle has been ground: one place in time for all views. It counts moments (the
/// passes that run at the same time: of all sections, or of the zones of a stroke) and the radii of
/// the last one. At 0 the part is the blank; a new run stands at its end.
class CycleCursor : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Keeps blank, end, or the place within the same double stroke; of another operation it stands
    /// at the end. A refused run changes nothing; one that was not recorded leaves nothing to step
    /// through.
    void setOutcome(OutcomePtr outcome);
    [[nodiscard]] const OutcomePtr& outcome() const { return m_outcome; } ///< null: nothing

    [[nodiscard]] long long position() const { return m_position; } ///< radii done, 0…count()
    [[nodiscard]] long long count() const;                          ///< of the whole cycle
    [[nodiscard]] bool atStart() const { return m_position == 0; }
    [[nodiscard]] bool atEnd() const { return m_position == count(); }

    void setPosition(long long position); ///< the nearest there is
    void step(CursorUnit unit, int by);   ///< to so many ends of the unit on, or back
    void toStroke(int stroke);            ///< to the end of a double stroke; 0: the blank
    void toTime(double time_s);           ///< to the last radius done by then

    // What has been done last; at the blank all zero.
    [[nodiscard]] const Pass* pass() const; ///< the first of its moment; null at the blank
    [[nodiscard]] int stroke() const;       ///< number of the double stroke or revolution
    [[nodiscard]] bool strokeDone() const;  ///< else the cycle stands within it
    [[nodiscard]] int radius() const;       ///< k
    [[nodiscard]] double time_s() const;    ///< since the start of the cycle
    [[nodiscard]] Progress progress() const;

signals:
    void moved();

private:
    void findMoments();
    [[nodiscard]] bool ends(CursorUnit unit, std::size_t moment) const;
    [[nodiscard]] std::size_t moment() const; ///< of what has been done last; not at the blank
    [[nodiscard]] const Pass& passAt(std::size_t moment) const;
    [[nodiscard]] const std::vector<long long>& endsOf(CursorUnit unit) const;
    [[nodiscard]] long long startOf(int stroke) const; ///< position at which it begins
    [[nodiscard]] long long endOf(int stroke) const;

    OutcomePtr m_outcome;
    std::vector<std::size_t> m_moments; ///< first pass of each, and the number of passes
    /// Positions at which a stage, double stroke, step or revolution ends, rising.
    std::array<std::vector<long long>, 4> m_ends;
    long long m_position = 0;
};

} // namespace sparkout
