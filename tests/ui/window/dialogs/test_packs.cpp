// SPDX-License-Identifier: GPL-3.0-or-later
// Packs by the hands of those who make one and those who take it in.
#include "core/file/project_file.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/pack.h"
#include "core/study/new_project.h"
#include "tests/registry.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/logo_samples.h"
#include "tests/ui/support/on_disk.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/lesson/lessons_dialog.h"
#include "ui/session/own_lessons.h"
#include "ui/session/settings.h"
#include "ui/window/dialogs/pack_commands.h"
#include "ui/window/dialogs/pack_plan.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTreeWidget>

namespace sparkout::test_packs {

using on_disk::bytesOf;

const QString lessonName = QStringLiteral("02-actual-feed.sparkout-lesson");

void write(const QString& path, const QByteArray& bytes) {
    QDir().mkpath(QFileInfo(path).absolutePath());
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

QString shippedLesson() {
    return QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/lessons/") + lessonName;
}

/// Somebody's program: his settings, and what stands beside them.
struct Seat {
    QTemporaryDir home;
    Settings settings{home.filePath(QStringLiteral("settings.ini"))};

    [[nodiscard]] std::unique_ptr<CatalogueStore> wheels() const {
        return CatalogueStore::make(CatalogueKind::wheels, settings.folder());
    }
    void keepWheel(const QString& name, double diameter_mm) const {
        Project project = newProject(Operation::traverse);
        project.wheel->diameter_mm = diameter_mm;
        QCOMPARE(wheels()->save(project, name), QString());
    }
    [[nodiscard]] double wheelDiameter(const QString& name) const {
        const auto store = wheels();
        for (const CatalogueItem& item : store->items()) {
            if (item.own && entryName(item.entry) == name) {
                return std::get<WheelEntry>(item.entry).value.diameter_mm;
            }
        }
        return 0;
    }
    /// A teacher with two wheels, a machine, heads with a logo and a lesson.
    void fill() {
        keepWheel(QStringLiteral("Круг 1"), 500);
        keepWheel(QStringLiteral("Круг 2"), 450);
        auto machines = CatalogueStore::make(CatalogueKind::machines, settings.folder());
        QCOMPARE(machines->save(newProject(Operation::plunge), QStringLiteral("3М151 № 7")),
                 QString());
        Company company;
        company.name = "Кафедра";
        company.developed = "Иванов";
        company.logo = samples::picture({160, 40}, "PNG");
        settings.setCompany(company);
        write(ownLessonsFolder(settings.folder()) + u'/' + lessonName, bytesOf(shippedLesson()));
    }
};

Pack packOf(Seat& seat) {
    return PackExportDialog(seat.settings, nullptr).pack();
}

std::size_t lineOf(const PackPlan& plan, const QString& name) {
    for (std::size_t i = 0; i < plan.lines().size(); ++i) {
        if (plan.lines()[i].name == name) {
            return i;
        }
    }
    qFatal("no line %s", qPrintable(name));
}

class TestPacks : public QObject {
    Q_OBJECT

private slots:
    /// By clicks from one program into a file, and by clicks from the file into another.
    void whatOneMakesAnotherTakesIn() {
        Seat teacher, student;
        teacher.fill();
        const QString path = teacher.home.filePath(QStringLiteral("класс.sparkout-pack"));
        QWidget window;
        window.show();
        {
            PackCommands commands(teacher.settings, &window);
            DialogAnswers answers({QStringLiteral("savePack"), QStringLiteral("file:") + path});
            answers.seen = [](QDialog& dialog) {
                if (auto* title = dialog.findChild<QLineEdit*>(QStringLiteral("packTitle"))) {
                    QTest::keyClicks(title, QStringLiteral("Class 401"));
                    const auto* tree = dialog.findChild<QTreeWidget*>(QStringLiteral("packParts"));
                    QCOMPARE(tree->topLevelItemCount(), 4); // machine, wheels, heads, lesson
                }
            };
            commands.exportPack();
            QCOMPARE(answers.fault(), QString());
        }
        QVERIFY(QFileInfo::exists(path));
        PackCommands commands(student.settings, &window);
        DialogAnswers answers({QStringLiteral("importPack")});
        answers.seen = [](QDialog& dialog) {
            const auto* lines = dialog.findChild<QTreeWidget*>(QStringLiteral("packLines"));
            QCOMPARE(lines->topLevelItemCount(), 5);
        };
        commands.importFile(path);
        QCOMPARE(answers.fault(), QString());
        QCOMPARE(student.wheelDiameter(QStringLiteral("Круг 1")), 500.0);
        QCOMPARE(student.wheelDiameter(QStringLiteral("Круг 2")), 450.0);
        QVERIFY(CatalogueStore::make(CatalogueKind::machines, student.settings.folder())
                    ->hasOwn(QStringLiteral("3М151 № 7")));
        QVERIFY(student.settings.company() == teacher.settings.company());
        QCOMPARE(bytesOf(ownLessons(student.settings.folder()).value(0)), bytesOf(shippedLesson()));
        // Taken in again there is nothing left to take.
        PackPlan again(packOf(teacher), student.settings);
        QCOMPARE(again.chosen(), 0);
        for (const PackPlan::Line& line : again.lines()) {
            QCOMPARE(line.state, PackPlan::State::same);
        }
    }

    /// What he has of the same name stays unless he says so, and is then shown value by value.
    void conflictsAreShownAndNothingIsReplacedUnasked() {
        Seat teacher, student;
        teacher.fill();
        student.keepWheel(QStringLiteral("Круг 1"), 600);
        Company own;
        own.name = "Завод";
        student.settings.setCompany(own);
        const QString lesson = ownLessonsFolder(student.settings.folder()) + u'/' + lessonName;
        write(lesson, "{}");
        const Pack pack = packOf(teacher);
        {
            PackPlan plan(pack, student.settings);
            const std::size_t wheel = lineOf(plan, QStringLiteral("Круг 1"));
            QCOMPARE(plan.lines()[wheel].state, PackPlan::State::different);
            QCOMPARE(plan.lines()[wheel].choice, PackPlan::Choice::leave);
            const auto differences = plan.differences(wheel);
            QCOMPARE(differences.size(), std::size_t{1});
            QCOMPARE(differences.front().yours, QStringLiteral("600"));
            QCOMPARE(differences.front().packs, QStringLiteral("500"));
            const auto heads = plan.differences(lineOf(plan, QStringLiteral("Кафедра")));
            QCOMPARE(heads.size(), std::size_t{3}); // name, developed, logo
            QCOMPARE(heads.front().yours, QStringLiteral("Завод"));
            QCOMPARE(plan.carryOut(student.settings), QStringList());
        }
        QCOMPARE(student.wheelDiameter(QStringLiteral("Круг 1")), 600.0);
        QCOMPARE(student.wheelDiameter(QStringLiteral("Круг 2")), 450.0); // he had none
        QVERIFY(student.settings.company() == own);
        QCOMPARE(bytesOf(lesson), QByteArray("{}"));

        PackPlan plan(pack, student.settings);
        plan.choose(lineOf(plan, QStringLiteral("Круг 1")), PackPlan::Choice::takeBeside);
        for (std::size_t i = 0; i < plan.lines().size(); ++i) {
            if (plan.lines()[i].part == PackPart::lesson) {
                plan.choose(i, PackPlan::Choice::takeBeside);
            } else if (plan.lines()[i].part == PackPart::company) {
                plan.choose(i, PackPlan::Choice::take);
            }
        }
        QCOMPARE(plan.carryOut(student.settings), QStringList());
        QCOMPARE(student.wheelDiameter(QStringLiteral("Круг 1")), 600.0);
        QCOMPARE(student.wheelDiameter(QStringLiteral("Круг 1 (2)")), 500.0);
        QVERIFY(student.settings.company() == teacher.settings.company());
        QCOMPARE(bytesOf(lesson), QByteArray("{}"));
        QCOMPARE(ownLessons(student.settings.folder()).size(), 2);
        QCOMPARE(bytesOf(ownLessonsFolder(student.settings.folder())
                         + QStringLiteral("/02-actual-feed (2).sparkout-lesson")),
                 bytesOf(shippedLesson()));

        PackPlan replacing(pack, student.settings);
        replacing.choose(lineOf(replacing, QStringLiteral("Круг 1")), PackPlan::Choice::take);
        QCOMPARE(replacing.carryOut(student.settings), QStringList());
        QCOMPARE(student.wheelDiameter(QStringLiteral("Круг 1")), 500.0);
    }

    /// A drawing is neither shown nor kept, and takes nobody's logo away.
    void aDrawingIsRefusedAsALogoAndTheRestIsTaken() {
        for (const QByteArray& drawing :
             {bytesOf(QStringLiteral(":/icons/sparkout.svg")),
              QByteArray("<svg><image href=\"/etc/hostname\"/></svg>"), QByteArray("GIF89a")}) {
            Seat student;
            Company own;
            own.name = "Завод";
            own.logo = samples::picture({80, 20}, "JPG");
            student.settings.setCompany(own);
            Pack pack;
            pack.company["name"] = "Кафедра";
            pack.logo = drawing.toBase64().toStdString();
            PackImportDialog dialog(pack, student.settings, nullptr);
            const auto* fault = dialog.findChild<QLabel*>(QStringLiteral("packLogoFault"));
            QVERIFY(fault && fault->text().contains(QStringLiteral("PNG")));
            PackPlan plan(pack, student.settings);
            QCOMPARE(plan.differences(0).size(), std::size_t{1}); // the name
            plan.choose(0, PackPlan::Choice::take);
            QCOMPARE(plan.carryOut(student.settings), QStringList());
            own.name = "Кафедра";
            QVERIFY(student.settings.company() == own);
            // Nor does it go on from settings that hold one.
            own.logo = drawing;
            student.settings.setCompany(own);
            QCOMPARE(packOf(student).logo, std::string());
        }
    }

    /// A picture whose head alone is in order: found out when it is taken, not before.
    void aPictureIsDecodedOnceItIsTaken() {
        Seat student;
        Pack pack;
        pack.company["name"] = "Кафедра";
        pack.logo =
            samples::withoutPixels(samples::picture({80, 20}, "PNG")).toBase64().toStdString();
        PackPlan plan(pack, student.settings);
        QCOMPARE(plan.logoFault(), QString());
        QCOMPARE(plan.differences(0).size(), std::size_t{2}); // the name, the logo
        QCOMPARE(plan.carryOut(student.settings).size(), 1);
        QCOMPARE(student.settings.company().name, std::string("Кафедра"));
        QVERIFY(student.settings.company().logo.isEmpty());
    }

    void anEntryOfAShippedNameIsNamedSo() {
        Seat seat;
        const auto store = seat.wheels();
        Pack pack;
        PackParts::add(store->items().front().entry, pack);
        PackPlan same(pack, seat.settings);
        QCOMPARE(same.lines().front().state, PackPlan::State::same);
        pack.wheels.front().value.diameter_mm -= 1;
        PackPlan other(pack, seat.settings);
        QCOMPARE(other.lines().front().state, PackPlan::State::shipped);
        QCOMPARE(other.differences(0).size(), std::size_t{1});
    }

    /// Chosen in the dialog by the keyboard.
    void theDialogTakesWhatItsBoxesSay() {
        Seat teacher, student;
        teacher.fill();
        student.keepWheel(QStringLiteral("Круг 2"), 400);
        PackImportDialog dialog(packOf(teacher), student.settings, nullptr);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        auto* lines = dialog.findChild<QTreeWidget*>(QStringLiteral("packLines"));
        const auto row = [lines](const QString& name) {
            return lines->findItems(name, Qt::MatchExactly, 1).value(0);
        };
        auto* box = qobject_cast<QComboBox*>(lines->itemWidget(row(QStringLiteral("Круг 2")), 3));
        QVERIFY(box);
        QCOMPARE(box->count(), 3);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Down); // keep yours → replace yours
        QCOMPARE(lines->currentItem(), row(QStringLiteral("Круг 2")));
        const auto* differences = dialog.findChild<QTreeWidget*>(QStringLiteral("packDifferences"));
        QCOMPARE(differences->topLevelItemCount(), 1);
        auto* other = qobject_cast<QComboBox*>(lines->itemWidget(row(QStringLiteral("Круг 1")), 3));
        other->setFocus();
        QTest::keyClick(other, Qt::Key_Up); // take → do not
        QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("importPack")),
                          Qt::LeftButton);
        QVERIFY(!dialog.isVisible());
        QCOMPARE(student.wheelDiameter(QStringLiteral("Круг 2")), 450.0);
        QCOMPARE(student.wheelDiameter(QStringLiteral("Круг 1")), 0.0);
    }

    void lessonsForStudentsHoldNoAnswers() {
        Seat teacher;
        teacher.fill();
        PackExportDialog dialog(teacher.settings, nullptr);
        QVERIFY(dialog.pack().lessons.front().lesson.variants.has_value());
        dialog.findChild<QCheckBox*>(QStringLiteral("packForStudents"))->setChecked(true);
        const Pack pack = dialog.pack();
        QVERIFY(!pack.lessons.front().lesson.variants.has_value());
        QCOMPARE(
            writeLesson(pack.lessons.front().lesson),
            writeLesson(forStudents(*readLesson(bytesOf(shippedLesson()).toStdString()).lesson)));
        QVERIFY(readPack(writePack(pack)).pack);
    }

    /// Taken in from a pack it stands in the list of laboratory works.
    void aLessonTakenInIsListed() {
        Seat teacher, student;
        teacher.fill();
        PackExportDialog dialog(teacher.settings, nullptr);
        dialog.findChild<QCheckBox*>(QStringLiteral("packForStudents"))->setChecked(true);
        PackPlan plan(dialog.pack(), student.settings);
        QCOMPARE(plan.carryOut(student.settings), QStringList());
        const LessonsDialog shipped({});
        const LessonsDialog all(student.settings.folder());
        const auto entries = [](const LessonsDialog& lessons) {
            return lessons.findChild<QListWidget*>(QStringLiteral("lessons"))->count();
        };
        QCOMPARE(entries(all), entries(shipped) + 1);
    }

    void whatIsNoLessonIsNotAdded() {
        Seat seat;
        PackExportDialog dialog(seat.settings, nullptr);
        const auto* state = dialog.findChild<QLabel*>(QStringLiteral("packState"));
        const auto* save = dialog.findChild<QPushButton*>(QStringLiteral("savePack"));
        QVERIFY(!save->isEnabled());
        dialog.addLessons({QStringLiteral(SPARKOUT_SOURCE_DIR "/README.md")});
        QVERIFY(state->text().contains(QStringLiteral("README.md")));
        dialog.addLessons({seat.home.filePath(QStringLiteral("none.sparkout-lesson"))});
        QVERIFY(!state->text().isEmpty());
        dialog.addLessons({shippedLesson(), shippedLesson()});
        QVERIFY(state->text().contains(lessonName));
        QCOMPARE(dialog.pack().lessons.size(), std::size_t{1});
        QVERIFY(save->isEnabled());
    }

    /// A damaged pack and one of a project are refused by name, and nothing is written.
    void whatIsNoPackIsRefused() {
        Seat seat;
        const QString path = seat.home.filePath(QStringLiteral("x.sparkout-pack"));
        QWidget window;
        PackCommands commands(seat.settings, &window);
        for (const QByteArray& bytes :
             {QByteArray(), QByteArray("{"), QByteArray("{\"format\": \"sparkout-project\"}"),
              QByteArray("{\"format\": \"sparkout-pack\", \"version\": 2}")}) {
            write(path, bytes);
            DialogAnswers answers({QStringLiteral("Escape")});
            QString title;
            answers.seen = [&](QDialog& dialog) { title = dialog.windowTitle(); };
            commands.importFile(path);
            QCOMPARE(answers.fault(), QString());
            QVERIFY(!title.isEmpty());
        }
        DialogAnswers answers({QStringLiteral("Escape")});
        commands.importFile(seat.home.filePath(QStringLiteral("none.sparkout-pack")));
        QCOMPARE(answers.fault(), QString());
        QVERIFY(!QFileInfo::exists(seat.settings.folder() + QStringLiteral("/catalogue")));
    }

    /// A folder that cannot be made: said, and the rest is taken all the same.
    void whatCannotBeKeptIsSaid() {
        Seat teacher, student;
        teacher.fill();
        write(ownLessonsFolder(student.settings.folder()), "a file in its place");
        PackPlan plan(packOf(teacher), student.settings);
        QCOMPARE(plan.carryOut(student.settings).size(), 1);
        QCOMPARE(student.wheelDiameter(QStringLiteral("Круг 1")), 500.0);
    }

    void theMenuOpensBothInRussian() {
        Bench bench(QStringLiteral("ru"));
        Seat teacher;
        teacher.fill();
        QString english;
        const auto look = [&english](QDialog& dialog) {
            english += englishIn(dialog.windowTitle());
            for (const auto* label : dialog.findChildren<QLabel*>()) {
                english += englishIn(label->text());
            }
            for (const auto* button : dialog.findChildren<QAbstractButton*>()) {
                english += englishIn(button->text());
            }
        };
        DialogAnswers answers({QStringLiteral("Escape"), QStringLiteral("Escape")});
        answers.seen = look;
        bench.action("exportPack")->trigger();
        Pack pack = packOf(teacher);
        PackImportDialog dialog(pack, teacher.settings, bench.window.get());
        QTimer::singleShot(0, &dialog, [&dialog] { dialog.open(); });
        QTRY_VERIFY(!dialog.isVisible() && dialog.result() == QDialog::Rejected
                    && answers.fault().isEmpty());
        QCOMPARE(english, QString());
    }
};

} // namespace sparkout::test_packs

SPARKOUT_TEST(test_packs, TestPacks)
#include "test_packs.moc"
