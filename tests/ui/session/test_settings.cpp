// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
#include "tests/registry.h"
#include "tests/ui/support/file_trouble.h"
#include "ui/session/settings.h"

#include <QFileInfo>
#include <QSignalSpy>

namespace sparkout::test_settings {

/// A path is whole with its drive, which Linux has none of.
QString inRoot(const QString& path) {
    return QDir::rootPath() + path;
}

class TestSettings : public QObject {
    Q_OBJECT

private slots:
    void whatIsSetIsThereAtTheNextStart() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("new/settings.json"));
        const QByteArray geometry("\x01\x00\xff\x7f", 4);
        {
            Settings settings(file);
            settings.setLanguage(QStringLiteral("ru"));
            settings.setTheme(QStringLiteral("contrast"));
            settings.setFontSize(115);
            settings.setLastFolder(QStringLiteral("/tmp/детали"));
            settings.setWindow(geometry, "state");
            settings.setStockOnDiameter(true);
            settings.addRecentFile(inRoot(QStringLiteral("tmp/вал.sparkout")));
        }
        const Settings again(file);
        QCOMPARE(again.language(), QStringLiteral("ru"));
        QCOMPARE(again.theme(), QStringLiteral("contrast"));
        QCOMPARE(again.fontSize(), 115);
        QVERIFY(again.stockOnDiameter());
        QCOMPARE(again.lastFolder(), QStringLiteral("/tmp/детали"));
        QCOMPARE(again.windowGeometry(), geometry);
        QCOMPARE(again.windowState(), QByteArray("state"));
        QCOMPARE(again.recentFiles(), QStringList{inRoot(QStringLiteral("tmp/вал.sparkout"))});
        QVERIFY(again.file().damaged().isEmpty());
    }

    void theCompanyIsKeptWhole() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        Company company;
        for (const Field& field : tableOf<CompanyTexts>().fields) {
            field.as<std::string>(static_cast<CompanyTexts*>(&company)) =
                "«" + std::string(field.key) + "»";
        }
        company.logo = QByteArray("\x89PNG\0\xff", 6);
        {
            Settings settings(file);
            QCOMPARE(settings.company(), Company());
            settings.setCompany(company);
        }
        QCOMPARE(Settings(file).company(), company);
        Settings again(file);
        again.setCompany({});
        QCOMPARE(again.company(), Company());
    }

    void theTitlePageIsKept() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        const QVariantMap texts{{QStringLiteral("university"), QStringLiteral("Южный «ЮУ»")},
                                {QStringLiteral("place"), QStringLiteral("Челябинск")}};
        {
            Settings settings(file);
            QVERIFY(settings.titlePage().isEmpty());
            settings.setTitlePage(texts);
        }
        QCOMPARE(Settings(file).titlePage(), texts);
    }

    void settingsAreWrittenSoonAfterTheyAreSet() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        Settings settings(file);
        settings.setTheme(QStringLiteral("dark"));
        QTRY_COMPARE(Settings(file).theme(), QStringLiteral("dark"));
    }

    void theNewestRecentFileComesFirstAndNineAreKept() {
        Settings settings = Settings::transient();
        for (int i = 0; i < 12; ++i) {
            settings.addRecentFile(inRoot(QStringLiteral("tmp/%1.sparkout")).arg(i));
        }
        const QString seventh = inRoot(QStringLiteral("tmp/7.sparkout"));
        settings.addRecentFile(inRoot(QStringLiteral("tmp/../tmp/7.sparkout"))); // made absolute
        settings.addRecentFile(seventh);
        QCOMPARE(settings.recentFiles().size(), 9);
        QCOMPARE(settings.recentFiles().first(), seventh);
        QCOMPARE(settings.recentFiles().count(seventh), 1);
    }

    // Both write the whole file; neither may take the other's away.
    void twoInstancesKeepEachOthersSettings() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        Settings one(file);
        Settings two(file);
        one.setTheme(QStringLiteral("dark"));
        one.addRecentFile(QStringLiteral("/tmp/one.sparkout"));
        QVERIFY(!one.flush());
        two.setLanguage(QStringLiteral("ru"));
        two.addRecentFile(QStringLiteral("/tmp/two.sparkout"));
        QVERIFY(!two.flush());
        const Settings again(file);
        QCOMPARE(again.theme(), QStringLiteral("dark"));
        QCOMPARE(again.language(), QStringLiteral("ru"));
        QCOMPARE(again.recentFiles().size(), 2);
    }

    void aDamagedFileIsKeptAsideAndTheDefaultsHold_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("cut") << QByteArray("{\"language\": \"r");
        QTest::newRow("binary") << QByteArray("\x00\xff\xfe{", 4);
        QTest::newRow("a list") << QByteArray("[1, 2]");
        QTest::newRow("too large") << QByteArray(qsizetype(limits::settingsBytes) + 1, ' ');
        QTest::newRow("nested") << QByteArray(100'000, '[');
    }

    void aDamagedFileIsKeptAsideAndTheDefaultsHold() {
        QFETCH(QByteArray, bytes);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        trouble::write(file, bytes);
        Settings settings(file);
        QCOMPARE(settings.theme(), QStringLiteral("system"));
        const QString aside = file + QStringLiteral(".damaged");
        QCOMPARE(settings.file().damaged(), QStringList{aside});
        QCOMPARE(trouble::bytesOf(aside), bytes);
        settings.setTheme(QStringLiteral("light"));
        QVERIFY(!settings.flush());
        QCOMPARE(Settings(file).theme(), QStringLiteral("light"));
    }

    /// Found at the end of a session, it is reported at the start of the next one.
    void aSecondDamagedFileIsKeptBesideTheFirstAndReportedOnce() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        const QString first = file + QStringLiteral(".damaged");
        const QString second = file + QStringLiteral(".damaged-2");
        trouble::write(file, "first");
        QCOMPARE(Settings(file).file().takeDamaged(), QStringList{first});
        QVERIFY(Settings(file).file().damaged().isEmpty()); // it was reported
        {
            Settings settings(file);
            settings.setLanguage(QStringLiteral("ru"));
            QVERIFY(!settings.flush());
            settings.setTheme(QStringLiteral("dark"));
            trouble::write(file, "second"); // by another program, while this one runs
        }
        QCOMPARE(trouble::bytesOf(first), QByteArray("first"));
        QCOMPARE(trouble::bytesOf(second), QByteArray("second"));
        Settings next(file);
        QCOMPARE(next.theme(), QStringLiteral("dark"));
        QCOMPARE(next.language(), QStringLiteral("ru")); // what was known of it before
        QCOMPARE(next.file().takeDamaged(), QStringList{second});
        QVERIFY(!next.flush());
        QVERIFY(Settings(file).file().damaged().isEmpty());
    }

    void aSettingThatIsTooLargeIsRefusedAndTheFileStays() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        Settings settings(file);
        settings.setTheme(QStringLiteral("dark"));
        QVERIFY(!settings.flush());
        const QByteArray before = trouble::bytesOf(file);
        QSignalSpy refused(&settings.file(), &SettingsFile::refused);
        settings.setHandout(QString(qsizetype(limits::settingsBytes), u'x'));
        QCOMPARE(refused.count(), 1);
        QCOMPARE(refused.front().front().value<FileError>().step, FileStep::content);
        QVERIFY(!settings.flush());
        QCOMPARE(settings.handout(), QString());
        QCOMPARE(trouble::bytesOf(file), before);
        // Together with what another instance has written it is not, either.
        Settings other(file);
        other.setHandout(QString(qsizetype(limits::settingsBytes) - 2000, u'x'));
        QVERIFY(!other.flush());
        const QByteArray full = trouble::bytesOf(file);
        settings.setTitlePage({{QStringLiteral("place"), QString(4000, u'y')}});
        QVERIFY(settings.flush());
        QCOMPARE(refused.count(), 2);
        QCOMPARE(trouble::bytesOf(file), full);
    }

    void valuesWithoutSenseCountAsNotSet() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        trouble::write(file,
                       R"({"language": 7, "theme": "pink", "fontSize": 1000, "recentFiles": 3,
                                 "window/state": {"a": 1}, "lastFolder": null, "later": "kept"})");
        Settings settings(file);
        QVERIFY(settings.language() == u"en" || settings.language() == u"ru");
        QCOMPARE(settings.theme(), QStringLiteral("system"));
        QCOMPARE(settings.fontSize(), 100);
        QVERIFY(settings.recentFiles().isEmpty());
        QVERIFY(settings.windowState().isEmpty());
        QCOMPARE(settings.lastFolder(), QDir::homePath());
        settings.setTheme(QStringLiteral("dark"));
        QVERIFY(!settings.flush());
        QVERIFY2(trouble::bytesOf(file).contains("\"later\""), "a newer version's key survives");
    }

#ifdef Q_OS_WIN
    void aFileOpenElsewhereStopsNobody() {
        using trouble::Held;
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        for (const auto against : {Held::Against::everything, Held::Against::replacing}) {
            const QByteArray before = R"({"theme": "dark", "later": "kept"})";
            trouble::write(file, before);
            Settings settings(file);
            QCOMPARE(settings.theme(), QStringLiteral("dark"));
            {
                const Held held(file, against);
                settings.setTheme(QStringLiteral("light"));
                const auto error = settings.flush();
                QVERIFY(error && error->systemError != 0 && error->step != FileStep::write);
                QCOMPARE(settings.theme(), QStringLiteral("light"));
            }
            QCOMPARE(trouble::bytesOf(file), before);
            QVERIFY(!settings.flush());
            QVERIFY(trouble::bytesOf(file).contains("\"later\""));
            QCOMPARE(Settings(file).theme(), QStringLiteral("light"));
            QCOMPARE(trouble::entries(folder.path()),
                     (QStringList{QStringLiteral("backups"), QStringLiteral("settings.json"),
                                  QStringLiteral("settings.json.bak")}));
        }
    }
#else
    void aFolderThatTakesNoFilesOrAFullDiskStopsNobody() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        trouble::write(file, R"({"theme": "dark"})");
        trouble::setMode(folder.path(), 0555);
        {
            const trouble::Unprivileged user;
            Settings settings(file);
            settings.setTheme(QStringLiteral("light"));
            QVERIFY(settings.flush().has_value());
            QCOMPARE(settings.theme(), QStringLiteral("light"));
        }
        trouble::setMode(folder.path(), 0755);
        {
            const trouble::NoBytes disk;
            Settings settings(file);
            settings.setTheme(QStringLiteral("light"));
            const auto error = settings.flush();
            QVERIFY(error && error->step == FileStep::write);
        }
        QVERIFY(Settings(file).theme() == u"dark" || Settings(file).theme() == u"light");
        QCOMPARE(trouble::entries(folder.path()),
                 (QStringList{QStringLiteral("backups"), QStringLiteral("settings.json")}));
    }
#endif

    void somethingElseInItsPlaceIsLeftAlone() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("settings.json")));
        Settings settings(file);
        settings.setTheme(QStringLiteral("dark"));
        const auto error = settings.flush();
        QVERIFY(error && error->step == FileStep::notRegular);
        QVERIFY(QFileInfo(file).isDir());
    }

    void whatCannotBeReadIsNamedAndLeftAlone_data() {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"pipe", "zero", "folder"}) {
            if (trouble::strangeKinds().contains(QString::fromLatin1(kind))) {
                QTest::newRow(kind) << QString::fromLatin1(kind);
            }
        }
    }

    void whatCannotBeReadIsNamedAndLeftAlone() {
        QFETCH(QString, kind);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        trouble::putStrange(kind, file);
        {
            Settings settings(file);
            QVERIFY(settings.file().unreadable());
            QCOMPARE(settings.file().unreadable()->step, FileStep::notRegular);
            QCOMPARE(QString::fromStdString(settings.file().unreadable()->path), file);
            QCOMPARE(settings.theme(), QStringLiteral("system"));
            settings.setTheme(QStringLiteral("dark"));
        }
        QCOMPARE(trouble::entries(folder.path()), QStringList{QStringLiteral("settings.json")});
        QVERIFY(!Settings(folder.filePath(QStringLiteral("absent.json"))).file().unreadable());
    }

#ifndef Q_OS_WIN
    // Its owner may write it, and for a while not read it.
    void whatCannotBeReadForAWhileIsNotWrittenOver() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        const QByteArray before = R"({"theme": "dark", "later": "kept"})";
        trouble::write(file, before);
        trouble::giveAway(folder.path());
        trouble::giveAway(file);
        const trouble::Unprivileged user;
        Settings settings(file);
        QCOMPARE(settings.theme(), QStringLiteral("dark"));
        trouble::setMode(file, 0200);
        settings.addRecentFile(QStringLiteral("/tmp/1.sparkout")); // looks what others have written
        QCOMPARE(settings.theme(), QStringLiteral("dark"));
        const auto error = settings.flush();
        QVERIFY(error && error->step != FileStep::write);
        trouble::setMode(file, 0600);
        QCOMPARE(trouble::bytesOf(file), before);
        QVERIFY(!settings.flush());
        const QByteArray after = trouble::bytesOf(file);
        QVERIFY(after.contains("\"later\"") && after.contains("1.sparkout"));
        QCOMPARE(Settings(file).theme(), QStringLiteral("dark"));
    }
#endif

#ifndef Q_OS_WIN
    void aDamagedFileThatCannotBePutAsideStays_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("cut") << QByteArray("{\"language\": \"ru\", \"theme");
        QTest::newRow("too large") << QByteArray(qsizetype(limits::settingsBytes) + 1, ' ');
    }

    void aDamagedFileThatCannotBePutAsideStays() {
        QFETCH(QByteArray, bytes);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        trouble::write(file, bytes);
        trouble::giveAway(folder.path());
        trouble::giveAway(file);
        trouble::setMode(folder.path(), 0555);
        const trouble::Unprivileged user;
        Settings settings(file);
        QVERIFY(settings.file().damaged().isEmpty());
        QVERIFY(settings.file().unreadable() && settings.file().unreadable()->systemError != 0);
        settings.setTheme(QStringLiteral("dark"));
        QVERIFY(settings.flush());
        QCOMPARE(trouble::bytesOf(file), bytes);
        trouble::setMode(folder.path(), 0755);
        QVERIFY(!settings.flush()); // it can be put aside now
        QCOMPARE(trouble::bytesOf(file + QStringLiteral(".damaged")), bytes);
        QCOMPARE(Settings(file).theme(), QStringLiteral("dark"));
    }
#endif

    void aHugeFileIsPutAsideUnread() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        trouble::putStrange(QStringLiteral("huge"), file);
        const Settings settings(file);
        QCOMPARE(settings.file().damaged(), QStringList{file + QStringLiteral(".damaged")});
        QVERIFY(!QFileInfo::exists(file));
    }

    void transientSettingsTouchNoDisk() {
        Settings settings = Settings::transient();
        settings.setTheme(QStringLiteral("dark"));
        QVERIFY(!settings.flush());
        QCOMPARE(settings.theme(), QStringLiteral("dark"));
    }
};

} // namespace sparkout::test_settings

SPARKOUT_TEST(test_settings, TestSettings)
#include "test_settings.moc"
