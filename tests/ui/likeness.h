// SPDX-License-Identifier: GPL-3.0-or-later
// Two pictures of one thing, drawn in two ways.
#pragma once

#include <QHash>
#include <QImage>

#include <algorithm>
#include <cmath>

/// How far two pictures look alike; texts and fine lines matter little.
struct Likeness {
    double differing = 0;  ///< share of pixels whose colour is another
    int colours = 0;       ///< of the first picture
    double worstShare = 0; ///< of the painted one's main colours, by how much it is another share
};

inline Likeness compare(const QImage& drawn, const QImage& model) {
    const auto near = [](QRgb a, QRgb b) {
        return std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)),
                         std::abs(qBlue(a) - qBlue(b))})
               <= 24;
    };
    Likeness likeness;
    QHash<QRgb, int> drawnColours, modelColours;
    const int all = model.width() * model.height();
    for (int y = 0; y < model.height(); ++y) {
        for (int x = 0; x < model.width(); ++x) {
            const QRgb a = drawn.pixel(x, y), b = model.pixel(x, y);
            likeness.differing += near(a, b) ? 0 : 1.0 / all;
            ++drawnColours[a];
            ++modelColours[b];
        }
    }
    likeness.colours = static_cast<int>(drawnColours.size());
    for (const auto [colour, count] : modelColours.asKeyValueRange()) {
        if (count < all / 50) {
            continue;
        }
        const auto alike = [&](const QHash<QRgb, int>& colours) {
            int sum = 0;
            for (const auto [other, times] : colours.asKeyValueRange()) {
                sum += near(other, colour) ? times : 0;
            }
            return double(sum) / all;
        };
        likeness.worstShare =
            std::max(likeness.worstShare, std::abs(alike(drawnColours) - alike(modelColours)));
    }
    return likeness;
}

inline bool saysAlike(const Likeness& likeness) {
    if (likeness.differing < 0.06 && likeness.colours > 20 && likeness.worstShare < 0.04) {
        return true;
    }
    qWarning("%.4f of the pixels differ, %d colours, shares by %.4f", likeness.differing,
             likeness.colours, likeness.worstShare);
    return false;
}
