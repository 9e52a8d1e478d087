// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/legend_drawing.h"

#include <QByteArray>
#include <QImage>
#include <QStringList>

#include <functional>

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

/// Makes the bytes of a file, which may take a second; in any thread. Empty: they could not be
/// made.
using PictureWork = std::function<QByteArray()>;

/// The drawing is taken down at once; the plot may change afterwards.
[[nodiscard]] PictureWork pngWork(const PlotPicture& picture, int scale);
[[nodiscard]] PictureWork svgWork(const PlotPicture& picture);
[[nodiscard]] PictureWork pdfWork(const PlotPicture& picture); ///< vectors, fonts embedded

} // namespace sparkout
