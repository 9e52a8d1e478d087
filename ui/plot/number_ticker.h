// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/text/number_text.h"

#include <qcustomplot.h>

namespace sparkout {

/// The numbers of an axis with a typographic minus; very small and large ones with a power of ten.
class NumberTicker : public QCPAxisTicker {
protected:
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
        const QString label =
            withPower(QCPAxisTicker::getTickLabel(tick, locale, format, precision));
        return label.startsWith(u'-') ? u'−' + label.mid(1) : label;
    }
};

/// Only whole numbers, for counts.
class WholeTicker : public QCPAxisTickerFixed {
public:
    WholeTicker() {
        setTickStep(1);
        setScaleStrategy(ssMultiples);
    }
};

} // namespace sparkout
