// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QList>

#include <cstddef>

class QAction;
class QTabBar;
class QToolButton;

namespace sparkout {

class Document;
class PartDrawing;
class PartRuns;

/// The surfaces of the set-up above the views: the part drawn to scale, and a tab for each surface
/// in the order of grinding with its light. Shown for several surfaces.
class PartStrip : public QFrame {
    Q_OBJECT

public:
    PartStrip(Document& document, const PartRuns& runs, QWidget* parent = nullptr);

    void setActions(const QList<QAction*>& actions); ///< actions of the menu at its end
    void retranslate();
    void follow();                ///< the document
    void tellResults(bool tells); ///< lights, margins and times, or only names
    [[nodiscard]] QTabBar& tabs() { return *m_tabs; }
    [[nodiscard]] PartDrawing& drawing() { return *m_drawing; }

signals:
    void surfaceWanted(std::size_t surface);
    void surfaceOnStepWanted(std::size_t step);
    void wholePartWanted();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showStatuses();
    void nameTabs(); ///< full names if they fit, otherwise numbers
    [[nodiscard]] QString tip(std::size_t surface) const;

    Document& m_document;
    const PartRuns& m_runs;
    PartDrawing* m_drawing;
    QTabBar* m_tabs;
    QToolButton* m_whole; ///< time and verdict of the part
    QToolButton* m_menu;
    bool m_following = false;
    bool m_tells = true; ///< shows results
};

} // namespace sparkout
