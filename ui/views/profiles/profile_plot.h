// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/profiles_look.h"
#include "ui/plot/view_plot.h"

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

} // namespace sparkout
