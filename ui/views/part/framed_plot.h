// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/profiles_look.h"
#include "ui/chart/view_plot.h"

#include <optional>
#include <vector>

namespace sparkout {

/// A plot of the zone profiles: hiding a line hides it in all of them.
class ProfilePlot : public ViewPlot {
    Q_OBJECT
public:
    using ViewPlot::ViewPlot;

    void setHidden(ProfileLines hidden);
    [[nodiscard]] virtual std::vector<ProfileLine> lines() const = 0; ///< as in the legend
    [[nodiscard]] LegendEntries entriesOf(const std::vector<ProfileLine>& lines) const;
    [[nodiscard]] LegendEntries legendEntries() const override { return entriesOf(lines()); }

    void keepLegible() { setMinimumSize(minimumSizeHint()); } ///< in the current font

protected:
    void changeEvent(QEvent* event) override;
    /// The size for a plot height and the lines of text around it.
    [[nodiscard]] QSize sizeFor(int plotHeight, int textLines) const;
    [[nodiscard]] const ProfileLines& hidden() const { return m_hidden; }
    [[nodiscard]] bool visible(ProfileLine line) const { return !m_hidden.contains(line); }

private:
    ProfileLines m_hidden;
};

/// A plot of profiles whose scales depend on each other: the user moves one frame, which the plot
/// converts to the axes of its cells.
class FramedPlot : public ProfilePlot {
    Q_OBJECT
public:
    using ProfilePlot::ProfilePlot;

    /// The user's frame: left, bottom, width and height; empty: everything.
    [[nodiscard]] PlotHistory::State visibleRange() const override;
    void setVisibleRange(const PlotHistory::State& range) override;

protected:
    void followMoves(QCPAxisRect& rect); ///< by the user, in this cell
    /// Sets the ranges of a cell, without a move by the user.
    void setRanges(const QCPAxisRect& rect, const QCPRange& x, const QCPRange& y);
    /// Shows an area at one scale for both axes.
    void showAround(const QCPAxisRect& rect, const QPointF& centre, double perPixel);
    [[nodiscard]] const std::optional<QRectF>& frame() const { return m_frame; } ///< none: all
    void showAll() { m_frame.reset(); }

private:
    std::optional<QRectF> m_frame;
    bool m_setting = false;
};

} // namespace sparkout
