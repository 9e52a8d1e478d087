// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"
#include "ui/window/dialogs/report_output.h"

#include <QObject>

#include <vector>

class QLabel;
class QStackedWidget;
class QWidget;

namespace sparkout {

class Actions;
class CycleCursor;
class Document;
class FileCommands;
class InputsPanel;
class LessonDesk;
class LessonEditor;
class MessagesPanel;
class RemedyOffers;
class Settings;
class ViewTabs;
class WindowLayout;

/// Applies a lesson to the window: hides views, panels and commands, locks or hides inputs, and
/// covers the views while a prediction is awaited.
class LessonWiring : public QObject {
    Q_OBJECT

public:
    /// The parts of the window that a lesson affects.
    struct Parts {
        LessonDesk& desk;
        Actions& actions;
        ViewTabs& tabs;
        WindowLayout& layout;
        InputsPanel& inputs;
        MessagesPanel& messages;
        RemedyOffers& remedies;
        FileCommands& files;
        Document& document;
        Settings& settings;
        QWidget* window;
    };

    /// `views` is covered while a prediction is awaited.
    LessonWiring(QWidget* views, QObject* parent);

    [[nodiscard]] QWidget* middle() const; ///< the views, or their cover
    void connectTo(const Parts& parts);
    void retranslate();
    [[nodiscard]] bool mayClose(); ///< asks to save or discard an edited lesson

    /// Moves to the moment that a step shows.
    static void goTo(CycleCursor& cursor, const ShownMoment& moment);

private:
    void enter(const Parts& parts);
    void enterViews(const Parts& parts);
    void apply(const Parts& parts);
    void connectPapers(const Parts& parts);
    void edit(const Parts& parts);
    void openEditor(const Parts& parts); ///< for the first time
    void connectPapersOfEditor(Settings& settings);
    void namePapersOfEditor() const;

    QStackedWidget* m_middle;
    QLabel* m_cover;
    LessonEditor* m_editor = nullptr;    ///< created on request
    std::vector<ReportActions> m_papers; ///< for the editor, in the order of their table
};

} // namespace sparkout
