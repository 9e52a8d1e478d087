// SPDX-License-Identifier: GPL-3.0-or-later
// Packs: read strictly, every part as its own file would be.
#include "core/lesson/pack.h"

#include "tests/core/catalogue/shipped_catalogues.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/core/support/json_mutator.h"
#include "tests/core/support/project_mutator.h"
#include "tests/registry.h"

namespace sparkout::test_pack {

using nlohmann::json;

const char* const lessonName = "02-actual-feed.sparkout-lesson";

/// With every part: two machines, three wheels, a material, heads, a lesson.
Pack samplePack() {
    Pack pack;
    pack.title = "Лаборатория шлифования";
    pack.note = "For group 401";
    pack.machines = catalogues::shipped<MachineEntry>();
    pack.machines.resize(2);
    pack.wheels = catalogues::shipped<WheelEntry>();
    pack.wheels.resize(3);
    pack.materials = catalogues::shipped<MaterialEntry>();
    pack.materials.resize(1);
    pack.company = {{"name", "Завод"}, {"developed", "A. Smith"}};
    pack.logo = std::string(8192 + 4, 'A');
    pack.lessons.push_back({lessonName, samples::lesson()});
    return pack;
}

std::string faultOfPack(const ReadPack& read) {
    if (read.pack.has_value() == hasErrors(read.issues)) {
        return "a pack with errors, or none without";
    }
    if (read.issues.size() > limits::issues) {
        return "too many issues";
    }
    for (const Issue& issue : read.issues) {
        if (issueSentence(issue).empty()) {
            return "no sentence";
        }
    }
    if (read.pack) {
        const std::string text = writePack(*read.pack);
        const ReadPack again = readPack(text);
        if (!again.pack || writePack(*again.pack) != text) {
            return "does not round-trip";
        }
    }
    return {};
}

class TestPack : public QObject {
    Q_OBJECT

private slots:
    void whatIsWrittenIsReadAgain() {
        const Pack pack = samplePack();
        const std::string text = writePack(pack);
        const ReadPack read = readPack(text);
        QVERIFY2(read.pack && read.issues.empty(),
                 read.issues.empty() ? "" : issueSentence(read.issues.front()).c_str());
        QCOMPARE(read.pack->title, pack.title);
        QCOMPARE(read.pack->note, pack.note);
        QCOMPARE(writeCatalogue(read.pack->machines), writeCatalogue(pack.machines));
        QCOMPARE(writeCatalogue(read.pack->wheels), writeCatalogue(pack.wheels));
        QCOMPARE(writeCatalogue(read.pack->materials), writeCatalogue(pack.materials));
        QCOMPARE(read.pack->company, pack.company);
        QCOMPARE(read.pack->logo, pack.logo);
        QCOMPARE(read.pack->lessons.size(), std::size_t{1});
        QCOMPARE(read.pack->lessons.front().file, std::string(lessonName));
        QCOMPARE(writeLesson(read.pack->lessons.front().lesson), samples::lessonText());
        QCOMPARE(writePack(*read.pack), text);
        QCOMPARE(read.pack->count(), std::size_t{2 + 3 + 1 + 1 + 1});
    }

    void anEmptyPackIsAPack() {
        const ReadPack read = readPack(writePack({}));
        QVERIFY(read.pack && read.issues.empty());
        QCOMPARE(read.pack->count(), std::size_t{0});
    }

    void aLessonForStudentsIsTaken() {
        Pack pack;
        pack.lessons.push_back({lessonName, forStudents(samples::lesson())});
        const ReadPack read = readPack(writePack(pack));
        QVERIFY(read.pack);
        QCOMPARE(writePack(*read.pack), writePack(pack));
    }

    void faultsAreRefusedWithTheirPath_data() {
        addColumns<QString, QString, int, QString>("pointer", "value", "code", "path");
        const auto row = [](const char* name, const char* pointer, const char* value,
                            IssueCode code, const char* path) {
            addRow(name, pointer, value, static_cast<int>(code), path);
        };
        row("another format", "/format", "\"sparkout-lesson\"", IssueCode::notOneOf, "/format");
        row("a newer one", "/version", "2", IssueCode::newerVersion, "/version");
        row("an unknown key", "/script", "\"rm\"", IssueCode::unknownKey, "/script");
        row("no text", "/title", "1", IssueCode::wrongType, "/title");
        row("no catalogue", "/wheels", "[]", IssueCode::wrongType, "/wheels");
        row("another kind", "/wheels/kind", "\"machines\"", IssueCode::notOneOf, "/wheels/kind");
        row("a value of an entry", "/wheels/entries/1/value/diameter_mm", "-1",
            IssueCode::outOfRange, "/wheels/entries/1/value/diameter_mm");
        row("a head", "/company/name", "[]", IssueCode::wrongType, "/company/name");
        row("no logo", "/company/logo", "\"A\"", IssueCode::wrongType, "/company/logo");
        row("half a logo", "/company/logo", "[\"AAAAA\"]", IssueCode::wrongType, "/company/logo");
        row("no base64", "/company/logo", "[\"A<A=\"]", IssueCode::wrongType, "/company/logo");
        row("padding inside", "/company/logo", "[\"A=AA\"]", IssueCode::wrongType, "/company/logo");
        row("no lessons", "/lessons", "[]", IssueCode::wrongType, "/lessons");
        for (const char* name :
             {"a", ".sparkout-lesson", "x.sparkout", "~1etc~1x.sparkout-lesson",
              "..~1x.sparkout-lesson", "..\\x.sparkout-lesson", ".x.sparkout-lesson",
              "C:x.sparkout-lesson", "x\n.sparkout-lesson", "x.sparkout-lesson "}) {
            row(name, (std::string("/lessons/") + name).c_str(), "{}", IssueCode::notAFileName,
                "/lessons/");
        }
        row("a fault of a lesson", "/lessons/02-actual-feed.sparkout-lesson/steps", "[]",
            IssueCode::wrongCount, "/lessons/02-actual-feed.sparkout-lesson/steps");
    }
    void faultsAreRefusedWithTheirPath() {
        QFETCH(const QString, pointer);
        QFETCH(const QString, value);
        QFETCH(const int, code);
        QFETCH(const QString, path);
        json file = json::parse(writePack(samplePack()));
        file[json::json_pointer(pointer.toStdString())] = json::parse(value.toStdString());
        const ReadPack read = readPack(file.dump());
        QVERIFY(!read.pack);
        QVERIFY2(std::ranges::any_of(read.issues,
                                     [&](const Issue& issue) {
                                         return issue.code == static_cast<IssueCode>(code)
                                                && issue.path.starts_with(path.toStdString());
                                     }),
                 (read.issues.front().path + " " + issueSentence(read.issues.front())).c_str());
    }

    void twoEntriesOfOneNameAreRefused() {
        Pack pack = samplePack();
        pack.wheels[2].name = pack.wheels[0].name;
        const ReadPack read = readPack(writePack(pack));
        QVERIFY(!read.pack);
        QCOMPARE(read.issues.size(), std::size_t{1});
        QCOMPARE(read.issues.front().code, IssueCode::nameTwice);
        QCOMPARE(read.issues.front().path, std::string("/wheels/entries/2/name"));
    }

    void tooMuchIsRefused() {
        Pack pack;
        pack.title = std::string(limits::packText + 1, 'x');
        pack.note = std::string(limits::packNote + 1, 'x');
        pack.logo = std::string(limits::logoText + 4, 'A');
        const ReadPack read = readPack(writePack(pack));
        QVERIFY(!read.pack);
        QCOMPARE(read.issues.size(), std::size_t{3});
        for (const Issue& issue : read.issues) {
            QCOMPARE(issue.code, IssueCode::stringTooLong);
        }
        json file = {{"format", packFormat}, {"version", packVersion}};
        for (std::size_t i = 0; i <= limits::packLessons; ++i) {
            file["lessons"][std::to_string(i) + ".sparkout-lesson"] = json::object();
        }
        const ReadPack many = readPack(file.dump());
        QVERIFY(!many.pack);
        QCOMPARE(many.issues.front().code, IssueCode::wrongCount);
    }

    void namesOfLessonFiles() {
        QVERIFY(isLessonFileName("Работа 3, зоны.sparkout-lesson"));
        QVERIFY(isLessonFileName(std::string(104, 'x') + ".sparkout-lesson"));
        QVERIFY(!isLessonFileName(std::string(105, 'x') + ".sparkout-lesson"));
        QVERIFY(!isLessonFileName("a/b.sparkout-lesson"));
        QVERIFY(!isLessonFileName(std::string("a\0.sparkout-lesson", 18)));
    }

    void damagedPacksAreAnswered() {
        std::string text = writePack(samplePack());
        const auto step = static_cast<std::size_t>(samples::sized(911, 6111, 211));
        for (std::size_t length = 0; length < text.size(); length += step) {
            const std::string fault = faultOfPack(readPack(text.substr(0, length)));
            QVERIFY2(fault.empty(), (fault + " at " + std::to_string(length)).c_str());
        }
        for (std::size_t bit = 0; bit < 8 * text.size(); bit += 8 * step + 1) {
            const char before = text[bit / 8];
            text[bit / 8] = static_cast<char>(before ^ (1 << bit % 8));
            const std::string fault = faultOfPack(readPack(text));
            QVERIFY2(fault.empty(), (fault + " at bit " + std::to_string(bit)).c_str());
            text[bit / 8] = before;
        }
        auto pick = samples::fromSeed(20261127);
        const json whole = json::parse(text);
        int accepted = 0;
        const int tries = samples::sized(200, 30, 2000);
        for (int i = 0; i < tries; ++i) {
            json file = whole;
            for (int changes = 1 + pick(3); changes > 0; --changes) {
                samples::mutateJson(file, pick);
            }
            const ReadPack read = readPack(file.dump());
            const std::string fault = faultOfPack(read);
            QVERIFY2(fault.empty(), (fault + "\n" + file.dump()).c_str());
            accepted += read.pack ? 1 : 0;
        }
        qInfo("%d of %d mutated packs were taken", accepted, tries);
        QVERIFY(accepted > 0 && accepted < tries);
    }
};

} // namespace sparkout::test_pack

SPARKOUT_TEST(test_pack, TestPack)
#include "test_pack.moc"
