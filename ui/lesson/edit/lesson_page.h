// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTabWidget>

#include <cstddef>
#include <string>
#include <vector>

namespace sparkout {

class LessonDraft;

/// A page of the editor of lessons: its tabs, by the part of the file that each of them shows.
class LessonPage : public QTabWidget {
    Q_OBJECT

public:
    /// Of the work as a whole.
    explicit LessonPage(LessonDraft& draft, QWidget* parent = nullptr);
    /// Of one of its steps.
    LessonPage(LessonDraft& draft, std::size_t step, QWidget* parent = nullptr);

    /// To the value at a path, or as near to it as there is a widget.
    void goTo(const std::string& path);

signals:
    void checkWanted(); ///< of the variants

private:
    void add(QWidget* page, const QString& title, std::vector<std::string> shows);
    [[nodiscard]] QWidget* variants(LessonDraft& draft);
    [[nodiscard]] QWidget* hiddenThings(LessonDraft& draft, std::size_t step);

    std::vector<std::vector<std::string>> m_shown; ///< paths by tab
};

} // namespace sparkout
