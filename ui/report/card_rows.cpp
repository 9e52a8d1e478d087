// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/card_rows.h"

#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/units.h"
#include "ui/report/cell_text.h"
#include "ui/report/operation_setup.h"
#include "ui/text/example_texts.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace sparkout::report {

namespace {

// The form requires minutes, also for a cycle of seconds: hundredths distinguish one of 9 s from
// one of 12 s.
constexpr int minuteDecimals = 2;
constexpr double hundredths = 100;

const Project& projectOf(std::size_t surface, const Setup& setup, const SetupRun& run) {
    return surface < run.surfaces.size() ? run.surfaces[surface].result.project
                                         : setup.surfaces[surface].project;
}

bool isBore(const Project& project) {
    return project.part->surface == Surface::internal;
}

QString wheelSize(const Wheel& wheel) {
    return printedNumber(wheel.diameter_mm, 5) + u'×' + printedNumber(wheel.width_mm);
}

} // namespace

QString CardRows::operation(const Setup& setup) {
    QStringList names;
    for (const GroundSurface& surface : setup.surfaces) {
        names << OperationSetup::operation(surface.project);
    }
    names.removeDuplicates();
    return names.size() == 1 ? names.front() : tr("Cylindrical grinding, several surfaces");
}

QString CardRows::surfaceName(const Setup& setup, std::size_t surface) {
    const QString name = manyLines(exampleTitle(setup.surfaces.at(surface).name)).simplified();
    const QString number = QString::number(surface + 1);
    return name.isEmpty() || name == number ? number : tr("%1 (%2)").arg(number, name);
}

QStringList CardRows::tolerances(const Part& part) {
    QStringList all;
    const auto add = [&all](const QString& name, const std::optional<double>& value_um) {
        if (value_um) {
            all << name + QChar(0xa0) + printedNumber(*value_um / units::umPerMm, 6);
        }
    };
    const Tolerance& of = part.tolerance;
    add(tr("radial runout"), of.radial_runout_um);
    add(tr("total runout"), of.total_runout_um);
    add(tr("roundness"), of.roundness_um);
    add(tr("cylindricity"), of.cylindricity_um);
    if (of.roughness_ra_um) { // in micrometres by its standard, without a unit
        all << QStringLiteral("Ra\u00a0") + printedNumber(*of.roughness_ra_um);
    }
    return all;
}

QString CardRows::minutes(double value_min) {
    return Names::fixed(value_min, minuteDecimals);
}

QStringList CardRows::minutesAddingUp(const std::vector<double>& values_min) {
    QStringList all;
    double sum = 0, printed = 0;
    for (const double value : values_min) {
        sum += value;
        const double upTo = std::round(sum * hundredths) / hundredths;
        all << minutes(upTo - printed);
        printed = upTo;
    }
    return all;
}

QString CardRows::fixture(const Setup& setup) {
    const Part& part = *setup.surfaces.front().project.part;
    QStringList all;
    if (isBore(setup.surfaces.front().project) || part.shaft.mounting == Mounting::chuck) {
        all << tr("Chuck");
    } else {
        all << tr("Centres") << tr("driving carrier");
    }
    if (const auto rests = part.shaft.steady_rests.size(); rests > 0) {
        all << tr("steady rests: %1").arg(rests);
    }
    return all.join(QStringLiteral("; "));
}

QString CardRows::grind(const CardLine& line, const Setup& setup, const Project& project) {
    const Part& part = *project.part;
    const QString name = surfaceName(setup, *line.surface);
    const bool travels = project.operation->travels;
    QString text = isBore(project) ? (travels ? tr("Grind bore %1 by traverse grinding to %2")
                                              : tr("Grind bore %1 by plunge grinding to %2"))
                                   : (travels ? tr("Grind surface %1 by traverse grinding to %2")
                                              : tr("Grind surface %1 by plunge grinding to %2"));
    text = text.arg(name, drawnSize(part))
           + tr(" over a length of %1").arg(printedNumber(part.length_mm, 6));
    const QStringList limits = tolerances(part);
    if (!limits.isEmpty()) {
        text += tr(", holding: %1").arg(limits.join(QStringLiteral("; ")));
    }
    if (!part.gaps.empty()) {
        text += tr("; gaps of the surface: %1").arg(part.gaps.size());
    }
    return text
           + tr(". Stock per side %1; wheel speed %2 m/s")
                 .arg(printedNumber(part.stock_mm),
                      printedNumber(project.machine->wheel_speed_m_s));
}

QString CardRows::tooling(const Project& project) {
    const QString marking = oneLine(project.wheel->marking);
    const auto read = readWheelMarking(project.wheel->marking);
    const bool saysSize = read && read->diameter_mm && read->width_mm;
    const QString size = wheelSize(*project.wheel);
    QStringList all{marking.isEmpty() ? tr("Wheel %1").arg(size)
                    : saysSize        ? tr("Wheel %1").arg(marking)
                                      : tr("Wheel %1, %2").arg(size, marking)};
    if (project.gauge->control == Control::gauge) {
        all << tr("in-process gauge");
    }
    return all.join(QStringLiteral("; "));
}

QString CardRows::settings(const CardLine& line, const SetupRun& run, const Project& project) {
    const Machine& machine = *project.machine;
    QStringList all;
    const auto seconds = [](double value) { return printedNumber(value); };
    if (project.operation->travels) {
        all << tr("overrun at the entry %1, at the exit %2 mm")
                   .arg(printedNumber(machine.overrun_entry_mm),
                        printedNumber(machine.overrun_exit_mm))
            << tr("dwell at the entry %1, at the exit %2 s")
                   .arg(seconds(machine.dwell_entry_s), seconds(machine.dwell_exit_s))
            << tr("plunge-in at a reversal %1 mm/min")
                   .arg(printedNumber(machine.plunge_feed_mm_min));
    }
    if (line.commands_mm.empty()) {
        all << tr("stages end by the position of the wheel head");
    } else {
        QStringList commands;
        for (const double command : line.commands_mm) {
            commands << printedNumber(std::round(command * 1e6) / 1e6);
        }
        all << tr("gauge commands at a stock per side of %1 mm")
                   .arg(commands.join(QStringLiteral("; ")));
    }
    QString text = all.join(QStringLiteral("; "));
    text.front() = text.front().toUpper();
    if (*line.surface >= run.surfaces.size()) {
        text += QStringLiteral(". ") + tr("This cycle was not run.");
    } else if (const auto status = run.surfaces[*line.surface].result.status;
               status != RunStatus::completed) {
        text += QStringLiteral(". ") + Names::status(status) + u'.';
    }
    return text;
}

QString CardRows::regime(const CardRegime& regime) {
    const QString stage = tr("Stage %1: ").arg(regime.stage);
    const QString steps = regime.countsStrokes ? tr("i in double strokes") : tr("i in revolutions");
    if (!regime.feeds) {
        return stage
               + (regime.untilSize ? tr("spark-out until size, %1").arg(steps)
                                   : tr("spark-out, %1").arg(steps));
    }
    QString feed =
        regime.countsStrokes ? tr("S radial, mm per double stroke") : tr("S radial, mm/min");
    if (regime.radialFeed < 0) {
        feed = tr("retraction, mm/min");
    }
    if (regime.axialFeed_mm_min) {
        feed += tr(" / axial, mm/min");
    }
    if (regime.continuousFeed_mm_min > 0) {
        feed += tr("; continuous %1 mm/min").arg(printedNumber(regime.continuousFeed_mm_min));
    }
    return stage + feed;
}

QStringList CardRows::cells(const CardRegime& regime) {
    QString feed = regime.feeds ? printedNumber(regime.radialFeed) : QStringLiteral("0");
    if (regime.axialFeed_mm_min) {
        feed += QStringLiteral(" / ") + printedNumber(*regime.axialFeed_mm_min);
    }
    return {QStringLiteral("1"),
            printedNumber(regime.diameter_mm, 6),
            printedNumber(regime.length_mm, 6),
            printedNumber(regime.stock_mm),
            QString::number(regime.steps),
            feed,
            printedNumber(regime.workSpeed_rpm, 5),
            Names::significant(regime.workSpeed_m_min)};
}

QString CardRows::measuring(const Project& project) {
    const MeasuringKind kind = measuringKind(*project.part);
    QStringList all{kind.isBore ? tr("Bore comparator") : tr("Indicating calliper")};
    if (kind.hasRunout) {
        all << tr("dial indicator with stand");
    }
    if (kind.hasForm) {
        all << tr("roundness tester");
    }
    if (kind.hasRoughness) {
        all << tr("roughness tester");
    }
    return all.join(QStringLiteral("; "));
}

/// Tolerances common to all surfaces are listed once, after them.
QString CardRows::control(const CardLine& line, const Setup& setup) {
    const auto limitsOf = [&setup](std::size_t surface) {
        return tolerances(*setup.surfaces[surface].project.part).join(QStringLiteral("; "));
    };
    const auto sizeOf = [&setup](std::size_t surface) {
        return drawnSize(*setup.surfaces[surface].project.part);
    };
    const auto with = [](const QString& text, const QString& limits) {
        return limits.isEmpty() ? text : text + QStringLiteral("; ") + limits;
    };
    const std::size_t first = line.measured.front();
    const QString common = limitsOf(first);
    if (line.measured.size() == 1) {
        return with(tr("Check surface %1: %2").arg(surfaceName(setup, first), sizeOf(first)),
                    common);
    }
    const bool isCommon = std::ranges::all_of(
        line.measured, [&](std::size_t surface) { return limitsOf(surface) == common; });
    QStringList each;
    for (const std::size_t surface : line.measured) {
        const QString size =
            tr("%1: %2", "surface, its size").arg(surfaceName(setup, surface), sizeOf(surface));
        each << (isCommon ? size : with(size, limitsOf(surface)));
    }
    const QString all = tr("Check surfaces %1").arg(each.join(QStringLiteral("; ")));
    return isCommon && !common.isEmpty()
               ? tr("%1; each: %2", "surfaces, tolerances").arg(all, common)
               : all;
}

QString CardRows::text(const CardLine& line, const Setup& setup, const SetupRun& run) {
    const Project& project = projectOf(line.surface.value_or(0), setup, run);
    switch (line.entry) {
    case CardEntry::install:
        return isBore(project) || project.part->shaft.mounting == Mounting::chuck
                   ? tr("Load the part and clamp it in the chuck")
                   : tr("Load the part between centres and clamp it");
    case CardEntry::fixture: return fixture(setup);
    case CardEntry::grind: return grind(line, setup, project);
    case CardEntry::tooling: return tooling(project);
    case CardEntry::settings: return settings(line, run, project);
    case CardEntry::regime: return regime(*line.regime);
    case CardEntry::dress: {
        const QString dressing = oneLine(project.wheel->dressing);
        return dressing.isEmpty()
                   ? tr("Dress the wheel as its dullness requires")
                   : tr("Dress the wheel as its dullness requires: %1").arg(dressing);
    }
    case CardEntry::control: return control(line, setup);
    case CardEntry::measuring: return measuring(project);
    case CardEntry::remove: break;
    }
    return tr("Take the part off");
}

std::vector<CardRow> CardRows::of(const OperationCard& card, const Setup& setup,
                                  const SetupRun& run) {
    std::vector<double> times;
    for (const CardLine& line : card.lines) {
        times.push_back(line.main_min.value_or(0));
    }
    const QStringList printed = minutesAddingUp(times);
    std::vector<CardRow> rows;
    for (std::size_t i = 0; i < card.lines.size(); ++i) {
        const CardLine& line = card.lines[i];
        const CardSymbol symbol = symbolOf(line.entry);
        CardRow row;
        row.text = text(line, setup, run);
        if (symbol == CardSymbol::transition) {
            row.symbol = tr("O", "service symbol of a transition");
            row.text = QStringLiteral("%1. ").arg(line.transition) + row.text;
        } else if (symbol == CardSymbol::tooling) {
            row.symbol = tr("T", "service symbol of tooling");
        } else if (symbol == CardSymbol::regime) {
            row.symbol = tr("R", "service symbol of regimes");
            row.cells = cells(*line.regime);
        }
        const bool lastRegime =
            i + 1 < card.lines.size() && card.lines[i + 1].entry == CardEntry::regime
            && (i + 2 == card.lines.size() || card.lines[i + 2].entry != CardEntry::regime);
        row.keeps = line.entry == CardEntry::install || line.entry == CardEntry::grind
                    || line.entry == CardEntry::tooling || line.entry == CardEntry::settings
                    || line.entry == CardEntry::control || lastRegime
                    || (i + 2 == card.lines.size()); // no unloading on a sheet of its own
        row.main = line.main_min ? printed[static_cast<qsizetype>(i)] : QString();
        row.auxiliary = line.auxiliary_min && *line.auxiliary_min > 0 ? minutes(*line.auxiliary_min)
                                                                      : QString();
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace sparkout::report
