// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/phases/phases_json.h"

#include "core/quality/requirement.h"
#include "core/quality/result_names.h"
#include "core/units.h"

#include <nlohmann/json.hpp>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

ordered_json deviationsJson(const PieceEnd& end) {
    ordered_json json = ordered_json::array();
    for (const DeviationRange& each : end.deviations) {
        json.push_back({each.least_mm * units::umPerMm, each.most_mm * units::umPerMm});
    }
    return json;
}

ordered_json worstJson(const std::optional<ConstraintResult>& worst) {
    return worst ? ordered_json{{"name", requirementOf(worst->kind).key},
                                {"where", whereText(*worst)},
                                {"relative_margin", worst->relativeMargin}}
                 : ordered_json(nullptr);
}

ordered_json rangeJson(const StockRange& range) {
    return {range.from_mm, range.to_mm};
}

} // namespace

std::string phasesJson(const PhaseDecision& decision) {
    ordered_json json = {
        {"stock_mm", rangeJson(decision.range)},  {"decided", decision.isDecided},
        {"too_many_pieces", decision.hasTooMany}, {"holds", decision.holds()},
        {"pieces", ordered_json::array()},        {"failing", ordered_json::array()}};
    for (const DecidedPiece& each : decision.pieces) {
        json["pieces"].push_back(
            {{"stock_mm", {each.piece.from_mm, each.piece.to_mm}},
             {"status", statusKey(each.piece.status)},
             {"steps_by_stage", each.piece.counts},
             {"time_min", each.time_s / units::secondsPerMinute},
             {"deviations_um_from", deviationsJson(each.low)},
             {"deviations_um_to", deviationsJson(each.high)},
             {"holds_mm", each.holds ? rangeJson(*each.holds) : ordered_json(nullptr)},
             {"worst", worstJson(each.worst)}});
    }
    for (const FailingStocks& each : decision.failing) {
        json["failing"].push_back({{"stock_mm", rangeJson(each.stocks)},
                                   {"status", statusKey(each.status)},
                                   {"worst", worstJson(each.worst)}});
    }
    return json.dump(2) + '\n';
}

} // namespace sparkout
