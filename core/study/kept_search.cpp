// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/kept_search.h"

#include "core/batch/batch_state.h"
#include "core/build_id.h"
#include "core/file/file_system.h"
#include "core/search/optimise.h"

#include <cerrno>
#include <cstddef>
#include <string>

namespace sparkout {

namespace {

constexpr std::chrono::seconds betweenWrites(1);

} // namespace

SearchQuestion searchQuestion(const Project& project, const SearchWish& wish) {
    std::string options = std::string("--method ") + searchMethodName(wish.method);
    options += wish.phases ? " --robust" : "";
    options += wish.refine ? " --refine" : "";
    return {buildId(), projectDigest(project), options};
}

std::optional<KeptSearchFault> KeptSearch::open() {
    SearchRecord record;
    const auto text = readFile(m_file, mostBytes);
    const auto* const error = std::get_if<FileError>(&text);
    if (error && error->systemError != ENOENT) {
        return *error;
    }
    if (!error) {
        ReadSearchState read = readSearchState(std::get<std::string>(text), m_question);
        if (read.fault != SearchStateFault::none) {
            return read;
        }
        record = std::move(read.record);
    }
    // A file that cannot be written is reported before the search, not after it.
    if (const auto failed = writeFileSafely(m_file, writeSearchState(m_question, record))) {
        return *failed;
    }
    m_written = std::chrono::steady_clock::now();
    m_journal = SearchJournal(std::move(record));
    m_journal.onStep = [this](const SearchRecord& now) {
        if (std::chrono::steady_clock::now() - m_written >= betweenWrites) {
            write(now);
        }
    };
    return std::nullopt;
}

void KeptSearch::write(const SearchRecord& record) {
    const std::string text = writeSearchState(m_question, record);
    const auto error = text.size() > mostBytes // the search could not be continued from it
                           ? FileError{utf8(m_file), FileStep::content, 0, {}}
                           : writeFileSafely(m_file, text);
    m_written = std::chrono::steady_clock::now();
    if (error && !m_failed && onFailure) {
        onFailure(*error);
    }
    m_failed = error.has_value();
}

} // namespace sparkout
