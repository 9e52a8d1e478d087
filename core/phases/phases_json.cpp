// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/phases/phases_json.h"

#include "core/format/output_json.h"
#include "core/quality/requirement.h"
#include "core/quality/result_names.h"
#include "core/units.h"

namespace sparkout {

namespace {

using nlohmann::ordered_json;

std::optional<Interval> endsOf(const StockRange& range) {
    return Interval{range.from_mm, range.to_mm};
}

constexpr Output<PhaseDecision> decisionRows[] = {
    {{.key = "stock_mm", .unit = "mm", .hint = "range of stocks per side"},
     [](const PhaseDecision& d) { return endsOf(d.range); }},
    {{.key = "decided"}, [](const PhaseDecision& d) { return d.isDecided; }},
    {{.key = "too_many_pieces", .hint = "the range has too many, and is not decided"},
     [](const PhaseDecision& d) { return d.hasTooMany; }},
    {{.key = "holds", .hint = "whether every requirement holds for every stock of the range"},
     [](const PhaseDecision& d) { return d.holds(); }},
};

constexpr Output<DecidedPiece> pieceRows[] = {
    {{.key = "stock_mm", .unit = "mm", .hint = "stocks per side whose cycles make the same steps"},
     [](const DecidedPiece& p) {
         return endsOf({p.piece.from_mm, p.piece.to_mm});
     }},
    {{.key = "status"},
     [](const DecidedPiece& p) { return std::string(statusKey(p.piece.status)); }},
    {{.key = "time_min", .unit = "min", .hint = "time of the cycle"},
     [](const DecidedPiece& p) { return p.time_s / units::secondsPerMinute; }},
    {{.key = "holds_mm", .unit = "mm", .hint = "those for which every requirement holds"},
     [](const DecidedPiece& p) { return p.holds ? endsOf(*p.holds) : std::nullopt; }},
};

constexpr Output<FailingStocks> failingRows[] = {
    {{.key = "stock_mm", .unit = "mm", .hint = "stocks per side for which the cycle fails"},
     [](const FailingStocks& f) { return endsOf(f.stocks); }},
    {{.key = "status"}, [](const FailingStocks& f) { return std::string(statusKey(f.status)); }},
};

constexpr Output<ConstraintResult> worstRows[] = {
    {{.key = "name"},
     [](const ConstraintResult& c) { return std::string(requirementOf(c.kind).key); }},
    {{.key = "where"}, [](const ConstraintResult& c) { return whereText(c); }},
    {{.key = "relative_margin", .hint = "at the worse end; positive when it holds"},
     [](const ConstraintResult& c) { return c.relativeMargin; }},
};

ordered_json deviationsJson(const PieceEnd& end) {
    ordered_json json = ordered_json::array();
    for (const DeviationRange& each : end.deviations) {
        json.push_back({each.least_mm * units::umPerMm, each.most_mm * units::umPerMm});
    }
    return json;
}

} // namespace

std::span<const Output<PhaseDecision>> phasesOutputs() {
    return decisionRows;
}

std::span<const Output<DecidedPiece>> phasePieceOutputs() {
    return pieceRows;
}

std::span<const Output<FailingStocks>> failingStocksOutputs() {
    return failingRows;
}

std::span<const Output<ConstraintResult>> phaseWorstOutputs() {
    return worstRows;
}

std::string phasesJson(const PhaseDecision& decision) {
    ordered_json json = outputsJson(phasesOutputs(), decision);
    json["pieces"] = outputsJsonOfEach(phasePieceOutputs(), decision.pieces);
    json["failing"] = outputsJsonOfEach(failingStocksOutputs(), decision.failing);
    for (std::size_t i = 0; i < decision.pieces.size(); ++i) {
        const DecidedPiece& piece = decision.pieces[i];
        json["pieces"][i].update({{"steps_by_stage", piece.piece.counts},
                                  {"deviations_um_from", deviationsJson(piece.low)},
                                  {"deviations_um_to", deviationsJson(piece.high)},
                                  {"worst", outputsJson(phaseWorstOutputs(), piece.worst)}});
    }
    for (std::size_t i = 0; i < decision.failing.size(); ++i) {
        json["failing"][i]["worst"] = outputsJson(phaseWorstOutputs(), decision.failing[i].worst);
    }
    return json.dump(2) + '\n';
}

} // namespace sparkout
