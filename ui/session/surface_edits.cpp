// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/surface_edits.h"

#include "core/setup/setup.h"

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr EditText addSurfaceText{"Edit", QT_TRANSLATE_NOOP("Edit", "Add a surface")};
constexpr EditText duplicateSurfaceText{"Edit", QT_TRANSLATE_NOOP("Edit", "Duplicate a surface")};
constexpr EditText renameSurfaceText{"Edit", QT_TRANSLATE_NOOP("Edit", "Rename a surface")};
constexpr EditText removeSurfaceText{"Edit", QT_TRANSLATE_NOOP("Edit", "Remove a surface")};
constexpr EditText moveSurfaceText{"Edit", QT_TRANSLATE_NOOP("Edit", "Move a surface")};
constexpr EditText standardTimesText{"Edit", QT_TRANSLATE_NOOP("Edit", "Standard times")};
constexpr EditText wheelWearText{"Edit", QT_TRANSLATE_NOOP("Edit", "Wheel wear")};

SurfaceStatePtr renamedSurface(const SurfaceState& surface, std::string name) {
    auto made = std::make_shared<SurfaceState>(surface);
    made->name = std::move(name);
    return made;
}

} // namespace

bool SurfaceEdits::canAdd() const {
    return m_document.surfaceCount() < limits::surfaces;
}

bool SurfaceEdits::canMove(int by) const {
    const auto to = static_cast<std::ptrdiff_t>(m_document.surface()) + by;
    return to >= 0 && to < static_cast<std::ptrdiff_t>(m_document.surfaceCount());
}

bool SurfaceEdits::isFreeName(const QString& name, std::size_t of) const {
    const std::string wanted = name.simplified().toStdString();
    const auto& surfaces = m_document.state().surfaces;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (i != of && nameOf(m_document.state(), i).toStdString() == wanted) {
            return false;
        }
    }
    return !wanted.empty();
}

QString SurfaceEdits::freeName() const {
    for (std::size_t number = m_document.surfaceCount() + 1;; ++number) {
        const QString name = tr("Surface %1").arg(number);
        if (isFreeName(name, m_document.surfaceCount())) {
            return name;
        }
    }
}

QString SurfaceEdits::nameOf(const SetupState& state, std::size_t surface) {
    const std::string& name = state.surfaces[surface]->name;
    return name.empty() ? tr("Surface %1").arg(surface + 1) : QString::fromStdString(name);
}

void SurfaceEdits::add(Project project, const QString& name, std::vector<std::string> open,
                       bool startsWhenDrawn, bool isDuplicate) {
    copyShared(m_document.project(), project);
    project.runs.clear();
    SurfaceState made = surfaceState(m_document.newSurfaceId(), name.simplified().toStdString(),
                                     std::move(project));
    made.open = std::move(open);
    made.startsWhenDrawn = startsWhenDrawn;
    insert(std::move(made), isDuplicate ? duplicateSurfaceText : addSurfaceText);
}

void SurfaceEdits::insert(SurfaceState surface, const EditText& text) {
    if (!canAdd()) {
        return;
    }
    SetupState state = m_document.state();
    for (std::size_t i = 0; i < state.surfaces.size(); ++i) {
        if (state.surfaces[i]->name.empty()) {
            state.surfaces[i] = renamedSurface(*state.surfaces[i], nameOf(state, i).toStdString());
        }
    }
    ++state.present;
    state.surfaces.insert(state.surfaces.begin() + static_cast<std::ptrdiff_t>(state.present),
                          std::make_shared<const SurfaceState>(std::move(surface)));
    m_document.endMerge();
    m_document.editSetup(std::move(state), text);
}

bool SurfaceEdits::rename(std::size_t surface, const QString& name) {
    if (!isFreeName(name, surface)) {
        return false;
    }
    SetupState state = m_document.state();
    state.surfaces[surface] =
        renamedSurface(*state.surfaces[surface], name.simplified().toStdString());
    m_document.endMerge();
    m_document.editSetup(std::move(state), renameSurfaceText);
    return true;
}

/// A single remaining surface needs no name: its file is that of one surface.
void SurfaceEdits::remove() {
    if (!canRemove()) {
        return;
    }
    SetupState state = m_document.state();
    state.surfaces.erase(state.surfaces.begin() + static_cast<std::ptrdiff_t>(state.present));
    state.present = std::min(state.present, state.surfaces.size() - 1);
    if (state.surfaces.size() == 1) {
        state.surfaces.front() = renamedSurface(*state.surfaces.front(), {});
    }
    m_document.endMerge();
    m_document.editSetup(std::move(state), removeSurfaceText);
}

void SurfaceEdits::move(int by) {
    if (!canMove(by)) {
        return;
    }
    SetupState state = m_document.state();
    const auto to = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(state.present) + by);
    std::swap(state.surfaces[state.present], state.surfaces[to]);
    state.present = to;
    m_document.endMerge();
    m_document.editSetup(std::move(state), moveSurfaceText);
}

void SurfaceEdits::setTimes(const SetupTimes& times, const WheelWear& wear) {
    SetupState state = m_document.state();
    const EditText text = state.wear == wear ? standardTimesText : wheelWearText;
    state.times = times;
    state.wear = wear;
    m_document.endMerge();
    m_document.editSetup(std::move(state), text);
}

} // namespace sparkout
