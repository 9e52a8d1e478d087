// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/measured_json.h"

#include "core/format/output_json.h"
#include "words/issue_words.h"
#include "words/measured_words.h"

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
    {{.key = "condition", .hint = "of the derivatives; none where they depend on each other"},
     [](const Identification& i) {
         return std::isfinite(i.condition) ? std::optional(i.condition) : std::nullopt;
     }},
    {{.key = "normality_probability", .hint = "of the residuals, if they are normal"},
     [](const Identification& i) {
         return i.normality ? std::optional(i.normality->probability) : std::nullopt;
     }},
    {{.key = "in_doubt", .hint = "the model does not fit, and the values are not to be used"},
     [](const Identification& i) { return i.status == IdentificationStatus::doesNotFit; }},
    {{.key = "measured_values"}, [](const Identification& i) { return std::int64_t(i.count); }},
};

constexpr Output<FittedValue> valueRows[] = {
    {{.key = "parameter"}, [](const FittedValue& v) { return parameterName(v.parameter); }},
    {{.key = "value"}, [](const FittedValue& v) { return v.value; }},
    {{.key = "unit", .hint = "empty for a factor"},
     [](const FittedValue& v) { return std::string(unitOf(v.parameter.kind)); }},
    {{.key = "interval_95"}, [](const FittedValue& v) { return std::optional(v.interval95); }},
};

constexpr Output<FitResiduals> residualsRows[] = {
    {{.key = "source"}, [](const FitResiduals& r) { return std::string(wordsOf(r.source).key); }},
    {{.key = "trace", .hint = "its number in the project; −1: parts"},
     [](const FitResiduals& r) { return std::int64_t{r.trace}; }},
    {{.key = "count"}, [](const FitResiduals& r) { return std::int64_t(r.values.size()); }},
    {{.key = "rms"}, [](const FitResiduals& r) { return r.rms; }},
    {{.key = "noise", .hint = "of a trace, from what neighbouring values differ by"},
     [](const FitResiduals& r) {
         return r.noise ? std::optional(std::sqrt(r.noise->variance())) : std::nullopt;
     }},
    {{.key = "noise_follows", .hint = "share of the noise that follows itself"},
     [](const FitResiduals& r) {
         return r.noise ? std::optional(r.noise->share()) : std::nullopt;
     }},
    {{.key = "lack_of_fit", .hint = "mean square of stretches over that of the noise; 1 is usual"},
     [](const FitResiduals& r) { return r.noise ? std::optional(r.lack.ratio) : std::nullopt; }},
    {{.key = "outliers", .hint = "lone values that a robust loss counts less"},
     [](const FitResiduals& r) { return std::int64_t(r.outliers); }},
    {{.key = "over_range", .hint = "lone readings far beyond the range of all others"},
     [](const FitResiduals& r) { return std::int64_t(r.overRange.size()); }},
    {{.key = "in_doubt", .hint = "more is left than noise leaves"},
     [](const FitResiduals& r) { return r.lack.isLacking(); }},
    {{.key = "unlike", .hint = "what is left: drift, lag, stage, spike or other"},
     [](const FitResiduals& r) {
         return r.lack.isLacking() ? std::optional<std::string>(wordsOf(r.unlike.kind).key)
                                   : std::nullopt;
     }},
    {{.key = "unlike_stage", .hint = "where what is left lies in one stage, from 1"},
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
    {{.key = "value", .hint = "with it fitted too"},
     [](const OutOfStepOf& o) { return o.time.amount; }},
    {{.key = "error", .hint = "standard error"}, [](const OutOfStepOf& o) { return o.time.error; }},
    {{.key = "unit"}, [](const OutOfStepOf& o) { return std::string(unitOf(o.time.kind)); }},
    {{.key = "moves", .hint = "the parameter that it moves most"},
     [](const OutOfStepOf& o) { return parameterName(o.parameters[o.time.parameter]); }},
    {{.key = "to", .hint = "what that one would be"},
     [](const OutOfStepOf& o) { return o.time.value; }},
};

constexpr Output<ForceLawChoice> forceLawRows[] = {
    {{.key = "supported", .hint = "by the spark-out: sources, threshold or undecided"},
     [](const ForceLawChoice& c) { return std::string(wordsOf(c.supported).key); }},
    {{.key = "aic_difference", .hint = "of the sources' law less that of the threshold"},
     [](const ForceLawChoice& c) { return c.aicDifference; }},
    {{.key = "sources_rms_um", .hint = "what the sources' law leaves of the diameter"},
     [](const ForceLawChoice& c) { return c.sourcesRms_um; }},
    {{.key = "threshold_rms_um", .hint = "what the law with a threshold leaves of it"},
     [](const ForceLawChoice& c) { return c.thresholdRms_um; }},
    {{.key = "time_constant_s", .hint = "of the law with a threshold"},
     [](const ForceLawChoice& c) { return c.timeConstant_s; }},
    {{.key = "revolutions", .hint = "of the spark-out that are recorded"},
     [](const ForceLawChoice& c) { return std::int64_t{c.revolutions}; }},
    {{.key = "readings"}, [](const ForceLawChoice& c) { return std::int64_t(c.readings); }},
    {{.key = "revolutions_more", .hint = "undecided: so many more would decide"},
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
    {{.key = "agrees", .hint = "the difference may be none"},
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

} // namespace

namespace {

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

} // namespace sparkout
