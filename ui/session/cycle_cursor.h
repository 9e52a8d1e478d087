// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/progress.h"
#include "core/study/outcome.h"

#include <QObject>

#include <array>
#include <vector>

namespace sparkout {

/// Unit of the cursor's steps: a stage, a double stroke (plunge: a revolution), a step E1…E5 of it,
/// a revolution or stroke of the wheel over the zone, one radius.
enum class CursorUnit { stage, stroke, step, revolution, radius };
inline constexpr std::array cursorUnits{CursorUnit::stage, CursorUnit::stroke, CursorUnit::step,
                                        CursorUnit::revolution, CursorUnit::radius};

/// Moment up to which the cycle has been ground, common to all views. It counts moments
/// (simultaneous passes: over all sections, or over the zones of a stroke) and the radii of the
/// last one. At 0 the part is the blank; a new run begins at its end.
class CycleCursor : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Sets the outcome and keeps the cursor at the blank, at the end, or within the same double
    /// stroke; for another operation it moves to the end. A refused run changes nothing; a run that
    /// was not recorded has no positions to step through.
    void setOutcome(OutcomePtr outcome);
    [[nodiscard]] const OutcomePtr& outcome() const { return m_outcome; } ///< may be null

    [[nodiscard]] long long position() const { return m_position; } ///< radii done, 0…count()
    [[nodiscard]] long long count() const; ///< number of radii in the whole cycle
    [[nodiscard]] bool atStart() const { return m_position == 0; }
    [[nodiscard]] bool atEnd() const { return m_position == count(); }

    void setPosition(long long position); ///< moves to the nearest position
    void step(CursorUnit unit,
              int by);          ///< moves by this number of ends of the unit, forward or back
    void toStroke(int stroke);  ///< moves to the end of a double stroke; 0: the blank
    void toTime(double time_s); ///< moves to the last radius done by this time

    // The last finished moment; at the blank all values are zero.
    [[nodiscard]] const Pass* pass() const; ///< first pass of the current moment; null at the blank
    [[nodiscard]] int stroke() const;       ///< number of the double stroke or revolution
    [[nodiscard]] bool strokeDone() const;  ///< false: the cursor is within the stroke
    [[nodiscard]] int radius() const;       ///< k
    [[nodiscard]] double time_s() const;    ///< since the start of the cycle
    [[nodiscard]] Progress progress() const;

signals:
    void moved();

private:
    void findMoments();
    [[nodiscard]] bool ends(CursorUnit unit, std::size_t moment) const;
    [[nodiscard]] std::size_t moment() const; ///< current moment; not at the blank
    [[nodiscard]] const Pass& passAt(std::size_t moment) const;
    [[nodiscard]] const std::vector<long long>& endsOf(CursorUnit unit) const;
    [[nodiscard]] long long startOf(int stroke) const; ///< position at which a stroke begins
    [[nodiscard]] long long endOf(int stroke) const;

    OutcomePtr m_outcome;
    std::vector<std::size_t> m_moments; ///< first pass of each moment, and the number of passes
    /// Positions at which a stage, double stroke, step or revolution ends, rising.
    std::array<std::vector<long long>, 4> m_ends;
    long long m_position = 0;
};

} // namespace sparkout
