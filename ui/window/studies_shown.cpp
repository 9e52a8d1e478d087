// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/studies_shown.h"

#include "core/study/batch_edits.h"
#include "core/study/search_edits.h"
#include "core/study/sweep_edits.h"
#include "ui/views/batch/batch_view.h"
#include "ui/views/optimise/optimise_view.h"
#include "ui/views/sweep/sweep_view.h"

#include <QCoreApplication>

namespace sparkout {

namespace {

struct StudiesShown {
    Q_DECLARE_TR_FUNCTIONS(StudiesShown)
};

QString ofOtherInputs(const View& view) {
    return StudiesShown::tr("It is of the inputs before the last edit. Run it for those of now in "
                            "the view “%1”.")
        .arg(view.title());
}

} // namespace

std::vector<StudyOffer> studiesShown(const std::vector<View*>& views, const Project& now) {
    std::vector<StudyOffer> offers;
    const auto offer = [&offers](const View& view, Study study, bool isCurrent) {
        offers.push_back({std::move(study), view.busy() ? StudiesShown::tr(
                                                "It is being run: wait for it, or stop it.")
                                            : isCurrent ? QString()
                                                        : ofOtherInputs(view)});
    };
    for (const View* view : views) {
        if (const auto* batch = qobject_cast<const BatchView*>(view); batch && batch->batch()) {
            offer(*batch, {.batch = batch->batch(), .indices = batch->indices()},
                  sameBatch(batch->batch()->result.project, now));
        }
        if (const auto* sweep = qobject_cast<const SweepView*>(view); sweep && sweep->sweep()) {
            offer(*sweep, {.sweep = sweep->sweep()},
                  sameSweep(sweep->sweep()->result.project, now));
        }
        if (const auto* search = qobject_cast<const OptimiseView*>(view);
            search && search->search() && search->search()->ran()) {
            offer(*search, {.search = search->search(), .before_s = search->before_s()},
                  !search->hasOtherWear() && sameSearch(search->search()->project, now));
        }
    }
    return offers;
}

} // namespace sparkout
