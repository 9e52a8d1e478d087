// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/lesson_run.h"

#include "core/file/project_file.h"
#include "core/setup/setup_file.h"
#include "ui/session/project_io.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

std::string presentMoment() {
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

bool isNoAnswer(const Answer& answer) {
    return answer == Answer{};
}

} // namespace

LessonRun::LessonRun(QObject* parent) : QObject(parent) {}

LessonRun::~LessonRun() {
    m_job.stop();
    m_disk.wait();
}

Project LessonRun::projectOf(std::size_t step) const {
    Setup setup = setupOf(lesson(), step);
    return std::move(
        setup.surfaces[static_cast<std::size_t>(lesson().steps[step].surface) - 1].project);
}

void LessonRun::start(Work work, const QString& file, bool isSaved) {
    m_job.stop();
    m_disk.wait();
    m_work = std::move(work);
    m_file = file;
    m_drafts.clear();
    m_results.clear();
    m_savedEntries = isSaved ? std::optional(m_work->entries.size()) : std::nullopt;
    m_step = 0;
    while (m_step + 1 < lesson().steps.size() && record(m_step).answer) {
        ++m_step;
    }
    readDraft();
    check();
    emit started();
}

void LessonRun::end() {
    if (m_work) {
        writeDraft();
        m_disk.wait();
        m_job.stop();
        m_work.reset();
        m_drafts.clear();
        m_results.clear();
        emit ended();
    }
}

void LessonRun::show(std::size_t step) {
    m_step = step;
    writeDraft();
}

StepRecord LessonRun::record(std::size_t step) const {
    return recordOf(*m_work, step);
}

bool LessonRun::isCovered() const {
    return m_work && isPrediction(current().goal) && !record(m_step).answer;
}

std::vector<std::size_t> LessonRun::openPredictions() const {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < lesson().steps.size(); ++i) {
        const LessonStep& step = lesson().steps[i];
        if (i != m_step && isPrediction(step.goal) && step.surface == current().surface
            && step.values == current().values && !record(i).answer) {
            open.push_back(i);
        }
    }
    return open;
}

const GoalResult* LessonRun::result(std::size_t step) const {
    const auto found = m_results.find(step);
    return found == m_results.end() ? nullptr : &found->second;
}

LessonRun::Mark LessonRun::mark(std::size_t step) const {
    if (!record(step).answer) {
        return Mark::open;
    }
    const GoalResult* const found = result(step);
    if (!found) {
        return Mark::checked;
    }
    return found->passed()                          ? Mark::passed
           : found->finding == Finding::forTeacher  ? Mark::teacher
           : found->finding == Finding::notAnswered ? Mark::open
                                                    : Mark::failed;
}

double LessonRun::pointsOf(std::size_t step) const {
    const StepRecord now = record(step);
    const LessonStep& of = lesson().steps[step];
    return mark(step) == Mark::passed && !now.isPredictedLate
               ? std::max(of.points - priceOf(of, now), 0.0)
               : 0;
}

double LessonRun::points() const {
    double sum = 0;
    for (std::size_t i = 0; i < lesson().steps.size(); ++i) {
        sum += pointsOf(i);
    }
    return sum;
}

bool LessonRun::isFull() const {
    return m_work->entries.size() >= limits::workEntries;
}

void LessonRun::add(WorkEntry entry) {
    entry.step = static_cast<int>(m_step) + 1;
    entry.when = presentMoment();
    addEntry(*m_work, std::move(entry));
    writeDraft();
}

void LessonRun::handIn(Answer answer) {
    if (isFull()) {
        return;
    }
    const bool predicts = isPrediction(current().goal);
    if (predicts && record(m_step).answer) {
        return; // the first one counts
    }
    WorkEntry entry;
    entry.event = predicts ? WorkEvent::prediction : WorkEvent::attempt;
    entry.answer = std::move(answer);
    m_drafts.erase(m_step);
    m_results.erase(m_step);
    add(std::move(entry));
    check();
    emit answered();
    emit changed();
    emit saveWanted();
}

void LessonRun::takeHint() {
    const std::size_t taken = record(m_step).hints.size();
    if (isFull() || taken >= current().hints.size()) {
        return;
    }
    WorkEntry entry;
    entry.event = WorkEvent::hint;
    entry.hint = static_cast<int>(taken) + 1;
    add(std::move(entry));
    emit changed();
    emit saveWanted();
}

void LessonRun::keepRun(const KeptRun& run) {
    if (isFull() || isCovered()) {
        return;
    }
    WorkEntry entry;
    entry.event = WorkEvent::run;
    entry.run = run;
    add(std::move(entry));
    emit changed();
    emit saveWanted();
}

void LessonRun::setDraft(Answer draft) {
    const auto known = m_drafts.find(m_step);
    if (known == m_drafts.end() ? isNoAnswer(draft) : known->second == draft) {
        return;
    }
    m_drafts[m_step] = std::move(draft);
    writeDraft();
}

const Answer* LessonRun::draft(std::size_t step) const {
    const auto found = m_drafts.find(step);
    return found == m_drafts.end() ? nullptr : &found->second;
}

/// Includes the runs kept in the work.
Setup LessonRun::setupFor(std::size_t step) const {
    Setup setup = settingsFor(step);
    Project& project =
        setup.surfaces[static_cast<std::size_t>(lesson().steps[step].surface) - 1].project;
    project.runs.clear();
    for (const WorkEntry& entry : m_work->entries) {
        if (entry.run) {
            project.runs.push_back(*entry.run);
        }
    }
    return setup;
}

Setup LessonRun::settingsFor(std::size_t step) const {
    const Answer* const draft = this->draft(step);
    const std::optional<Answer> handedIn = record(step).answer;
    for (const Answer* each : {draft, handedIn ? &*handedIn : nullptr}) {
        if (each && each->hasSetup()) {
            ReadSetup read = readSetup(each->setup.text);
            if (read.setup && forbiddenChanges(lesson(), step, *read.setup).empty()) {
                return std::move(*read.setup);
            }
        }
    }
    return setupOf(lesson(), step);
}

/// Checks each answer that counts and was not checked yet.
void LessonRun::check() {
    std::vector<std::pair<std::size_t, Answer>> open;
    for (std::size_t i = 0; i < lesson().steps.size(); ++i) {
        if (const auto answer = record(i).answer; answer && !result(i)) {
            open.emplace_back(i, *answer);
        }
    }
    if (open.empty()) {
        return;
    }
    m_job.start([this, open = std::move(open), lesson = lesson()](const std::stop_token& stop,
                                                                  const NewestJob::Post& post) {
        for (const auto& [step, answer] : open) {
            GoalResult result = checkStep(lesson, step, answer, stop);
            if (stop.stop_requested()) {
                return;
            }
            post([this, at = step, result = std::move(result)] {
                m_results[at] = result;
                emit changed();
            });
        }
    });
}

void LessonRun::markSaved(const QString& file, std::size_t entries) {
    const bool isAnother = file != m_file;
    m_file = file;
    m_savedEntries = entries;
    if (isAnother) {
        writeDraft();
    }
}

void LessonRun::flush() {
    if (m_work) {
        writeDraft();
    }
    m_disk.wait();
}

QString LessonRun::draftFile() const {
    const QByteArray path = QFileInfo(m_file).absoluteFilePath().toUtf8();
    return m_draftFolder + u'/'
           + QString::fromLatin1(
               contentHash({path.constData(), std::size_t(path.size())}).toHex().left(40))
           + QStringLiteral(".sparkout-work");
}

/// Writes the work with the answers not handed in as further entries, that of the current step
/// last.
void LessonRun::writeDraft() {
    if (m_draftFolder.isEmpty()) {
        return;
    }
    Work draft = *m_work;
    const auto put = [&](std::size_t step, const Answer& answer) {
        WorkEntry entry;
        entry.step = static_cast<int>(step) + 1;
        entry.when = presentMoment();
        entry.answer = answer;
        addEntry(draft, std::move(entry));
    };
    for (const auto& [step, answer] : m_drafts) {
        if (step != m_step) {
            put(step, answer);
        }
    }
    const auto front = m_drafts.find(m_step);
    put(m_step, front == m_drafts.end() ? Answer() : front->second);
    m_disk.start([draft = std::move(draft), file = draftFile(), folder = m_draftFolder] {
        if (QDir().mkpath(folder)) { // a failure here loses only typed text
            (void)writeFileSafely(systemPath(file), writeWork(draft));
        }
        return Background::Answer([] {});
    });
}

void LessonRun::readDraft() {
    if (m_draftFolder.isEmpty() || !QFileInfo::exists(draftFile())) {
        return;
    }
    auto text = readFile(systemPath(draftFile()), limits::fileBytes);
    const auto* const content = std::get_if<std::string>(&text);
    ReadWork read = content ? readWork(*content) : ReadWork();
    if (!read.work || read.work->sha256 != m_work->sha256
        || read.work->entries.size() <= m_work->entries.size() || brokenSeal(*read.work)) {
        return;
    }
    const std::size_t known = m_work->entries.size();
    if (known > 0 && read.work->entries[known - 1].sha256 != m_work->entries.back().sha256) {
        return; // another course of the work
    }
    for (std::size_t i = known; i < read.work->entries.size(); ++i) {
        WorkEntry& entry = read.work->entries[i];
        m_step = static_cast<std::size_t>(entry.step) - 1;
        if (!isNoAnswer(entry.answer)) {
            m_drafts[m_step] = std::move(entry.answer);
        }
    }
}

} // namespace sparkout
