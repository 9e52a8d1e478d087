// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/kept_runs.h"

#include "core/file/project_file.h"
#include "core/project/wheel.h"
#include "ui/session/surface_edits.h"
#include "ui/text/example_texts.h"

#include <QDateTime>

#include <algorithm>

namespace sparkout {

namespace {

constexpr EditText keepText{"Edit", QT_TRANSLATE_NOOP("Edit", "Keep the current run")};
constexpr EditText renameText{"Edit", QT_TRANSLATE_NOOP("Edit", "Rename a kept run")};
constexpr EditText deleteText{"Edit", QT_TRANSLATE_NOOP("Edit", "Delete a kept run")};
constexpr EditText restoreText{"Edit",
                               QT_TRANSLATE_NOOP("Edit", "Restore the inputs of a kept run")};

constexpr std::size_t mostRuns = 1000; ///< limit in the table of the project
constexpr std::size_t fileShare = 2;   ///< with indentation, a text may double in length
constexpr std::size_t valuesShare = 2; ///< half is left for the rest of the project

/// Whether a name is free, both in the file and as displayed.
bool isFree(const std::vector<KeptRun>& runs, const std::string& name) {
    const QString shown = runName(name);
    return std::ranges::none_of(
        runs, [&](const KeptRun& run) { return run.name == name || runName(run.name) == shown; });
}

std::string freeName(const std::vector<KeptRun>& runs) {
    for (std::size_t number = runs.size() + 1;; ++number) {
        const std::string name = givenRunName(GivenName::run, QString::number(number));
        if (isFree(runs, name)) {
            return name;
        }
    }
}

/// The wanted name, with a number if a run has it already.
std::string freeName(const std::vector<KeptRun>& runs, const QString& wanted) {
    std::string name = wanted.toStdString();
    for (int number = 2; !isFree(runs, name); ++number) {
        name = QStringLiteral("%1 (%2)").arg(wanted).arg(number).toStdString();
    }
    return name;
}

/// Whether a project file with these runs would be readable, with a margin.
bool fitFile(const std::vector<KeptRun>& runs) {
    std::size_t bytes = 0, values = 0;
    for (const KeptRun& run : runs) {
        for (const std::string* text : {&run.inputs.text, &run.summary.text}) {
            bytes += text->size();
            values += static_cast<std::size_t>(std::ranges::count(*text, ','));
        }
    }
    return runs.size() <= mostRuns && bytes * fileShare < limits::fileBytes
           && values * valuesShare < limits::values;
}

/// Whether it is the same record, whatever its current name.
bool sameRecord(const KeptRun& a, const KeptRun& b) {
    return a.when == b.when && a.inputs == b.inputs && a.summary == b.summary;
}

} // namespace

KeptRuns::KeptRuns(Document& document, QObject* parent) : QObject(parent), m_document(document) {
    connect(&document, &Document::projectReplaced, this, [this] { follow(true); });
    connect(&document, &Document::changed, this, [this] { follow(false); });
    connect(&m_recall, &RunRecall::recalled, this, [this](const std::string& text) {
        for (Entry& entry : m_entries) {
            if (entry.run.inputs.text == text) {
                compare(entry);
            }
        }
        emit runRecalled();
    });
    follow(true);
}

// --- edits --------------------------------------------------------------------------------------

KeptRuns::Kept KeptRuns::keep(const Outcome& outcome, const QString& name) {
    if (!outcome.ran()) {
        return Kept::refused;
    }
    Project project = m_document.project();
    const QString when = QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs);
    project.runs.push_back(
        keptRun(outcome.result, summarise(outcome.result, outcome.accuracy, outcome.constraints),
                name.isEmpty() ? freeName(all()) : freeName(all(), name), when.toStdString()));
    if (!fitFile(project.runs)) {
        return Kept::full;
    }
    m_document.endMerge();
    m_document.edit(std::move(project), keepText);
    return Kept::yes;
}

void KeptRuns::rename(int index, const QString& name) {
    const std::string wanted = name.simplified().toStdString();
    // Drops a name typed for a row that has been removed.
    if (!wanted.empty() && index >= 0 && index < count()) {
        Project project = m_document.project();
        project.runs.at(static_cast<std::size_t>(index)).name = wanted;
        m_document.endMerge();
        m_document.edit(std::move(project), renameText);
    }
}

void KeptRuns::remove(int index) {
    Project project = m_document.project();
    project.runs.erase(project.runs.begin() + index);
    m_document.endMerge();
    m_document.edit(std::move(project), deleteText);
}

bool KeptRuns::restore(int index) {
    const Project* const kept = inputs(index);
    if (!kept) {
        return false;
    }
    Project project = *kept;
    project.runs = all();
    project.measured = m_document.project().measured; // not part of the run
    if (m_document.state().wear.isGiven() && m_document.surface() > 0) {
        // Restores the wheel worn by the earlier surfaces for the run.
        project.wheel->diameter_mm = m_document.project().wheel->diameter_mm;
        project.wheel->dullness = m_document.project().wheel->dullness;
        const auto& dressed = m_document.project().wheel->force_recipe;
        if (auto& recipe = project.wheel->force_recipe; recipe && dressed) {
            recipe->wear_flat_mm = dressed->wear_flat_mm;
        }
    }
    m_document.endMerge();
    m_document.edit(std::move(project), restoreText, {}, Document::Laws::stay);
    return true;
}

// --- chosen and computed runs -------------------------------------------------------------------

std::vector<KeptRuns::Entry> KeptRuns::entriesNow() const {
    const SetupState& state = m_document.state();
    std::vector<Entry> entries;
    for (const KeptRun& run : all()) {
        entries.push_back({run});
    }
    for (std::size_t i = 0; i < state.surfaces.size(); ++i) {
        for (const KeptRun& run : *state.surfaces[i]->runs) {
            if (i != state.present) {
                entries.push_back({run, SurfaceEdits::nameOf(state, i)});
            }
        }
    }
    return entries;
}

/// Chooses the newest run of another document or surface, or the new ones of this one.
void KeptRuns::follow(bool another) {
    std::vector<Entry> now = entriesNow();
    const auto isSame = [](const Entry& a, const Entry& b) {
        return a.run == b.run && a.surface == b.surface;
    };
    if (!another && std::ranges::equal(m_entries, now, isSame)) {
        return;
    }
    std::vector<Entry> before = another ? std::vector<Entry>() : std::move(m_entries);
    m_entries.clear();
    for (Entry& entry : now) {
        const auto known = std::ranges::find_if(before, [&entry](const Entry& each) {
            return sameRecord(each.run, entry.run)
                   && each.surface.isEmpty() == entry.surface.isEmpty();
        });
        if (known != before.end()) {
            known->run = std::move(entry.run);
            known->surface = std::move(entry.surface);
            m_entries.push_back(std::move(*known));
            before.erase(known);
            continue;
        }
        entry.chosen = !another && entry.surface.isEmpty();
        m_entries.push_back(std::move(entry));
        compare(m_entries.back());
    }
    if (another && count() > 0) {
        m_entries[static_cast<std::size_t>(count()) - 1].chosen = true;
    }
    request();
    if (another) {
        emit replaced();
    }
    emit changed();
}

void KeptRuns::request() {
    std::set<std::string> texts, wanted;
    for (const Entry& entry : m_entries) {
        if (entry.chosen || entry.surface.isEmpty()) {
            texts.insert(entry.run.inputs.text);
        }
        if (entry.chosen) {
            wanted.insert(entry.run.inputs.text);
        }
    }
    m_recall.setRuns(std::move(texts), std::move(wanted));
}

void KeptRuns::compare(Entry& entry) {
    const RecalledRun* const now = m_recall.find(entry.run.inputs.text);
    if (now && now->summary) {
        const std::optional<ReadSummary>& kept = summaryOf(entry);
        entry.changed = !kept || !changedSince(*kept, *now->summary).empty();
    }
}

bool KeptRuns::isChosen(int index) const {
    return at(index).chosen;
}

void KeptRuns::choose(int index, bool chosen) {
    if (index < 0 || index >= static_cast<int>(m_entries.size())) {
        return;
    }
    Entry& entry = m_entries.at(static_cast<std::size_t>(index));
    if (entry.chosen != chosen) {
        entry.chosen = chosen;
        request();
        emit changed();
    }
}

const RecalledRun* KeptRuns::recalled(int index) const {
    return m_recall.find(at(index).run.inputs.text);
}

const Project* KeptRuns::inputs(int index) const {
    const Entry& entry = at(index);
    if (!entry.inputs) {
        ReadResult read = readProject(entry.run.inputs.text);
        std::optional<Project>& project = read.project ? read.project : read.unfinished;
        if (project) {
            entry.inputs = std::make_shared<const Project>(std::move(*project));
        }
    }
    return entry.inputs.get();
}

const std::optional<ReadSummary>& KeptRuns::summaryOf(const Entry& entry) {
    if (!entry.read) {
        entry.read = readSummary(entry.run.summary.text);
    }
    return *entry.read;
}

const ReadSummary* KeptRuns::summary(int index) const {
    const std::optional<ReadSummary>& read = summaryOf(at(index));
    return read ? &*read : nullptr;
}

const RecalledRun* RunRecall::find(const std::string& inputs) const {
    const auto found = m_runs.find(inputs);
    return found == m_runs.end() ? nullptr : &found->second;
}

bool RunRecall::isOpen(const std::string& inputs) const {
    const RecalledRun* run = find(inputs);
    return !run || (run->summary && !run->feeds && m_wanted.contains(inputs));
}

void RunRecall::setRuns(std::set<std::string> all, std::set<std::string> wanted) {
    m_all = std::move(all);
    m_wanted = std::move(wanted);
    std::erase_if(m_runs, [this](const auto& run) { return !m_all.contains(run.first); });
    for (auto& [inputs, run] : m_runs) {
        if (!m_wanted.contains(inputs)) {
            run.feeds.reset(); // limits the memory of a hundred kept runs
        }
    }
    std::vector<std::string> open; // drawn ones come first
    std::ranges::copy_if(m_all, std::back_inserter(open),
                         [this](const std::string& inputs) { return isOpen(inputs); });
    std::stable_partition(open.begin(), open.end(),
                          [this](const std::string& inputs) { return m_wanted.contains(inputs); });
    const bool underWay = std::ranges::all_of(
        open, [this](const std::string& inputs) { return m_pending.contains(inputs); });
    if (underWay) {
        return;
    }
    m_pending = {open.begin(), open.end()};
    m_job.start([this, open](const std::stop_token& stop, const NewestJob::Post& post) {
        for (const std::string& inputs : open) {
            RecalledRun run = recallRun(inputs, stop);
            if (stop.stop_requested()) {
                return;
            }
            post([this, inputs, run = std::move(run)] { take(inputs, run); });
        }
    });
}

void RunRecall::take(const std::string& inputs, RecalledRun run) {
    m_pending.erase(inputs);
    if (!m_all.contains(inputs)) {
        return; // deleted meanwhile
    }
    if (!m_wanted.contains(inputs)) {
        run.feeds.reset();
    }
    m_runs[inputs] = std::move(run);
    emit recalled(inputs);
}

} // namespace sparkout
