// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/legend_drawing.h"

#include <QByteArray>
#include <QImage>
#include <QStringList>

#include <functional>

class QCustomPlot;

/// Exports a plot as a picture: title lines, legend and the plot as on the screen, on the plot's
/// background. The caller sets the look of the plot first.
namespace sparkout {

struct PlotPicture {
    QCustomPlot* plot = nullptr;
    QStringList heading;  ///< the first line is the title
    LegendEntries legend; ///< without hidden entries
};

inline constexpr int largestPictureScale = 4;

/// Size at scale 1, in pixels of the plot's screen.
[[nodiscard]] QSize pictureSize(const PlotPicture& picture);

/// `scale` 1…4; the resolution is stored in the image, so that its size on paper is constant.
[[nodiscard]] QImage pictureImage(const PlotPicture& picture, int scale);

/// Makes the bytes of a file, on any thread; may take a second. Empty on failure.
using PictureWork = std::function<QByteArray()>;

/// The drawing is recorded at once; the plot may change afterwards.
[[nodiscard]] PictureWork pngWork(const PlotPicture& picture, int scale);
[[nodiscard]] PictureWork svgWork(const PlotPicture& picture);
[[nodiscard]] PictureWork pdfWork(const PlotPicture& picture); ///< vectors, fonts embedded

} // namespace sparkout
