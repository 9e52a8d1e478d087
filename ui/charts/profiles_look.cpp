// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/profiles_look.h"

#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"

namespace sparkout {

using style::Drawn;

namespace {

Drawn drawnAs(ProfileLine line) {
    switch (line) {
    case ProfileLine::profile:
    case ProfileLine::spread: return Drawn::profile;
    case ProfileLine::blank: return Drawn::blank;
    case ProfileLine::target: return Drawn::target;
    case ProfileLine::gauge: return Drawn::gauge;
    case ProfileLine::leastSquares:
    case ProfileLine::inscribed:
    case ProfileLine::circumscribed:
    case ProfileLine::minimumZone: return Drawn::referenceCircle;
    case ProfileLine::field: break;
    }
    return Drawn::toleranceField;
}

} // namespace

QPen ProfileLook::pen(ProfileLine line, const QPalette& palette, bool dim) {
    const QColor colour = style::dimmed(style::colour(drawnAs(line), palette), dim);
    QPen pen = style::line(drawnAs(line), colour);
    if (line == ProfileLine::spread) { // the edge of its area
        pen.setWidthF(0.8);
    }
    return pen;
}

QColor ProfileLook::fill(ProfileLine line, const QPalette& palette, bool dim) {
    QColor colour = style::dimmed(style::colour(drawnAs(line), palette), dim);
    const bool strong = line == ProfileLine::spread;
    colour.setAlphaF(colour.alphaF() * (strong ? 0.35F : style::isDark(palette) ? 0.22F : 0.16F));
    return colour;
}

QString ProfileLook::name(ProfileLine line) {
    switch (line) {
    case ProfileLine::profile: return tr("profile, along the axis its mean");
    case ProfileLine::spread: return tr("minimum…maximum over the radii");
    case ProfileLine::blank: return tr("blank");
    case ProfileLine::target: return tr("target radius");
    case ProfileLine::leastSquares: return tr("least-squares circle");
    case ProfileLine::minimumZone: return tr("circles of the minimum zone");
    case ProfileLine::inscribed: return tr("maximum inscribed circle");
    case ProfileLine::circumscribed: return tr("minimum circumscribed circle");
    case ProfileLine::field: return tr("tolerance band");
    case ProfileLine::gauge: return tr("gauge");
    }
    return {};
}

} // namespace sparkout
