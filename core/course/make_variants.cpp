// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/course/make_variants.h"

#include "core/project/optimisation.h"
#include "core/statistics/philox.h"

#include <map>
#include <set>

namespace sparkout {

namespace {

/// The levels of a try, drawn uniformly.
VariantLevels drawn(const VariantLevels& counts, std::uint32_t seed, long long tried) {
    VariantLevels levels;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const std::uint64_t bits =
            randomBits(seed, RandomStream::variant, static_cast<std::uint64_t>(tried),
                       static_cast<std::uint32_t>(i));
        levels.push_back(
            static_cast<std::size_t>((bits >> 32) * static_cast<std::uint64_t>(counts[i]) >> 32));
    }
    return levels;
}

} // namespace

MadeVariants makeVariants(const Lesson& lesson, std::size_t count, std::uint32_t seed,
                          const std::stop_token& stop,
                          const std::function<void(const VariantTry&)>& note) {
    MadeVariants made;
    if (needsSearch(lesson)) {
        const Project& project = lesson.base.surfaces[variedSurface(lesson)].project;
        if (!project.optimisation) {
            made.fault = LessonFault::noGrid;
            return made;
        }
        made.reference = bestAnswer(project, stop);
        made.isStopped = stop.stop_requested();
        if (!made.reference) {
            made.fault = LessonFault::noReference;
            return made;
        }
    }
    if (!lesson.variants) {
        made.variants.assign(count, {{}, made.reference});
        return made;
    }
    const VariantLevels counts = levelCounts(lesson);
    std::map<VariantLevels, VariantFault> known;
    std::set<VariantLevels> taken;
    while (made.variants.size() < count && made.tries < mostTries(count)) {
        const VariantLevels levels = drawn(counts, seed, made.tries++);
        CheckedVariant found;
        if (taken.contains(levels)) {
            found.fault = VariantFault::alike;
        } else if (const auto before = known.find(levels); before != known.end()) {
            found.fault = before->second;
        } else {
            found = checkVariant(lesson, levels, made.reference, stop);
            if (stop.stop_requested()) {
                made.isStopped = true;
                return made;
            }
            if (found.fault) {
                known.emplace(levels, *found.fault);
            } else {
                taken.insert(levels);
                made.variants.push_back({levels, found.best});
            }
        }
        if (found.fault) {
            ++made.refused[static_cast<std::size_t>(*found.fault)];
        }
        if (note) {
            note({levels, std::move(found), made.variants.size()});
        }
    }
    return made;
}

} // namespace sparkout
