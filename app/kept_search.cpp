// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kept_search.h"

#include "app/io/cli_io.h"
#include "core/printable.h"

#include <cerrno>
#include <cstddef>
#include <utility>
#include <variant>

namespace sparkout::cli {

namespace {

using namespace std::chrono_literals;

constexpr auto interval = 1s;
constexpr std::size_t mostBytes = std::size_t{1} << 20;

std::string refusalOf(const ReadSearchState& read, const SearchQuestion& asked) {
    switch (read.fault) {
    case SearchStateFault::none: break;
    case SearchStateFault::otherFormat: return "is no progress of a search, and stays as it is";
    case SearchStateFault::otherVersion:
        return "is the progress of a search by another version of this program";
    case SearchStateFault::changed:
        return "is damaged: its checksum is not that of its contents; delete it to begin anew";
    case SearchStateFault::badValue:
        return "is damaged: " + printable(read.value.path) + ": " + printable(read.value.found)
               + "; allowed: " + read.value.least + "…" + read.value.most
               + "; delete it to begin anew";
    case SearchStateFault::otherEngine:
        return "is the progress of a search by another build of this program, "
               + printable(read.question.engine) + "; this one is " + asked.engine;
    case SearchStateFault::otherProject: return "is the progress of a search of another project";
    case SearchStateFault::otherOptions:
        return "is the progress of a search with other options, " + printable(read.question.options)
               + "; these are " + asked.options;
    }
    return {};
}

} // namespace

int KeptSearch::open(const SearchQuestion& question) {
    m_question = question;
    SearchRecord record;
    const auto text = readFile(m_file, mostBytes);
    const auto* const error = std::get_if<FileError>(&text);
    if (error && error->systemError != ENOENT) {
        print(stderr, describe(*error));
        return refused;
    }
    if (!error) {
        ReadSearchState read = readSearchState(std::get<std::string>(text), question);
        if (read.fault != SearchStateFault::none) {
            print(stderr, printable(m_file) + ": " + refusalOf(read, question) + '\n');
            return refused;
        }
        record = std::move(read.record);
    }
    // What cannot be kept is said before the search, not after it.
    if (const int failed = save(m_file, writeSearchState(question, record))) {
        return failed;
    }
    m_written = std::chrono::steady_clock::now();
    m_journal.emplace(std::move(record));
    m_journal->onStep = [this](const SearchRecord& now) {
        if (std::chrono::steady_clock::now() - m_written >= interval) {
            write(now);
        }
    };
    return done;
}

void KeptSearch::write(const SearchRecord& record) {
    const std::string text = writeSearchState(m_question, record);
    const auto error = text.size() > mostBytes // it could not be gone on from
                           ? FileError{m_file, FileStep::content, 0, {}}
                           : writeFileSafely(m_file, text);
    m_written = std::chrono::steady_clock::now();
    if (error && !m_failed) {
        print(stderr, "the progress is not kept: " + describe(*error));
    }
    m_failed = error.has_value();
}

void KeptSearch::close() {
    if (m_journal && m_journal->hasRefused()) {
        print(stderr, printable(m_file)
                          + ": a cycle in it is not of this search, or does not take the time "
                            "that stands there; that search was made anew\n");
    }
    if (m_journal) {
        write(m_journal->record());
    }
}

} // namespace sparkout::cli
