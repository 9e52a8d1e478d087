// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_draft.h"

#include "core/lesson/lesson_file.h"
#include "core/project/member.h"
#include "ui/text/texts.h"

#include <QUndoCommand>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

namespace sparkout {

namespace {

constexpr int stepsOfHistory = 200;

/// The index behind the name of a list, if the path is that of an item.
std::optional<std::size_t> indexAfter(std::string_view list, const std::string& path) {
    return path.starts_with(list)
               ? std::optional(static_cast<std::size_t>(std::atoi(path.c_str() + list.size())))
               : std::nullopt;
}

} // namespace

class LessonDraft::Edit : public QUndoCommand {
public:
    Edit(LessonDraft& draft, std::string key, LessonPtr after)
        : m_draft(draft)
        , m_key(std::move(key))
        , m_before(draft.m_lesson)
        , m_after(std::move(after)) {}

    void undo() override { show(m_before); }
    void redo() override { show(m_after); }
    int id() const override { return m_key.empty() ? -1 : 1; }
    bool mergeWith(const QUndoCommand* next) override {
        const auto* edit = static_cast<const Edit*>(next); // of this id
        if (edit->m_key != m_key) {
            return false;
        }
        m_after = edit->m_after;
        return true;
    }

private:
    void show(const LessonPtr& lesson) {
        m_draft.m_lesson = lesson;
        emit m_draft.changed();
    }

    LessonDraft& m_draft;
    std::string m_key;
    LessonPtr m_before, m_after;
};

LessonDraft::LessonDraft(QObject* parent)
    : FormModel(parent), m_lesson(std::make_shared<const Lesson>()) {
    m_history.setUndoLimit(stepsOfHistory);
}

Lesson LessonDraft::about(Setup base) {
    for (GroundSurface& surface : base.surfaces) {
        surface.project.runs.clear(); // belong to the teacher
    }
    Lesson lesson;
    lesson.base = std::move(base);
    lesson.steps.emplace_back();
    lesson.steps.front().goal.text.emplace();
    return lesson;
}

void LessonDraft::begin(Lesson lesson, const QString& path) {
    m_lesson = std::make_shared<const Lesson>(std::move(lesson));
    m_path = path;
    m_history.clear();
    emit replaced();
}

std::string LessonDraft::text() const {
    return writeLesson(*m_lesson);
}

Issues LessonDraft::faults() const {
    Issues issues = readLesson(text()).issues;
    std::erase_if(issues, [](const Issue& issue) { return issue.severity != Severity::error; });
    return issues;
}

const Project& LessonDraft::projectAt(const std::string& path) const {
    const auto stepOf = [this](int number) { // counted from 1
        const auto& steps = m_lesson->steps;
        const bool isThere = number >= 1 && static_cast<std::size_t>(number) <= steps.size();
        return isThere ? steps[static_cast<std::size_t>(number) - 1].surface : 1;
    };
    int wanted = m_lesson->variants ? m_lesson->variants->surface : 1;
    if (const auto step = indexAfter("/steps/", path)) {
        wanted = stepOf(static_cast<int>(*step) + 1);
    } else if (const auto bound = indexAfter("/variants/figures/", path);
               bound && m_lesson->variants) {
        const auto& figures = m_lesson->variants->figures;
        wanted = *bound < figures.size() ? stepOf(figures[*bound].step) : 1;
    }
    const auto& surfaces = m_lesson->base.surfaces;
    const int last = static_cast<int>(surfaces.size());
    return surfaces[static_cast<std::size_t>(std::clamp(wanted, 1, last)) - 1].project;
}

void LessonDraft::edit(const std::string& key, const std::function<void(Lesson& lesson)>& change) {
    auto after = std::make_shared<Lesson>(*m_lesson);
    change(*after);
    m_history.push(new Edit(*this, key, std::move(after)));
}

const void* LessonDraft::ownerOf(const std::string& path) const {
    return memberIn(tableOf<LessonSheet>(), static_cast<const LessonSheet*>(m_lesson.get()), path)
        .owner;
}

void LessonDraft::change(const std::string& path, const Change& set, bool merges) {
    edit(merges ? path : std::string(), [&](Lesson& lesson) {
        LessonSheet* const sheet = &lesson;
        if (void* const owner = memberIn(tableOf<LessonSheet>(), sheet, path).owner) {
            set(owner);
        }
    });
}

void LessonDraft::markSaved(const QString& path) {
    m_path = path;
    m_history.setClean();
    emit changed();
}

QString LessonDraft::location(const std::string& path) {
    QStringList words;
    const StructInfo* table = &tableOf<LessonSheet>();
    const Field* list = nullptr;
    const QStringList keys = QString::fromStdString(path).split(u'/', Qt::SkipEmptyParts);
    for (qsizetype i = 0; i < keys.size(); ++i) {
        const Field* field = table ? table->find(keys[i].toStdString()) : nullptr;
        bool isIndex = false;
        const int index = keys[i].toInt(&isIndex);
        if (i == 0 && keys[i] == u"project") {
            words += tr("Project");
            words += inputLocation(path.substr(std::string_view("/project").size()));
            break;
        }
        if (isIndex && list && list->nested) {
            words += QStringLiteral("%1 %2").arg(structText(list->nested->name)).arg(index + 1);
        } else if (!field) { // an input, if values of a step break a rule of the project
            words += inputLocation('/' + keys.mid(i).join(u'/').toStdString());
            break;
        } else {
            if (field->kind != Kind::objectList || i + 1 == keys.size()) {
                words += inputText(field->label); // otherwise each names itself
            }
            table = field->nested;
            list = field;
        }
    }
    words.removeAll(QString());
    return words.join(QStringLiteral(" › "));
}

} // namespace sparkout
