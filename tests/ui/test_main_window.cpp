// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/examples_dialog.h"
#include "ui/dialogs/faults_dialog.h"
#include "ui/file_commands.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/messages_panel.h"
#include "ui/inputs/number_field.h"
#include "ui/inputs/stage_table.h"
#include "ui/main_window.h"
#include "ui/session/operation.h"

#include "core/project/project_file.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSignalSpy>
#include <QStyleFactory>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <clocale>

using namespace sparkout;

namespace {

QString example(const char* name) {
    return QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/examples/") + QString::fromUtf8(name);
}

/// A window with the 30h6 example, in a language, at the size of a small laptop.
struct Bench {
    explicit Bench(const QString& code) : settings(Settings::transient()) {
        language.apply(code);
        window = std::make_unique<MainWindow>(settings, language);
        window->resize(1366, 768);
        window->show();
    }
    void open(const QString& path) {
        QSignalSpy shown(window.get(), &MainWindow::outcomeShown);
        QVERIFY(window->document().open(path).opened());
        QTRY_COMPARE(shown.count(), 1);
        QTest::qWait(50); // queued replots and layouts
    }
    Settings settings;
    Language language;
    std::unique_ptr<MainWindow> window;
};

/// A text a person reads, and where it stands.
struct Shown {
    QString text;
    QString where;
};

void addTo(QList<Shown>& list, const QObject* object, const QString& text) {
    if (!text.isEmpty()) {
        list += {text, QString::fromUtf8(object->metaObject()->className()) + u' '
                           + object->objectName()};
    }
}

QList<Shown> textsOf(const QWidget& window) {
    QList<Shown> list;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        const bool hiddenPartOfATabBar = widget->objectName().startsWith(QStringLiteral("Scroll"));
        if (hiddenPartOfATabBar) {
            continue;
        }
        addTo(list, widget, widget->toolTip());
        addTo(list, widget, widget->accessibleName());
        addTo(list, widget, widget->accessibleDescription());
        addTo(list, widget, widget->windowTitle());
        if (const auto* label = qobject_cast<const QLabel*>(widget)) {
            addTo(list, label, label->text());
        } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
            addTo(list, button, button->text());
        } else if (const auto* box = qobject_cast<const QGroupBox*>(widget)) {
            addTo(list, box, box->title());
        } else if (const auto* line = qobject_cast<const QLineEdit*>(widget)) {
            addTo(list, line, line->placeholderText());
        } else if (const auto* combo = qobject_cast<const QComboBox*>(widget)) {
            for (int i = 0; i < combo->count(); ++i) {
                addTo(list, combo, combo->itemText(i));
            }
        } else if (const auto* tabs = qobject_cast<const QTabWidget*>(widget)) {
            for (int i = 0; i < tabs->count(); ++i) {
                addTo(list, tabs, tabs->tabText(i));
            }
        } else if (const auto* view = qobject_cast<const QAbstractItemView*>(widget)) {
            const QAbstractItemModel* model = view->model();
            for (int row = 0; model && row < model->rowCount(); ++row) {
                addTo(list, view, model->headerData(row, Qt::Vertical).toString());
                addTo(list, view, model->headerData(row, Qt::Vertical, Qt::ToolTipRole).toString());
            }
            for (int column = 0; model && column < model->columnCount(); ++column) {
                addTo(list, view, model->headerData(column, Qt::Horizontal).toString());
                for (int row = 0; row < model->rowCount(); ++row) {
                    const QModelIndex index = model->index(row, column);
                    addTo(list, view, index.data().toString());
                    addTo(list, view, index.data(Qt::ToolTipRole).toString());
                }
            }
        }
    }
    for (const QAction* action : window.findChildren<QAction*>()) {
        addTo(list, action, action->text());
        addTo(list, action, action->toolTip());
    }
    return list;
}

/// English words of a text: three Latin letters or more that are no name, key, unit or symbol.
QString englishIn(QString text) {
    static const QRegularExpression tags(QStringLiteral("<sub>[^<]*</sub>|<[^>]*>"));
    static const QRegularExpression word(QStringLiteral("(?<![\\w.])[A-Za-z]{3,}(?![\\w])"),
                                         QRegularExpression::UseUnicodePropertiesOption);
    static const QStringList allowed{
        QStringLiteral("Sparkout"),    QStringLiteral("English"),  QStringLiteral("Ctrl"),
        QStringLiteral("Alt"),         QStringLiteral("Ins"),      QStringLiteral("Del"),
        QStringLiteral("Shift"),       QStringLiteral("HRC"),      QStringLiteral("MODEL"),
        QStringLiteral("ISO"),         QStringLiteral("cos"),      QStringLiteral("sin"),
        QStringLiteral("QCustomPlot"), QStringLiteral("GNU"),      QStringLiteral("General"),
        QStringLiteral("Public"),      QStringLiteral("License"),  QStringLiteral("Debian"),
        QStringLiteral("Linux"),       QStringLiteral("bookworm"), QStringLiteral("JSON"),
        QStringLiteral("CSV"),
    };
    text.replace(tags, QStringLiteral(" ")).remove(u'&');
    QStringList found;
    for (auto it = word.globalMatch(text); it.hasNext();) {
        const QString one = it.next().captured();
        if (!allowed.contains(one)) {
            found += one;
        }
    }
    return found.join(u' ');
}

void verifyRussian(const QWidget& window) {
    for (const Shown& shown : textsOf(window)) {
        const QString english = englishIn(shown.text);
        QVERIFY2(english.isEmpty(), qPrintable(shown.where + QStringLiteral(": ") + shown.text));
    }
}

bool labelFits(const QLabel& label) {
    if (label.wordWrap()) {
        return label.heightForWidth(label.width()) <= label.height()
               && label.minimumSizeHint().width() <= label.width();
    }
    return label.sizeHint().width() <= label.width() && label.sizeHint().height() <= label.height();
}

/// Every visible label, button and choice has room for its text.
void verifyNothingClipped(const QWidget& window) {
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible()) {
            continue;
        }
        bool fits = true;
        QString text;
        if (const auto* label = qobject_cast<const QLabel*>(widget)) {
            text = label->text();
            fits = text.isEmpty() || labelFits(*label);
        } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
            text = button->text();
            fits = text.isEmpty() || button->sizeHint().width() <= button->width();
        } else if (const auto* combo = qobject_cast<const QComboBox*>(widget)) {
            text = combo->currentText();
            fits = combo->fontMetrics().horizontalAdvance(text) + 30 <= combo->width();
        }
        QVERIFY2(fits, qPrintable(QStringLiteral("%1 %2: %3 (%4 of %5)")
                                      .arg(QString::fromUtf8(widget->metaObject()->className()),
                                           widget->objectName(), text)
                                      .arg(widget->width())
                                      .arg(widget->sizeHint().width())));
    }
}

} // namespace

class TestMainWindow : public QObject {
    Q_OBJECT

private slots:
    void inARussianWindowNoEnglishIsLeft_data() {
        QTest::addColumn<QString>("path");
        QTest::newRow("traverse") << QString();
        QTest::newRow("plunge") << QString();
    }

    void inARussianWindowNoEnglishIsLeft() {
        Bench bench(QStringLiteral("en"));
        Project project =
            newProject(qstrcmp(QTest::currentDataTag(), "plunge") == 0 ? Operation::plunge
                                                                       : Operation::traverse);
        project.part.stock_mm = 0.2; // warnings, too
        project.part.diameter_mm = 2;
        bench.window->document().startUntitled(project);
        QTRY_VERIFY(bench.window->outcome() != nullptr);
        for (QAction* action : bench.window->findChildren<QAction*>()) {
            if (action->text() == QStringLiteral("Русский")) {
                action->trigger();
            }
        }
        QTest::qWait(50);
        QCOMPARE(QLocale().language(), QLocale::Russian);
        verifyRussian(*bench.window);
        ExamplesDialog examples;
        for (const auto* button : examples.findChildren<QAbstractButton*>()) {
            QVERIFY2(englishIn(button->text()).isEmpty(), qPrintable(button->text()));
        }
        verifyRussian(AboutDialog());
    }

    void everyVisibleTextHasRoomOnASmallScreen_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("path");
        for (const char* code : {"en", "ru"}) {
            for (const char* name :
                 {"shaft-30h6-factory.sparkout", "plunge-shaft-two-stage.sparkout"}) {
                QTest::addRow("%s %s", code, name) << QString::fromUtf8(code) << example(name);
            }
        }
    }

    void everyVisibleTextHasRoomOnASmallScreen() {
        QFETCH(QString, language);
        QFETCH(QString, path);
        Bench bench(language);
        bench.open(path);
        for (int page = 0; page < static_cast<int>(bench.window->inputs().pages().size()); ++page) {
            bench.window->inputs().showPage(page);
            QTest::qWait(20);
            verifyNothingClipped(*bench.window);
            const FormPage* form = bench.window->inputs().pages()[std::size_t(page)];
            QVERIFY(form->widget()->width() <= form->viewport()->width());
        }
    }

    void aTypedFeedChangesTheVerdictAndSurvivesSaveAndReopen() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("вал.sparkout"));
        QVERIFY(QFile::copy(example("shaft-30h6-factory.sparkout"), path));
        Bench bench(QStringLiteral("ru"));
        bench.open(path);
        const OutcomePtr before = bench.window->outcome();
        auto& table = *bench.window->findChild<StageTable*>();
        table.view().setFocus();
        table.view().setCurrentIndex(table.view().model()->index(1, 0));
        QTest::keyClick(&table.view(), Qt::Key_0);
        auto* editor = table.view().findChild<NumberField*>();
        QVERIFY(editor);
        QTest::keyClicks(editor, QStringLiteral(",003"));
        QTest::keyClick(editor, Qt::Key_Return);
        QCOMPARE(bench.window->document().project().cycle.stages[1].radial_feed_mm.value(), 0.003);
        QTRY_VERIFY(bench.window->outcome()->result.project.cycle.stages[1].radial_feed_mm
                    == 0.003);
        const OutcomePtr after = bench.window->outcome();
        QVERIFY(after->result.time_s < before->result.time_s);
        QVERIFY(bench.window->isWindowModified());
        QVERIFY(bench.window->files().save());
        QVERIFY(!bench.window->isWindowModified());

        Bench again(QStringLiteral("en"));
        again.open(path);
        QVERIFY(
            sameProject(again.window->document().project(), bench.window->document().project()));
        const OutcomePtr same = again.window->outcome();
        QCOMPARE(same->result.time_s, after->result.time_s);
        QCOMPARE(same->constraints.size(), after->constraints.size());
        for (std::size_t i = 0; i < same->constraints.size(); ++i) {
            QCOMPARE(same->constraints[i].value, after->constraints[i].value);
        }
    }

    void refusedInputsAreListedAndTheMessageLeadsToTheField() {
        Bench bench(QStringLiteral("en"));
        bench.open(example("shaft-30h6-factory.sparkout"));
        Project project = bench.window->document().project();
        project.part.radii_per_section = 35;
        bench.window->document().edit(project, {"Input", "Radii per section"});
        QTRY_VERIFY(!bench.window->outcome()->ran());
        MessagesPanel& messages = bench.window->messages();
        QCOMPARE(messages.count(), 1);
        QVERIFY(messages.item(0)->text().contains(QStringLiteral("Radii per section")));
        emit messages.itemDoubleClicked(messages.item(0));
        const auto* field =
            bench.window->findChild<QWidget*>(QStringLiteral("/part/radii_per_section"));
        QVERIFY(field->isVisible());
        QCOMPARE(bench.window->focusWidget(), field);
    }

    void aRefusedTextIsListedAndTheVerdictSaysSo() {
        Bench bench(QStringLiteral("en"));
        bench.open(example("shaft-30h6-factory.sparkout"));
        bench.window->inputs().showPage(0);
        auto* field = bench.window->findChild<NumberField*>(QStringLiteral("/part/diameter_mm"));
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("thirty"));
        QTRY_COMPARE(bench.window->messages().item(0)->data(Qt::UserRole).toString(),
                     QStringLiteral("/part/diameter_mm"));
        const auto* notice = bench.window->findChild<QLabel*>(QStringLiteral("refusedFields"));
        QTRY_VERIFY(notice->isVisible());
        QVERIFY(notice->text().startsWith(QStringLiteral("1 field"))
                && notice->text().contains(QStringLiteral("refused text")));
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("31"));
        QTRY_VERIFY(!notice->isVisible());
    }

    void faultsAreListedAsPathAndSentence() {
        const ReadResult read = readProject(R"({"format":"sparkout-project","version":1,"x":1})");
        const QStringList lines = FaultsDialog::lines(read.issues);
        QCOMPARE(lines.size(), static_cast<int>(read.issues.size()));
        QVERIFY(lines.join(u'\n').contains(QStringLiteral("/x: ")));
        FaultsDialog dialog(QStringLiteral("a.sparkout"), read.issues);
        QVERIFY(dialog.findChildren<QAbstractButton*>().size() >= 2);
    }

    void theGalleryOpensEveryExampleAsAnUntitledCopy() {
        QVERIFY(!ExamplesDialog::paths().isEmpty());
        Document document;
        for (const QString& path : ExamplesDialog::paths()) {
            QVERIFY2(!hasErrors(document.openCopy(ExamplesDialog::textOf(path))), qPrintable(path));
            QVERIFY(document.filePath().isEmpty());
            QVERIFY(!document.modified());
        }
    }

    void everyWidgetOneCanFocusHasAnAccessibleName() {
        Bench bench(QStringLiteral("en"));
        bench.open(example("shaft-30h6-factory.sparkout"));
        for (const QWidget* widget : bench.window->findChildren<QWidget*>()) {
            const QString name = QString::fromUtf8(widget->metaObject()->className());
            const bool own = widget->focusPolicy() != Qt::NoFocus && widget->isVisible()
                             && !qobject_cast<const QScrollBar*>(widget)
                             && !widget->objectName().startsWith(QStringLiteral("qt_"))
                             && !name.startsWith(QStringLiteral("QDock"));
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            const bool named =
                !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty());
            QVERIFY2(!own || named, qPrintable(name + u' ' + widget->objectName()));
        }
    }

    void theLayoutIsRememberedAndUndoReachesTheWholeWindow() {
        Bench bench(QStringLiteral("en"));
        bench.open(example("shaft-30h6-factory.sparkout"));
        bench.window->inputs().showPage(0);
        auto* field = bench.window->findChild<NumberField*>(QStringLiteral("/part/diameter_mm"));
        bench.window->activateWindow();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("31"));
        QCOMPARE(bench.window->document().project().part.diameter_mm, 31.0);
        QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(bench.window->document().project().part.diameter_mm, 30.0);
        QCOMPARE(field->text(), QStringLiteral("30"));
        bench.window->close();
        QVERIFY(!bench.settings.windowState().isEmpty());
    }
};

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    TestMainWindow test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_main_window.moc"
