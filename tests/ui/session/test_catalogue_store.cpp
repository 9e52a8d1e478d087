// SPDX-License-Identifier: GPL-3.0-or-later
// The entries of the catalogues, shipped and of one's own: searched, taken, kept.
#include "tests/registry.h"
#include "tests/ui/support/catalogue_bench.h"
#include "tests/whole_project.h"
#include "ui/session/catalogue_store.h"
#include "ui/session/guarded_file.h"
#include "ui/session/project_io.h"
#include "ui/text/texts.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <algorithm>

namespace sparkout::test_catalogue_store {

using namespace catalogue_bench;

class TestCatalogueStore : public QObject {
    Q_OBJECT

private slots:
    void init() { QVERIFY(m_folder.isValid()); }

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
                    if (changes[i].then != notKnown()) { // then the project has none
                        QCOMPARE(after[i].now, changes[i].then);
                    }
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
        project.material->grade = "X5CrNi18-10";
        project.material->flow_stress_mpa = 1234;
        project.material->hardness_hrc.reset();
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
        QCOMPARE(taken.material->flow_stress_mpa, 1234.0);
        QCOMPARE(taken.material->grade, project.material->grade);

        QCOMPARE(store->rename(QStringLiteral("мой сплав"), QStringLiteral("N")), QString());
        QVERIFY(store->hasOwn(QStringLiteral("N")));
        QVERIFY(!store->hasOwn(QStringLiteral("мой сплав")));
        project.material->flow_stress_mpa = 99; // the same name: replaced, not doubled
        QCOMPARE(store->save(project, QStringLiteral("N")), QString());
        QCOMPARE(store->items().size(), shipped + 1);
        QCOMPARE(store->remove(QStringLiteral("N")), QString());
        QCOMPARE(store->items().size(), shipped);
        const BackupHistory history(QFileInfo(store->ownFile()).absolutePath());
        QVERIFY(!history.versions(store->ownFile()).empty()); // the first of these minutes
        QVERIFY(QFile::exists(store->ownFile() + QStringLiteral(".bak")));
    }

    void aMachineSavedAsMineKeepsItsEntrySide() {
        Project project = newProject(Operation::traverse);
        project.machine->entry_side = EntrySide::tailstock; // the zones' compliances count from it
        auto store = CatalogueStore::make(CatalogueKind::machines,
                                          m_folder.filePath(QStringLiteral("sides")));
        QCOMPARE(store->save(project, QStringLiteral("M")), QString());
        const auto mine = std::find_if(store->items().begin(), store->items().end(),
                                       [](const CatalogueItem& item) { return item.own; });
        QVERIFY(mine != store->items().end());
        const Project other = newProject(Operation::traverse);
        const Project taken = withEntry(mine->entry, other);
        QVERIFY(taken.machine->entry_side == EntrySide::tailstock);
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

private:
    QTemporaryDir m_folder;
};

} // namespace sparkout::test_catalogue_store

SPARKOUT_TEST(test_catalogue_store, TestCatalogueStore)
#include "test_catalogue_store.moc"
