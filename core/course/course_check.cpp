// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/course/course_check.h"

#include "core/course/variant.h"
#include "core/setup/setup_file.h"

#include <utility>

namespace sparkout {

CheckedSteps checkedAsGiven(Lesson lesson, const std::stop_token& stop) {
    CheckedSteps checked{withBestTimes(std::move(lesson), stop), {}};
    for (std::size_t step = 0; step < checked.lesson.steps.size(); ++step) {
        Answer given;
        given.setup.text = writeSetup(setupOf(checked.lesson, step));
        checked.steps.push_back(checkStep(checked.lesson, step, given));
    }
    return checked;
}

CheckedSteps checkedAnswers(const Work& work) {
    CheckedSteps checked{work.lesson, {}};
    for (std::size_t step = 0; step < work.lesson.steps.size(); ++step) {
        checked.steps.push_back(
            checkStep(work.lesson, step, recordOf(work, step).answer.value_or(Answer())));
    }
    return checked;
}

} // namespace sparkout
