// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/feed_text.h"

#include "core/simulation/feed_curves.h"
#include "core/simulation/stroke_step.h"
#include "ui/text/names.h"

#include <QCoreApplication>
#include <QStringList>

namespace sparkout {

namespace {

class FeedText {
    Q_DECLARE_TR_FUNCTIONS(FeedText)
public:
    static QString name(Quantity quantity);
    static QString withUnit(Quantity quantity);
    static QString where(const FeedPoint& p, double time_s, const FeedSeries& series);
    static QString values(const FeedPoint& p, const FeedSeries& series);

private:
    static QString spread(const Spread& s, bool sign);
};

QString FeedText::name(Quantity quantity) {
    switch (quantity) {
    case Quantity::programmed: return tr("programmed feed");
    case Quantity::actual: return tr("actual feed");
    case Quantity::programmedSum: return tr("accumulated programmed feed");
    case Quantity::actualSum: return tr("accumulated actual feed");
    case Quantity::came: return tr("radius before the pass");
    case Quantity::left: return tr("radius after the pass");
    case Quantity::axialFeed: return tr("axial feed");
    case Quantity::force: return tr("normal force");
    }
    return {};
}

QString FeedText::withUnit(Quantity quantity) {
    switch (quantity) {
    case Quantity::axialFeed: return tr("%1, mm/min").arg(name(quantity));
    case Quantity::force: return tr("%1, N").arg(name(quantity));
    default: return tr("%1, µm").arg(name(quantity));
    }
}

QString FeedText::spread(const Spread& s, bool sign) {
    const auto text = [sign](double v) {
        return sign ? Names::signedMicrometres(v) : Names::micrometres(v);
    };
    if (s.max - s.min < 0.005) {
        return text(s.mean);
    }
    return QStringLiteral("%1 (%2…%3)").arg(text(s.mean), text(s.min), text(s.max));
}

QString FeedText::where(const FeedPoint& p, double time_s, const FeedSeries& series) {
    QStringList parts{Names::place(p.place, series.operation)};
    if (p.place.step != Step::none) {
        parts << Names::stepMeaning(p.place.zone, p.place.step);
    }
    if (series.operation->travels && p.place.revolution > 0) {
        parts << tr("pass %1").arg(p.place.revolution);
    }
    if (p.radius >= 0) {
        parts << tr("radius %1").arg(p.radius);
    }
    return parts.join(QStringLiteral(", ")) + QStringLiteral(" — ") + Names::time(time_s, 4);
}

QString FeedText::values(const FeedPoint& p, const FeedSeries& series) {
    QStringList parts;
    parts << tr("feed: programmed %1, actual %2 µm")
                 .arg(spread(p.programmed_um, false), spread(p.actual_um, false));
    parts << tr("accumulated: programmed %1, actual %2 µm")
                 .arg(spread(p.programmedSum_um, false), spread(p.actualSum_um, false));
    parts << tr("radius before %1, after %2 µm")
                 .arg(spread(p.came_um, true), spread(p.left_um, true));
    if (series.operation->axial() && p.axialFeed_mm_min > 0) {
        parts << tr("axial feed %1 mm/min").arg(Names::significant(p.axialFeed_mm_min));
    }
    parts << tr("force %1 N").arg(Names::significant(p.force_n.mean));
    return parts.join(QStringLiteral("; "));
}

} // namespace

QString quantityName(Quantity quantity) {
    return FeedText::name(quantity);
}

QString quantityWithUnit(Quantity quantity) {
    return FeedText::withUnit(quantity);
}

Digits quantityDigits(Quantity quantity) {
    switch (quantity) {
    case Quantity::came:
    case Quantity::left: return Digits::signedHundredths;
    case Quantity::axialFeed:
    case Quantity::force: return Digits::significant;
    default: return Digits::hundredths;
    }
}

QString feedText(const FeedPoints& points, double time_s, const FeedSeries& series,
                 bool wholeStrokes) {
    const FeedPoint* const at = feedPointAt(points, time_s);
    return at ? FeedText::where(*at, wholeStrokes ? at->end_s : time_s, series) + u'\n'
                    + FeedText::values(*at, series)
              : QString();
}

QString strokeStepName(StrokeStep step) {
    QStringList codes;
    QString meaning;
    for (const Zone zone : {Zone::rz1, Zone::nz, Zone::rz2}) {
        const Step of = stepOf(zone, step);
        if (of != Step::none) {
            codes << Names::step(of);
            meaning = Names::stepMeaning(zone, of);
        }
    }
    return codes.isEmpty() ? QString() : QStringLiteral("%1 %2").arg(codes.join(u'/'), meaning);
}

} // namespace sparkout
