// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The dialog of a catalogue as a user meets it on the pages of the inputs.
#include "tests/registry.h"
#include "tests/ui/support/catalogue_bench.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/on_disk.h"
#include "tests/ui/support/text_checks.h"
#include "tests/whole_project.h"
#include "ui/inputs/catalogue_bar.h"
#include "ui/session/settings.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTreeWidget>

namespace sparkout::test_catalogue_dialog {

using namespace catalogue_bench;
using on_disk::bytesOf;

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

void write(const QString& path, const QByteArray& bytes) {
    QDir().mkpath(QFileInfo(path).absolutePath());
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

class TestCatalogueDialog : public QObject {
    Q_OBJECT

private slots:
    void init() { QVERIFY(m_folder.isValid()); }

    void pickedByKeyboardItIsOneStepOfTheHistory() {
        Window window(materialPage);
        const std::string before = window.document().project().material->grade;
        const double flow = window.document().project().material->flow_stress_mpa;
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
        QCOMPARE(window.document().project().material->grade, std::string("СЧ25"));
        QCOMPARE(window.document().project().material->flow_stress_mpa, 900.0);
        QCOMPARE(window.document().project().material->shear_factor, 1.9); // it does not give it
        window.document().undo();
        QCOMPARE(window.document().project().material->grade, before);
        QCOMPARE(window.document().project().material->flow_stress_mpa, flow);
        QVERIFY(!window.document().canUndo());
    }

    void whatIsNotKnownIsSaid() {
        Window window(materialPage);
        {
            DialogAnswers answers({QStringLiteral("Enter")});
            answers.seen = [](QDialog& dialog) {
                child<QLineEdit>(dialog, "catalogueSearch")->setText(QStringLiteral("40Х 28"));
            };
            window.press("fromCatalogue");
            QCOMPARE(answers.fault(), QString());
        }
        QCOMPARE(window.document().project().material->hardness_hrc, std::optional(28.0));
        DialogAnswers answers({QStringLiteral("Enter")});
        answers.seen = [](QDialog& dialog) {
            child<QLineEdit>(dialog, "catalogueSearch")->setText(QStringLiteral("СЧ25"));
            QCOMPARE(visibleEntries(dialog).size(), 1);
            const auto* preview = child<QTreeWidget>(dialog, "cataloguePreview");
            const auto rows = preview->findItems(QStringLiteral("not known"), Qt::MatchExactly, 2);
            QCOMPARE(rows.size(), 2); // hardness and burn temperature
            QCOMPARE(rows[0]->text(1), QStringLiteral("28"));
            QVERIFY(rows[0]->font(2).bold());
            QVERIFY2(rows[0]->text(3).contains(QStringLiteral("HB")), qPrintable(rows[0]->text(3)));
        };
        window.press("fromCatalogue");
        QCOMPARE(answers.fault(), QString());
        QVERIFY(!window.document().project().material->hardness_hrc);
    }

    void cancelLeavesEverythingAsItIs() {
        Window window(machinePage);
        const std::string before = window.document().project().machine->name;
        DialogAnswers answers({QStringLiteral("Escape")});
        window.press("fromCatalogue");
        QCOMPARE(answers.fault(), QString());
        QCOMPARE(window.document().project().machine->name, before);
        QVERIFY(!window.document().canUndo());
    }

    void saveAsMineAndDeleteByKeyboard() {
        Window window(wheelPage);
        DialogAnswers answers({QStringLiteral("Enter"),       // the name
                               QStringLiteral("deleteEntry"), // in the catalogue
                               QStringLiteral("Yes"), QStringLiteral("Escape")});
        int dialogs = 0;
        answers.seen = [&dialogs](QDialog& dialog) {
            if (++dialogs == 1) {
                auto* name = child<QLineEdit>(dialog, "newName");
                name->selectAll();
                QTest::keyClick(name, Qt::Key_Delete);
                QVERIFY(!child<QPushButton>(dialog, "acceptName")->isEnabled());
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
        QCOMPARE(bytesOf(path + QStringLiteral(".damaged")), damaged);
        QVERIFY(fault->text().contains(QStringLiteral(".damaged")));
        QVERIFY(!child<QPushButton>(dialog, "putAside")->isVisible());
        QCOMPARE(store->save(project, QStringLiteral("new")), QString());
        write(path, "[]"); // damaged once more: the first one stays
        store->refresh();
        QString aside;
        QCOMPARE(store->putAside(aside), QString());
        QCOMPARE(bytesOf(path + QStringLiteral(".damaged")), damaged);
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

private:
    QTemporaryDir m_folder;
};

} // namespace sparkout::test_catalogue_dialog

SPARKOUT_TEST(test_catalogue_dialog, TestCatalogueDialog)
#include "test_catalogue_dialog.moc"
