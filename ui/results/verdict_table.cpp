// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/verdict_table.h"

#include "core/process/profile.h"
#include "core/process/wheel_wave.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/wheel.h"
#include "core/quality/diameter_shares.h"
#include "core/units.h"
#include "ui/chart/quantity_colour.h"
#include "ui/kit/metrics.h"
#include "ui/results/margin_model.h"
#include "ui/text/calibration_text.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QAbstractItemView>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QPainter>
#include <QPixmapCache>
#include <QPolygonF>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

namespace sparkout {

QColor lightColour(Light light, const QPalette& palette) {
    switch (light) {
    case Light::holds: return style::colour(style::Drawn::holds, palette);
    case Light::close:
    case Light::undecided: return style::colour(style::Drawn::close, palette);
    case Light::fails: break;
    }
    return style::colour(style::Drawn::fails, palette);
}

namespace {

void paintLight(QPainter& painter, Light light, const QRectF& box) {
    switch (light) {
    case Light::holds: painter.drawEllipse(box); break;
    case Light::close:
    case Light::undecided:
        painter.drawPolygon(
            QPolygonF({QPointF(box.center().x(), box.top()), box.bottomRight(), box.bottomLeft()}));
        break;
    case Light::fails: painter.drawRect(box.adjusted(1, 1, -1, -1)); break;
    }
}

/// Draws once for each key, into a square of this size.
template <class Draw>
QPixmap keptPixmap(const QString& key, int size, qreal ratio, bool grey, Draw draw) {
    QPixmap pixmap;
    if (!QPixmapCache::find(key, &pixmap)) {
        pixmap = QPixmap(QSize(size, size) * ratio);
        pixmap.setDevicePixelRatio(ratio);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setOpacity(grey ? 0.4 : 1);
        draw(painter);
        painter.end();
        QPixmapCache::insert(key, pixmap);
    }
    return pixmap;
}

} // namespace

QPixmap lightPixmap(Light light, int size, qreal ratio, bool grey) {
    const QColor colour = lightColour(light, QGuiApplication::palette());
    // Qt caches drawings of an icon by the identity of its picture, so a new one for every result
    // would fill the cache.
    const QString key = QStringLiteral("sparkout-light %1 %2 %3 %4 %5")
                            .arg(int(light))
                            .arg(size)
                            .arg(ratio)
                            .arg(grey)
                            .arg(colour.rgb());
    return keptPixmap(key, size, ratio, grey, [&](QPainter& painter) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        paintLight(painter, light, QRectF(1, 1, size - 2, size - 2));
    });
}

QPixmap judgedPixmap(JudgedState state, int size, qreal ratio, bool grey) {
    const bool isDashed = state == JudgedState::nominal || state == JudgedState::batchNotRun;
    if (!isDashed && state != JudgedState::notComputed) {
        const bool isOpen = state == JudgedState::undecided || state == JudgedState::measuredDiffer;
        return lightPixmap(isFailure(state)              ? Light::fails
                           : isOpen                      ? Light::undecided
                           : state == JudgedState::close ? Light::close
                                                         : Light::holds,
                           size, ratio, grey);
    }
    const QPalette palette = QGuiApplication::palette();
    const QColor colour =
        isDashed ? lightColour(Light::holds, palette) : palette.color(QPalette::PlaceholderText);
    const QString key = QStringLiteral("sparkout-ring %1 %2 %3 %4 %5")
                            .arg(isDashed)
                            .arg(size)
                            .arg(ratio)
                            .arg(grey)
                            .arg(colour.rgb());
    return keptPixmap(key, size, ratio, grey, [&](QPainter& painter) {
        QPen pen(colour, isDashed ? 2 : 1);
        if (isDashed) {
            pen.setDashPattern({1.5, 1});
        }
        painter.setPen(pen);
        painter.drawEllipse(QRectF(2, 2, size - 4, size - 4));
    });
}

namespace {

QPixmap lightOnLine(Light light, int size, int line, qreal ratio, bool grey) {
    const QPixmap drawn = lightPixmap(light, size, ratio, grey);
    const QString key =
        QStringLiteral("sparkout-light-on-line %1 %2").arg(drawn.cacheKey()).arg(line);
    QPixmap pixmap;
    if (!QPixmapCache::find(key, &pixmap)) {
        pixmap = QPixmap(QSize(size, std::max(size, line)) * ratio);
        pixmap.setDevicePixelRatio(ratio);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.drawPixmap(QPointF(0, std::max(0, line - size) / 2.0), drawn);
        painter.end();
        QPixmapCache::insert(key, pixmap);
    }
    return pixmap;
}

} // namespace

LightIcons lightIcons(QAbstractItemView& table, bool grey) {
    constexpr int size = metrics::iconSmall;
    const int line = std::max(size, table.fontMetrics().height());
    table.setIconSize({size, line});
    LightIcons icons;
    for (const Light light : {Light::holds, Light::close, Light::undecided, Light::fails}) {
        icons[static_cast<std::size_t>(light)] =
            QIcon(lightOnLine(light, size, line, table.devicePixelRatioF(), grey));
    }
    return icons;
}

namespace {

struct VerdictTable {
    Q_DECLARE_TR_FUNCTIONS(VerdictTable)
};

} // namespace

QString lightName(Light light) {
    switch (light) {
    case Light::holds: return VerdictTable::tr("met");
    case Light::close: return VerdictTable::tr("close to the limit");
    case Light::undecided: return VerdictTable::tr("not decided");
    case Light::fails: return VerdictTable::tr("not met");
    }
    return {};
}

QString lightName(const ConstraintResult& constraint) {
    if (!constraint.isWhole) {
        return VerdictTable::tr("not known: strips uncut");
    }
    return !isLowerBound(constraint) ? lightName(lightOf(constraint))
           : isComputed(constraint)  ? VerdictTable::tr("machine not known")
                                     : VerdictTable::tr("runout of the wheel not known");
}

namespace {

/// A name with what its group does not contain: the stage and the unit.
QString requirementName(const ConstraintResult& c, const QString& name, const QString& where) {
    QStringList parts{name};
    if (c.section < 0 && requirementOf(c.kind).scope != ConstraintScope::part) {
        if (c.stage > 0) {
            parts << where;
        }
        if (*requirementOf(c.kind).unit) {
            parts << unitText(requirementOf(c.kind).unit);
        }
    }
    return parts.join(QStringLiteral(", "));
}

int groupOf(const ConstraintResult& constraint) {
    return constraint.section >= 0 ? constraint.section
                                   : -1 - static_cast<int>(requirementOf(constraint.kind).scope);
}

QString groupName(const ConstraintResult& constraint) {
    if (constraint.section >= 0) {
        return VerdictTable::tr("%1, µm").arg(Names::zoneFull(constraint.zone, constraint.section));
    }
    switch (requirementOf(constraint.kind).scope) {
    case ConstraintScope::part: return VerdictTable::tr("Whole part, µm");
    case ConstraintScope::pass: return VerdictTable::tr("Every pass");
    case ConstraintScope::setting: return VerdictTable::tr("Machine settings");
    case ConstraintScope::section: break;
    }
    return {};
}

std::vector<ValueHead> heads() {
    return {{.text = VerdictTable::tr("Requirement"),
             .tip = VerdictTable::tr(
                 "Requirement of the drawing, the process or the machine on the cycle"),
             .isText = true},
            {.text = VerdictTable::tr("Value"), .tip = VerdictTable::tr("Worst value")},
            {.text = VerdictTable::tr("Limit"), .tip = VerdictTable::tr("Allowed value")},
            {.text = VerdictTable::tr("Margin"),
             .tip = VerdictTable::tr(
                 "Distance of the value from its limit; below 0 the limit is exceeded")}};
}

std::vector<CsvCell> copiedCells(const ConstraintResult& c) {
    return {Names::where(c),
            requirementName(c, Names::constraint(c.kind), Names::where(c)),
            Names::value(c),
            Names::limit(c),
            withoutPlus(Names::margin(c)),
            unitText(requirementOf(c.kind).unit),
            lightName(c)};
}

ValueHead headOf(const ConstraintResult& c, const Project& project) {
    const char* const by = requirementOf(c.kind).measuredBy;
    const QString guess =
        LimitNames::isGuess(c.kind, project)
            ? VerdictTable::tr("Without a measured Ra this is the range of usual wheels.")
            : QString();
    return {.text = QStringLiteral("%1, %2").arg(Names::where(c), Names::constraint(c.kind)),
            .tip = joined({Names::isRange(c.kind) ? rangeText(c) : QString(),
                           by ? requirementText(by) : QString(),
                           EstimateNames::behind(project, c.kind), guess},
                          QStringLiteral("\n"))};
}

/// The name, in words where it needs attention; else the mark is enough. The panel states above it
/// which machine is not known.
ValueCell nameCell(const ConstraintResult& c, const Project& project, const LightIcons& icons) {
    const bool guessed = LimitNames::isGuess(c.kind, project);
    const QString name = requirementName(
        c, guessed ? VerdictTable::tr("Ra, estimate") : Names::constraintBrief(c.kind),
        VerdictTable::tr("stage %1").arg(c.stage));
    const Light light = lightOf(c);
    const bool isPlain = light == Light::holds || isLowerBound(c);
    return {.text = isPlain ? name : name + u'\n' + lightName(c),
            .tip = isLowerBound(c) ? lightName(c) : QString(),
            .said = lightName(c),
            .icon = icons[static_cast<std::size_t>(light)]};
}

} // namespace

std::vector<const ConstraintResult*> verdictRows(const Outcome& outcome) {
    std::vector<const ConstraintResult*> sorted, rows;
    for (const ConstraintResult& c : outcome.constraints) {
        sorted.push_back(&c);
    }
    std::ranges::stable_sort(sorted, {}, [](const ConstraintResult* c) {
        const int group = groupOf(*c);
        return std::pair(group < 0, std::abs(group)); // the zones first
    });
    for (const ConstraintResult* const c : sorted) {
        if (rows.empty() || groupOf(*rows.back()) != groupOf(*c)) {
            rows.push_back(nullptr);
        }
        rows.push_back(c);
    }
    return rows;
}

ValueTable verdictTable(const Outcome* outcome, const LightIcons& icons) {
    ValueTable table{.columns = heads(), .isList = true, .atTop = true};
    table.sheet.header << VerdictTable::tr("Zone or section");
    for (const ValueHead& column : table.columns) {
        table.sheet.header << column.text;
    }
    table.sheet.header << VerdictTable::tr("Unit") << VerdictTable::tr("Verdict");
    if (!outcome) {
        return table;
    }
    const std::vector<const ConstraintResult*> rows = verdictRows(*outcome);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!rows[i]) {
            table.addRow({.isGroup = true}, {{.text = groupName(*rows[i + 1])}, {}, {}, {}});
            continue;
        }
        const ConstraintResult& c = *rows[i];
        table.sheet.rows.push_back(copiedCells(c));
        table.addRow(headOf(c, outcome->result.project),
                     {nameCell(c, outcome->result.project, icons),
                      {.text = Names::value(c)},
                      {.text = Names::limit(c)},
                      {.text = Names::margin(c)}});
    }
    return table;
}

} // namespace sparkout

namespace sparkout::verdict {

namespace {

struct VerdictWhy {
    Q_DECLARE_TR_FUNCTIONS(VerdictWhy)
public:
    static QString diameter(const Outcome& outcome, const ConstraintResult& c);
    static QString form(const Outcome& outcome, const ConstraintResult& c);
    static QString wholePart(const Outcome& outcome);
    static QString waves(const Project& project);
    static QString place(const Outcome& outcome, const ConstraintResult& c);
};

/// The least difference of the ratio from 1 at which it is stated.
constexpr double tellingRatio = 0.05;

QString VerdictWhy::diameter(const Outcome& outcome, const ConstraintResult& c) {
    const bool smallest = c.kind == ConstraintKind::diameterMin;
    const DiameterShares shares =
        diameterShares(outcome.result, static_cast<std::size_t>(c.section),
                       smallest ? DiameterEnd::smallest : DiameterEnd::largest);
    const QString zone = Names::within(Names::zone(c.zone, c.section));
    QString own = tr("%1 against the gauge %2 µm", "zone")
                      .arg(zone, Names::signedMicrometres(shares.section_um));
    if (std::abs(shares.complianceRatio - 1) > tellingRatio) {
        own += tr(" (compliance %1 of the gauged one's)")
                   .arg(QStringLiteral("×") + Names::significant(shares.complianceRatio));
    }
    const QStringList parts{
        tr("gauge at the end %1 µm").arg(Names::signedMicrometres(shares.reading_um)), own,
        tr("spread in the section %1 µm").arg(Names::signedMicrometres(shares.form_um))};
    const QString text =
        tr("%1 in %2, %3 µm from nominal: %4.")
            .arg(Names::constraint(c.kind), zone, Names::signedMicrometres(c.value),
                 parts.join(QStringLiteral("; ")));
    const auto index = static_cast<std::size_t>(c.section);
    if (index >= outcome.result.ifEven.size()) {
        return text;
    }
    const DeviationRange& even = outcome.result.ifEven[index];
    return text
           + tr(" With an even number of lobes: %1 µm.")
                 .arg(Names::signedMicrometres((smallest ? even.least_mm : even.most_mm)
                                               * units::umPerMm));
}

QString VerdictWhy::form(const Outcome& outcome, const ConstraintResult& c) {
    const Project& project = outcome.result.project;
    const double own_um =
        c.kind == ConstraintKind::radialRunout ? addedRunout_um(*project.machine) : 0;
    const double blank_um = initialRunout(*project.part) * units::umPerMm;
    const double left_um = c.value - own_um;
    QString text =
        tr("%1 in %2: the blank has %3 µm, the end of the cycle %4 µm")
            .arg(Names::constraint(c.kind), Names::within(Names::zone(c.zone, c.section)),
                 Names::micrometres(blank_um), Names::micrometres(left_um));
    if (own_um > 0) {
        text += tr("; the machine's own runout adds %1 µm").arg(Names::micrometres(own_um));
    }
    if (own_um > c.limit) {
        return text + tr(", more than the limit: no cycle can meet it.");
    }
    if (!c.knowsMachine) {
        text += tr("; the machine's share is not known");
    } else if (project.machine->form) {
        text += tr(", including the form that the machine prints");
    }
    return c.holds ? text + u'.'
                   : text + tr(". More passes without feed or a smaller last feed reduce it.");
}

QString VerdictWhy::waves(const Project& project) {
    if (!project.wheel->runout) {
        return tr("The runout of the wheel is not given, so the waves it prints are not known.");
    }
    return tr("A wheel with an amplitude of %1 µm prints %2 waves around the part. A work speed at "
              "which the ratio of the speeds is not near to a whole number leaves less of them.")
        .arg(Names::micrometres(wheelAmplitude_mm(project) * units::umPerMm))
        .arg(orderOfWaves(project));
}

/// Compares mean radii with their own mean, and the roundness of the worst section.
QString VerdictWhy::wholePart(const Outcome& outcome) {
    QStringList parts;
    double mean_mm = 0, form_mm = 0;
    const std::vector<SectionAccuracy>& sections = outcome.accuracy.sections;
    for (const SectionAccuracy& section : sections) {
        mean_mm += section.meanRadius_mm / static_cast<double>(sections.size());
        form_mm = std::max(form_mm, section.leastSquares.deviation());
    }
    std::size_t low = 0, high = 0;
    for (std::size_t i = 1; i < sections.size(); ++i) {
        low = sections[i].meanRadius_mm < sections[low].meanRadius_mm ? i : low;
        high = sections[i].meanRadius_mm > sections[high].meanRadius_mm ? i : high;
    }
    for (const std::size_t i : std::set{low, high}) {
        parts << QStringLiteral("%1 %2").arg(
            Names::within(Names::zone(outcome.result.sections[i].zone, static_cast<int>(i))),
            Names::signedMicrometres((sections[i].meanRadius_mm - mean_mm) * units::umPerMm));
    }
    return tr("Mean radii along the part, µm from their own mean: %1; the worst section is %2 µm "
              "out of round.")
        .arg(parts.join(QStringLiteral(", ")), Names::micrometres(form_mm * units::umPerMm));
}

/// The number of the last stage up to this one that feeds, from 1.
int lastFeeding(const Cycle& cycle, int stage) {
    while (stage > 1 && !cycle.stages[static_cast<std::size_t>(stage) - 1].feeds()) {
        --stage;
    }
    return stage;
}

QString VerdictWhy::place(const Outcome& outcome, const ConstraintResult& c) {
    const QString place = Names::place(*c.at, outcome.result.project.operation);
    if (c.kind == ConstraintKind::roughness) {
        return tr("%1: left by the last cut (%2).").arg(Names::constraint(c.kind), place);
    }
    const QString text = tr("%1: worst in %2.").arg(Names::constraint(c.kind), place);
    return c.holds ? text
                   : text
                         + tr(" A smaller feed in stage %1 or a sharper wheel lowers it.")
                               .arg(lastFeeding(*outcome.result.project.cycle, c.at->stage));
}

/// The largest axial feed with an overlap [mm/min]; with an overlap of 1 it leaves no strips.
QString mostAxialFeed(const Project& project, double overlap = 1) {
    return Names::significant(project.wheel->width_mm * project.machine->work_speed_rpm / overlap,
                              4);
}

} // namespace

QString why(const Outcome& outcome, const ConstraintResult& requirement) {
    if (!requirement.isWhole) {
        return VerdictWhy::tr("%1: not known, since strips stay uncut; an axial feed of at most "
                              "%2 mm/min leaves none.")
            .arg(Names::constraint(requirement.kind), mostAxialFeed(outcome.result.project));
    }
    switch (requirement.kind) {
    case ConstraintKind::overlap:
        return VerdictWhy::tr("The wheel's width times the work speed over the axial feed; 1 is "
                              "reached at %1 mm/min.")
            .arg(mostAxialFeed(outcome.result.project));
    case ConstraintKind::leastOverlap:
    case ConstraintKind::leastOverlapLast:
        return VerdictWhy::tr("The wheel's width times the work speed over the axial feed; %1 is "
                              "reached at %2 mm/min.")
            .arg(Names::amount(requirement.kind, requirement.limit, false),
                 mostAxialFeed(outcome.result.project, requirement.limit));
    case ConstraintKind::leastSteps:
        return VerdictWhy::tr("This is the minimum over the stages with stock; a smaller feed or "
                              "more stock in stage %1 increases it.")
            .arg(requirement.stage);
    case ConstraintKind::diameterMin:
    case ConstraintKind::diameterMax: return VerdictWhy::diameter(outcome, requirement);
    case ConstraintKind::radialRunout:
    case ConstraintKind::roundness: return VerdictWhy::form(outcome, requirement);
    case ConstraintKind::waviness: return VerdictWhy::waves(outcome.result.project);
    case ConstraintKind::cylindricity:
    case ConstraintKind::totalRunout: return VerdictWhy::wholePart(outcome);
    default: return requirement.at ? VerdictWhy::place(outcome, requirement) : QString();
    }
}

std::string inputPath(const ConstraintResult& requirement) {
    const Requirement& row = requirementOf(requirement.kind);
    if (requirement.stage > 0 && row.settingOfStage) {
        return "/cycle/stages/" + std::to_string(requirement.stage - 1) + '/' + row.settingOfStage;
    }
    return row.setting ? row.setting : "";
}

const ConstraintResult* worst(const Outcome& outcome) {
    return worstRequirement(outcome.constraints);
}

namespace {

struct VerdictText {
    Q_DECLARE_TR_FUNCTIONS(VerdictText)
};

QString minutes(double time_s) {
    return VerdictText::tr("%1 min").arg(Names::significant(time_s / units::secondsPerMinute));
}

} // namespace

/// In seconds first below two minutes, as grinders count a plunge.
QString time(const SimulationResult& result) {
    const QString seconds = Names::significant(result.time_s, 4);
    return result.time_s < shortTime_s
               ? VerdictText::tr("%1 s (%2)").arg(seconds, minutes(result.time_s))
               : VerdictText::tr("%1 (%2 s)").arg(minutes(result.time_s), seconds);
}

QString status(const SimulationResult& result) {
    if (result.status != RunStatus::cannotReachSize && result.status != RunStatus::tooLong) {
        return Names::status(result.status);
    }
    return VerdictText::tr("%1: the gauge reads %2 mm, %3 µm per side remain")
        .arg(Names::status(result.status), Names::millimetres(result.gaugeReading_mm),
             Names::micrometres(result.remainingStock_mm * units::umPerMm));
}

} // namespace sparkout::verdict
