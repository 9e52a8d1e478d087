// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/profile_plot.h"

#include <QEvent>

#include <utility>

namespace sparkout {

void ProfilePlot::setHidden(ProfileLines hidden) {
    m_hidden = std::move(hidden);
    showChoice();
}

LegendEntries ProfilePlot::entriesOf(const std::vector<ProfileLine>& lines) const {
    LegendEntries entries;
    for (const ProfileLine line : lines) {
        const bool swatch = line == ProfileLine::spread || line == ProfileLine::field;
        const QPen pen = ProfileLook::pen(line, palette(), isDimmed());
        LegendEntry entry;
        entry.colour = swatch ? ProfileLook::fill(line, palette(), isDimmed()) : pen.color();
        entry.pen = swatch ? Qt::NoPen : pen.style();
        entry.text = ProfileLook::name(line);
        entry.key = static_cast<int>(line);
        entry.shown = visible(line);
        entries.push_back(entry);
    }
    return entries;
}

void ProfilePlot::changeEvent(QEvent* event) {
    ViewPlot::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        keepLegible();
    }
}

QSize ProfilePlot::sizeFor(int plotHeight, int textLines) const {
    constexpr int leastWidth = 200;
    return {leastWidth, plotHeight + textLines * fontMetrics().lineSpacing()};
}

} // namespace sparkout
