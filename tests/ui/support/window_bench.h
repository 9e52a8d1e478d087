// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the whole window share.
#pragma once

#include "ui/kit/theme.h"
#include "ui/window/main_window.h"

#include <QDockWidget>
#include <QTest>

#include <memory>

namespace sparkout {

/// Paths of all shipped examples, in order.
[[nodiscard]] QStringList examplePaths();
[[nodiscard]] QString nameOf(const QString& path); ///< of a file, without its ending

/// A window as a user with a small laptop has it.
struct Bench {
    explicit Bench(const QString& language, Theme theme = Theme::light,
                   RunController::Runner runner = evaluate);
    ~Bench(); ///< goes back to the usual size of the font

    /// Opens a project and waits until the views have drawn its outcome; false when they do not.
    [[nodiscard]] bool open(const QString& path);
    [[nodiscard]] QAction* action(const char* name) const;   ///< of the menus, by object name
    [[nodiscard]] QDockWidget& dock(const char* name) const; ///< a panel, by object name
    void settle() const; ///< queued layouts, replots and repaints
    void rest() const;   ///< also what is laid out a moment later
    void resize(int width, int height) const;
    void setFontSize(int percent) const;                   ///< by the menu
    void drag(const QPoint& from, const QPoint& by) const; ///< what parts the panels

    Settings settings;
    Language language;
    std::unique_ptr<MainWindow> window;
};

/// Such a window with a project.
struct OpenBench : Bench {
    OpenBench(const QString& code, const QString& path) : Bench(code) { QVERIFY(open(path)); }
};

/// Collects what Qt warns of while it lives, except what the offscreen platform says about itself.
class WarningCatcher {
public:
    WarningCatcher();
    ~WarningCatcher();
    [[nodiscard]] QStringList take(); ///< what was warned of since the last time
};

} // namespace sparkout
