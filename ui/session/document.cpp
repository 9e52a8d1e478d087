// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/document.h"

#include "core/batch/usual_batch.h"
#include "core/file/project_file.h"
#include "core/project/machine.h"
#include "core/project/member.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/setup/setup.h"
#include "core/study/batch_edits.h"
#include "core/study/new_project.h"
#include "core/study/search_edits.h"
#include "core/study/starting_project.h"
#include "ui/text/example_texts.h"

#include <QCoreApplication>
#include <QUndoCommand>

#include <algorithm>
#include <memory>

namespace sparkout {

namespace {

std::optional<double> numberAt(const Project& project, const std::string& path) {
    const ConstMember member = findMember(project, path);
    return numberIn(*member.field, member.owner);
}

/// The path of a surface among the open inputs of all of them.
std::string placeOf(std::size_t surface) {
    return surface == 0 ? std::string() : surfacePath(surface);
}

constexpr EditText reloadText{"Edit", QT_TRANSLATE_NOOP("Edit", "Reload the file")};

} // namespace

QString EditText::shown() const {
    return QCoreApplication::translate(context, text);
}

Issues newErrors(const Project& before, const Project& after) {
    const Issues known = validate(before);
    Issues issues = validate(after);
    std::erase_if(issues, [&known](const Issue& issue) {
        return issue.severity != Severity::error
               || std::any_of(known.begin(), known.end(), [&issue](const Issue& other) {
                      return other.code == issue.code && other.path == issue.path;
                  });
    });
    return issues;
}

bool breaksRules(const Project& before, const Project& after) {
    return !newErrors(before, after).empty();
}

namespace {

/// Derives the factor of Ra from a measured Ra, as when a document is opened.
SetupState withMeasuredRa(SetupState state) {
    const Wheel& wheel = *state.inFront().project.wheel;
    if (!wheel.measured_ra || wheel.roughness_factor != 1) {
        return state;
    }
    if (const std::optional<double> factor = factorOfMeasuredRa(state.setup())) {
        for (SurfaceStatePtr& surface : state.surfaces) {
            auto made = std::make_shared<SurfaceState>(*surface);
            made->project.wheel->roughness_factor = *factor;
            surface = std::move(made);
        }
    }
    return state;
}

} // namespace

/// One step of the history: the whole value before and after.
class Document::Edit : public QUndoCommand {
public:
    Edit(Document& document, SetupState after, EditText text, QString mergeKey)
        : m_document(document)
        , m_before(document.m_present)
        , m_after(std::move(after))
        , m_text(text)
        , m_mergeKey(std::move(mergeKey)) {}

    [[nodiscard]] const EditText& editText() const { return m_text; }
    [[nodiscard]] const QString& mergeKey() const { return m_mergeKey; }
    /// The surface before the edit; null if it was added by it, or later.
    [[nodiscard]] const SurfaceState* before(int surface) const {
        const auto index = m_before.indexOf(surface);
        return index ? m_before.surfaces[*index].get() : nullptr;
    }

    int id() const override { return m_mergeKey.isEmpty() ? -1 : 1; }
    void undo() override { m_document.setState(m_before); }
    void redo() override { m_document.setState(m_after); }

    bool mergeWith(const QUndoCommand* other) override {
        const auto* next = static_cast<const Edit*>(other);
        if (next->m_mergeKey != m_mergeKey) {
            return false;
        }
        m_after = next->m_after;
        setObsolete(sameState(m_before, m_after));
        return true;
    }

private:
    Document& m_document;
    SetupState m_before;
    SetupState m_after;
    EditText m_text;
    QString m_mergeKey;
};

Document::Document(QObject* parent) : QObject(parent) {
    m_present = stateOf(plainSetup(m_project));
    connect(&m_history, &QUndoStack::indexChanged, this, &Document::historyChanged);
    connect(&m_history, &QUndoStack::cleanChanged, this, &Document::historyChanged);
}

void Document::edit(Project changed, EditText text, const QString& mergeKey, Laws laws) {
    if (sameProject(changed, m_project)) {
        return;
    }
    const Project before = m_present.inFront().project;
    if (changed.wheel->measured_ra != m_project.wheel->measured_ra) {
        changed.wheel->roughness_factor = 1;
    }
    if (changed.wheel->measured_ra && changed.wheel->roughness_factor == 1) {
        changed.wheel->roughness_factor =
            withMeasuredRa(with(changed, openInputs())).inFront().project.wheel->roughness_factor;
    }
    std::vector<std::string> open = openIn(changed);
    const bool starts = isStarting(changed, open);
    const bool makesBatch = starts && hasBatchAsMade(changed);
    const bool movesLaws = laws == Laws::move && !m_gate;
    m_movedLaws = movesLaws && !makesBatch ? moveLawsOf(changed, m_present.inFront(), mergeKey)
                                           : std::vector<FactorKind>();
    if (starts) {
        if (surfaceCount() == 1 && hasWheelAsMade(changed)) {
            changed = withUsualWheel(std::move(changed));
        }
        if (hasPlainShaft(changed) && surfaceCount() == 1) {
            changed = withPlainShaft(std::move(changed));
        }
        StartingCycle start = startingCycleOf(changed).value_or(StartingCycle{.project = changed});
        changed = std::move(start.project);
        if (makesBatch) {
            changed = withUsualBatch(std::move(changed));
        }
        if (openInputs().empty() || !changed.optimisation) { // an existing search stays
            changed = usualSearch(std::move(changed));
        }
        start.project = changed;
        m_started = std::move(start);
    }
    SetupState after = with(std::move(changed), std::move(open));
    if (movesLaws) {
        moveLawsOfOthers(after, mergeKey);
    }
    if (push(std::move(after), text, mergeKey)) {
        emit edited(before);
    }
}

/// Moves the laws of a surface whose inputs an edit changes; none while numbers are to be entered.
std::vector<FactorKind> Document::moveLawsOf(Project& changed, const SurfaceState& present,
                                             const QString& mergeKey) const {
    const SurfaceState* const joined = beforeJoined(present.id, mergeKey);
    const SurfaceState& base = joined ? *joined : present;
    return base.open.empty() ? moveLaws(changed, present.project, base.project)
                             : std::vector<FactorKind>();
}

/// Moves the laws of the other surfaces, whose shared inputs an edit of the current one changes.
void Document::moveLawsOfOthers(SetupState& after, const QString& mergeKey) {
    for (std::size_t i = 0; i < after.surfaces.size(); ++i) {
        if (i != after.present && after.surfaces[i] != m_present.surfaces[i]) {
            auto other = std::make_shared<SurfaceState>(*after.surfaces[i]);
            for (const FactorKind kind :
                 moveLawsOf(other->project, *m_present.surfaces[i], mergeKey)) {
                if (std::ranges::count(m_movedLaws, kind) == 0) {
                    m_movedLaws.push_back(kind);
                }
            }
            after.surfaces[i] = std::move(other);
        }
    }
}

/// Whether the drawing has just become complete, or changes while the cycle made for it is
/// unchanged.
bool Document::isStarting(const Project& changed, const std::vector<std::string>& open) const {
    if (!openInputs().empty()) {
        return open.empty() && m_present.inFront().startsWhenDrawn;
    }
    if (!followsDrawing()) {
        return false;
    }
    const std::string path = firstDifference(m_project, changed);
    const bool isOtherMachine = changed.machine->name != m_project.machine->name;
    return path.starts_with("/part/") || path.starts_with("/material/")
           || path.starts_with("/wheel/") || isOtherMachine;
}

/// Whether its wheel is the one chosen for the project, which is replaced with the cycle.
bool Document::hasWheelAsMade(const Project& changed) const {
    const auto hasWheelOf = [&changed](const Project& made) {
        return firstDifference(made, changed,
                               [](std::string_view path) { return path.starts_with("/wheel"); })
            .empty();
    };
    return hasWheelOf(m_project)
           && hasWheelOf(openInputs().empty() ? withUsualWheel(m_project)
                                              : undrawnProject(m_project.operation));
}

/// Whether its batch is the one created with the project, which is replaced with the cycle.
bool Document::hasBatchAsMade(const Project& changed) const {
    const auto isOf = [&changed](const Project& made) {
        return firstDifference(made, changed,
                               [](std::string_view path) { return path.starts_with("/batch"); })
            .empty();
    };
    return changed.batch
           && ((m_started && isOf(m_started->project)) || isOf(undrawnProject(changed.operation)));
}

void Document::editSetup(SetupState changed, EditText text, const QString& mergeKey) {
    changed = withMeasuredRa(std::move(changed));
    if (!sameState(changed, m_present)) {
        (void)push(std::move(changed), text, mergeKey);
    }
}

void Document::keepElsewhere() {
    m_isKeptElsewhere = true;
    emit historyChanged();
}

bool Document::push(SetupState after, EditText text, const QString& mergeKey) {
    if (m_gate && !m_gate(after)) {
        emit changed();
        return false;
    }
    m_history.push(new Edit(*this, std::move(after), text, roundKey(mergeKey)));
    return true;
}

/// The current value with another current project.
SetupState Document::with(Project changed, std::vector<std::string> open) const {
    SetupState made = m_present;
    const SurfaceState& before = m_present.inFront();
    SurfaceState after = surfaceState(before.id, before.name, std::move(changed), &before);
    after.open = std::move(open);
    after.startsWhenDrawn = before.startsWhenDrawn;
    if (made.surfaces.size() > 1
        && (!haveSameShared(before.project, after.project)
            || !haveSameSharedCalibrations(before.project, after.project))) {
        for (SurfaceStatePtr& surface : made.surfaces) {
            auto other = std::make_shared<SurfaceState>(*surface);
            copyShared(after.project, other->project);
            surface = std::move(other);
        }
    }
    made.surfaces[made.present] = std::make_shared<const SurfaceState>(std::move(after));
    return made;
}

/// A change of operation converts the numbers, which does not count as entering them.
std::vector<std::string> Document::openIn(const Project& changed) const {
    std::vector<std::string> open = openInputs();
    if (changed.operation == m_project.operation) {
        std::erase_if(open, [&](const std::string& path) {
            return numberAt(changed, path) != numberAt(m_project, path);
        });
    }
    return open;
}

bool Document::followsDrawing() const {
    return m_started && openInputs().empty() && sameProject(m_started->project, m_project);
}

const StartingCycle* Document::followingCycle() const {
    return followsDrawing() && m_started->usualDepth_mm > 0 ? &*m_started : nullptr;
}

bool Document::isOpen(const std::string& path) const {
    return std::ranges::find(openInputs(), path) != openInputs().end();
}

Issues Document::newFaults() const {
    const bool isNew = m_started && m_filePath.isEmpty();
    Issues issues = isNew && openInputs().empty() ? machineRefusals(m_project) : Issues();
    for (const std::string& path : openInputs()) {
        const Field& field = *findMember(m_project, path).field;
        issues.push_back(
            {IssueCode::missingKey, Severity::error, path, {}, Bounds{field.stated(), field.unit}});
    }
    return issues;
}

void Document::withdraw(const std::string& path, EditText text) {
    if (isOpen(path)) {
        return;
    }
    Project project = m_project;
    const Member member = findMember(project, path);
    setNumberIn(*member.field, member.owner, numberAt(m_begun, path));
    std::vector<std::string> open = openInputs();
    open.push_back(path);
    const Project before = m_present.inFront().project;
    m_movedLaws.clear();
    if (push(with(std::move(project), std::move(open)), text, QString::fromStdString(path))) {
        emit edited(before);
    }
}

QString Document::roundKey(const QString& mergeKey) const {
    return mergeKey.isEmpty() ? QString() : QString::number(m_mergeRound) + u' ' + mergeKey;
}

Project Document::beforeEditsOf(const QString& mergeKey) const {
    const SurfaceState* before = beforeJoined(m_present.inFront().id, mergeKey);
    return before ? before->withRuns() : m_project;
}

/// A surface before the edits with this key that a further edit would join; null if it joins none.
const SurfaceState* Document::beforeJoined(int surface, const QString& mergeKey) const {
    const Edit* last = editAt(m_history.index() - 1);
    const bool joins = last && !mergeKey.isEmpty() && last->mergeKey() == roundKey(mergeKey);
    return joins ? last->before(surface) : nullptr;
}

void Document::endMerge() {
    ++m_mergeRound;
}

const Document::Edit* Document::editAt(int index) const {
    return static_cast<const Edit*>(m_history.command(index));
}

QString Document::undoText() const {
    const Edit* edit = editAt(m_history.index() - 1);
    return edit ? edit->editText().shown() : QString();
}

QString Document::redoText() const {
    const Edit* edit = editAt(m_history.index());
    return edit ? edit->editText().shown() : QString();
}

void Document::undo() {
    step([this] { m_history.undo(); });
}

void Document::redo() {
    step([this] { m_history.redo(); });
}

void Document::step(const std::function<void()>& step) {
    endMerge();
    const SetupState before = m_present;
    step();
    const auto pathOf = [&before](const SurfaceState& now) {
        const auto index = before.indexOf(now.id);
        return index ? firstDifference(before.surfaces[*index]->project, now.project)
                     : std::string();
    };
    if (before.indexOf(m_present.inFront().id) && pathOf(m_present.inFront()).empty()) {
        // Shows the changed surface, unless the current one has changed.
        for (std::size_t i = 0; i < surfaceCount(); ++i) {
            if (!pathOf(*m_present.surfaces[i]).empty()) {
                showSurface(i);
                break;
            }
        }
    }
    const auto index = before.indexOf(m_present.inFront().id);
    if (!index) {
        return; // the step brought the surface back
    }
    if (const std::string path = firstDifference(before.surfaces[*index]->withRuns(), m_project);
        !path.empty()) {
        emit stepped(path);
    }
}

QStringList Document::unsavedEdits() const {
    QStringList texts;
    const int clean = m_history.cleanIndex();
    if (clean >= 0) { // edits made or undone since
        for (int i = std::min(clean, m_history.index()); i < std::max(clean, m_history.index());
             ++i) {
            texts += editAt(i)->editText().shown();
        }
    }
    texts.removeDuplicates();
    return texts;
}

const Project* Document::lastWith(Operation operation) const {
    if (m_project.operation == operation) {
        return &m_project;
    }
    for (int i = m_history.index() - 1; i >= 0; --i) {
        const SurfaceState* before = editAt(i)->before(m_present.inFront().id);
        if (before && before->project.operation == operation) {
            return &before->project;
        }
    }
    return nullptr;
}

void Document::startUntitled(Project project) {
    startUntitled(plainSetup(std::move(project)));
}

void Document::startUntitled(Setup setup) {
    take(std::move(setup), {}, {}, false);
}

void Document::startIncomplete(Project project, std::vector<std::string> open) {
    SetupState state = stateOf(plainSetup(std::move(project)));
    SurfaceState surface = state.inFront();
    surface.open = std::move(open);
    state.surfaces = {std::make_shared<const SurfaceState>(std::move(surface))};
    replace(std::move(state), {}, {}, false, Kept::onDisk);
}

OpenResult Document::open(const QString& path) {
    LoadedProject loaded = loadProject(path);
    OpenResult result{std::move(loaded.issues), std::move(loaded.error)};
    if (loaded.setup) {
        result.taken = true;
        take(std::move(*loaded.setup), path, loaded.hash, false);
    }
    return result;
}

Issues Document::openCopy(const QByteArray& text) {
    LoadedProject loaded = parseProject({text.constData(), static_cast<std::size_t>(text.size())});
    if (loaded.setup && !hasErrors(loaded.issues)) {
        std::vector<std::pair<std::string, std::string>> names;
        for (GroundSurface& surface : loaded.setup->surfaces) {
            names.emplace_back(surface.project.title, surface.name);
            surface.project.title = exampleTitle(surface.project.title).toStdString();
            surface.name = exampleTitle(surface.name).toStdString();
        }
        startUntitled(std::move(*loaded.setup));
        m_exampleNames = std::move(names);
    }
    return loaded.issues;
}

void Document::nameExample() {
    if (m_exampleNames.size() != surfaceCount() || m_history.count() > 0 || !m_filePath.isEmpty()) {
        return;
    }
    for (std::size_t i = 0; i < surfaceCount(); ++i) {
        auto named = std::make_shared<SurfaceState>(*m_present.surfaces[i]);
        named->project.title = exampleTitle(m_exampleNames[i].first).toStdString();
        named->name = exampleTitle(m_exampleNames[i].second).toStdString();
        m_present.surfaces[i] = std::move(named);
    }
    m_project.title = m_present.inFront().project.title;
    m_begun.title = m_project.title;
    emit changed();
}

std::optional<FileError> Document::save() {
    return saveAs(m_filePath);
}

std::optional<FileError> Document::saveAs(const QString& path) {
    const SavedContent saved = saveContent([this] { return projectText(setup()); }, path);
    if (!saved.error) {
        markSaved(path, saved.hash);
    }
    return saved.error;
}

void Document::markSaved(const QString& path, const QByteArray& hash) {
    const bool wasRefused = !newFaults().empty();
    m_filePath = path;
    m_diskHash = hash;
    m_readOnly = false;
    endMerge();
    m_history.setClean();
    if (wasRefused && newFaults().empty()) {
        emit changed();
    }
    emit saved();
    emit historyChanged();
}

void Document::markUnsaved() {
    m_history.resetClean();
}

/// Surfaces are matched by their place: the runs shared with the history stay shared.
void Document::reload(Setup setup, const QByteArray& hash) {
    endMerge();
    SetupState state = stateOf(std::move(setup));
    for (std::size_t i = 0; i < std::min(state.surfaces.size(), surfaceCount()); ++i) {
        const SurfaceState& now = *m_present.surfaces[i];
        auto known = std::make_shared<SurfaceState>(*state.surfaces[i]);
        known->id = now.id;
        if (*known->runs == *now.runs) {
            known->runs = now.runs;
        }
        state.surfaces[i] = std::move(known);
    }
    state.present = std::min(surface(), state.surfaces.size() - 1);
    editSetup(std::move(state), reloadText);
    m_diskHash = hash;
    m_history.setClean();
}

void Document::take(Setup setup, const QString& path, const QByteArray& hash, bool readOnly) {
    shareCalibrations(setup); // older files have them in one surface
    replace(stateOf(std::move(setup)), path, hash, readOnly, Kept::onDisk);
}

void Document::recover(Setup setup, const QString& path, const QByteArray& hash, bool readOnly,
                       const std::vector<std::string>& open) {
    SetupState state = stateOf(std::move(setup));
    for (std::size_t i = 0; i < state.surfaces.size(); ++i) {
        auto surface = std::make_shared<SurfaceState>(*state.surfaces[i]);
        const std::vector<Leaf> leaves = leavesOf(tableOf<Project>(), &surface->project);
        const std::string place = placeOf(i);
        for (const std::string& each : open) {
            const std::string at = each.starts_with(place) ? each.substr(place.size()) : "";
            const bool isNumber = std::ranges::any_of(leaves, [&at](const Leaf& leaf) {
                return leaf.path == at
                       && (leaf.field->kind == Kind::number || leaf.field->kind == Kind::integer);
            });
            if (isNumber) {
                surface->open.push_back(at);
            }
        }
        state.surfaces[i] = std::move(surface);
    }
    replace(std::move(state), path, hash, readOnly, Kept::nowhere);
}

void Document::replace(SetupState state, const QString& path, const QByteArray& hash, bool readOnly,
                       Kept kept) {
    m_exampleNames.clear();
    m_gate = {};
    m_isKeptElsewhere = false;
    m_history.clear();
    if (kept == Kept::nowhere) {
        m_history.resetClean();
    }
    m_present = std::move(state);
    m_project = m_present.inFront().withRuns();
    m_begun = m_project;
    m_started.reset();
    m_filePath = path;
    m_diskHash = hash;
    m_readOnly = readOnly;
    endMerge();
    emit historyChanged();
    emit replaced();
    emit projectReplaced();
    emit changed();
}

SetupState Document::stateOf(Setup setup) {
    SetupState made;
    shareMeasuredRa(setup);
    for (GroundSurface& surface : setup.surfaces) {
        made.surfaces.push_back(std::make_shared<const SurfaceState>(
            surfaceState(newSurfaceId(), std::move(surface.name), std::move(surface.project))));
    }
    made.times = setup.times;
    made.wear = setup.wear;
    return made;
}

std::vector<std::string> Document::allOpenInputs() const {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < surfaceCount(); ++i) {
        for (const std::string& path : m_present.surfaces[i]->open) {
            all.push_back(placeOf(i) + path);
        }
    }
    return all;
}

void Document::showSurface(std::size_t surface) {
    if (surface == m_present.present) {
        return;
    }
    endMerge();
    SetupState state = m_present;
    state.present = surface;
    setState(state);
}

Setup Document::upToPresent() const {
    Setup made;
    for (std::size_t i = m_present.wear.isGiven() ? 0 : surface(); i <= surface(); ++i) {
        made.surfaces.push_back({m_present.surfaces[i]->name, m_present.surfaces[i]->project});
    }
    made.surfaces.back().project.runs = m_project.runs;
    made.times = m_present.times;
    made.wear = m_present.wear;
    return made;
}

void Document::setState(const SetupState& state) {
    const SurfaceStatePtr before = m_present.surfaces[m_present.present];
    m_present = state;
    const SurfaceState& now = m_present.inFront();
    const bool sameRuns = now.runs == before->runs;
    std::vector<KeptRun> runs = sameRuns ? std::move(m_project.runs) : *now.runs;
    m_project = now.project;
    m_project.runs = std::move(runs);
    if (now.id != before->id) {
        emit projectReplaced();
    }
    emit changed();
}

} // namespace sparkout
