// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/window_bench.h"

#include "ui/kit/font_size.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTest>

#include <mutex>

namespace sparkout {

namespace {

std::mutex warningsMutex;
QStringList warnings;
QtMessageHandler before = nullptr;

bool aboutThePlatform(const QString& text) {
    return text.contains(QStringLiteral("This plugin does not support"))
           || text.contains(QStringLiteral("XDG_RUNTIME_DIR"));
}

void collect(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if (aboutThePlatform(text)) {
        return; // hundreds of them would hide what matters
    }
    if (type != QtDebugMsg && type != QtInfoMsg) {
        const std::lock_guard lock(warningsMutex);
        warnings += text;
    }
    before(type, context, text);
}

} // namespace

QStringList examplePaths() {
    const QDir folder(QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/examples"));
    QStringList paths;
    for (const QString& name : folder.entryList({QStringLiteral("*.sparkout")}, QDir::Files)) {
        paths += folder.filePath(name);
    }
    return paths;
}

QString nameOf(const QString& path) {
    return QFileInfo(path).completeBaseName();
}

Bench::Bench(const QString& code, Theme theme, RunController::Runner runner)
    : settings(Settings::transient()) {
    settings.setTheme(themeCode(theme));
    applyTheme(theme);
    language.apply(code);
    window = std::make_unique<MainWindow>(settings, language, std::move(runner));
    window->resize(1366, 768);
    window->show();
    window->activateWindow();
}

Bench::~Bench() {
    window.reset();
    applyFontSize(usualFontSize);
}

bool Bench::open(const QString& path) {
    QSignalSpy shown(window.get(), &MainWindow::outcomeShown);
    if (!window->document().open(path).opened()) {
        return false;
    }
    const bool came =
        QTest::qWaitFor([&] { return shown.count() > 0 && !window->runs().running(); }, 120'000);
    settle();
    return came;
}

QAction* Bench::action(const char* name) const {
    return window->findChild<QAction*>(QString::fromUtf8(name));
}

void Bench::settle() const {
    for (int i = 0; i < 6; ++i) {
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
    }
}

void Bench::rest() const {
    settle();
    QTest::qWait(60);
    settle();
}

QDockWidget& Bench::dock(const char* name) const {
    return *window->findChild<QDockWidget*>(QString::fromUtf8(name));
}

void Bench::resize(int width, int height) const {
    window->resize(width, height);
    rest();
}

void Bench::setFontSize(int percent) const {
    action(("fontSize-" + QByteArray::number(percent)).constData())->trigger();
    rest();
}

void Bench::drag(const QPoint& from, const QPoint& by) const {
    QTest::mousePress(window.get(), Qt::LeftButton, {}, from);
    QTest::mouseMove(window.get(), from + by);
    settle();
    QTest::mouseRelease(window.get(), Qt::LeftButton, {}, from + by);
    rest();
}

WarningCatcher::WarningCatcher() {
    before = qInstallMessageHandler(collect);
}

WarningCatcher::~WarningCatcher() {
    qInstallMessageHandler(before);
}

QStringList WarningCatcher::take() {
    const std::lock_guard lock(warningsMutex);
    return std::exchange(warnings, {});
}

} // namespace sparkout
