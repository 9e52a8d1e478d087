// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QPaintDevice>
#include <QSize>
#include <QString>

#include <memory>

namespace sparkout {

class SvgEngine;

/// Paints SVG 1.1 with clipping, which Qt's QSvgGenerator ignores: a zoomed curve would extend over
/// the whole sheet. Text remains text.
class SvgDevice : public QPaintDevice {
public:
    SvgDevice(QSize size, int dotsPerInch, QString title); ///< size in dots
    ~SvgDevice() override;

    [[nodiscard]] QByteArray document() const; ///< requires that the painter has ended
    [[nodiscard]] QPaintEngine* paintEngine() const override;

protected:
    [[nodiscard]] int metric(PaintDeviceMetric metric) const override;

private:
    QSize m_size;
    int m_dotsPerInch;
    QString m_title;
    std::unique_ptr<SvgEngine> m_engine;
};

} // namespace sparkout
