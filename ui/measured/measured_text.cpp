// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/measured_text.h"

#include "core/project/measured.h"
#include "core/project/project.h"
#include "core/simulation/result.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "words/measured_words.h"

#include <algorithm>
#include <array>
#include <utility>

namespace sparkout {

namespace {

const QString noneStated = QStringLiteral("–");
constexpr qsizetype placesListed = 6; ///< number of places of a quantity listed in a sentence

QString capitalised(QString text) {
    if (!text.isEmpty()) {
        text[0] = text[0].toUpper();
    }
    return text;
}

QString fromTo(double low, double high, MeasuredQuantity quantity) {
    const QString from = MeasuredText::value(low, quantity);
    const QString to = MeasuredText::value(high, quantity);
    return from == to ? from : from + u'…' + to;
}

} // namespace

QString MeasuredText::quantity(MeasuredQuantity quantity) {
    const std::span<const Choice> choices = choicesOf<MeasuredQuantity>();
    return capitalised(choiceText(choices[static_cast<std::size_t>(quantity)].label));
}

QString MeasuredText::trace(TraceQuantity quantity) {
    const std::span<const Choice> choices = choicesOf<TraceQuantity>();
    return capitalised(choiceText(choices[static_cast<std::size_t>(quantity)].label));
}

QString MeasuredText::place(const Project& project, int place) {
    constexpr std::array zones{Zone::rz1, Zone::nz, Zone::rz2};
    if (place < 0) {
        return tr("whole part");
    }
    const auto index = static_cast<std::size_t>(place);
    return project.operation->travels && index < zones.size() ? Names::zone(zones.at(index))
                                                              : Names::zone(Zone::section, place);
}

QString MeasuredText::brief(MeasuredQuantity quantity) {
    switch (quantity) {
    case MeasuredQuantity::diameter_deviation: return tr("Diameter", "brief");
    case MeasuredQuantity::radial_runout: return tr("Runout", "brief");
    case MeasuredQuantity::roundness: return tr("Roundness", "brief");
    case MeasuredQuantity::cylindricity: return tr("Cylindricity", "brief");
    case MeasuredQuantity::roughness_ra: break;
    }
    return QStringLiteral("Ra");
}

QString MeasuredText::name(const Project& project, const MeasuredStatistics& of) {
    return of.place < 0
               ? brief(of.quantity)
               : tr("%1, %2", "quantity, zone").arg(brief(of.quantity), place(project, of.place));
}

QString MeasuredText::column(ColumnQuantity quantity) {
    using enum ColumnQuantity;
    switch (quantity) {
    case part: return tr("Part number");
    case place: return tr("Zone or section");
    case diameter: return tr("Diameter");
    case diameter_deviation: return tr("Diameter deviation");
    case roundness: return tr("Roundness");
    case radial_runout: return tr("Radial runout");
    case cylindricity: return tr("Cylindricity");
    case roughness_ra: return tr("Roughness Ra");
    case when: return tr("When measured");
    case note: return tr("Note");
    case time: return tr("Time of the sample");
    case gauge_size: return tr("Size at the gauge");
    case wheel_power: return tr("Wheel power");
    case spindle_current: return tr("Spindle current");
    case normal_force: return tr("Normal force");
    case ignored:
    case count_: break;
    }
    return tr("Not read");
}

QString MeasuredText::unit(ColumnUnit unit) {
    switch (unit) {
    case ColumnUnit::mm: return unitText("mm");
    case ColumnUnit::um: return unitText("µm");
    case ColumnUnit::s: return unitText("s");
    case ColumnUnit::ms: return tr("ms");
    case ColumnUnit::min: return unitText("min");
    case ColumnUnit::kw: return unitText("kW");
    case ColumnUnit::w: return tr("W");
    case ColumnUnit::n: return unitText("N");
    case ColumnUnit::kn: return tr("kN");
    case ColumnUnit::a: return tr("A");
    case ColumnUnit::unknown: return tr("unknown");
    case ColumnUnit::none: break;
    }
    return noneStated;
}

QString MeasuredText::fault(const CellFault& fault) {
    const QString text = issueText(fault.issue);
    return fault.line == 0 ? text
           : fault.column == 0
               ? tr("Line %1: %2").arg(fault.line).arg(text)
               : tr("Line %1, column %2: %3")
                     .arg(QString::number(fault.line), QString::number(fault.column), text);
}

// --- comparisons --------------------------------------------------------------------------------

QString MeasuredText::value(double value_um, MeasuredQuantity quantity) {
    constexpr int raDecimals = 3;
    return quantity == MeasuredQuantity::diameter_deviation ? Names::signedMicrometres(value_um)
           : quantity == MeasuredQuantity::roughness_ra     ? Names::fixed(value_um, raDecimals)
                                                            : Names::micrometres(value_um);
}

QString MeasuredText::width(double width_um, MeasuredQuantity quantity) {
    return quantity == MeasuredQuantity::roughness_ra ? value(width_um, quantity)
                                                      : Names::micrometres(width_um);
}

QString MeasuredText::mean(const AdequacyRow& row) {
    const MeasuredQuantity of = row.measured.quantity;
    const QString mean = value(row.measured.mean, of);
    return row.mean95 ? QStringLiteral("%1 ± %2").arg(
               mean, width((row.mean95->high - row.mean95->low) / 2, of))
                      : mean;
}

QString MeasuredText::bias(const AdequacyRow& row) {
    if (!row.bias95) {
        return noneStated;
    }
    const MeasuredQuantity of = row.measured.quantity;
    const double middle = (row.bias95->low + row.bias95->high) / 2;
    return QStringLiteral("%1 ± %2 (%3)")
        .arg(of == MeasuredQuantity::roughness_ra ? value(middle, of)
                                                  : Names::signedMicrometres(middle),
             width((row.bias95->high - row.bias95->low) / 2, of), width(row.biasLimit, of));
}

QString MeasuredText::predicted(const Project& project, const AdequacyRow& row) {
    if (!row.predicted) {
        return noneStated;
    }
    const MeasuredQuantity of = row.measured.quantity;
    return knowsMachine(requirementOn(of), project)
               ? fromTo(row.predicted->low, row.predicted->high, of)
               : Names::formAmount(row.predicted->low, false);
}

QString MeasuredText::scatter(const AdequacyRow& row) {
    if (!row.scatter) {
        return noneStated;
    }
    constexpr double most = 999; // a prediction that hardly scatters
    return QStringLiteral("%1 (%2…%3)")
        .arg(row.scatter->ratio > most ? QStringLiteral(">999")
                                       : Names::significant(row.scatter->ratio),
             Names::significant(row.scatter->low, 2), Names::significant(row.scatter->high, 2));
}

QString MeasuredText::share(const AdequacyRow& row) {
    if (!row.share || row.share->count == 0) {
        return noneStated;
    }
    const InsideShare& share = *row.share;
    return tr("%1 of %2 (%3…%4)", "parts inside, all parts, interval")
        .arg(QString::number(share.inside), QString::number(share.count),
             LimitNames::percent(share.interval.low), LimitNames::percent(share.interval.high));
}

QString MeasuredText::verdict(AdequacyVerdict verdict) {
    return QCoreApplication::translate("Measured", textOf(verdict));
}

QString MeasuredText::consequence(const std::vector<AdequacyRow>& rows, AdequacyVerdict verdict) {
    const bool isOfSize = std::ranges::any_of(rows, [verdict](const AdequacyRow& row) {
        return row.verdict == verdict
               && row.measured.quantity == MeasuredQuantity::diameter_deviation;
    });
    switch (verdict) {
    case AdequacyVerdict::adequate: return {};
    case AdequacyVerdict::biased:
        if (!isOfSize) {
            return {};
        }
        return tr("The compliance, the force or the setting of the gauge are not those of the "
                  "machine: calibrate them on these parts before the prediction is used.");
    case AdequacyVerdict::scatterDiffers:
        return tr("The factors of the batch do not scatter as in the shop: enter the measured "
                  "scatter of stock, runout and dullness in the batch.");
    case AdequacyVerdict::biasedAndScatters:
        if (!isOfSize) {
            return {};
        }
        return tr("Calibrate compliance, force or the setting of the gauge first, then compare "
                  "the scatter again.");
    case AdequacyVerdict::tooFewParts: return tr("Measure more parts of the same setting.");
    case AdequacyVerdict::notPredicted: break;
    }
    return tr("These measurements do not test the model.");
}

QString MeasuredText::briefVerdict(AdequacyVerdict verdict) {
    switch (verdict) {
    case AdequacyVerdict::adequate: return tr("agrees");
    case AdequacyVerdict::biased: return tr("biased");
    case AdequacyVerdict::scatterDiffers: return tr("scatter differs");
    case AdequacyVerdict::biasedAndScatters: return tr("biased, scatter differs");
    case AdequacyVerdict::tooFewParts: return tr("too few parts");
    case AdequacyVerdict::notPredicted: break;
    }
    return tr("not predicted");
}

QString MeasuredText::listed(const Project& project, const std::vector<AdequacyRow>& rows,
                             AdequacyVerdict verdict) {
    std::vector<std::pair<MeasuredQuantity, QStringList>> groups;
    for (const AdequacyRow& row : rows) {
        if (row.verdict != verdict) {
            continue;
        }
        const MeasuredQuantity of = row.measured.quantity;
        if (groups.empty() || groups.back().first != of) {
            groups.emplace_back(of, QStringList());
        }
        if (row.measured.place >= 0) {
            groups.back().second << place(project, row.measured.place);
        }
    }
    QStringList texts;
    for (const auto& [quantity, places] : groups) {
        QString within = places.mid(0, placesListed).join(QStringLiteral(", "));
        if (const qsizetype more = places.size() - placesListed; more > 0) {
            within += u' ' + tr("and %n more", nullptr, static_cast<int>(more));
        }
        texts << (within.isEmpty() ? brief(quantity)
                                   : tr("%1 %2", "quantity, zones").arg(brief(quantity), within));
    }
    return texts.join(QStringLiteral("; "));
}

QStringList MeasuredText::judgement(const Project& project, const std::vector<AdequacyRow>& rows) {
    QStringList sentences;
    for (const AdequacyVerdict verdict :
         {AdequacyVerdict::biasedAndScatters, AdequacyVerdict::biased,
          AdequacyVerdict::scatterDiffers, AdequacyVerdict::tooFewParts,
          AdequacyVerdict::notPredicted, AdequacyVerdict::adequate}) {
        const QString of = listed(project, rows, verdict);
        if (of.isEmpty()) {
            continue;
        }
        const QString follows = consequence(rows, verdict);
        const QString what = capitalised(MeasuredText::verdict(verdict));
        sentences
            << (follows.isEmpty()
                    ? tr("%1: %2.", "verdict, of what").arg(what, of)
                    : tr("%1: %2. %3", "verdict, of what, what follows").arg(what, of, follows));
    }
    return sentences << where(rows);
}

QStringList MeasuredText::holdOut(const Project& project, const std::vector<HoldOutRow>& rows) {
    constexpr int digits = 3;
    QStringList sentences;
    for (const HoldOutRow& row : rows) {
        const MeasuredTrace& trace = project.measured->traces[static_cast<std::size_t>(row.trace)];
        const auto range = [](const Interval& interval) {
            return Names::significant(interval.low, digits) + u'…'
                   + Names::significant(interval.high, digits);
        };
        const QString text = row.agrees() ? tr("Not used for the calibration, %1: %2: %3 %4, "
                                               "predicted %5 (%6). The prediction agrees.")
                                          : tr("Not used for the calibration, %1: %2: %3 %4, "
                                               "predicted %5 (%6). The prediction does not agree: "
                                               "the difference is %7 %4.");
        sentences << text.arg(QString::fromStdString(trace.source),
                              QCoreApplication::translate("Measured", wordsOf(row.quantity).text),
                              Names::significant(row.measured, digits),
                              QCoreApplication::translate("Unit", unitOf(row.quantity)),
                              Names::significant(row.predicted, digits), range(row.predicted95));
        if (!row.agrees()) {
            sentences.back() = sentences.back().arg(range(row.difference95));
        }
    }
    return sentences;
}

/// Other causes of a bias than compliance and force.
QStringList MeasuredText::where(const std::vector<AdequacyRow>& rows) {
    const auto isBiased = [&rows](MeasuredQuantity quantity) {
        return std::ranges::any_of(rows, [quantity](const AdequacyRow& row) {
            return row.measured.quantity == quantity
                   && (row.verdict == AdequacyVerdict::biased
                       || row.verdict == AdequacyVerdict::biasedAndScatters);
        });
    };
    QStringList sentences;
    if (isBiased(MeasuredQuantity::roughness_ra)) {
        sentences << tr("Ra is brought into line by its factor: Calibrate from measurements…, "
                        "page “Ra and strengths”.");
    }
    if (isBiased(MeasuredQuantity::radial_runout) || isBiased(MeasuredQuantity::roundness)) {
        sentences << tr("A bias of runout or roundness is the form of the machine, of its centres "
                        "and its headstock, and not its compliance.");
    }
    return sentences;
}

} // namespace sparkout
