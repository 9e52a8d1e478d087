// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTabWidget>

#include <cstddef>
#include <string>
#include <vector>

namespace sparkout {

class LessonDraft;

/// A page of the editor of lessons: its tabs, each for a part of the file.
class LessonPage : public QTabWidget {
    Q_OBJECT

public:
    explicit LessonPage(LessonDraft& draft, QWidget* parent = nullptr);
    LessonPage(LessonDraft& draft, std::size_t step, QWidget* parent = nullptr);

    /// Shows the value at a path, or the nearest widget.
    void goTo(const std::string& path);

signals:
    void checkWanted(); ///< a check of the variants is requested

private:
    void add(QWidget* page, const QString& title, std::vector<std::string> shows);
    [[nodiscard]] QWidget* variants(LessonDraft& draft);
    [[nodiscard]] QWidget* hiddenThings(LessonDraft& draft, std::size_t step);

    std::vector<std::vector<std::string>> m_shown; ///< paths by tab
};

} // namespace sparkout
