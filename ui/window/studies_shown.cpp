// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/studies_shown.h"

#include "ui/session/document.h"
#include "ui/session/studies.h"

#include <QCoreApplication>

namespace sparkout {

namespace {

struct StudiesShown {
    Q_DECLARE_TR_FUNCTIONS(StudiesShown)
};

/// The reason why it cannot be exported; empty if it can. `view` is the class of its view.
QString hindrance(bool isRunning, bool isStale, const char* view, const char* title) {
    return isRunning ? StudiesShown::tr("It is being run: wait for it, or stop it.")
           : isStale ? StudiesShown::tr("These results are for the inputs before the last edit. "
                                        "Compute them for the current inputs in the view “%1”.")
                           .arg(QCoreApplication::translate(view, title))
                     : QString();
}

} // namespace

std::vector<StudyOffer> studiesOffered(Studies& studies, const Project& now,
                                       const Document& document) {
    std::vector<StudyOffer> offers;
    if (const BatchOutcomePtr& batch = studies.batch.result()) {
        offers.push_back({{.batch = batch, .indices = studies.indices()},
                          hindrance(studies.batch.running() || studies.indexJob().running(),
                                    !studies.batch.isOf(now), "sparkout::BatchView", "Batch")});
    }
    if (const SweepResultPtr& sweep = studies.sweep.result()) {
        offers.push_back({{.sweep = sweep},
                          hindrance(studies.sweep.running(), !studies.sweep.isOf(now),
                                    "sparkout::SweepView", "Sweep")});
    }
    if (const SearchOutcomePtr& search = studies.search.result()) {
        const bool wearsOtherwise =
            search->wear
            && !sameWear(SurfaceWear(document.setup(), document.surface()), *search->wear);
        offers.push_back(
            {{.search = search, .before_s = search->given.time_s},
             hindrance(studies.search.running(), !studies.search.isOf(now) || wearsOtherwise,
                       "sparkout::OptimiseView", "Optimise")});
    }
    return offers;
}

} // namespace sparkout
