// SPDX-License-Identifier: GPL-3.0-or-later
// No writer writes what its own reader refuses: each kind of file is grown until its writer gives
// up; what was written last is read back whole, and what was refused changed nothing on the disk.
#include "core/catalogue/catalogue.h"
#include "core/file/project_file.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/pack.h"
#include "core/lesson/text_markup.h"
#include "core/lesson/work.h"
#include "core/project/part.h"
#include "core/search/grid.h"
#include "core/search/search_record_text.h"
#include "core/setup/setup_file.h"
#include "core/study/kept_search.h"
#include "core/study/new_project.h"
#include "tests/registry.h"
#include "tests/ui/support/file_trouble.h"
#include "ui/session/catalogue_store.h"
#include "ui/session/guarded_file.h"
#include "ui/session/recovery_store.h"
#include "ui/session/settings.h"

#include <QFileInfo>

#include <functional>

namespace sparkout::test_writers {

/// How a kind of file is written and read back, grown by a number of bytes.
struct Writer {
    std::size_t most; ///< bytes that its reader takes
    /// Writes more than so many bytes; false: it was refused.
    std::function<bool(const QString& path, std::size_t bytes)> write;
    /// Whether the file is read, and holds what was written.
    std::function<bool(const QString& path, std::size_t bytes)> reads;
};

/// Texts of at most so many letters each, together so many bytes.
std::vector<std::string> texts(std::size_t bytes, std::size_t longest = 60'000) {
    std::vector<std::string> all;
    for (std::size_t left = bytes; left > 0;) {
        const std::size_t length = std::min(left, longest);
        all.emplace_back(length, 'x');
        left -= length;
    }
    return all;
}

/// Runs that were kept, with long summaries.
std::vector<KeptRun> runs(std::size_t bytes) {
    std::vector<KeptRun> all;
    for (const std::string& text : texts(bytes)) {
        KeptRun run;
        run.name = "Run " + std::to_string(all.size() + 1);
        run.when = "2026-11-26T10:00:00.000Z";
        run.inputs.text = "{\"notes\":\"" + text + "\"}";
        all.push_back(std::move(run));
    }
    return all;
}

Setup setupWith(std::size_t bytes, int surfaces) {
    Setup setup = plainSetup(newProject(Operation::traverse));
    for (int i = 1; i < surfaces; ++i) {
        setup.surfaces.push_back(setup.surfaces.front());
    }
    for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
        setup.surfaces[i].name = surfaces > 1 ? "Surface " + std::to_string(i + 1) : std::string();
        setup.surfaces[i].project.runs = runs(bytes / setup.surfaces.size());
    }
    return setup;
}

Lesson lessonWith(std::size_t bytes) {
    Lesson lesson;
    lesson.base = plainSetup(newProject(Operation::traverse));
    lesson.title = {"A lesson", "Работа"};
    for (const std::string& text : texts(bytes, limits::lessonText.bytes)) {
        LessonStep step;
        step.task = {text, "Задание"};
        step.goal.text.emplace();
        lesson.steps.push_back(std::move(step));
    }
    return lesson;
}

Work workWith(std::size_t bytes) {
    Work work = newWork(forStudents(lessonWith(10)), {}, {}, 1, "A student", "TM-31");
    for (const std::string& text : texts(bytes)) {
        WorkEntry entry;
        entry.when = "2026-11-26T10:00:00Z";
        entry.answer.text = text;
        addEntry(work, std::move(entry));
    }
    return work;
}

Pack packWith(std::size_t bytes) {
    Pack pack;
    pack.title = "A pack";
    pack.logo.assign(limits::logoText / 4 * 4, 'A');
    pack.lessons.push_back({"a.sparkout-lesson", lessonWith(bytes)});
    return pack;
}

std::vector<CatalogueEntry> wheelsWith(std::size_t bytes) {
    std::vector<CatalogueEntry> all;
    for (const std::string& text : texts(bytes)) {
        auto entry = entryOf<WheelEntry>(newProject(Operation::traverse),
                                         "Wheel " + std::to_string(all.size() + 1));
        entry.note = text;
        all.emplace_back(std::move(entry));
    }
    return all;
}

/// Written by the guarded file, as the window does.
Writer guarded(std::function<std::optional<std::string>(std::size_t bytes)> make,
               std::size_t most = limits::fileBytes) {
    return {most,
            [make](const QString& path, std::size_t bytes) {
                GuardedFile file;
                return !file.write(path, [&] { return make(bytes); });
            },
            [make](const QString& path, std::size_t bytes) {
                return trouble::bytesOf(path).toStdString() == make(bytes);
            }};
}

template <class Value, class Write, class Read>
Writer guarded(Value (*value)(std::size_t), Write write, Read read,
               std::size_t most = limits::fileBytes) {
    return guarded(
        [=](std::size_t bytes) -> std::optional<std::string> {
            std::string text = write(value(bytes));
            return read(text) ? std::optional(std::move(text)) : std::nullopt;
        },
        most);
}

/// The tasks of as many steps as a lesson may have, as long as they may be.
constexpr std::size_t lessonTasks = 100 * limits::lessonText.bytes;

QVariantMap settingsWith(std::size_t bytes) {
    QVariantMap texts;
    texts.insert(QStringLiteral("university"), QString(qsizetype(bytes), u'x'));
    return texts;
}

/// Searches whose record takes somewhat more than so many bytes.
SearchRecord searchesOf(std::size_t bytes) {
    SearchRecord record;
    record.finished.emplace_back().last =
        GridCycle(100, {std::size_t(mostSettings), int(mostStockSteps)});
    const std::size_t ofOne = writeSearchState({}, record).size() - writeSearchState({}, {}).size();
    record.finished.resize(bytes / ofOne + 1, record.finished.front());
    return record;
}

/// The progress of a search, as `optimize --resume` keeps it.
Writer keptSearch() {
    const SearchQuestion question{"engine", "project", "--method full"};
    return {KeptSearch::mostBytes,
            [question](const QString& path, std::size_t bytes) {
                KeptSearch kept(path.toStdString(), question);
                bool refused = kept.open().has_value();
                kept.onFailure = [&refused](const FileError&) { refused = true; };
                kept.journal() = SearchJournal(searchesOf(bytes));
                kept.close();
                return !refused;
            },
            [question](const QString& path, std::size_t bytes) {
                KeptSearch kept(path.toStdString(), question);
                return !kept.open()
                       && writeSearchState(question, kept.journal().record())
                              == writeSearchState(question, searchesOf(bytes));
            }};
}

std::map<QByteArray, Writer> writers() {
    std::map<QByteArray, Writer> all;
    all["project"] = guarded([](std::size_t bytes) { return projectText(setupWith(bytes, 1)); });
    all["set-up"] = guarded([](std::size_t bytes) { return projectText(setupWith(bytes, 3)); });
    all["work"] = guarded(workWith, writeWork,
                          [](const std::string& text) { return readWork(text).work.has_value(); });
    all["lesson"] = guarded(
        lessonWith, writeLesson,
        [](const std::string& text) { return readLesson(text).lesson.has_value(); }, lessonTasks);
    all["pack"] = guarded(
        packWith, writePack,
        [](const std::string& text) { return readPack(text).pack.has_value(); }, lessonTasks);
    all["search"] = keptSearch();
    all["catalogue"] = {
        limits::fileBytes,
        [](const QString& path, std::size_t bytes) {
            const QString folder = QFileInfo(path).absolutePath();
            return CatalogueStore::make(CatalogueKind::wheels, folder)
                ->keep(wheelsWith(bytes))
                .isEmpty();
        },
        [](const QString& path, std::size_t bytes) {
            const QString folder = QFileInfo(path).absolutePath();
            const auto store = CatalogueStore::make(CatalogueKind::wheels, folder);
            return store->fault().isEmpty()
                   && std::ranges::count_if(store->items(), [](const CatalogueItem& item) {
                          return item.own;
                      }) == std::ptrdiff_t(wheelsWith(bytes).size());
        }};
    all["settings"] = {limits::settingsBytes,
                       [](const QString& path, std::size_t bytes) {
                           Settings settings(path);
                           bool refused = false;
                           QObject::connect(&settings.file(), &SettingsFile::refused,
                                            [&refused] { refused = true; });
                           settings.setTitlePage(settingsWith(bytes));
                           return !settings.flush() && !refused;
                       },
                       [](const QString& path, std::size_t bytes) {
                           const Settings settings(path);
                           return settings.titlePage() == settingsWith(bytes)
                                  && settings.file().damaged().isEmpty();
                       }};
    return all;
}

QString fileOf(const QTemporaryDir& folder, const QByteArray& kind) {
    QDir(folder.path()).mkdir(QStringLiteral("catalogue"));
    return kind == "catalogue" ? folder.filePath(QStringLiteral("catalogue/wheels.json"))
                               : folder.filePath(QStringLiteral("file"));
}

class TestWriters : public QObject {
    Q_OBJECT

private slots:
    void theLargestContentIsReadBackAndMoreIsRefused_data() {
        QTest::addColumn<QByteArray>("kind");
        for (const auto& [kind, writer] : writers()) {
            QTest::newRow(kind.constData()) << kind;
        }
    }

    void theLargestContentIsReadBackAndMoreIsRefused() {
        QFETCH(QByteArray, kind);
        const Writer writer = writers().at(kind);
        const QTemporaryDir folder;
        const QString path = fileOf(folder, kind);
        QByteArray before;
        bool wasRefused = false;
        std::size_t largest = 0;
        std::vector<std::size_t> steps{writer.most / 64, writer.most + 1};
        if (writer.most <= 4u << 20 || qEnvironmentVariableIsSet("SPARKOUT_LONG")) {
            steps.insert(steps.begin() + 1, writer.most * 15 / 16); // takes seconds to read back
        }
        for (const std::size_t bytes : steps) {
            const bool written = writer.write(path, bytes);
            if (written) {
                QVERIFY2(writer.reads(path, bytes), qPrintable(QString::number(bytes)));
                before = trouble::bytesOf(path);
                largest = bytes;
            } else {
                QCOMPARE(trouble::bytesOf(path), before);
                wasRefused = true;
            }
        }
        QVERIFY(largest > 0 && wasRefused);
    }

    /// All that the window's inputs take, with the largest logo.
    void theSettingsHoldTheLargestCompany() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        Company company;
        for (const Field& field : tableOf<CompanyTexts>().fields) {
            field.as<std::string>(static_cast<CompanyTexts*>(&company)) =
                QString(200, QChar(0x416)).toStdString();
        }
        company.logo = QByteArray(1 << 20, '\xff'); // Logo::mostBytes
        {
            Settings settings(file);
            settings.setCompany(company);
            for (int i = 0; i < Settings::recentFilesKept; ++i) {
                settings.addRecentFile(QString(4000, QChar(u'a' + i)));
            }
            QVERIFY(!settings.flush());
            settings.setTheme(QStringLiteral("dark"));
            QVERIFY(!settings.flush());
        }
        const Settings again(file);
        QCOMPARE(again.company(), company);
        QCOMPARE(again.recentFiles().size(), Settings::recentFilesKept);
        QCOMPARE(again.theme(), QStringLiteral("dark"));
        QVERIFY(again.file().damaged().isEmpty());
        QCOMPARE(trouble::entries(folder.path()),
                 (QStringList{QStringLiteral("backups"), QStringLiteral("settings.json"),
                              QStringLiteral("settings.json.bak")}));
    }
};

} // namespace sparkout::test_writers

SPARKOUT_TEST(test_writers, TestWriters)
#include "test_writers.moc"
