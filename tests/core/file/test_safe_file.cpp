// SPDX-License-Identifier: GPL-3.0-or-later
// The safe writer in ordinary life and on odd targets. Injected faults, kills and full disks are
// in safe_file_faults.py. Root may do everything, so as root the tests run as the user nobody.
// What is made of links, modes, devices and a second program is tried on POSIX alone.
#include "core/file/safe_file.h"
#include "core/sha256.h"
#include "tests/check_line.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <share.h>
#else
#include <fcntl.h>
#include <grp.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

using namespace sparkout;
namespace fs = std::filesystem;

namespace {

#ifdef _WIN32

fs::path makeFolder() {
    static int made = 0;
    fs::path folder = fs::temp_directory_path()
                      / ("sparkout-files-" + std::to_string(QCoreApplication::applicationPid())
                         + "-" + std::to_string(++made));
    return fs::create_directory(folder) ? folder : fs::path();
}

#else

fs::path rootsFolder; ///< prepared by root for what nobody cannot make; empty without root

fs::path makeFolder() {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "sparkout-files-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) { // TMPDIR may not be ours
        name = "/tmp/sparkout-files-XXXXXX";
        if (::mkdtemp(name.data()) == nullptr)
            return {};
    }
    return name;
}

mode_t modeOf(const fs::path& path) {
    struct stat found {};
    return ::lstat(path.c_str(), &found) == 0 ? found.st_mode & 07777 : 0;
}

#endif

void put(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

std::string get(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

using Names = std::vector<std::string>;

} // namespace

class TestSafeFile : public QObject {
    Q_OBJECT

    HeldFunctions m_kinds;
    fs::path m_folder;
    fs::path file(const std::string& name = "part.sparkout") const { return m_folder / name; }

private slots:
    void init() {
        m_folder = makeFolder();
        QVERIFY(!m_folder.empty());
    }
    void cleanup() {
        std::error_code ignored;
        fs::permissions(m_folder, fs::perms::owner_all, ignored);
        fs::remove_all(m_folder, ignored);
        if (std::string(QTest::currentTestFunction()).starts_with("kind"))
            m_kinds.count();
    }
    void cleanupTestCase() {
        m_kinds.print("03", QStringLiteral("cases of the 12 kinds of targets as documented"));
    }

    // Ordinary life

    void aNewFileHoldsTheBytes_data() {
        QTest::addColumn<qsizetype>("size");
        for (const qsizetype size : {0, 1, 65535, 65536, 65537, 3'000'000})
            QTest::addRow("%lld bytes", static_cast<long long>(size)) << size;
    }
    void aNewFileHoldsTheBytes() {
        QFETCH(qsizetype, size);
        std::string bytes(static_cast<std::size_t>(size), '\0');
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = static_cast<char>(i * 7 + i / 256);
        QVERIFY(!writeFileSafely(file(), bytes));
        QVERIFY(get(file()) == bytes);
        QCOMPARE(namesIn(m_folder), Names{"part.sparkout"});
    }

    // Bytes that come bit by bit

    void bytesComeBitByBit() {
        std::string whole;
        SafeFileWriter writer(file(), SafeFileWriter::Existing::refused);
        for (int i = 0; i < 20'000; ++i) {
            const std::string line = std::to_string(i) + "\n";
            whole += line;
            QVERIFY(writer.write(line));
        }
        QVERIFY(!fs::exists(file()));
        QVERIFY(writer.finish());
        QVERIFY(!writer.error());
        QVERIFY(get(file()) == whole);
        QCOMPARE(namesIn(m_folder), Names{"part.sparkout"});
    }

    void bytesThatChangedOnTheDiskAreNotTakenForTheOnesWritten() {
        put(file(), "old");
        SafeFileWriter writer(file(), SafeFileWriter::Existing::replaced);
        QVERIFY(
            writer.write(std::string(300'000, 'x'))); // more than one block: some are on the disk
        Names names = namesIn(m_folder);
        std::erase(names, "part.sparkout");
        QCOMPARE(names.size(), std::size_t{1});
        std::fstream(m_folder / names.front(), std::ios::in | std::ios::out | std::ios::binary)
            << 'y';
        QVERIFY(!writer.finish());
        QVERIFY(writer.error()->step == FileStep::verify);
        QCOMPARE(get(file()), std::string("old"));
    }

    void whatIsNotFinishedLeavesNothing() {
        put(file(), "old");
        {
            SafeFileWriter writer(file(), SafeFileWriter::Existing::replaced);
            QVERIFY(writer.write(std::string(300'000, 'x')));
        }
        QCOMPARE(get(file()), std::string("old"));
        QCOMPARE(namesIn(m_folder), Names{"part.sparkout"});
    }

    void aFileInTheWayIsKeptOrReplaced() {
        put(file(), "old");
        fs::permissions(file(), fs::perms(0640));
        const fs::perms before = fs::status(file()).permissions();
        SafeFileWriter refused(file(), SafeFileWriter::Existing::refused);
        QVERIFY(refused.error() && refused.error()->systemError == EEXIST);
        QVERIFY(!refused.write("x") && !refused.finish());
        QCOMPARE(get(file()), std::string("old"));
        SafeFileWriter replaced(file(), SafeFileWriter::Existing::replaced);
        QVERIFY(replaced.write("new") && replaced.finish());
        QCOMPARE(get(file()), std::string("new"));
        QVERIFY(fs::status(file()).permissions() == before);
    }

    void aFileThatCameMeanwhileIsKept() {
        SafeFileWriter writer(file(), SafeFileWriter::Existing::refused);
        QVERIFY(writer.write("mine"));
        put(file(), "theirs");
        QVERIFY(!writer.finish());
        QVERIFY(writer.error()->step == FileStep::rename);
        QCOMPARE(writer.error()->systemError, EEXIST);
        QCOMPARE(get(file()), std::string("theirs"));
    }

    void aFolderThatIsNotThereIsAnError() {
        SafeFileWriter writer(m_folder / "none" / "a.csv", SafeFileWriter::Existing::refused);
        QVERIFY(writer.error() && writer.error()->step == FileStep::open);
        QVERIFY(!writer.write("x"));
    }

#ifndef _WIN32
    void aNewFileGetsItsModeFromTheUmask() {
        const mode_t before = ::umask(027);
        const auto error = writeFileSafely(file(), "new");
        ::umask(before);
        QVERIFY(!error);
        QCOMPARE(modeOf(file()), mode_t{0640});
    }
#endif

    void aShorterTextLeavesNothingOfTheLongerOne() {
        put(file(), std::string(5000, 'x'));
        QVERIFY(!writeFileSafely(file(), "short"));
        QCOMPARE(get(file()), std::string("short"));
    }

#ifndef _WIN32
    void aNameRelativeToTheWorkingFolderIsWrittenThere() {
        // In a child: who dropped root's rights may not be able to come back to where it was.
        const pid_t child = ::fork();
        if (child == 0) {
            const bool written =
                ::chdir(m_folder.c_str()) == 0 && !writeFileSafely("вал 30h6.sparkout", "new");
            ::_exit(written ? 0 : 1);
        }
        int status = -1;
        QCOMPARE(::waitpid(child, &status, 0), child);
        QCOMPARE(status, 0);
        QCOMPARE(get(file("вал 30h6.sparkout")), std::string("new"));
    }
#endif

    void theBackupIsThePreviousVersion() {
        const WriteOptions keep{.keepBackup = true};
        QVERIFY(!writeFileSafely(file(), "1", keep));
        QCOMPARE(namesIn(m_folder), Names{"part.sparkout"}); // there was none to keep
        QVERIFY(!writeFileSafely(file(), "2", keep));
        QCOMPARE(get(file("part.sparkout.bak")), std::string("1"));
        QVERIFY(!writeFileSafely(file(), "3", keep));
        QCOMPARE(get(file()), std::string("3"));
        QCOMPARE(get(file("part.sparkout.bak")), std::string("2"));
        QCOMPARE(namesIn(m_folder), (Names{"part.sparkout", "part.sparkout.bak"}));
    }

    void saveReplacesOnlyTheExpectedVersion() {
        for (const bool keepsBackup : {false, true}) {
            const fs::path path = file(keepsBackup ? "kept" : "plain");
            const auto write = [&](const char* text, const std::string& expected) {
                return writeFileSafely(path, text,
                                       {.keepBackup = keepsBackup, .expected = expected});
            };
            const auto isChange = [](const std::optional<FileError>& error) {
                return error && error->step == FileStep::changed && !error->replaced;
            };
            QVERIFY(isChange(write("1", sha256("0")))); // there is none
            QVERIFY(!fs::exists(path));
            QVERIFY(!write("1", {}));
            QVERIFY(isChange(write("2", {}))); // there is one
            QVERIFY(isChange(write("2", sha256("0"))));
            QCOMPARE(get(path), std::string("1"));
            QVERIFY(!write("2", sha256("1")));
            QCOMPARE(get(path), std::string("2"));
        }
        QCOMPARE(get(file("kept.bak")), std::string("1"));
        QCOMPARE(namesIn(m_folder), (Names{"kept", "kept.bak", "plain"}));
    }

    /// Each counts up what it finds; a save that comes too late finds another number and repeats.
    void savesOfTheExpectedVersionLoseNoUpdate() {
        constexpr int writers = 4, each = 25;
        QVERIFY(!writeFileSafely(file(), "0"));
        std::vector<std::thread> threads;
        for (int i = 0; i < writers; ++i) {
            threads.emplace_back([path = file()] {
                for (int done = 0; done < each;) {
                    const auto read = readFile(path, 100);
                    const auto* text = std::get_if<std::string>(&read);
                    if (text == nullptr)
                        continue; // not there while it is exchanged without an exchange
                    const int next = std::atoi(text->c_str()) + 1;
                    const auto error =
                        writeFileSafely(path, std::to_string(next), {.expected = sha256(*text)});
                    done += error ? 0 : 1;
                }
            });
        }
        for (std::thread& thread : threads)
            thread.join();
        QCOMPARE(get(file()), std::to_string(writers * each));
        QCOMPARE(namesIn(m_folder), Names{"part.sparkout"});
    }

    void putAsideReplacesNothing() {
        for (const char* name :
             {"part.sparkout.damaged", "part.sparkout.damaged-2", "part.sparkout.damaged-3"}) {
            put(file(), name);
            const auto aside = putAside(file());
            QVERIFY(std::holds_alternative<fs::path>(aside));
            QCOMPARE(std::get<fs::path>(aside).filename().string(), std::string(name));
            QCOMPARE(get(std::get<fs::path>(aside)), std::string(name));
        }
        QCOMPARE(namesIn(m_folder).size(), std::size_t(3));
        const auto missing = putAside(file());
        QVERIFY(std::holds_alternative<FileError>(missing));
        QCOMPARE(std::get<FileError>(missing).systemError, ENOENT);
    }

    void aBackupThatCannotBeMadeStopsTheSave() {
        put(file(), "old");
        fs::create_directory(file("part.sparkout.bak"));
        const auto error = writeFileSafely(file(), "new", {.keepBackup = true});
        QVERIFY(error && error->step == FileStep::backup && !error->replaced);
        QCOMPARE(get(file()), std::string("old"));
        QCOMPARE(namesIn(m_folder), (Names{"part.sparkout", "part.sparkout.bak"}));
    }

#ifndef _WIN32
    void anErrorNamesThePathAndTheFreeSpace() {
        fs::create_directory(file());
        ::chmod(m_folder.c_str(), 0500);
        const auto error = writeFileSafely(file("new.sparkout"), "new");
        QVERIFY(error.has_value());
        QCOMPARE(error->path, file("new.sparkout").string());
        QCOMPARE(error->systemError, EACCES);
        QVERIFY(error->freeBytes.has_value());
    }

    void leftoversOfAKilledSaveAreRemovedAndNothingElse() {
        // A save that is "killed" while it waits: the name it used is learned from the folder.
        const pid_t killed = ::fork();
        if (killed == 0) {
            for (;;)
                (void)writeFileSafely(file(), std::string(1'000'000, 'a'));
        }
        std::string leftover;
        for (int i = 0; i < 20000 && leftover.empty(); ++i)
            for (const auto& name : namesIn(m_folder))
                if (name.starts_with(".sparkout-"))
                    leftover = name;
        ::kill(killed, SIGKILL);
        ::waitpid(killed, nullptr, 0);
        QVERIFY(!leftover.empty());
        put(file(leftover), "half");
        const std::string otherFile = ".sparkout-0123456789abcdef" + leftover.substr(26);
        const std::string notOurs = leftover.substr(0, leftover.size() - 5) + "g.tmp";
        put(file(otherFile), "of another file");
        put(file(notOurs), "not hexadecimal");

        const int inUse = ::open(file(leftover).c_str(), O_RDONLY);
        QCOMPARE(::flock(inUse, LOCK_EX), 0);
        QVERIFY(!writeFileSafely(file(), "new"));
        QVERIFY(fs::exists(file(leftover))); // a running save holds it
        ::close(inUse);
        QVERIFY(!writeFileSafely(file(), "new"));
        QVERIFY(!fs::exists(file(leftover)));
        QVERIFY(fs::exists(file(otherFile)));
        QVERIFY(fs::exists(file(notOurs)));
    }
#endif

    void savesAtTheSameTimeLeaveOneWholeFile() {
        std::vector<std::thread> threads;
        std::vector<int> failures(4);
        for (std::size_t t = 0; t < 4; ++t)
            threads.emplace_back([&, t] {
                const std::string bytes(200'000, static_cast<char>('a' + t));
                for (int i = 0; i < 50; ++i)
                    failures[t] += writeFileSafely(file(), bytes).has_value();
            });
        for (auto& thread : threads)
            thread.join();
        QCOMPARE(failures, std::vector<int>(4));
        const std::string bytes = get(file());
        QCOMPARE(bytes.size(), std::size_t{200'000});
        QVERIFY(bytes.find_first_not_of(bytes[0]) == std::string::npos);
        QCOMPARE(namesIn(m_folder), Names{"part.sparkout"});
    }

#ifdef _WIN32
    // A scanner for viruses, for one, has it open so that it cannot be replaced.
    void aFileThatIsOpenElsewhereForAMomentIsWaitedFor() {
        put(file(), "old");
        const int held = ::_wsopen(file().c_str(), _O_RDONLY | _O_BINARY, _SH_DENYNO);
        QVERIFY(held >= 0);
        std::thread release([held] {
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
            ::_close(held);
        });
        const auto error = writeFileSafely(file(), "new");
        release.join();
        QVERIFY(!error);
        QCOMPARE(get(file()), std::string("new"));
        QCOMPARE(namesIn(m_folder), Names{"part.sparkout"});
    }

    void aFileThatStaysOpenElsewhereIsKept() {
        put(file(), "old");
        const int held = ::_wsopen(file().c_str(), _O_RDONLY | _O_BINARY, _SH_DENYNO);
        QVERIFY(held >= 0);
        const auto error = writeFileSafely(file(), "new");
        ::_close(held);
        QVERIFY(error && error->step == FileStep::rename && error->systemError == EACCES);
        QVERIFY(!error->replaced);
        QCOMPARE(get(file()), std::string("old"));
        QCOMPARE(namesIn(m_folder), Names{"part.sparkout"});
    }
#endif

    // Targets of twelve kinds, numbered as in reliability.md, check 3

#ifndef _WIN32
    void kind01_aLinkStaysAndItsTargetIsWritten() {
        fs::create_directory(file("folder"));
        put(file("folder/real"), "old");
        fs::create_symlink("folder/real", file());
        fs::create_symlink(file(), file("second link"));
        QVERIFY(!writeFileSafely(file("second link"), "new", {.keepBackup = true}));
        QVERIFY(fs::is_symlink(file()) && fs::is_symlink(file("second link")));
        QCOMPARE(get(file("folder/real")), std::string("new"));
        QCOMPARE(get(file("folder/real.bak")), std::string("old"));
    }

    void kind02_aDanglingLinkStaysAndItsTargetIsMade() {
        fs::create_symlink("not yet", file());
        QVERIFY(!writeFileSafely(file(), "new"));
        QVERIFY(fs::is_symlink(file()));
        QCOMPARE(get(file("not yet")), std::string("new"));
    }

    void kind02_linksInACircleAreRefused() {
        fs::create_symlink("b", file("a"));
        fs::create_symlink("a", file("b"));
        const auto error = writeFileSafely(file("a"), "new");
        QVERIFY(error && error->systemError == ELOOP);
    }
#endif

    void kind03_anotherHardLinkKeepsTheOldText() {
        put(file(), "old");
        fs::create_hard_link(file(), file("other"));
        QVERIFY(!writeFileSafely(file(), "new"));
        QCOMPARE(get(file()), std::string("new"));
        QCOMPARE(get(file("other")), std::string("old"));
    }

#ifndef _WIN32
    void kind04_aFifoIsRefusedAndStays() {
        QCOMPARE(::mkfifo(file().c_str(), 0600), 0);
        const auto error = writeFileSafely(file(), "new");
        QVERIFY(error && error->step == FileStep::notRegular);
        QVERIFY(fs::is_fifo(file()));
        const auto read = readFile(file(), 100); // and reading it does not wait for a writer
        QVERIFY(std::get<FileError>(read).step == FileStep::notRegular);
    }
#endif

    void kind05_aFolderIsRefusedAndStays_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"folder", "folder/", "folder/.", "new/", ""})
            QTest::addRow("'%s'", name) << name;
    }
    void kind05_aFolderIsRefusedAndStays() {
        QFETCH(QString, name);
        fs::create_directory(file("folder"));
        const auto error =
            writeFileSafely(name.isEmpty() ? fs::path() : file(name.toStdString()), "new");
        QVERIFY(error && error->step == FileStep::notRegular);
        QCOMPARE(namesIn(m_folder), Names{"folder"});
    }

#ifndef _WIN32
    void kind06_theModeIsKept_data() {
        QTest::addColumn<int>("mode");
        for (const int mode : {0640, 0600, 0664, 0755})
            QTest::addRow("%o", static_cast<unsigned>(mode)) << mode;
    }
    void kind06_theModeIsKept() {
        QFETCH(int, mode);
        put(file(), "old");
        ::chmod(file().c_str(), static_cast<mode_t>(mode));
        QVERIFY(!writeFileSafely(file(), "new"));
        QCOMPARE(static_cast<int>(modeOf(file())), mode);
    }
#endif

    void kind07_aReadOnlyFileIsRefused() {
        put(file(), "old");
        fs::permissions(file(), fs::perms(0444));
        const auto error = writeFileSafely(file(), "new");
        QVERIFY(error && error->step == FileStep::readOnly && error->systemError == EACCES);
        QCOMPARE(get(file()), std::string("old"));
        QCOMPARE(namesIn(m_folder), Names{"part.sparkout"});
        fs::permissions(file(), fs::perms(0644)); // Windows removes no such file
    }

#ifndef _WIN32
    void kind08_inAReadOnlyFolderTheOldFileStays() {
        put(file(), "old");
        ::chmod(m_folder.c_str(), 0500);
        const auto error = writeFileSafely(file(), "new");
        QVERIFY(error && error->step == FileStep::create && error->systemError == EACCES);
        QCOMPARE(get(file()), std::string("old"));
    }

    void kind09_inAStickyFolderOnlyOnesOwnFileIsReplaced() {
        ::chmod(m_folder.c_str(), 01777);
        put(file(), "old");
        QVERIFY(!writeFileSafely(file(), "new"));
        QCOMPARE(get(file()), std::string("new"));
        if (rootsFolder.empty())
            QSKIP("a file of another user can only be made by root");
        const fs::path foreign = rootsFolder / "foreign";
        for (const bool backup : {false, true}) {
            const auto error = writeFileSafely(foreign, "new", {.keepBackup = backup});
            QVERIFY(error.has_value());
            QVERIFY(error->systemError == EPERM || error->systemError == EACCES);
            QCOMPARE(get(foreign), std::string("old"));
            for (const auto& name : namesIn(rootsFolder))
                QVERIFY(!name.starts_with(".sparkout-"));
        }
    }
#endif

    void kind10_aMissingFolderIsNotMade() {
        const auto error = writeFileSafely(file("no folder/part.sparkout"), "new");
        QVERIFY(error && error->step == FileStep::open && error->systemError == ENOENT);
        QCOMPARE(namesIn(m_folder), Names{});
    }

    void kind11_aNameOf255BytesIsWrittenAndALongerOneRefused() {
        const std::string longest(255, 'n');
        QVERIFY(!writeFileSafely(file(longest), "old"));
        QVERIFY(!writeFileSafely(file(longest), "new"));
        QCOMPARE(get(file(longest)), std::string("new"));
        const auto noBackup = writeFileSafely(file(longest), "newer", {.keepBackup = true});
        QVERIFY(noBackup && noBackup->step == FileStep::backup);
        QCOMPARE(get(file(longest)), std::string("new"));
        const auto error = writeFileSafely(file(longest + "n"), "new");
        QVERIFY(error && error->systemError != 0);
#ifndef _WIN32
        QCOMPARE(error->systemError, ENAMETOOLONG);
#endif
        QCOMPARE(namesIn(m_folder), Names{longest});
    }

    void kind11_aNulInTheNameIsRefused() {
        using namespace std::string_literals;
        const auto error = writeFileSafely(file("part\0.sparkout"s), "new");
        QVERIFY(error && error->systemError == EINVAL);
        QCOMPARE(namesIn(m_folder), Names{});
    }

#ifdef _WIN32
    void kind12_aDeviceIsRefusedAndStays() {
        const auto error = writeFileSafely("NUL", "new");
        QVERIFY(error && error->step == FileStep::notRegular);
        const auto read = readFile("NUL", 100);
        QVERIFY(std::get<FileError>(read).step == FileStep::notRegular);
    }
#else
    void kind12_aDeviceIsRefusedAndStays() {
        const fs::path device =
            fs::exists(rootsFolder / "device") ? rootsFolder / "device" : fs::path("/dev/null");
        fs::create_symlink(device, file("link"));
        for (const fs::path& path : {device, file("link")}) {
            const auto error = writeFileSafely(path, "new");
            QVERIFY(error && error->step == FileStep::notRegular);
            QVERIFY(fs::is_character_file(device));
            const auto read = readFile(path, 100);
            QVERIFY(std::get<FileError>(read).step == FileStep::notRegular);
        }
        QVERIFY(fs::is_symlink(file("link")));
    }
#endif

    // Reading

    void aFileIsReadBackWholly() {
        using namespace std::string_literals;
        std::string bytes = "\xEF\xBB\xBF вал\0\r\n"s;
        bytes.append(200'000, 'z');
        put(file(), bytes);
        QVERIFY(std::get<std::string>(readFile(file(), bytes.size())) == bytes);
    }

    void aFileAtTheLimitIsReadAndOneByteMoreIsNot() {
        put(file(), std::string(1000, 'x'));
        QCOMPARE(std::get<std::string>(readFile(file(), 1000)).size(), std::size_t{1000});
        const auto read = readFile(file(), 999);
        QVERIFY(std::get<FileError>(read).step == FileStep::tooLarge);
    }

    void aMissingOrForbiddenFileIsAnErrorWithItsCause() {
        const auto missing = readFile(file(), 100);
        QCOMPARE(std::get<FileError>(missing).systemError, ENOENT);
        QCOMPARE(std::get<FileError>(missing).path, file().string());
#ifndef _WIN32
        put(file(), "secret");
        ::chmod(file().c_str(), 0);
        const auto forbidden = readFile(file(), 100);
        QVERIFY(std::get<FileError>(forbidden).step == FileStep::open);
        QCOMPARE(std::get<FileError>(forbidden).systemError, EACCES);
#endif
    }
};

#ifdef _WIN32

QTEST_GUILESS_MAIN(TestSafeFile)

#else

namespace {

constexpr uid_t nobody = 65534;

/// A sticky folder with a file and a device that nobody could not make. The tests start where
/// root's home would have them start: in a folder that nobody cannot come back to.
bool prepareAsRoot() {
    rootsFolder = makeFolder();
    put(rootsFolder / "foreign", "old");
    ::chmod((rootsFolder / "foreign").c_str(), 0666);
    (void)::mknod((rootsFolder / "device").c_str(), S_IFCHR | 0666, makedev(1, 3));
    ::chmod(rootsFolder.c_str(), 01777);
    const fs::path sealed = rootsFolder / "sealed";
    return ::mkdir(sealed.c_str(), 0700) == 0 && ::chdir(sealed.c_str()) == 0;
}

int runTests(int argc, char** argv) {
    TestSafeFile test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace

int main(int argc, char** argv) {
    if (::geteuid() != 0)
        return runTests(argc, argv);
    if (!prepareAsRoot())
        return 2;
    const pid_t child = ::fork();
    if (child == 0) {
        if (::setgroups(0, nullptr) != 0 || ::setresgid(nobody, nobody, nobody) != 0
            || ::setresuid(nobody, nobody, nobody) != 0)
            return 2;
        return runTests(argc, argv);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    std::error_code ignored;
    fs::remove_all(rootsFolder, ignored);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

#endif

#include "test_safe_file.moc"
