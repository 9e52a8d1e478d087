// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/stock_layers.h"
#include "ui/plot/legend_drawing.h"
#include "ui/plot/painted_layer.h"

#include <QCoreApplication>
#include <QPalette>
#include <QString>

namespace sparkout {

/// Colours and words that the stacked layers and their surface share.
class LayersLook {
    Q_DECLARE_TR_FUNCTIONS(LayersLook)
public:
    [[nodiscard]] static QColor stage(int stage, const QPalette& palette); ///< counted from 1
    /// The colour of a layer, lighter for every other one, so that neighbours differ.
    [[nodiscard]] static QColor layer(const LayerSeries& series, std::size_t span,
                                      const QPalette& palette);
    /// The zones or sections along the length, by rising length.
    [[nodiscard]] static std::vector<Band> zoneBands(const LayerSeries& series,
                                                     const QPalette& palette);
    [[nodiscard]] static QColor uncut(const QPalette& palette); ///< stock still to be removed
    /// A swatch for each stage; the key is its number.
    [[nodiscard]] static LegendEntries stages(const LayerSeries& series, const CurveChoice& choice,
                                              const QPalette& palette);
    /// "Double strokes 3…5, stage 1".
    [[nodiscard]] static QString spanName(const LayerSeries& series, std::size_t span);
    /// The layer of a zone or section in words and numbers.
    [[nodiscard]] static QString values(const LayerSeries& series, const LayersDone& done,
                                        std::size_t column, std::size_t span);
};

} // namespace sparkout
