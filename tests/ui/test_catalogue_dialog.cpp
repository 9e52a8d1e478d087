// SPDX-License-Identifier: GPL-3.0-or-later
// Catalogues, wheel markings and tolerance classes as a user meets them on the pages of the inputs.
#include "core/project/validate.h"
#include "tests/registry.h"
#include "tests/ui/dialog_answers.h"
#include "tests/ui/text_checks.h"
#include "tests/ui/window_bench.h"
#include "ui/dialogs/catalogue_dialog.h"
#include "ui/dialogs/entry_name_dialog.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/session/catalogue_changes.h"
#include "ui/session/operation.h"
#include "ui/session/search_text.h"
#include "ui/session/settings.h"
#include "ui/session/source_names.h"
#include "ui/session/texts.h"

#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

namespace test_catalogue_dialog {

using namespace sparkout;

namespace {

constexpr std::array kinds{CatalogueKind::materials, CatalogueKind::wheels,
                           CatalogueKind::machines};

template <class Widget>
Widget* child(const QObject& parent, const char* name) {
    return parent.findChild<Widget*>(QString::fromLatin1(name));
}

QStringList visibleEntries(const QDialog& dialog) {
    QStringList names;
    const auto* list = child<QTreeWidget>(dialog, "catalogueList");
    for (int i = 0; i < list->topLevelItemCount(); ++i) {
        if (!list->topLevelItem(i)->isHidden()) {
            names += list->topLevelItem(i)->text(0);
        }
    }
    return names;
}

/// A window on one of the pages, with settings of its own.
struct Window {
    explicit Window(int pageNumber, Operation operation = Operation::traverse) : page(pageNumber) {
        bench.window->document().startUntitled(newProject(operation));
        bench.window->inputs().showPage(page);
        bench.settle();
    }
    [[nodiscard]] Document& document() { return bench.window->document(); }
    template <class Widget>
    [[nodiscard]] Widget* on(const char* name) {
        return child<Widget>(*bench.window->inputs().pages()[std::size_t(page)], name);
    }
    void press(const char* name) {
        auto* button = on<QPushButton>(name);
        QVERIFY(button && button->isVisible());
        button->setFocus();
        QTest::keyClick(button, Qt::Key_Space);
    }
    int page;
    Bench bench{QStringLiteral("en")};
};

constexpr int partPage = 0, materialPage = 1, wheelPage = 2, machinePage = 3;

void write(const QString& path, const QByteArray& bytes) {
    QDir().mkpath(QFileInfo(path).absolutePath());
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QString textOf(const Project& project, CatalogueKind kind) {
    return QString::fromStdString(kind == CatalogueKind::materials ? project.material.grade
                                  : kind == CatalogueKind::wheels  ? project.wheel.marking
                                                                   : project.machine.name);
}

} // namespace

class TestCatalogueDialog : public QObject {
    Q_OBJECT

private slots:
    void init() { QVERIFY(m_folder.isValid()); }

    void everyShippedEntryIsTakenWithoutAFault() {
        for (const CatalogueKind kind : kinds) {
            const auto store = CatalogueStore::make(kind, {});
            QVERIFY(store->items().size() >= 10);
            for (const CatalogueItem& item : store->items()) {
                // A wheel for bores does not reach over a neck, one for shafts not into a bore.
                bool fits = false;
                for (const char* name : {"shaft-30h6-factory", "plunge-shaft-two-stage",
                                         "internal-plunge", "slender-shaft"}) {
                    Project project = loadProject(QStringLiteral(SPARKOUT_SOURCE_DIR
                                                                 "/resources/examples/%1.sparkout")
                                                      .arg(QString::fromLatin1(name)))
                                          .project.value();
                    const Project taken = withEntry(item.entry, project);
                    QCOMPARE(textOf(taken, kind), entryName(item.entry));
                    const bool sound = !hasErrors(validate(taken));
                    fits = fits || sound;
                    QVERIFY2(sound || kind == CatalogueKind::wheels,
                             qPrintable(entryName(item.entry)));
                }
                QVERIFY2(fits, qPrintable(entryName(item.entry)));
            }
        }
    }

    void everyNumberOfAShippedEntryTellsItsSource() {
        for (const CatalogueKind kind : kinds) {
            const auto store = CatalogueStore::make(kind, {});
            for (const CatalogueItem& item : store->items()) {
                for (const CatalogueChange& change :
                     changesBy(item.entry, newProject(Operation::traverse))) {
                    QVERIFY(!change.source
                            || !sourceShown(*change.source, *change.field, false).isEmpty());
                }
                QVERIFY(!sourcesShown(item).isEmpty());
                for (const ValueSource& source : sourcesOf(item.entry)) {
                    QVERIFY2(isEstimate(source) || !sourceText(source.source).isEmpty(),
                             source.source.c_str());
                }
            }
        }
    }

    void searchForgivesCaseOrderAlphabetAndYo() {
        const QString text = searchForm(QStringLiteral("500×50×203 25А F60 L 6 V Закалённые 40Х ")
                                        + inLatinLetters(QStringLiteral("ШХ15")));
        for (const char* query : {"25a f60", "F60 25А", "500x50", "закаленные", "ЗАКАЛЁННЫЕ 40x",
                                  "shkh15", "  l  6 ", ""}) {
            QVERIFY2(matchesQuery(text, QString::fromUtf8(query)), query);
        }
        QVERIFY(!matchesQuery(text, QStringLiteral("f60 f80")));
        QCOMPARE(searchForm(QStringLiteral("0,25")), searchForm(QStringLiteral("0.25")));
    }

    void pickedByKeyboardItIsOneStepOfTheHistory() {
        Window window(materialPage);
        const std::string before = window.document().project().material.grade;
        const double flow = window.document().project().material.flow_stress_mpa;
        DialogAnswers answers({QStringLiteral("Enter")});
        answers.seen = [](QDialog& dialog) {
            QVERIFY(!child<QPushButton>(dialog, "renameEntry")->isEnabled());
            auto* search = child<QLineEdit>(dialog, "catalogueSearch");
            QCOMPARE(dialog.focusWidget(), search);
            QTest::keyClicks(search, QStringLiteral("cast-iron"));
            QVERIFY(visibleEntries(dialog).isEmpty());
            QVERIFY(!child<QPushButton>(dialog, "takeOver")->isEnabled());
            search->selectAll();
            QTest::keyClicks(search, QStringLiteral("IRON grey"));
            QCOMPARE(visibleEntries(dialog).size(), 2);
            QTest::keyClick(search, Qt::Key_Down);
            const auto* preview = child<QTreeWidget>(dialog, "cataloguePreview");
            QVERIFY(preview->topLevelItemCount() >= 5);
            QCOMPARE(preview->topLevelItem(0)->text(2), QStringLiteral("СЧ25"));
        };
        window.press("fromCatalogue");
        QCOMPARE(answers.fault(), QString());
        QCOMPARE(window.document().project().material.grade, std::string("СЧ25"));
        QCOMPARE(window.document().project().material.flow_stress_mpa, 900.0);
        QCOMPARE(window.document().project().material.shear_factor, 1.9); // it does not give it
        window.document().undo();
        QCOMPARE(window.document().project().material.grade, before);
        QCOMPARE(window.document().project().material.flow_stress_mpa, flow);
        QVERIFY(!window.document().canUndo());
    }

    void cancelLeavesEverythingAsItIs() {
        Window window(machinePage);
        const std::string before = window.document().project().machine.name;
        DialogAnswers answers({QStringLiteral("Escape")});
        window.press("fromCatalogue");
        QCOMPARE(answers.fault(), QString());
        QCOMPARE(window.document().project().machine.name, before);
        QVERIFY(!window.document().canUndo());
    }

    void thePreviewSaysWhatChanges() {
        for (const CatalogueKind kind : kinds) {
            const auto store = CatalogueStore::make(kind, {});
            Project project = newProject(Operation::traverse);
            for (const CatalogueItem& item : store->items()) {
                const auto changes = changesBy(item.entry, project);
                const Project taken = withEntry(item.entry, project);
                const auto after = changesBy(item.entry, taken);
                QCOMPARE(after.size(), changes.size());
                bool changed = false;
                for (std::size_t i = 0; i < changes.size(); ++i) {
                    QCOMPARE(after[i].now, changes[i].then);
                    QVERIFY(!after[i].changed);
                    changed = changed || changes[i].changed;
                }
                QVERIFY(changed);
            }
        }
    }

    void savedAsMineItIsThereAgainIsRenamedAndDeleted() {
        const QString folder = m_folder.filePath(QStringLiteral("mine"));
        Project project = newProject(Operation::traverse);
        project.material.grade = "X5CrNi18-10";
        project.material.flow_stress_mpa = 1234;
        project.material.hardness_hrc.reset();
        auto store = CatalogueStore::make(CatalogueKind::materials, folder);
        const std::size_t shipped = store->items().size();
        QCOMPARE(store->save(project, QStringLiteral("мой сплав")), QString());
        QVERIFY(store->hasOwn(QStringLiteral("мой сплав")));
        QVERIFY(QFile::exists(store->ownFile()));

        store = CatalogueStore::make(CatalogueKind::materials, folder); // another start
        QCOMPARE(store->items().size(), shipped + 1);
        const auto mine = std::find_if(store->items().begin(), store->items().end(),
                                       [](const CatalogueItem& item) { return item.own; });
        QVERIFY(matchesQuery(mine->search, QStringLiteral("МОЙ x5crni")));
        const Project taken = withEntry(mine->entry, newProject(Operation::traverse));
        QCOMPARE(taken.material.flow_stress_mpa, 1234.0);
        QCOMPARE(taken.material.grade, project.material.grade);

        QCOMPARE(store->rename(QStringLiteral("мой сплав"), QStringLiteral("N")), QString());
        QVERIFY(store->hasOwn(QStringLiteral("N")));
        QVERIFY(!store->hasOwn(QStringLiteral("мой сплав")));
        project.material.flow_stress_mpa = 99; // the same name: replaced, not doubled
        QCOMPARE(store->save(project, QStringLiteral("N")), QString());
        QCOMPARE(store->items().size(), shipped + 1);
        QCOMPARE(store->remove(QStringLiteral("N")), QString());
        QCOMPARE(store->items().size(), shipped);
    }

    void aMachineSavedAsMineKeepsItsEntrySide() {
        Project project = newProject(Operation::traverse);
        project.machine.entry_side = EntrySide::tailstock; // the zones' compliances count from it
        auto store = CatalogueStore::make(CatalogueKind::machines,
                                          m_folder.filePath(QStringLiteral("sides")));
        QCOMPARE(store->save(project, QStringLiteral("M")), QString());
        const auto mine = std::find_if(store->items().begin(), store->items().end(),
                                       [](const CatalogueItem& item) { return item.own; });
        QVERIFY(mine != store->items().end());
        const Project other = newProject(Operation::traverse);
        QVERIFY(withEntry(mine->entry, other).machine.entry_side == EntrySide::tailstock);
        const auto changes = changesBy(mine->entry, other);
        const auto side = std::find_if(changes.begin(), changes.end(), [](const auto& change) {
            return change.key == "entry_side";
        });
        QVERIFY(side != changes.end());
        QVERIFY(side->changed);
        QCOMPARE(side->then, choiceText(choicesOf<EntrySide>()[1].label));
    }

    void twoWindowsKeepEachOthersEntries() {
        const QString folder = m_folder.filePath(QStringLiteral("two"));
        const Project project = newProject(Operation::traverse);
        auto one = CatalogueStore::make(CatalogueKind::machines, folder);
        auto other = CatalogueStore::make(CatalogueKind::machines, folder);
        QCOMPARE(one->save(project, QStringLiteral("A")), QString());
        QCOMPARE(other->save(project, QStringLiteral("B")), QString());
        one->refresh();
        QVERIFY(one->hasOwn(QStringLiteral("A")) && one->hasOwn(QStringLiteral("B")));
    }

    void mineIsShownInPlaceOfAShippedOneOfItsName() {
        auto store = CatalogueStore::make(CatalogueKind::materials, {});
        const std::size_t shipped = store->items().size();
        Project project = newProject(Operation::traverse);
        project.material.flow_stress_mpa = 777;
        QCOMPARE(store->save(project, QStringLiteral("ШХ15")), QString());
        QCOMPARE(store->items().size(), shipped);
        QVERIFY(store->hasOwn(QStringLiteral("ШХ15")));
        QCOMPARE(store->remove(QStringLiteral("ШХ15")), QString());
        QCOMPARE(store->items().size(), shipped);
        QVERIFY(!store->hasOwn(QStringLiteral("ШХ15")));
    }

    void valuesNobodyCouldReadAgainAreNotKept() {
        auto store = CatalogueStore::make(CatalogueKind::wheels,
                                          m_folder.filePath(QStringLiteral("refused")));
        Project project = newProject(Operation::traverse);
        project.wheel.width_mm = -3;
        const QString fault = store->save(project, QStringLiteral("bad"));
        QVERIFY2(fault.contains(QStringLiteral("Wheel width")), qPrintable(fault));
        QVERIFY(!store->hasOwn(QStringLiteral("bad")));
        QVERIFY(!QFile::exists(store->ownFile()));
    }

    void saveAsMineAndDeleteByKeyboard() {
        Window window(wheelPage);
        DialogAnswers answers({QStringLiteral("Enter"),       // the name
                               QStringLiteral("deleteEntry"), // in the catalogue
                               QStringLiteral("Yes"), QStringLiteral("Escape")});
        int dialogs = 0;
        answers.seen = [&dialogs](QDialog& dialog) {
            if (++dialogs == 1) {
                auto* name = child<QLineEdit>(dialog, "entryName");
                name->selectAll();
                QTest::keyClick(name, Qt::Key_Delete);
                QVERIFY(!child<QPushButton>(dialog, "keepName")->isEnabled());
                QTest::keyClicks(name, QStringLiteral("bench wheel"));
            } else if (dialogs == 2) {
                auto* search = child<QLineEdit>(dialog, "catalogueSearch");
                QTest::keyClicks(search, QStringLiteral("bench"));
                QCOMPARE(visibleEntries(dialog), QStringList(QStringLiteral("bench wheel")));
            } else if (dialogs == 4) {
                QVERIFY(visibleEntries(dialog).isEmpty());
            }
        };
        window.press("saveAsMine");
        QVERIFY(!window.document().canUndo()); // the project is as it was
        window.press("fromCatalogue");
        QCOMPARE(answers.fault(), QString());
        QCOMPARE(dialogs, 4);
    }

    void aDamagedFileOfMineIsSaidAndNothingIsLost() {
        const QString folder = m_folder.filePath(QStringLiteral("damaged"));
        const QString path = folder + QStringLiteral("/catalogue/materials.json");
        const QByteArray damaged = "{ \"format\": \"sparkout-catalogue\", \"version\": 1, ";
        write(path, damaged);
        auto store = CatalogueStore::make(CatalogueKind::materials, folder);
        QVERIFY(!store->fault().isEmpty());
        QVERIFY(store->items().size() >= 10); // the shipped ones are there
        const Project project = newProject(Operation::traverse);
        QVERIFY(!store->save(project, QStringLiteral("new")).isEmpty());
        QVERIFY(!store->remove(QStringLiteral("x")).isEmpty());
        QCOMPARE(bytesOf(path), damaged);

        CatalogueDialog dialog(*store, project, nullptr, nullptr);
        dialog.show();
        auto* fault = child<QLabel>(dialog, "catalogueFault");
        QVERIFY(fault->isVisible());
        QVERIFY(fault->text().contains(path));
        QVERIFY(fault->text().contains(store->fault()));
        QTest::mouseClick(child<QPushButton>(dialog, "putAside"), Qt::LeftButton);
        QVERIFY(store->fault().isEmpty());
        QCOMPARE(bytesOf(path + QStringLiteral(".damaged-1")), damaged);
        QVERIFY(fault->text().contains(QStringLiteral("damaged-1")));
        QVERIFY(!child<QPushButton>(dialog, "putAside")->isVisible());
        QCOMPARE(store->save(project, QStringLiteral("new")), QString());
        write(path, "[]"); // damaged once more: the first one stays
        store->refresh();
        QString aside;
        QCOMPARE(store->putAside(aside), QString());
        QCOMPARE(bytesOf(path + QStringLiteral(".damaged-1")), damaged);
        QCOMPARE(bytesOf(aside), QByteArray("[]"));
    }

    void theDialogKeepsItsSize() {
        Settings settings(m_folder.filePath(QStringLiteral("size/settings.json")));
        QCOMPARE(settings.folder(), m_folder.filePath(QStringLiteral("size")));
        const auto store = CatalogueStore::make(CatalogueKind::wheels, {});
        const Project project = newProject(Operation::traverse);
        {
            CatalogueDialog dialog(*store, project, &settings, nullptr);
            dialog.show();
            dialog.resize(1003, 507);
        }
        CatalogueDialog dialog(*store, project, &settings, nullptr);
        QCOMPARE(dialog.size(), QSize(1003, 507));
    }

    void dialogsHaveNamesRoomAndAreRussian() {
        for (const char* code : {"en", "ru"}) {
            Bench bench(QString::fromLatin1(code));
            for (const CatalogueKind kind : kinds) {
                const auto store = CatalogueStore::make(kind, {});
                CatalogueDialog dialog(*store, newProject(Operation::traverse), nullptr, nullptr);
                dialog.show();
                QTest::qWait(20);
                const QStringList tight = textsWithoutRoom(dialog);
                QVERIFY2(tight.isEmpty(), qPrintable(tight.join(u'\n')));
                for (const QWidget* widget : interactiveWidgets(dialog)) {
                    const auto* button = qobject_cast<const QAbstractButton*>(widget);
                    QVERIFY2(!widget->accessibleName().isEmpty()
                                 || (button && !button->text().isEmpty()),
                             qPrintable(pathOf(widget)));
                }
                QString all;
                for (const ShownText& shown : textsOf(dialog)) {
                    all += shown.text + u'\n';
                }
                for (const char* site : {"aloro", "org", "allmetals", "altermet", "uralprokatmetiz",
                                         "ferrotrade", "metall", "life", "steel", "lib"}) {
                    all.remove(QString::fromLatin1(site));
                }
                QVERIFY2(code == std::string("en") || englishIn(all).isEmpty(),
                         qPrintable(englishIn(all)));
            }
        }
    }

    void aMarkingIsExplainedAndFillsWhatItSays() {
        Window window(wheelPage);
        auto* line = window.on<QLineEdit>("/wheel/marking");
        auto* meaning = window.on<QLabel>("markingMeaning");
        auto* fill = window.on<QPushButton>("fillFromMarking");
        line->setFocus();
        line->selectAll();
        QTest::keyClicks(line, QStringLiteral("400x40x203 63C F80 K 8 V 30"));
        QVERIFY2(meaning->text().contains(QStringLiteral("green silicon carbide")),
                 qPrintable(meaning->text()));
        QVERIFY(meaning->text().contains(QStringLiteral("0.185")));
        QVERIFY(fill->isEnabled());
        const Project before = window.document().project();
        window.press("fillFromMarking");
        const Wheel& wheel = window.document().project().wheel;
        QCOMPARE(wheel.diameter_mm, 400.0);
        QCOMPARE(wheel.width_mm, 40.0);
        QCOMPARE(wheel.grain_mm, 0.185);
        QCOMPARE(wheel.grain_share, (62 - 2 * 8) / 100.0);
        QCOMPARE(wheel.dullness, before.wheel.dullness); // it says nothing of it
        QVERIFY(!fill->isEnabled());
        window.document().undo();
        QCOMPARE(window.document().project().wheel.diameter_mm, before.wheel.diameter_mm);
        QCOMPARE(window.document().project().wheel.marking, before.wheel.marking);
        line->setFocus();
        line->selectAll();
        QTest::keyClicks(line, QStringLiteral("the old one"));
        QVERIFY(meaning->text().startsWith(QStringLiteral("Not understood")));
        QVERIFY(!fill->isVisible());
    }

    void aMarkingBelowTheMachinesSpeedIsSaid() {
        Window window(wheelPage);
        Project project = window.document().project();
        project.machine.wheel_speed_m_s = 50;
        project.wheel.marking = "25А F60 L 6 V 35";
        window.document().edit(project, {"Input", "Marking"});
        auto* meaning = window.on<QLabel>("markingMeaning");
        QVERIFY(meaning->text().contains(QStringLiteral("above what the marking allows")));
        project.machine.wheel_speed_m_s = 35;
        window.document().edit(project, {"Input", "Wheel speed"});
        QVERIFY(!meaning->text().contains(QStringLiteral("above what the marking allows")));
    }

    void aToleranceClassFillsTheLimits_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<double>("nominal");
        QTest::addColumn<double>("upper");
        QTest::addColumn<double>("lower");
        QTest::addColumn<QString>("shown");
        QTest::newRow("30h6") << "30h6" << 30.0 << 0.0 << -13.0 << "30h6";
        QTest::newRow("Cyrillic, comma")
            << QString::fromUtf8("38,74к6") << 38.74 << 18.0 << 2.0 << "38.74k6";
        QTest::newRow("letters alone") << "f7" << 30.0 << -20.0 << -41.0 << "30f7";
    }

    void aToleranceClassFillsTheLimits() {
        QFETCH(QString, typed);
        QFETCH(double, nominal);
        QFETCH(double, upper);
        QFETCH(double, lower);
        QFETCH(QString, shown);
        Window window(partPage);
        const Part before = window.document().project().part;
        auto* size = window.on<QLineEdit>("sizeField");
        size->setFocus();
        size->selectAll();
        size->insert(typed); // pasted: QTest types no Cyrillic
        size->setModified(true);
        QVERIFY(window.on<QLabel>("sizeMeaning")->isVisible());
        QTest::keyClick(size, Qt::Key_Return);
        const Part& part = window.document().project().part;
        QCOMPARE(part.diameter_mm, nominal);
        QCOMPARE(part.upper_deviation_um, upper);
        QCOMPARE(part.lower_deviation_um, lower);
        QCOMPARE(size->text(), shown);
        QVERIFY(!window.on<QLabel>("sizeMeaning")->isVisible());
        window.document().undo();
        QCOMPARE(window.document().project().part.diameter_mm, before.diameter_mm);
        QCOMPARE(window.document().project().part.lower_deviation_um, before.lower_deviation_um);
        QVERIFY(!window.document().canUndo());
    }

    void aToleranceClassIsTakenWhenItIsLeft() {
        Window window(partPage);
        auto* size = window.on<QLineEdit>("sizeField");
        size->setFocus();
        size->selectAll();
        QTest::keyClicks(size, QStringLiteral("40k6"));
        QVERIFY(window.on<QLabel>("sizeMeaning")->isVisible());
        QVERIFY(!window.document().canUndo());
        QTest::keyClick(size, Qt::Key_Tab);
        const Part& part = window.document().project().part;
        QCOMPARE(part.diameter_mm, 40);
        QCOMPARE(part.upper_deviation_um, 18);
        QCOMPARE(part.lower_deviation_um, 2);
        QVERIFY(!window.on<QLabel>("sizeMeaning")->isVisible());
    }

    void aClassThatIsNoneIsExplained() {
        Window window(partPage);
        const Part before = window.document().project().part;
        auto* size = window.on<QLineEdit>("sizeField");
        auto* meaning = window.on<QLabel>("sizeMeaning");
        for (const auto& [typed, said] :
             {std::pair("30H7", "Capital letters are for bores"), std::pair("30q6", "ISO 286 has"),
              std::pair("600h6", "ISO 286 has"), std::pair("thirty", "Not a size")}) {
            size->setFocus();
            size->selectAll();
            QTest::keyClicks(size, QString::fromLatin1(typed));
            QVERIFY2(meaning->text().startsWith(QString::fromLatin1(said)),
                     qPrintable(meaning->text()));
            QTest::keyClick(size, Qt::Key_Return);
            QVERIFY(meaning->isVisible());
        }
        QCOMPARE(window.document().project().part.diameter_mm, before.diameter_mm);
        QVERIFY(!window.document().canUndo());
    }

    void limitsOfAClassAreRecognised() {
        Window window(partPage);
        Project project = window.document().project();
        project.part.diameter_mm = 50;
        project.part.upper_deviation_um = -9;
        project.part.lower_deviation_um = -25;
        window.document().edit(project, {"Input", "Diameter"});
        QCOMPARE(window.on<QLineEdit>("sizeField")->text(), QStringLiteral("50g6"));
        project.part.lower_deviation_um = -26;
        window.document().edit(project, {"Input", "Diameter"});
        QCOMPARE(window.on<QLineEdit>("sizeField")->text(), QString());
    }

private:
    QTemporaryDir m_folder;
};

} // namespace test_catalogue_dialog

SPARKOUT_TEST(test_catalogue_dialog, TestCatalogueDialog)
#include "test_catalogue_dialog.moc"
