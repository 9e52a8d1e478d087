// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QTextBrowser;

namespace sparkout {

class LessonDraft;

/// A text of the lesson as shown to students, in a chosen language.
class TextPreview : public QWidget {
    Q_OBJECT

public:
    using TextOf = std::function<Bilingual(const Lesson& lesson)>;
    TextPreview(LessonDraft& draft, TextOf text, QWidget* parent = nullptr);

private:
    void show();

    LessonDraft& m_draft;
    TextOf m_text;
    QComboBox* m_language;
    QTextBrowser* m_shown;
};

} // namespace sparkout
