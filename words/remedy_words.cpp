// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/remedy_words.h"

#include "core/digits.h"
#include "core/phases/sampled_phases.h"
#include "core/project/cycle.h"
#include "core/project/member.h"
#include "core/project/validate.h"
#include "core/text.h"
#include "core/units.h"

#include <cmath>
#include <cstdlib>

namespace sparkout {

namespace {

const Field& rowOf(const Project& project, const RemedySetting& setting) {
    return *findMember(project, setting.rowPath(project)).field;
}

double rounded(double value, int digits) {
    if (value == 0) {
        return 0;
    }
    const double scale = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}

/// Why a setting with which all requirements are met is not offered.
const char* notOffered(bool room, RemedyConflict::Kind kind) {
    if (kind == RemedyConflict::Kind::warned) {
        return room ? SPARKOUT_NOOP(
                   "Remedy", "Among the values tried, no single setting gives a sufficient margin: "
                             "with {change}, "
                             "nothing is close to its limit, but the change brings a warning.")
                    : SPARKOUT_NOOP(
                        "Remedy", "Among the values tried, no single setting helps: with {change}, "
                                  "all requirements are met, but the change brings a warning.");
    }
    return room ? SPARKOUT_NOOP(
               "Remedy", "Among the values tried, no single setting gives a sufficient margin: "
                         "with {change}, "
                         "nothing is close to its limit, but one more stage ends without a step.")
                : SPARKOUT_NOOP(
                    "Remedy", "Among the values tried, no single setting helps: with {change}, all "
                              "requirements are met, but one more stage ends without a step.");
}

/// The result of the next value towards the current one; null if it is not known, or if an
/// additional stage helps with the current feed.
const char* nearerValue(bool room, const Remedy& remedy) {
    const RemedySetting& setting = remedy.setting;
    if (!remedy.failing) {
        return nullptr;
    }
    if (*remedy.failing != setting.before) {
        return SPARKOUT_NOOP("Remedy", "{value}, one step nearer to the current {before}, is not "
                                       "enough.");
    }
    if (setting.kind == RemedyKind::addFeed) {
        return SPARKOUT_NOOP("Remedy", "With the current feed the added stage does not help.");
    }
    if (setting.kind == RemedyKind::addSparkOut) {
        return room ? SPARKOUT_NOOP("Remedy", "Without this stage the margin is too small.")
                    : SPARKOUT_NOOP("Remedy", "Without this stage the cycle is unfit.");
    }
    return room ? SPARKOUT_NOOP("Remedy", "With the current value the margin is too small.")
                : SPARKOUT_NOOP("Remedy", "The current value is not enough.");
}

/// The text for a good value with too few good neighbours.
const char* tooFewValues(bool room) {
    return room ? SPARKOUT_NOOP(
               "Remedy",
               "Among the values tried, no single setting gives a sufficient margin: with {change} "
               "the margin is sufficient, but not with the values next to it.")
                : SPARKOUT_NOOP("Remedy", "Among the values tried, no single setting helps: with "
                                          "{change} all requirements are met, but not with the "
                                          "values next to it.");
}

/// The text for a setting that helps for every stock, but not for the batch.
const char* wherePartsAreBad(const RemedyConflict& conflict) {
    return conflict.second
               ? SPARKOUT_NOOP("Remedy",
                               "Among the values tried, no single setting helps: with {change} all "
                               "requirements are met for every stock, but too many parts of the "
                               "batch are rejected: “{second}” is not met.")
               : SPARKOUT_NOOP("Remedy", "Among the values tried, no single setting helps: with "
                                         "{change} all requirements are met for every stock, but "
                                         "the cycle does not end by itself for too many parts of "
                                         "the batch.");
}

/// The directions in which two requirements would change a setting.
const char* asksFor(const RemedyConflict& conflict) {
    const RemedySetting& setting = *conflict.setting;
    if (setting.addsStage()) {
        return SPARKOUT_NOOP("Remedy", "No single setting helps. “{first}” asks for one more stage "
                                       "({change}), “{second}” for none.");
    }
    return conflict.value < setting.before
               ? SPARKOUT_NOOP("Remedy", "No single setting helps. “{first}” asks for less "
                                         "({change}), “{second}” for more.")
               : SPARKOUT_NOOP("Remedy", "No single setting helps. “{first}” asks for more "
                                         "({change}), “{second}” for less.");
}

/// The text for a setting that helps for the stated stock alone.
const char* whereAnotherStockFails(bool room, const RemedyConflict& conflict) {
    if (!conflict.second) {
        return room ? SPARKOUT_NOOP(
                   "Remedy",
                   "Among the values tried, no single setting gives a sufficient margin: with "
                   "{change}, nothing is close to its limit for the stated stock, "
                   "but with a stock of {stock} mm the cycle does not end by "
                   "itself.")
                    : SPARKOUT_NOOP("Remedy",
                                    "Among the values tried, no single setting helps: with "
                                    "{change}, the cycle is fit for the stated stock, but with a "
                                    "stock of {stock} mm the cycle does not end by itself.");
    }
    return room ? SPARKOUT_NOOP(
               "Remedy",
               "Among the values tried, no single setting gives a sufficient margin: with "
               "{change}, nothing is close to its limit for the stated stock, but "
               "with a stock of {stock} mm “{second}” is not met.")
                : SPARKOUT_NOOP("Remedy", "Among the values tried, no single setting helps: with "
                                          "{change}, the cycle is fit for the stated stock, but "
                                          "with a stock of {stock} mm “{second}” is not met.");
}

/// The text if nothing helps the first requirement.
const char* whereNothingMends(bool room, const RemedyConflict& conflict) {
    if (!conflict.first) {
        return SPARKOUT_NOOP(
            "Remedy", "Among the values tried, no single setting lets the cycle end by itself.");
    }
    if (!conflict.setting) {
        return room ? SPARKOUT_NOOP(
                   "Remedy",
                   "Among the values tried, no single setting gives “{first}” a larger margin.")
                    : SPARKOUT_NOOP("Remedy", "Among the values tried, no single setting meets "
                                              "“{first}” or brings it closer to its limit.");
    }
    if (!conflict.second) {
        return room ? SPARKOUT_NOOP("Remedy",
                                    "Among the values tried, no single setting gives “{first}” a "
                                    "sufficient margin: it is largest with {change}.")
                    : SPARKOUT_NOOP("Remedy",
                                    "Among the values tried, no single setting meets “{first}”: it "
                                    "comes closest to its limit with {change}.");
    }
    return room ? SPARKOUT_NOOP(
               "Remedy",
               "Among the values tried, no single setting gives “{first}” a sufficient margin: it "
               "is largest with {change}, where that of “{second}” is too small.")
                : SPARKOUT_NOOP(
                    "Remedy", "Among the values tried, no single setting meets “{first}”: it comes "
                              "closest to its limit with {change}, where “{second}” is not met.");
}

/// The text if something helps the first requirement.
const char* whereTheFirstIsMended(bool room, const RemedyConflict& conflict) {
    return !conflict.first ? SPARKOUT_NOOP(
               "Remedy", "Among the values tried, no single setting helps: with {change}, the "
                         "cycle ends by itself, but “{second}” is not met.")
           : room ? SPARKOUT_NOOP(
                 "Remedy",
                 "Among the values tried, no single setting gives a sufficient margin: with "
                 "{change}, that of “{first}” is sufficient, but that of “{second}” is not.")
           : conflict.kind == RemedyConflict::Kind::opposed
               ? asksFor(conflict)
               : SPARKOUT_NOOP("Remedy",
                               "Among the values tried, no single setting meets all requirements: "
                               "with {change}, “{first}” is met, but “{second}” is still not met.");
}

} // namespace

std::string RemedyWording::number(double value) const {
    return plainNumber(value);
}

std::string RemedyWording::input(const char* label, const char* symbol) const {
    return std::string(label) + ' ' + symbol;
}

std::string RemedyWording::requirement(ConstraintKind kind) const {
    return requirementOf(kind).label;
}

/// The values for the placeholders of a text, which is translated first.
std::string RemedyWording::filled(const char* text, TextPlaces places) const {
    return placedText(translated(text), places);
}

std::string RemedyWording::inUnit(const Project& project, const RemedySetting& setting,
                                  const std::string& values) const {
    if (setting.isCount()) {
        return values;
    }
    const bool isStep =
        setting.kind == RemedyKind::radialFeed || setting.kind == RemedyKind::addFeed;
    const char* const of = isStep && project.operation->travels ? "mm" // what S_t is one of
                                                                : rowOf(project, setting).unit;
    return values + ' ' + unit(of);
}

std::string RemedyWording::valueText(const Project& project, const RemedySetting& setting,
                                     double value) const {
    return inUnit(project, setting, number(value));
}

std::string RemedyWording::intervalText(const Project& project, const Remedy& remedy) const {
    return inUnit(project, remedy.setting,
                  number(remedy.interval.low) + "…" + number(remedy.interval.high));
}

std::string RemedyWording::withValue(const Project& project, const RemedySetting& setting,
                                     double value, const std::string& is) const {
    const Field& row = rowOf(project, setting);
    const std::string stage = number(static_cast<double>(setting.stage) + 1);
    const bool strokes = project.operation->travels;
    switch (setting.kind) {
    case RemedyKind::radialFeed:
    case RemedyKind::axialFeed:
        return filled(SPARKOUT_NOOP("Remedy", "{feed} of stage {stage} {is}"),
                      {{"feed", row.symbol}, {"stage", stage}, {"is", is}});
    case RemedyKind::stock: {
        const Project changed = setting.applied(project, value);
        const Stage& giver = changed.cycle->stages[setting.other];
        return filled(
            SPARKOUT_NOOP("Remedy", "Stock per side of stage {stage} {is} (stage {other}: {rest})"),
            {{"stage", stage},
             {"is", is},
             {"other", number(static_cast<double>(setting.other) + 1)},
             {"rest", valueText(project, setting, giver.stock_mm)}});
    }
    case RemedyKind::sparkOut:
        return filled(strokes ? SPARKOUT_NOOP("Remedy", "Double strokes of spark-out {is}")
                              : SPARKOUT_NOOP("Remedy", "Revolutions of spark-out {is}"),
                      {{"is", is}});
    case RemedyKind::addFeed: {
        const Project changed = setting.applied(project, value);
        const Stage& added = changed.cycle->stages[setting.stage + 1];
        return filled(SPARKOUT_NOOP("Remedy", "One more stage after stage {stage}: {feed} {is}, "
                                              "stock per side {stock}"),
                      {{"stage", stage},
                       {"feed", row.symbol},
                       {"is", is},
                       {"stock", number(added.stock_mm) + ' ' + unit("mm")}});
    }
    case RemedyKind::addSparkOut:
        return filled(
            strokes ? SPARKOUT_NOOP("Remedy", "Spark-out as one more stage: double strokes {is}")
                    : SPARKOUT_NOOP("Remedy", "Spark-out as one more stage: revolutions {is}"),
            {{"is", is}});
    case RemedyKind::stockWithFeed: {
        RemedySetting stock = setting;
        stock.kind = RemedyKind::stock;
        const StageFeed& feed = project.operation->radial();
        const Field& feedRow = *tableOf<Stage>().find(feed.key);
        const char* const feedUnit = !project.operation->travels ? feedRow.unit : "mm";
        return filled(SPARKOUT_NOOP("Remedy", "{change}, with {feed} of stage 1 = {value}"),
                      {{"change", withValue(project, stock, value, is)},
                       {"feed", feedRow.symbol},
                       {"value", number(setting.feed) + ' ' + unit(feedUnit)}});
    }
    case RemedyKind::startingCycle: return translated(SPARKOUT_NOOP("Remedy", "Starting cycle"));
    case RemedyKind::dwellEntry:
    case RemedyKind::dwellExit:
    case RemedyKind::workSpeed:
    case RemedyKind::plungeFeed:
    case RemedyKind::targetDiameter: break;
    }
    return input(row.label, row.symbol) + ' ' + is;
}

std::string RemedyWording::equal(const Project& project, const RemedySetting& setting,
                                 double value) const {
    return withValue(project, setting, value, "= " + valueText(project, setting, value));
}

std::string RemedyWording::change(const Project& project, const Remedy& remedy) const {
    if (remedy.values <= 1) {
        return equal(project, remedy.setting, remedy.value);
    }
    return withValue(project, remedy.setting, remedy.value,
                     filled(SPARKOUT_NOOP("Remedy", "= {value} ({interval})"),
                            {{"value", valueText(project, remedy.setting, remedy.value)},
                             {"interval", intervalText(project, remedy)}}));
}

/// Seconds below two minutes.
std::string RemedyWording::time(double time_s) const {
    constexpr int digits = 2;
    const double value = rounded(std::abs(time_s), digits);
    return value < shortTime_s
               ? filled(SPARKOUT_NOOP("Remedy", "{time} s"), {{"time", number(value)}})
               : filled(
                   SPARKOUT_NOOP("Remedy", "{time} min"),
                   {{"time", number(rounded(std::abs(time_s) / units::secondsPerMinute, digits))}});
}

std::string RemedyWording::cost(const Remedy& remedy) const {
    if (remedy.setting.isWholeCycle()) {
        return time(remedy.time_s);
    }
    if (!remedy.timeChange_s) {
        return filled(SPARKOUT_NOOP("Remedy", "the cycle takes {time}"),
                      {{"time", time(remedy.time_s)}});
    }
    constexpr double none_s = 0.005;
    return std::abs(*remedy.timeChange_s) < none_s
               ? translated(SPARKOUT_NOOP("Remedy", "in the same time"))
               : (*remedy.timeChange_s > 0 ? "+" : "−") + time(*remedy.timeChange_s);
}

std::string RemedyWording::line(const Project& project, const Remedy& remedy) const {
    return filled(
        SPARKOUT_NOOP("Remedy", "{change}: {cost}; {parts}"),
        {{"change", change(project, remedy)}, {"cost", cost(remedy)}, {"parts", goodFor(remedy)}});
}

std::string RemedyWording::goodFor(const Remedy& remedy) const {
    const std::string stocks = remedy.stocks
                                   ? translated(SPARKOUT_NOOP("Remedy", "for every stock"))
                                   : filled(SPARKOUT_NOOP("Remedy", "for {phases} stocks"),
                                            {{"phases", number(remedy.phases)}});
    return remedy.batch
               ? stocks
                     + filled(SPARKOUT_NOOP("Remedy", ", {bad} of {parts} rejected"),
                              {{"bad", number(static_cast<double>(remedy.batch->bad))},
                               {"parts", number(static_cast<double>(remedy.batch->parts))}})
               : stocks;
}

std::string RemedyWording::proof(const Project& project, RemedyGoal goal,
                                 const Remedy& remedy) const {
    const RemedySetting& setting = remedy.setting;
    if (setting.isWholeCycle()) {
        std::string text =
            filled(
                goal == RemedyGoal::room
                    ? SPARKOUT_NOOP("Remedy", "A cycle made for the given part, wheel and machine: "
                                              "nothing is close to its limit; it takes {time}.")
                    : SPARKOUT_NOOP("Remedy", "A cycle made for the given part, wheel and machine: "
                                              "all requirements are met; it takes {time}."),
                {{"time", time(remedy.time_s)}})
            + ' '
            + translated(SPARKOUT_NOOP("Remedy", "It has stages, work speed, overruns and dwells "
                                                 "of its own."))
            + ' ' + heldStocks(remedy);
        return remedy.batch ? text + ' ' + heldParts(*remedy.batch) : text;
    }
    std::string text = filled(
        goal == RemedyGoal::room
            ? SPARKOUT_NOOP("Remedy", "Run with {value}: nothing is close to its limit; the "
                                      "cycle takes {time}.")
            : SPARKOUT_NOOP("Remedy", "Run with {value}: all requirements are met; the cycle takes "
                                      "{time}."),
        {{"value", valueText(project, setting, remedy.value)}, {"time", time(remedy.time_s)}});
    if (remedy.values > 1) {
        text +=
            ' '
            + filled(
                SPARKOUT_NOOP("Remedy",
                              "This applies to all {values} values of {interval} that can be set."),
                {{"values", number(remedy.values)}, {"interval", intervalText(project, remedy)}});
    }
    const char* const nearer = nearerValue(goal == RemedyGoal::room, remedy);
    if (nearer) {
        text += ' '
                + filled(nearer, {{"value", valueText(project, setting,
                                                      remedy.failing.value_or(setting.before))},
                                  {"before", valueText(project, setting, setting.before)}});
    }
    text += ' ' + heldStocks(remedy);
    return remedy.batch ? text + ' ' + heldParts(*remedy.batch) : text;
}

std::string RemedyWording::heldParts(const RemedyBatch& batch) const {
    constexpr double percent = 100;
    return filled(
        SPARKOUT_NOOP("Remedy",
                      "Of {parts} parts of the batch drawn for this check, {bad} are rejected: "
                      "with 95 % confidence at most {share} % of all parts are."),
        {{"parts", number(static_cast<double>(batch.parts))},
         {"bad", number(static_cast<double>(batch.bad))},
         {"share", number(std::ceil(percent * percent * mostBad(batch)) / percent)}});
}

std::string RemedyWording::heldStocks(const Remedy& remedy) const {
    constexpr int digits = 5;
    constexpr double percent = 100;
    if (remedy.stocks) {
        return filled(SPARKOUT_NOOP("Remedy", "The cycle is fit for every stock per side of "
                                              "{from}…{to} mm: decided, not sampled."),
                      {{"from", number(rounded(remedy.stocks->from_mm, digits))},
                       {"to", number(rounded(remedy.stocks->to_mm, digits))}});
    }
    return filled(
        SPARKOUT_NOOP("Remedy",
                      "The cycle is fit for all {phases} stocks drawn at random within one infeed: "
                      "with 95 % confidence it is unfit for at most {share} % of all stocks."),
        {{"phases", number(remedy.phases)},
         {"share",
          number(std::ceil(percent * percent * mostFailing(remedy.phases, remedy.candidate))
                 / percent)}});
}

std::string RemedyWording::scope(const RemedyResult& result) const {
    if (result.remedies.empty()) {
        return {};
    }
    return translated(
        result.remedies.front().stocks
            ? SPARKOUT_NOOP(
                "Remedy",
                "Each change helps for every stock within half an infeed of the stated one.")
            : SPARKOUT_NOOP("Remedy",
                            "Each change helps for the stocks tried within half an infeed of the "
                            "stated one; under position control this is sampled, not decided."));
}

std::string RemedyWording::conflict(const Project& project, RemedyGoal goal,
                                    const RemedyConflict& conflict) const {
    using enum RemedyConflict::Kind;
    constexpr int stockDigits = 5;
    const bool room = goal == RemedyGoal::room;
    const char* const sentence =
        conflict.kind == narrow                            ? tooFewValues(room)
        : conflict.kind == batch                           ? wherePartsAreBad(conflict)
        : conflict.kind == stocks                          ? whereAnotherStockFails(room, conflict)
        : conflict.kind == warned || conflict.kind == idle ? notOffered(room, conflict.kind)
        : conflict.kind == unmended                        ? whereNothingMends(room, conflict)
                                                           : whereTheFirstIsMended(room, conflict);
    return filled(sentence,
                  {{"first", conflict.first ? requirement(conflict.first->kind) : std::string()},
                   {"second", conflict.second ? requirement(conflict.second->kind) : std::string()},
                   {"stock", number(rounded(conflict.stock_mm, stockDigits))},
                   {"change", conflict.setting ? equal(project, *conflict.setting, conflict.value)
                                               : std::string()}});
}

std::string RemedyWording::extent(const RemedyResult& result) const {
    const std::string tried = number(static_cast<double>(result.tried));
    const std::string all = number(static_cast<double>(result.settings));
    if (result.outOfTime) {
        return filled(SPARKOUT_NOOP("Remedy", "The time was up after {tried} of {all} settings."),
                      {{"tried", tried}, {"all", all}});
    }
    return result.stopped ? filled(SPARKOUT_NOOP("Remedy", "Stopped after {tried} of {all} "
                                                           "settings."),
                                   {{"tried", tried}, {"all", all}})
                          : std::string();
}

} // namespace sparkout
