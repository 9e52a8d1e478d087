// SPDX-License-Identifier: GPL-3.0-or-later
// F1 tells of every input and every view, in both languages, and no link of the help is dead.
#include "core/lesson/lesson.h"
#include "core/project/project.h"
#include "tests/registry.h"
#include "tests/ui/support/languages.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/view.h"
#include "ui/help/help_book.h"
#include "ui/help/help_window.h"
#include "ui/inputs/hint_strip.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/kit/help_topic.h"
#include "ui/text/hint_text.h"
#include "ui/text/texts.h"
#include "ui/window/dialogs/examples_dialog.h"
#include "ui/window/help_desk.h"
#include "ui/window/view_tabs.h"

#include <QAction>
#include <QDockWidget>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSet>
#include <QTextBlock>
#include <QTextBrowser>

#include <functional>
#include <map>
#include <set>

namespace sparkout::test_help {

constexpr int patience_ms = 60'000; ///< with a window that comes to the front on a busy machine

/// Every row of every table, by a walk of its own.
void everyField(const StructInfo& table, std::set<const StructInfo*>& seen,
                const std::function<void(const Field&)>& visit) {
    if (!seen.insert(&table).second) {
        return;
    }
    for (const Field& field : table.fields) {
        visit(field);
        if (field.nested) {
            everyField(*field.nested, seen, visit);
        }
    }
}

/// Anchors a page really has, as a browser finds them.
QStringList anchorsOf(const HelpPage& page) {
    static const QRegularExpression name(QStringLiteral("<a name=\"([^\"]+)\""));
    QStringList anchors;
    for (auto it = name.globalMatch(page.html); it.hasNext();) {
        anchors += it.next().captured(1);
    }
    return anchors;
}

bool leadsSomewhere(const HelpBook& book, const QString& topic) {
    const HelpPage* page = book.find(topic.section(u'#', 0, 0));
    const QString anchor = topic.section(u'#', 1);
    return page && (anchor.isEmpty() || anchorsOf(*page).contains(anchor));
}

/// A page without what is no prose: code, names of works, formula symbols.
QString proseOf(QString html) {
    static const QRegularExpression other(QStringLiteral("<(code|pre|cite|var)\\b[^>]*>.*?</\\1>"),
                                          QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression tags(QStringLiteral("<su[bp]>.*?</su[bp]>|<[^>]*>"));
    return html.replace(other, QStringLiteral(" ")).replace(tags, QStringLiteral(" "));
}

HelpWindow* helpOf(const Bench& bench) {
    return bench.window->help().helpWindow();
}

/// Presses F1 in the window and says which topic came up.
QString topicByF1(Bench& bench, QWidget& widget) {
    widget.window()->activateWindow();
    if (!QTest::qWaitForWindowActive(widget.window(), patience_ms)) {
        return QStringLiteral("not active");
    }
    widget.setFocus();
    QTest::keyClick(&widget, Qt::Key_F1);
    return helpOf(bench) ? helpOf(bench)->topic() : QStringLiteral("no help");
}

class TestHelp : public QObject {
    Q_OBJECT

private slots:
    void everyInputOfTheTablesIsDescribed_data() { addLanguages(); }

    void everyInputOfTheTablesIsDescribed() {
        QFETCH(QString, language);
        Language spoken;
        spoken.apply(language);
        const HelpBook book{QString()};
        std::set<const StructInfo*> seen;
        int fields = 0;
        everyField(tableOf<Project>(), seen, [&](const Field& field) {
            const QString topic = fieldTopic(field);
            QVERIFY2(topic.contains(u'#') && leadsSomewhere(book, topic), field.key);
            const HelpPage& page = *book.find(topic.section(u'#', 0, 0));
            const auto section =
                std::ranges::find(page.sections, topic.section(u'#', 1), &HelpSection::anchor);
            QVERIFY(section != page.sections.end());
            QVERIFY2(section->title.startsWith(inputText(field.label).simplified()),
                     qPrintable(section->title));
            const QString hint = withIndices(inputText(field.hint)).section(u'`', 0, 0);
            QVERIFY2(page.html.contains(hint), qPrintable(hint));
            ++fields;
        });
        QVERIFY(fields > 120);
    }

    void f1OnAFieldTellsOfIt_data() { addLanguages(); }

    void f1OnAFieldTellsOfIt() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePaths().front());
        std::set<const Field*> told;
        const auto& pages = bench.window->inputs().pages();
        for (std::size_t i = 0; i < pages.size(); ++i) {
            bench.window->inputs().showPage(int(i));
            bench.settle();
            for (QWidget* widget : pages[i]->widget()->findChildren<QWidget*>()) {
                const Field* field = hintField(widget);
                if (!field || !widget->isVisible() || !widget->isEnabled()
                    || widget->focusPolicy() == Qt::NoFocus || widget->focusProxy()
                    || !told.insert(field).second) {
                    continue;
                }
                QCOMPARE(topicByF1(bench, *widget), fieldTopic(*field));
            }
        }
        QVERIFY2(told.size() > 40, qPrintable(QString::number(told.size())));
    }

    void f1OnAViewTellsOfIt() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        for (View* view : bench.window->views()) {
            bench.window->viewTabs().showView(view);
            bench.settle();
            QCOMPARE(topicByF1(bench, *view), view->objectName());
            QVERIFY2(helpOf(bench)->book().find(view->objectName()), "no page of this view");
        }
        bench.window->findChild<QDockWidget*>(QStringLiteral("step"))->show();
        bench.settle();
        for (const auto& [name, topic] : {std::pair{"requirements", "verdict"},
                                          {"stepFormulas", "step"},
                                          {"play", "playback"}}) {
            auto* widget = bench.window->findChild<QWidget*>(QString::fromLatin1(name));
            QVERIFY2(widget, name);
            QCOMPARE(topicByF1(bench, *widget), QString::fromLatin1(topic));
        }
    }

    /// A lesson hides views and shows them by the names that the help has for them, too.
    void lessonsNameTheViewsThatThereAre() {
        const Bench bench(QStringLiteral("en"));
        QSet<QString> views, named;
        for (const View* view : bench.window->views()) {
            views << view->objectName();
        }
        const auto choices = choicesOf<Hideable>();
        for (std::size_t i = 0; i < choices.size(); ++i) {
            if (isView(static_cast<Hideable>(i))) {
                named << QString::fromLatin1(choices[i].key);
            }
        }
        QCOMPARE(named, views);
    }

    void everyTopicSetInTheWindowHasItsPlace() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        bench.action("helpContents")->trigger();
        QVERIFY(!bench.window->inputs().pages().empty()); // which builds them
        QSet<QString> topics;
        for (const QWidget* widget : bench.window->findChildren<QWidget*>()) {
            const QString topic = helpTopicOf(widget);
            if (!topic.isEmpty() && !topics.contains(topic)) {
                topics += topic;
                QVERIFY2(leadsSomewhere(helpOf(bench)->book(), topic), qPrintable(topic));
            }
        }
        for (const char* wanted : {"verdict", "messages", "stages", "playback", "step", "feeds",
                                   "inputs-part", "editing#catalogues"}) {
            QVERIFY2(topics.contains(QString::fromLatin1(wanted)), wanted);
        }
    }

    void f1InATornOffViewTellsOfIt() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        View* view = bench.window->views()[2];
        bench.window->viewTabs().detach(view);
        bench.settle();
        QCOMPARE(topicByF1(bench, *view), view->objectName());
    }

    void f1InADialogTellsOfTheDialog() {
        const Bench bench(QStringLiteral("en"));
        ExamplesDialog dialog(bench.window.get());
        dialog.open(); // modal
        QVERIFY(QTest::qWaitForWindowActive(&dialog, patience_ms));
        QTest::keyClick(dialog.focusWidget(), Qt::Key_F1);
        auto* help = dialog.findChild<HelpWindow*>();
        QVERIFY(help && help->isVisible());
        QCOMPARE(help->topic(), QStringLiteral("start#examples"));
        QVERIFY(leadsSomewhere(help->book(), help->topic()));
        QVERIFY(QTest::qWaitForWindowActive(help, patience_ms)); // it can be used
        QTest::keyClick(help->focusWidget(), Qt::Key_Escape);
        QVERIFY(!help->isVisible() && dialog.isVisible());
    }

    void noLinkIsDead_data() { addLanguages(); }

    void noLinkIsDead() {
        QFETCH(QString, language);
        Language spoken;
        spoken.apply(language);
        const HelpBook book{QString()};
        static const QRegularExpression link(QStringLiteral("href=\"([^\"]*)\""));
        int links = 0;
        for (const HelpPage& page : book.pages()) {
            for (auto it = link.globalMatch(page.html); it.hasNext();) {
                const QString target = it.next().captured(1);
                QVERIFY2(target.startsWith(QStringLiteral("help:"))
                             && leadsSomewhere(book, target.mid(5)),
                         qPrintable(page.id + QStringLiteral(" → ") + target));
                ++links;
            }
        }
        QVERIFY(links > 100);
    }

    void bothLanguagesHaveTheSamePagesAndAnchors() {
        std::map<QString, QStringList> anchors[2];
        for (const int i : {0, 1}) {
            Language spoken;
            spoken.apply(QString::fromLatin1(i == 0 ? "en" : "ru"));
            const HelpBook book{QString()};
            for (const HelpPage& page : book.pages()) {
                QVERIFY2(!page.sections.empty() && page.title != page.id && page.html.size() > 200,
                         qPrintable(page.id));
                anchors[i][page.id] = anchorsOf(page);
            }
        }
        QCOMPARE(anchors[0], anchors[1]);
        QVERIFY(anchors[0].size() > 20);
    }

    void noPageMixesTheLanguages_data() { addLanguages(); }

    void noPageMixesTheLanguages() {
        QFETCH(QString, language);
        Bench bench(language);
        bench.action("helpShortcuts")->trigger();
        // names of the time and of encodings, which both languages have
        static const QRegularExpression names(QStringLiteral("\\b(UTC|UTF-\\d+|Windows-\\d+)\\b"));
        static const QRegularExpression cyrillic(
            QStringLiteral("(?<![\\dА-Яа-яЁё])[А-Яа-яЁё]{2,}(?![\\dА-Яа-яЁё])"));
        for (const HelpPage& page : helpOf(bench)->book().pages()) {
            // The list of works names each in its own language, the glossary its terms in both.
            static const QRegularExpression lists(QStringLiteral("name=\"(all-keys|terms)\".*"),
                                                  QRegularExpression::DotMatchesEverythingOption);
            const QString prose = proseOf(QString(page.html).remove(lists)).remove(names);
            if (language == u"ru") {
                QCOMPARE(page.id + u' ' + englishIn(prose), page.id + u' ');
            } else {
                const auto found = cyrillic.match(prose);
                QVERIFY2(!found.hasMatch(), qPrintable(page.id + u' ' + found.captured()));
            }
        }
    }

    void thePageOfKeysNamesThoseOfTheWindow_data() { addLanguages(); }

    void thePageOfKeysNamesThoseOfTheWindow() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePaths().front());
        bench.action("helpShortcuts")->trigger();
        QCOMPARE(helpOf(bench)->topic(), QStringLiteral("shortcuts"));
        const QString page = helpOf(bench)->book().find(QStringLiteral("shortcuts"))->html;
        int keys = 0;
        for (const QAction* action : bench.window->findChildren<QAction*>()) {
            for (const QKeySequence& key : action->shortcuts()) {
                const QString shown = key.toString(QKeySequence::NativeText);
                QVERIFY2(page.contains(shown.toHtmlEscaped()), qPrintable(shown));
                ++keys;
            }
        }
        QVERIFY(keys > 20);
        QVERIFY(page.contains(QStringLiteral("Alt+1")));
    }

    void searchFindsWhatHoldsEveryWord() {
        Language spoken;
        spoken.apply(QStringLiteral("ru"));
        const HelpBook book{QString()};
        const auto hits = book.search(QStringLiteral("степень ЗАТУПЛЕНИЯ"));
        QVERIFY(!hits.empty());
        QCOMPARE(hits.front().topic(), QStringLiteral("inputs-wheel#wheel.dullness"));
        for (const auto& hit : hits) {
            const QString text = (hit.section->title + u' ' + hit.section->text).toLower();
            QVERIFY2(text.contains(QStringLiteral("степен"))
                         && text.contains(QStringLiteral("затуплени")),
                     qPrintable(hit.topic()));
        }
        QVERIFY(!book.search(QStringLiteral("ещё будет снят")).empty());
        QCOMPARE(book.search(QStringLiteral("ещё будет снят")).size(),
                 book.search(QStringLiteral("еще будет снят")).size());
        QVERIFY(book.search(QStringLiteral("затупления абракадабра")).empty());
        QVERIFY(book.search(QStringLiteral("  ")).empty());
    }

    void searchFindsAWordInItsOtherForms() {
        Language spoken;
        const auto topics = [](const QString& words) {
            QStringList found;
            const HelpBook book{QString()};
            for (const auto& hit : book.search(words)) {
                found << hit.topic();
            }
            return found;
        };
        spoken.apply(QStringLiteral("ru"));
        QVERIFY(topics(QStringLiteral("податливость")).size() > 3);
        QCOMPARE(topics(QStringLiteral("податливостью")), topics(QStringLiteral("податливость")));
        QCOMPARE(topics(QStringLiteral("продольными подачами")),
                 topics(QStringLiteral("продольная подача")));
        spoken.apply(QStringLiteral("en"));
        QVERIFY(topics(QStringLiteral("compliance")).size() > 3);
        QCOMPARE(topics(QStringLiteral("compliances")), topics(QStringLiteral("compliance")));
        QVERIFY(!topics(QStringLiteral("accuracy")).empty()); // whose stem ends in another letter
        QCOMPARE(topics(QStringLiteral("'compliance'")), topics(QStringLiteral("compliance")));
        QVERIFY(topics(QStringLiteral("''")).empty());
    }

    void searchDoesNotTakeAnotherWordForAForm() {
        Language spoken;
        spoken.apply(QStringLiteral("ru"));
        const HelpWords axis{QStringLiteral("ось")};
        QVERIFY(axis.areIn(QStringLiteral("Ось детали")));
        QVERIFY(!axis.areIn(QStringLiteral("о точности, скорость, основа, обороты")));
        const HelpWords field{QStringLiteral("поле")};
        QVERIFY(field.areIn(QStringLiteral("в полях допуска")));
        QVERIFY(!field.areIn(QStringLiteral("полный, получен")));
        const auto places = HelpWords{QStringLiteral("еще степень")}.placesIn(
            QStringLiteral("Ещё раз: степени затупления"));
        QCOMPARE(places.size(), 2);
        QCOMPARE(places[0].at, 0);
        QCOMPARE(places[0].length, 3);
        QCOMPARE(places[1].at, 9);
        QCOMPARE(places[1].length, 7);
    }

    void theWindowSearchesAndGoesBackByKeys() {
        Bench bench(QStringLiteral("en"));
        bench.action("helpContents")->trigger();
        HelpWindow* help = helpOf(bench);
        QVERIFY(QTest::qWaitForWindowActive(help, patience_ms));
        QCOMPARE(help->topic(), QStringLiteral("start"));
        QTest::keyClick(help->focusWidget(), Qt::Key_F, Qt::ControlModifier);
        auto* search = help->findChild<QLineEdit*>(QStringLiteral("helpSearch"));
        QVERIFY(search->hasFocus());
        QTest::keyClicks(search, QStringLiteral("elastic balances"));
        QTest::keyClick(search, Qt::Key_Return);
        QCOMPARE(help->topic(), QStringLiteral("model#model-3"));
        auto* page = help->findChild<QTextBrowser*>(QStringLiteral("helpPage"));
        QVERIFY(!page->extraSelections().isEmpty());
        for (const QTextEdit::ExtraSelection& marked : page->extraSelections()) {
            const QString word = marked.cursor.selectedText().toLower();
            QVERIFY2(word.startsWith(QStringLiteral("elastic"))
                         || word.startsWith(QStringLiteral("balance")),
                     qPrintable(word));
        }
        QTest::keyClick(help->focusWidget(), Qt::Key_Left, Qt::AltModifier);
        QTRY_COMPARE(help->topic(), QStringLiteral("start"));
        QTest::keyClick(help->focusWidget(), Qt::Key_Right, Qt::AltModifier);
        QTRY_COMPARE(help->topic(), QStringLiteral("model#model-3"));
        search->setFocus();
        QTest::keyClick(search, Qt::Key_Escape); // first the words …
        QVERIFY(search->text().isEmpty() && help->isVisible());
        QTest::keyClick(search, Qt::Key_Escape); // … then the window
        QVERIFY(!help->isVisible());
    }

    void theHelpFollowsTheLanguage() {
        Bench bench(QStringLiteral("en"));
        bench.action("helpContents")->trigger();
        HelpWindow* help = helpOf(bench);
        help->openTopic(QStringLiteral("feeds#span"));
        QVERIFY(help->windowTitle().contains(QStringLiteral("Feeds by stage")));
        bench.action("russian")->trigger();
        QTRY_VERIFY(help->windowTitle().contains(QStringLiteral("Подачи по ступеням")));
        QCOMPARE(help->topic(), QStringLiteral("feeds#span"));
        const auto* page = help->findChild<QTextBrowser*>(QStringLiteral("helpPage"));
        QVERIFY(page->toPlainText().contains(QStringLiteral("реверсная зона входа")));
    }

    void linksAreInTheColourOfTheTheme() {
        Bench bench(QStringLiteral("en"));
        bench.action("helpContents")->trigger();
        const auto* page = helpOf(bench)->findChild<QTextBrowser*>(QStringLiteral("helpPage"));
        for (const Theme theme : {Theme::dark, Theme::contrast, Theme::light}) {
            bench.action(qPrintable(QStringLiteral("theme-") + themeCode(theme)))->trigger();
            bench.settle();
            const QColor wanted = paletteOf(theme).color(QPalette::Link);
            int links = 0;
            for (QTextBlock block = page->document()->begin(); block.isValid();
                 block = block.next()) {
                for (auto it = block.begin(); it != block.end(); ++it) {
                    const QTextCharFormat format = it.fragment().charFormat();
                    if (!format.anchorHref().isEmpty()) {
                        QCOMPARE(format.foreground().color(), wanted);
                        ++links;
                    }
                }
            }
            QVERIFY(links > 10);
        }
    }

    void textsOfTheHelpWindowHaveRoom_data() { addLanguages(); }

    void textsOfTheHelpWindowHaveRoom() {
        QFETCH(QString, language);
        Bench bench(language);
        bench.action("helpContents")->trigger();
        HelpWindow* help = helpOf(bench);
        help->resize(700, 480);
        bench.settle();
        const QStringList offenders = textsWithoutRoom(*help);
        QVERIFY2(offenders.isEmpty(), qPrintable(offenders.join(u'\n')));
        const auto* page = help->findChild<QTextBrowser*>(QStringLiteral("helpPage"));
        for (const HelpPage& one : help->book().pages()) {
            help->openTopic(one.id);
            QVERIFY2(page->document()->idealWidth() <= page->viewport()->width()
                         || one.html.contains(QStringLiteral("<pre>")),
                     qPrintable(one.id));
        }
    }
};

} // namespace sparkout::test_help

SPARKOUT_TEST(test_help, TestHelp)
#include "test_help.moc"
