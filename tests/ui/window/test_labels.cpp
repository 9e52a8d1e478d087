// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: own_language
// Every text of the window has room on a small screen, and in a Russian window all are Russian.
#include "core/study/new_project.h"
#include "tests/registry.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/languages.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "tests/whole_project.h"
#include "ui/chart/view.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/kit/font_size.h"
#include "ui/window/dialogs/about_dialog.h"
#include "ui/window/dialogs/examples_dialog.h"
#include "ui/window/view_tabs.h"

#include <QComboBox>
#include <QFileInfo>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTabBar>

namespace sparkout::test_labels {

/// Goes through every view and every page of the inputs; neither takes room from the other.
template <typename Visit>
void everyPlace(Bench& bench, Visit visit) {
    for (View* view : bench.window->views()) {
        bench.window->viewTabs().showView(view);
        bench.settle();
        visit(view->objectName());
    }
    const int pages = static_cast<int>(bench.window->inputs().pages().size());
    for (int page = 0; page < pages; ++page) {
        bench.window->inputs().showPage(page);
        bench.settle();
        visit(QStringLiteral("page %1").arg(page + 1));
    }
}

/// Offenders of many places, each once, with where it was seen first.
class Offenders {
public:
    void add(const QString& place, const QStringList& texts) {
        for (const QString& text : texts) {
            if (!m_seen.contains(text)) {
                m_seen += text;
                m_lines += place + QStringLiteral(": ") + text;
            }
        }
    }
    [[nodiscard]] bool none() const { return m_lines.isEmpty(); }
    [[nodiscard]] QByteArray report() const { return m_lines.join(u'\n').toUtf8(); }

private:
    QStringList m_seen;
    QStringList m_lines;
};

QStringList englishTextsOf(const Bench& bench, const QWidget& window) {
    // The project's own words are not the program's.
    const Project& project = bench.window->document().project();
    const QString file = QFileInfo(bench.window->document().filePath()).fileName();
    QStringList list;
    for (const ShownText& shown : textsOf(window)) {
        QString text = shown.text;
        for (const QString& own :
             {file, QString::fromStdString(project.title), QString::fromStdString(project.notes)}) {
            text.remove(own.isEmpty() ? QStringLiteral("\x01") : own);
        }
        if (!englishIn(text).isEmpty()) {
            list += shown.where + QStringLiteral(": ") + shown.text;
        }
    }
    return list;
}

/// No page of inputs is wider than what is seen of it.
void verifyPagesFit(const QWidget& window, const QString& place) {
    for (const auto* area : window.findChildren<QScrollArea*>()) {
        QVERIFY2(!area->isVisible() || !area->widget()
                     || area->widget()->width() <= area->viewport()->width(),
                 qPrintable(place + u' ' + pathOf(area)));
    }
}

class TestLabels : public QObject {
    Q_OBJECT

private slots:
    void everyVisibleTextHasRoomOnASmallScreen_data() {
        addColumns<QString, QString>("language", "path");
        for (const char* language : {"en", "ru"}) {
            for (const QString& path : filesIn(QString::fromUtf8(language), examplePaths())) {
                QTest::addRow("%s %s", language, qPrintable(nameOf(path)))
                    << QString::fromUtf8(language) << path;
            }
        }
    }

    void everyVisibleTextHasRoomOnASmallScreen() {
        QFETCH(QString, language);
        QFETCH(QString, path);
        OpenBench bench(language, path);
        QCOMPARE(bench.window->size(), QSize(1366, 768)); // nothing asks for more
        Offenders offenders;
        everyPlace(bench, [&](const QString& place) {
            offenders.add(place, textsWithoutRoom(*bench.window));
        });
        QVERIFY2(offenders.none(), offenders.report());
    }

    void everyVisibleTextHasRoomWithLargerType_data() {
        addColumns<QString, int, QSize>("language", "percent", "size");
        for (const char* language : {"en", "ru"}) {
            for (const int percent : fontSizes) {
                const bool smaller = percent < usualFontSize;
                if (percent == usualFontSize
                    || (smaller && !qEnvironmentVariableIsSet("SPARKOUT_LONG"))) {
                    continue; // as above, or with more room
                }
                if (percent < fontSizes.back()) {
                    QTest::addRow("%s %d small", language, percent)
                        << QString::fromUtf8(language) << percent << QSize(1366, 768);
                }
                if (percent == fontSizes.back() || qEnvironmentVariableIsSet("SPARKOUT_LONG")) {
                    QTest::addRow("%s %d large", language, percent)
                        << QString::fromUtf8(language) << percent << QSize(1920, 1080);
                }
            }
        }
    }

    void everyVisibleTextHasRoomWithLargerType() {
        QFETCH(QString, language);
        QFETCH(int, percent);
        QFETCH(QSize, size);
        std::vector<const char*> names{"shaft-30h6-optimal"};
        if (qEnvironmentVariableIsSet("SPARKOUT_LONG")) {
            names.push_back("internal-plunge");
        }
        for (const char* name : names) {
            Bench bench(language);
            bench.window->resize(size);
            QVERIFY(bench.open(examplePath(name)));
            bench.setFontSize(percent);
            QCOMPARE(bench.settings.fontSize(), percent);
            Offenders offenders;
            everyPlace(bench, [&](const QString& place) {
                offenders.add(place, textsWithoutRoom(*bench.window));
            });
            QVERIFY2(offenders.none(), offenders.report());
            QCOMPARE(bench.window->size(), size); // nothing asks for more
        }
    }

    void noPageNeedsScrollingSideways() {
        for (const char* language : {"en", "ru"}) {
            OpenBench bench(QString::fromUtf8(language), examplePaths().front());
            const QTabBar& tabs = *bench.window->findChild<ViewTabs*>()->tabBar();
            QVERIFY2(tabs.tabRect(tabs.count() - 1).right() < tabs.width(), language);
            for (View* view : bench.window->views()) { // by no other name
                const QString tab = tabs.tabText(bench.window->viewTabs().indexOf(view));
                QVERIFY2(view->title().contains(tab, Qt::CaseInsensitive), qPrintable(tab));
            }
            Project project = bench.window->document().project();
            project.cycle->stages.front().radial_feed_mm = 0.00025; // a number of many digits
            bench.window->document().startUntitled(project);
            everyPlace(bench, [&](const QString& place) { verifyPagesFit(*bench.window, place); });
        }
    }

    void refusedInputsHaveRoomForTheirReasons() {
        for (const char* language : {"en", "ru"}) {
            Bench bench(QString::fromUtf8(language));
            Project project = newProject(Operation::traverse);
            project.part->stock_mm = 0.2;
            project.part->diameter_mm = -2;
            project.part->radii_per_section = 35;
            project.cycle->stages.front().radial_feed_mm.reset();
            bench.window->document().startUntitled(project);
            QTRY_VERIFY(bench.window->studies().outcome && !bench.window->studies().outcome->ran());
            Offenders offenders;
            everyPlace(bench, [&](const QString& place) {
                offenders.add(place, textsWithoutRoom(*bench.window));
                verifyPagesFit(*bench.window, place);
            });
            QVERIFY2(offenders.none(), offenders.report());
        }
    }

    void inARussianWindowNoEnglishIsLeft_data() {
        QTest::addColumn<QString>("path");
        for (const QString& path : filesIn(QStringLiteral("ru"), examplePaths())) {
            QTest::addRow("%s", qPrintable(nameOf(path))) << path;
        }
        QTest::newRow("with warnings") << QString();
    }

    void inARussianWindowNoEnglishIsLeft() {
        QFETCH(QString, path);
        Bench bench(QStringLiteral("en"));
        if (path.isEmpty()) {
            Project project = newProject(Operation::plunge);
            project.part->stock_mm = 0.2;
            project.part->diameter_mm = 2;
            bench.window->document().startUntitled(project);
            QTRY_VERIFY(bench.window->studies().outcome != nullptr);
        } else {
            QVERIFY(bench.open(path));
        }
        bench.action("russian")->trigger(); // switched, not started so
        bench.settle();
        QCOMPARE(QLocale().language(), QLocale::Russian);
        Offenders offenders;
        everyPlace(bench, [&](const QString& place) {
            offenders.add(place, englishTextsOf(bench, *bench.window));
        });
        QVERIFY2(offenders.none(), offenders.report());
    }

    void dialogsOfARussianWindowAreRussianAndHaveRoom() {
        const Bench bench(QStringLiteral("ru"));
        ExamplesDialog examples;
        AboutDialog about;
        for (QDialog* dialog : std::initializer_list<QDialog*>{&examples, &about}) {
            dialog->show();
            QTest::qWait(20);
            Offenders offenders;
            offenders.add(dialog->windowTitle(), textsWithoutRoom(*dialog));
            offenders.add(dialog->windowTitle(), englishTextsOf(bench, *dialog));
            QVERIFY2(offenders.none(), offenders.report());
        }
    }

    void theChecksFindWhatTheyLookFor_data() {
        addColumns<int, int>("width", "offenders");
        QTest::newRow("room for all") << 400 << 0;
        QTest::newRow("room for none") << 50 << 6;
    }

    void theChecksFindWhatTheyLookFor() {
        QFETCH(int, width);
        QFETCH(int, offenders);
        const QString text = QStringLiteral("A text of quite some length");
        QWidget window;
        QWidget narrow(&window); // cuts off what stands in it
        narrow.setGeometry(0, 200, width, 60);
        auto* cut = new QLabel(text, &narrow);
        cut->setGeometry(0, 0, 300, 30);
        auto* plain = new QLabel(text, &window);
        auto* rich = new QLabel(QStringLiteral("<b>%1</b>").arg(text), &window);
        auto* button = new QPushButton(text, &window);
        auto* combo = new QComboBox(&window);
        combo->addItem(text);
        auto* box = new QGroupBox(text, &window);
        int y = 0;
        for (QWidget* widget : std::initializer_list<QWidget*>{plain, rich, button, combo, box}) {
            widget->setGeometry(0, y, width, 30);
            y += 32;
        }
        window.resize(500, 300);
        window.show();
        const QStringList found = textsWithoutRoom(window);
        QVERIFY2(found.size() == offenders, qPrintable(found.join(u'\n')));
    }

    void englishWordsAreToldFromNamesAndUnits() {
        QCOMPARE(englishIn(QStringLiteral("Сохранить (Ctrl+S), 5 mm, E1…E5, PNG")), QString());
        QCOMPARE(englishIn(QStringLiteral("Сохранить Save &As")), QStringLiteral("Save"));
        QCOMPARE(englishIn(QStringLiteral("Блок: SSE2, AVX2, AVX-512; Clang 14.0.6")), QString());
    }
};

} // namespace sparkout::test_labels

SPARKOUT_TEST(test_labels, TestLabels)
#include "test_labels.moc"
