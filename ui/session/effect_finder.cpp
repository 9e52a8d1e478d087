// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/effect_finder.h"

#include "core/study/evaluate.h"

#include <stop_token>
#include <utility>

namespace sparkout {

EffectFinder::EffectFinder(QObject* parent) : QObject(parent) {}

void EffectFinder::request(Project before, Project after) {
    m_job.start([this, before = std::move(before), after = std::move(after)](
                    const std::stop_token& stop, const NewestJob::Post& post) {
        const OutcomePtr now = evaluate(before, stop);
        const OutcomePtr then = now ? evaluate(after, stop) : nullptr;
        if (then) {
            post([this, now, then] { emit found(now, then); });
        }
    });
}

void EffectFinder::drop() {
    m_job.stop();
}

} // namespace sparkout
