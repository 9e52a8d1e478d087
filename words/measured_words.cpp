// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/measured_words.h"

#include "core/file/output_json.h"
#include "core/text.h"
#include "words/issue_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

constexpr Output<Identification> identificationRows[] = {
    {{.key = "status"}, [](const Identification& i) { return std::string(wordsOf(i.status).key); }},
    {{.key = "condition",
      .hint = "condition number of the derivatives; none if they depend on each other"},
     [](const Identification& i) {
         return std::isfinite(i.condition) ? std::optional(i.condition) : std::nullopt;
     }},
    {{.key = "normality_probability", .hint = "of the residuals, if they are normal"},
     [](const Identification& i) {
         return i.normality ? std::optional(i.normality->probability) : std::nullopt;
     }},
    {{.key = "in_doubt", .hint = "whether the model does not fit and the values must not be used"},
     [](const Identification& i) { return i.status == IdentificationStatus::doesNotFit; }},
    {{.key = "measured_values"}, [](const Identification& i) { return std::int64_t(i.count); }},
};

constexpr Output<FittedValue> valueRows[] = {
    {{.key = "parameter"}, [](const FittedValue& v) { return parameterName(v.parameter); }},
    {{.key = "value"}, [](const FittedValue& v) { return v.value; }},
    {{.key = "unit", .hint = "empty for a factor"},
     [](const FittedValue& v) { return std::string(unitOf(v.parameter.kind)); }},
    {{.key = "interval_95"}, [](const FittedValue& v) { return std::optional(v.interval95); }},
    {{.key = "usual_range", .hint = "none of the clock and the zero of the traces"},
     [](const FittedValue& v) { return v.usual; }},
    {{.key = "in_doubt", .hint = "outside its usual range, so that the model does not fit"},
     [](const FittedValue& v) { return !v.isUsual(); }},
};

constexpr Output<FitResiduals> residualsRows[] = {
    {{.key = "source"}, [](const FitResiduals& r) { return std::string(wordsOf(r.source).key); }},
    {{.key = "trace", .hint = "its number in the project; −1: parts"},
     [](const FitResiduals& r) { return std::int64_t{r.trace}; }},
    {{.key = "count"}, [](const FitResiduals& r) { return std::int64_t(r.values.size()); }},
    {{.key = "rms"}, [](const FitResiduals& r) { return r.rms; }},
    {{.key = "noise", .hint = "noise of a trace, from differences of neighbouring values"},
     [](const FitResiduals& r) {
         return r.noise ? std::optional(std::sqrt(r.noise->variance())) : std::nullopt;
     }},
    {{.key = "noise_follows", .hint = "share of the noise that follows itself"},
     [](const FitResiduals& r) {
         return r.noise ? std::optional(r.noise->share()) : std::nullopt;
     }},
    {{.key = "lack_of_fit", .hint = "mean square of stretches over that of the noise; 1 is usual"},
     [](const FitResiduals& r) { return r.noise ? std::optional(r.lack.ratio) : std::nullopt; }},
    {{.key = "outliers", .hint = "outliers that a robust loss weighs less"},
     [](const FitResiduals& r) { return std::int64_t(r.outliers); }},
    {{.key = "over_range", .hint = "lone readings far beyond the range of all others"},
     [](const FitResiduals& r) { return std::int64_t(r.overRange.size()); }},
    {{.key = "in_doubt", .hint = "whether the residuals exceed the noise"},
     [](const FitResiduals& r) { return r.lack.isLacking(); }},
    {{.key = "unlike", .hint = "kind of the residuals: drift, lag, stage, spike or other"},
     [](const FitResiduals& r) {
         return r.lack.isLacking() ? std::optional<std::string>(wordsOf(r.unlike.kind).key)
                                   : std::nullopt;
     }},
    {{.key = "unlike_stage",
      .hint = "stage in which the residuals lie, from 1; none if they lie in several"},
     [](const FitResiduals& r) {
         return r.lack.isLacking() && r.unlike.stage >= 0
                    ? std::optional<std::int64_t>(r.unlike.stage + 1)
                    : std::nullopt;
     }},
    {{.key = "unit"}, [](const FitResiduals& r) { return std::string(unitOf(r.source)); }},
};

constexpr Output<OutOfStepOf> outOfStepRows[] = {
    {{.key = "parameter", .hint = "a property of the recorder that was not fitted"},
     [](const OutOfStepOf& o) { return std::string(keyOf(o.time.kind)); }},
    {{.key = "value", .hint = "its value when fitted too"},
     [](const OutOfStepOf& o) { return o.time.amount; }},
    {{.key = "error", .hint = "standard error"}, [](const OutOfStepOf& o) { return o.time.error; }},
    {{.key = "unit"}, [](const OutOfStepOf& o) { return std::string(unitOf(o.time.kind)); }},
    {{.key = "moves", .hint = "parameter that it changes most"},
     [](const OutOfStepOf& o) { return parameterName(o.parameters[o.time.parameter]); }},
    {{.key = "to", .hint = "value of that parameter then"},
     [](const OutOfStepOf& o) { return o.time.value; }},
};

constexpr Output<ForceLawChoice> forceLawRows[] = {
    {{.key = "supported", .hint = "by the spark-out: sources, threshold or undecided"},
     [](const ForceLawChoice& c) { return std::string(wordsOf(c.supported).key); }},
    {{.key = "aic_difference",
      .hint = "AIC of the sources' law minus that of the law with a threshold"},
     [](const ForceLawChoice& c) { return c.aicDifference; }},
    {{.key = "sources_rms_um", .hint = "residuals of the diameter by the sources' law"},
     [](const ForceLawChoice& c) { return c.sourcesRms_um; }},
    {{.key = "threshold_rms_um", .hint = "residuals of the diameter by the law with a threshold"},
     [](const ForceLawChoice& c) { return c.thresholdRms_um; }},
    {{.key = "time_constant_s", .hint = "of the law with a threshold"},
     [](const ForceLawChoice& c) { return c.timeConstant_s; }},
    {{.key = "revolutions", .hint = "of the spark-out that are recorded"},
     [](const ForceLawChoice& c) { return std::int64_t{c.revolutions}; }},
    {{.key = "readings"}, [](const ForceLawChoice& c) { return std::int64_t(c.readings); }},
    {{.key = "revolutions_more",
      .hint = "additional revolutions that would decide; none if decided"},
     [](const ForceLawChoice& c) {
         return c.revolutionsMore ? std::optional<std::int64_t>(*c.revolutionsMore) : std::nullopt;
     }},
};

constexpr Output<HoldOutRow> holdOutRows[] = {
    {{.key = "trace", .hint = "its number in the project; no calibrated input rests on it"},
     [](const HoldOutRow& r) { return std::int64_t{r.trace}; }},
    {{.key = "quantity",
      .hint =
          "time: between two sizes, from the middle of the first feed to the end of the last; "
          "after_feeds: removed of the diameter after the last feed; power: mean over the feeds"},
     [](const HoldOutRow& r) { return std::string(wordsOf(r.quantity).key); }},
    {{.key = "unit"}, [](const HoldOutRow& r) { return std::string(unitOf(r.quantity)); }},
    {{.key = "measured"}, [](const HoldOutRow& r) { return r.measured; }},
    {{.key = "predicted"}, [](const HoldOutRow& r) { return r.predicted; }},
    {{.key = "predicted_95",
      .hint = "with the calibrated inputs at the ends of their intervals, in all combinations"},
     [](const HoldOutRow& r) { return std::optional(r.predicted95); }},
    {{.key = "difference_95", .hint = "measured less predicted, with the noise of the trace"},
     [](const HoldOutRow& r) { return std::optional(r.difference95); }},
    {{.key = "agrees", .hint = "whether the difference may be zero"},
     [](const HoldOutRow& r) { return r.agrees(); }},
};

ordered_json rowJson(const Project& project, const AdequacyRow& row) {
    ordered_json json = outputsJson(adequacyOutputs(), {project, row});
    json["predicted"] = outputsJson(predictedOutputs(), row.predicted);
    json["variance_ratio"] = outputsJson(varianceRatioOutputs(), row.scatter);
    json["inside"] = outputsJson(insideShareOutputs(), row.share);
    return json;
}

ordered_json fitJson(const Identification& found, const std::vector<FittedParameter>& requested) {
    ordered_json json = outputsJson(identificationOutputs(), found);
    json["values"] = outputsJsonOfEach(fittedValueOutputs(), found.values);
    json["correlation"] = found.correlation;
    json["residuals"] = outputsJsonOfEach(fitResidualsOutputs(), found.residuals);
    if (found.forceLaw) {
        json["force_law"] = outputsJson(forceLawOutputs(), *found.forceLaw);
    }
    json["out_of_step"] = ordered_json::array();
    json["cannot_tell"] = ordered_json::array();
    json["remarks"] = ordered_json::array();
    for (const Issue& issue : found.issues) {
        json["remarks"].push_back({{"path", issue.path}, {"text", Wording().sentence(issue)}});
    }
    for (const OutOfStep& one : found.outOfStep) {
        json["out_of_step"].push_back(outputsJson(outOfStepOutputs(), {requested, one}));
    }
    for (const Unidentified& one : found.unidentified) {
        ordered_json names = ordered_json::array();
        for (const std::size_t i : one.parameters) {
            names.push_back(parameterName(requested[i]));
        }
        json["cannot_tell"].push_back({{"parameters", std::move(names)},
                                       {"measure", wordsOf(one.advice).key},
                                       {"product_is_told", one.isProduct}});
    }
    return json;
}

/// Removes the number at the beginning of a text; empty if there is none.
template <class Number>
std::optional<Number> takeNumber(std::string_view& text) {
    Number number{};
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) {
        return std::nullopt;
    }
    text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
    return number;
}

bool takeMark(std::string_view& text, char mark) {
    const bool isThere = text.starts_with(mark);
    text.remove_prefix(isThere ? 1 : 0);
    return isThere;
}

/// "compliance:2=1.1~0.2"
std::optional<FittedParameter> fittedParameterOf(std::string_view text) {
    const std::string_view key = text.substr(0, text.find_first_of(":="));
    text.remove_prefix(key.size());
    FittedParameter parameter;
    int kind = 0;
    while (kind < static_cast<int>(FittedKind::count_)
           && key != keyOf(static_cast<FittedKind>(kind))) {
        ++kind;
    }
    parameter.kind = static_cast<FittedKind>(kind);
    bool isKnown = parameter.kind != FittedKind::count_;
    if (takeMark(text, ':')) {
        parameter.place = takeNumber<int>(text);
        isKnown = isKnown && parameter.place.value_or(-1) >= 0;
    }
    if (takeMark(text, '=')) {
        const auto mean = takeNumber<double>(text);
        const bool isBoth = takeMark(text, '~');
        const auto deviation = takeNumber<double>(text);
        isKnown = isKnown && mean && isBoth && deviation && std::isfinite(*mean)
                  && std::isfinite(*deviation) && *deviation > 0
                  && (*mean > 0 || !isFactor(parameter.kind));
        parameter.prior = {mean.value_or(1), deviation.value_or(1)};
    }
    return isKnown && text.empty() ? std::optional(parameter) : std::nullopt;
}

} // namespace

std::optional<std::vector<FittedParameter>> fittedParametersOf(const std::string& text) {
    std::vector<FittedParameter> found;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(',', from), text.size());
        const auto parameter = fittedParameterOf(std::string_view(text).substr(from, end - from));
        from = end + 1;
        if (!parameter) {
            return std::nullopt;
        }
        found.push_back(*parameter);
    }
    return found;
}

std::optional<RobustLoss> robustLossOf(const std::string& text) {
    for (const RobustLoss loss : {RobustLoss::none, RobustLoss::huber, RobustLoss::tukey}) {
        if (text == keyOf(loss)) {
            return loss;
        }
    }
    return std::nullopt;
}

std::string parameterName(const FittedParameter& parameter) {
    const std::string key = keyOf(parameter.kind);
    return parameter.place ? key + ':' + std::to_string(*parameter.place) : key;
}

std::string knownParameters() {
    std::string known;
    for (int kind = 0; kind < static_cast<int>(FittedKind::count_); ++kind) {
        known += (known.empty() ? "" : ", ") + std::string(keyOf(static_cast<FittedKind>(kind)));
    }
    return known;
}

std::string parameterHint() {
    return "compliance:N is of one zone or section, and beta=1.2~0.1 has the mean and the standard "
           "deviation of what is known before; the deviation, and the mean of a factor, are above "
           "0";
}

std::span<const Output<Identification>> identificationOutputs() {
    return identificationRows;
}

std::span<const Output<FittedValue>> fittedValueOutputs() {
    return valueRows;
}

std::span<const Output<FitResiduals>> fitResidualsOutputs() {
    return residualsRows;
}

std::span<const Output<ForceLawChoice>> forceLawOutputs() {
    return forceLawRows;
}

std::span<const Output<HoldOutRow>> holdOutOutputs() {
    return holdOutRows;
}

std::span<const Output<OutOfStepOf>> outOfStepOutputs() {
    return outOfStepRows;
}

std::string measuredJson(const Project& project, const MeasuredAnswer& answer) {
    ordered_json json = {{"adequacy", ordered_json::array()}, {"identification", nullptr}};
    for (const AdequacyRow& row : answer.rows) {
        json["adequacy"].push_back(rowJson(project, row));
    }
    if (!answer.holdOut.empty()) {
        json["hold_out"] = outputsJsonOfEach(holdOutOutputs(), answer.holdOut);
    }
    if (answer.fit) {
        json["identification"] = fitJson(*answer.fit, answer.parameters);
    }
    return json.dump(2) + '\n';
}

MeasuredWords wordsOf(TrialRecord record) {
    switch (record) {
    case TrialRecord::size: return {"size", SPARKOUT_NOOP("Trial", "size at the gauge")};
    case TrialRecord::power: return {"power", SPARKOUT_NOOP("Trial", "power of the wheel")};
    case TrialRecord::sizeAndPower:
        return {"size_and_power", SPARKOUT_NOOP("Trial", "size and power")};
    case TrialRecord::force:
    case TrialRecord::count_: break;
    }
    return {"force", SPARKOUT_NOOP("Trial", "normal force")};
}

MeasuredWords wordsOf(TrialSparkOut sparkOut) {
    switch (sparkOut) {
    case TrialSparkOut::none: return {"none", SPARKOUT_NOOP("Trial", "without spark-out")};
    case TrialSparkOut::untilSettled:
    case TrialSparkOut::count_: break;
    }
    return {"until_settled", SPARKOUT_NOOP("Trial", "with spark-out")};
}

MeasuredWords wordsOf(TrialStatus status) {
    switch (status) {
    case TrialStatus::designed:
        return {"designed", SPARKOUT_NOOP("Trial", "trials, most informative first")};
    case TrialStatus::notApplicable:
        return {"not_applicable",
                SPARKOUT_NOOP("Trial", "the project cannot have these parameters, or one of them "
                                       "is given twice")};
    case TrialStatus::notRun:
        return {"not_run", SPARKOUT_NOOP("Trial", "no trial of the project can be run")};
    case TrialStatus::stopped: break;
    }
    return {"stopped", SPARKOUT_NOOP("Trial", "stopped")};
}

MeasuredWords wordsOf(StiffnessUnit unit) {
    switch (unit) {
    case StiffnessUnit::headstock: return {"headstock", SPARKOUT_NOOP("Trial", "headstock")};
    case StiffnessUnit::tailstock: return {"tailstock", SPARKOUT_NOOP("Trial", "tailstock")};
    case StiffnessUnit::wheel_head:
    case StiffnessUnit::count_: break;
    }
    return {"wheel_head", SPARKOUT_NOOP("Trial", "wheel head")};
}

MeasuredWords wordsOf(StiffnessTrialStatus status) {
    switch (status) {
    case StiffnessTrialStatus::found: return {"found", SPARKOUT_NOOP("Trial", "found")};
    case StiffnessTrialStatus::tooFewPlaces:
        return {"too_few_places",
                SPARKOUT_NOOP("Trial", "there are fewer places than stiffnesses to find")};
    case StiffnessTrialStatus::notMeasurable:
        return {"not_measurable",
                SPARKOUT_NOOP("Trial", "such a trial needs an external surface, a shaft without "
                                       "steady rests and places on it; of the system with a chuck "
                                       "or at two places the wheel head's stiffness, too")};
    case StiffnessTrialStatus::negative: break;
    }
    return {"negative",
            SPARKOUT_NOOP("Trial", "the readings contradict the shaft: a unit would have to be "
                                   "stiffer than rigid")};
}

MeasuredWords wordsOf(LoadLine line) {
    switch (line) {
    case LoadLine::straight:
        return {"straight", SPARKOUT_NOOP("Trial", "deflection is in proportion to the load")};
    case LoadLine::play:
        return {"play", SPARKOUT_NOOP("Trial", "there is play, and the stiffness is that beyond "
                                               "it: remove the play before loading")};
    case LoadLine::bent:
        return {"bent", SPARKOUT_NOOP("Trial", "the stiffness changes with the load, and the "
                                               "result is a mean: load as the deepest cut does")};
    case LoadLine::untested: break;
    }
    return {"untested", SPARKOUT_NOOP("Trial", "play is undetermined: load twice, "
                                               "differently, at each place")};
}

const char* textOf(AdequacyVerdict verdict) {
    switch (verdict) {
    case AdequacyVerdict::adequate:
        return SPARKOUT_NOOP("Measured", "the model agrees with the parts");
    case AdequacyVerdict::biased:
        return SPARKOUT_NOOP("Measured", "the mean differs from the predicted one");
    case AdequacyVerdict::scatterDiffers:
        return SPARKOUT_NOOP("Measured", "the parts scatter differently than predicted");
    case AdequacyVerdict::biasedAndScatters:
        return SPARKOUT_NOOP(
            "Measured",
            "the mean differs from the predicted one, and the parts scatter differently");
    case AdequacyVerdict::tooFewParts:
        return SPARKOUT_NOOP("Measured", "too few parts for a conclusion");
    case AdequacyVerdict::notPredicted: break;
    }
    return SPARKOUT_NOOP("Measured", "not predicted by this cycle");
}

MeasuredWords wordsOf(IdentificationStatus status) {
    switch (status) {
    case IdentificationStatus::fitted: return {"fitted", SPARKOUT_NOOP("Measured", "found")};
    case IdentificationStatus::cannotTell:
        return {"cannot_tell",
                SPARKOUT_NOOP("Measured", "the data leave some parameters undetermined")};
    case IdentificationStatus::noData:
        return {"no_data", SPARKOUT_NOOP("Measured", "there are too few measured values for these "
                                                     "parameters")};
    case IdentificationStatus::notApplicable:
        return {"not_applicable",
                SPARKOUT_NOOP("Measured",
                              "the project cannot have these parameters, one of them is given "
                              "twice, or the setting of the gauge is to be fitted to traces")};
    case IdentificationStatus::notRun:
        return {"not_run", SPARKOUT_NOOP("Measured", "the cycle of the project cannot be run to "
                                                     "size")};
    case IdentificationStatus::notConverged:
        return {"not_converged", SPARKOUT_NOOP("Measured", "no best values were found")};
    case IdentificationStatus::doesNotFit:
        return {"does_not_fit",
                SPARKOUT_NOOP("Measured",
                              "the model does not fit: the residuals exceed the noise, a time, lag "
                              "or drift is left out, a value lies outside its usual range, or an "
                              "input would be refused")};
    case IdentificationStatus::stopped: break;
    }
    return {"stopped", SPARKOUT_NOOP("Measured", "stopped")};
}

MeasuredWords wordsOf(Advice advice) {
    switch (advice) {
    case Advice::power:
        return {"power", SPARKOUT_NOOP("Measured", "record the wheel's power over the same cycle")};
    case Advice::force:
        return {"force", SPARKOUT_NOOP("Measured", "record the normal force over the same cycle")};
    case Advice::size:
        return {"size", SPARKOUT_NOOP("Measured", "record the size at the gauge over a cycle")};
    case Advice::another_feed:
        return {"another_feed", SPARKOUT_NOOP("Measured", "record a cycle with a stage at another "
                                                          "feed, or with a spark-out")};
    case Advice::idle:
        return {"idle",
                SPARKOUT_NOOP("Measured", "record the power before the wheel touches, too")};
    case Advice::place_sizes:
        return {"place_sizes",
                SPARKOUT_NOOP("Measured", "measure the size in these zones or sections")};
    case Advice::cycle_start:
        return {"cycle_start",
                SPARKOUT_NOOP("Measured", "record a trace that has the beginning of the cut")};
    case Advice::several_parts:
    case Advice::count_: break;
    }
    return {"several_parts", SPARKOUT_NOOP("Measured", "measure more parts")};
}

MeasuredWords wordsOf(SupportedLaw law) {
    switch (law) {
    case SupportedLaw::sources:
        return {"sources",
                SPARKOUT_NOOP("Measured", "the spark-out supports the sources' force law")};
    case SupportedLaw::threshold:
        return {"threshold", SPARKOUT_NOOP("Measured", "the spark-out supports the force law with "
                                                       "a threshold")};
    case SupportedLaw::undecided: break;
    }
    return {"undecided",
            SPARKOUT_NOOP("Measured", "the spark-out does not separate the two force laws")};
}

MeasuredWords wordsOf(HoldOutQuantity quantity) {
    switch (quantity) {
    case HoldOutQuantity::after_feeds:
        return {"after_feeds", SPARKOUT_NOOP("Measured", "removed after the last feed, on the "
                                                         "diameter")};
    case HoldOutQuantity::power:
        return {"power", SPARKOUT_NOOP("Measured", "mean wheel power over the feeds")};
    case HoldOutQuantity::time: break;
    }
    return {"time", SPARKOUT_NOOP("Measured", "time from the middle of the first feed to the end "
                                              "of the last one, between the same two sizes")};
}

MeasuredWords wordsOf(FittedKind kind, bool hasThreshold) {
    if (hasThreshold && kind == FittedKind::alpha) {
        return {"alpha", SPARKOUT_NOOP("Measured", "factor of the specific normal force K₀")};
    }
    if (hasThreshold && kind == FittedKind::beta) {
        return {"beta", SPARKOUT_NOOP("Measured", "factor of the threshold force F′₀")};
    }
    if (hasThreshold && kind == FittedKind::chip_power) {
        return {"chip_power", SPARKOUT_NOOP("Measured", "factor of b·K_z·Vₖ")};
    }
    if (hasThreshold && kind == FittedKind::friction_power) {
        return {"friction_power", SPARKOUT_NOOP("Measured", "factor of b·μ·F′₀·Vₖ")};
    }
    switch (kind) {
    case FittedKind::alpha: return {"alpha", SPARKOUT_NOOP("Measured", "factor of α = γ·b·kₛ")};
    case FittedKind::beta: return {"beta", SPARKOUT_NOOP("Measured", "factor of β = γ·b·kᵣ")};
    case FittedKind::compliance:
        return {"compliance", SPARKOUT_NOOP("Measured", "factor of the compliance γ")};
    case FittedKind::flow_stress:
        return {"flow_stress", SPARKOUT_NOOP("Measured", "factor of the flow stress σᵢ")};
    case FittedKind::dullness:
        return {"dullness", SPARKOUT_NOOP("Measured", "factor of the dullness η")};
    case FittedKind::chip_power:
        return {"chip_power", SPARKOUT_NOOP("Measured", "factor of b·kₜ·Vₖ")};
    case FittedKind::friction_power:
        return {"friction_power", SPARKOUT_NOOP("Measured", "factor of b·μ·kᵣ·Vₖ")};
    case FittedKind::idle_power: return {"idle_power", SPARKOUT_NOOP("Measured", "idle power")};
    case FittedKind::size_offset:
        return {"size_offset", SPARKOUT_NOOP("Measured", "offset of the gauge")};
    case FittedKind::time_shift:
        return {"time_shift", SPARKOUT_NOOP("Measured", "beginning of the cycle in the trace")};
    case FittedKind::power_delay:
        return {"power_delay", SPARKOUT_NOOP("Measured", "delay of the power trace")};
    case FittedKind::force_delay:
        return {"force_delay", SPARKOUT_NOOP("Measured", "delay of the force trace")};
    case FittedKind::blank_runout:
        return {"blank_runout", SPARKOUT_NOOP("Measured", "runout of the blank")};
    case FittedKind::gauge_lag:
        return {"gauge_lag", SPARKOUT_NOOP("Measured", "time constant of the gauge")};
    case FittedKind::power_lag:
        return {"power_lag", SPARKOUT_NOOP("Measured", "time constant of the power's filter")};
    case FittedKind::force_lag:
        return {"force_lag", SPARKOUT_NOOP("Measured", "time constant of the force's filter")};
    case FittedKind::gauge_drift:
        return {"gauge_drift", SPARKOUT_NOOP("Measured", "drift of the gauge")};
    case FittedKind::gauge_setting:
        return {"gauge_setting", SPARKOUT_NOOP("Measured", "setting of the gauge")};
    case FittedKind::count_: break;
    }
    return {"", ""};
}

MeasuredWords wordsOf(FitSource source) {
    switch (source) {
    case FitSource::size: return {"size", SPARKOUT_NOOP("Measured", "size at the gauge")};
    case FitSource::power: return {"power", SPARKOUT_NOOP("Measured", "power of the wheel")};
    case FitSource::force: return {"force", SPARKOUT_NOOP("Measured", "normal force")};
    case FitSource::parts: break;
    }
    return {"parts", SPARKOUT_NOOP("Measured", "diameters of parts")};
}

MeasuredWords wordsOf(Unlike unlike) {
    switch (unlike) {
    case Unlike::drift:
        return {"drift", SPARKOUT_NOOP(
                             "Measured",
                             "the difference grows with time, as when a gauge or a sensor drifts")};
    case Unlike::lag:
        return {"lag",
                SPARKOUT_NOOP(
                    "Measured",
                    "the trace lags where it changes fast, as with a damped gauge or a filter")};
    case Unlike::stage:
        return {"stage", SPARKOUT_NOOP("Measured", "the difference lies in one stage: is its feed "
                                                   "that of the recording?")};
    case Unlike::spike:
        return {
            "spike",
            SPARKOUT_NOOP(
                "Measured",
                "the difference lies in a few outliers: give them less weight, or leave them out")};
    case Unlike::other:
    case Unlike::count_: break;
    }
    return {"other",
            SPARKOUT_NOOP(
                "Measured",
                "the project and the recording differ in something other than these parameters")};
}

const char* overRangeAdvice() {
    return SPARKOUT_NOOP("Measured", "readings so far beyond all others come from a sensor at the "
                                     "end of its range: leave them out, or give outliers less "
                                     "weight");
}

const char* unitOf(HoldOutQuantity quantity) {
    switch (quantity) {
    case HoldOutQuantity::after_feeds: return SPARKOUT_NOOP("Unit", "µm");
    case HoldOutQuantity::power: return SPARKOUT_NOOP("Unit", "kW");
    case HoldOutQuantity::time: break;
    }
    return SPARKOUT_NOOP("Unit", "s");
}

const char* unitOf(FitSource source) {
    switch (source) {
    case FitSource::size: return "mm";
    case FitSource::power: return "kW";
    case FitSource::force: return "N";
    case FitSource::parts: break;
    }
    return "µm";
}

} // namespace sparkout
