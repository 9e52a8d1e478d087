// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/trial_words.h"

#include "core/text.h"

namespace sparkout {

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
        return {"play",
                SPARKOUT_NOOP("Trial", "there is play, and the stiffness is that beyond it: "
                                       "take the play out before loading")};
    case LoadLine::bent:
        return {"bent", SPARKOUT_NOOP("Trial", "the stiffness changes with the load, and what was "
                                               "found is a mean: load as the deepest cut does")};
    case LoadLine::untested: break;
    }
    return {"untested", SPARKOUT_NOOP("Trial", "play is undetermined: load twice, "
                                               "differently, at each place")};
}

} // namespace sparkout
