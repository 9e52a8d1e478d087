// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/measured_words.h"

#include "core/text.h"

namespace sparkout {

const char* textOf(AdequacyVerdict verdict) {
    switch (verdict) {
    case AdequacyVerdict::adequate:
        return SPARKOUT_NOOP("Measured", "the model agrees with the parts");
    case AdequacyVerdict::biased:
        return SPARKOUT_NOOP("Measured", "the mean differs from the predicted one");
    case AdequacyVerdict::scatterDiffers:
        return SPARKOUT_NOOP("Measured", "the parts scatter otherwise than predicted");
    case AdequacyVerdict::biasedAndScatters:
        return SPARKOUT_NOOP("Measured", "the mean differs from the predicted one, and the parts "
                                         "scatter otherwise");
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
                              "twice, or the setting of the gauge is asked of traces")};
    case IdentificationStatus::notRun:
        return {"not_run", SPARKOUT_NOOP("Measured", "the cycle of the project cannot be run to "
                                                     "size")};
    case IdentificationStatus::notConverged:
        return {"not_converged", SPARKOUT_NOOP("Measured", "no best values were found")};
    case IdentificationStatus::doesNotFit:
        return {"does_not_fit",
                SPARKOUT_NOOP("Measured",
                              "the model does not fit: the residuals exceed the noise, a time, lag "
                              "or drift is left out, a factor lies outside the searched range, or "
                              "an input would be refused")};
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

const char* unitOf(FittedKind kind) {
    switch (kind) {
    case FittedKind::idle_power: return "kW";
    case FittedKind::size_offset:
    case FittedKind::gauge_setting:
    case FittedKind::blank_runout: return "mm";
    case FittedKind::time_shift:
    case FittedKind::power_delay:
    case FittedKind::force_delay:
    case FittedKind::gauge_lag: return "s";
    case FittedKind::gauge_drift: return "mm/min";
    default: return "";
    }
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
