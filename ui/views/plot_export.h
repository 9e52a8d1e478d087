// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/legend_drawing.h"

#include <QByteArray>
#include <QImage>
#include <QStringList>

class QCustomPlot;

/// A plot as a picture of its own: title lines, legend and the plot as it is on the screen, on the
/// plot's background. The caller puts the plot into the look it wants first.
namespace sparkout {

struct PlotPicture {
    QCustomPlot* plot = nullptr;
    QStringList heading;  ///< the first line is the title
    LegendEntries legend; ///< hidden entries are left out
};

inline constexpr int largestPictureScale = 4;

/// Size at scale 1, in pixels of the plot's screen.
[[nodiscard]] QSize pictureSize(const PlotPicture& picture);

/// `scale` 1…4; the resolution is noted in the image, so that its size on paper stays the same.
[[nodiscard]] QImage pictureImage(const PlotPicture& picture, int scale);

/// The bytes of a file; empty when they could not be made.
[[nodiscard]] QByteArray picturePng(const PlotPicture& picture, int scale);
[[nodiscard]] QByteArray pictureSvg(const PlotPicture& picture);
[[nodiscard]] QByteArray picturePdf(const PlotPicture& picture); ///< vectors, fonts embedded

} // namespace sparkout
