// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/lesson/lesson.h"
#include "ui/form/field_editor.h"

#include <QCoreApplication>
#include <QString>
#include <QUndoStack>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace sparkout {

/// A laboratory work while its teacher edits it: the whole lesson, so that what no page shows is
/// kept as it is, its file and its history. A step of the history holds the lesson before and
/// after.
class LessonDraft : public FormModel {
    Q_OBJECT

public:
    explicit LessonDraft(QObject* parent = nullptr);

    /// Starts another lesson; an empty path: it has no file yet.
    void begin(Lesson lesson, const QString& path);
    /// A minimal lesson on a set-up: without texts, with one step that asks for words.
    [[nodiscard]] static Lesson about(Setup base);

    [[nodiscard]] const Lesson& lesson() const { return *m_lesson; }
    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] bool isChanged() const { return !m_history.isClean(); }
    [[nodiscard]] QUndoStack& history() { return m_history; }
    [[nodiscard]] std::string text() const; ///< contents of the draft's file
    /// The errors found by the strict reader of lessons.
    [[nodiscard]] Issues faults() const;
    /// The project to which a path of the lesson refers, as stored in the lesson: a step, a varied
    /// input, a bound of a figure.
    [[nodiscard]] const Project& projectAt(const std::string& path) const;

    /// Changes the lesson; successive changes with the same key are one step of the history.
    void edit(const std::string& key, const std::function<void(Lesson& lesson)>& change);
    [[nodiscard]] const void* ownerOf(const std::string& path) const override;
    void change(const std::string& path, const Change& set, bool merges) override;
    [[nodiscard]] bool hasHistory() const override { return true; }
    void markSaved(const QString& path);

    /// A place of a lesson in words: "Step 2 › Goal › Choice › Option 3".
    [[nodiscard]] static QString location(const std::string& path);

signals:
    void replaced(); ///< another lesson

private:
    using LessonPtr = std::shared_ptr<const Lesson>;
    class Edit;

    LessonPtr m_lesson;
    QString m_path;
    QUndoStack m_history;
};

} // namespace sparkout
