// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of README and help, drawn by the program as it is: they are put into help-pictures/
// of the build folder, from where they are copied to resources/help/pictures. Each of those that
// are shipped is drawn here.
#include "tests/registry.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/window_bench.h"
#include "tests/whole_project.h"
#include "ui/chart/view.h"
#include "ui/window/view_tabs.h"

#include <QDir>
#include <QPushButton>

#include <functional>
#include <utility>

namespace sparkout::test_help_pictures {

constexpr int patience_ms = 60'000;

struct Scene {
    const char* name; ///< of the picture
    const char* example;
    const char* view; ///< object name
    const char* language = "en";
    Theme theme = Theme::light;
    std::function<void(Bench&)> prepare = [](Bench&) {};
};

void press(Bench& bench, const char* button) {
    auto* const found = bench.window->findChild<QPushButton*>(QString::fromLatin1(button));
    QVERIFY2(found, button);
    QTRY_VERIFY2_WITH_TIMEOUT(found->isEnabled(), button,
                              patience_ms); // a quick study runs by itself
    QTest::mouseClick(found, Qt::LeftButton);
}

void waitForRun(Bench& bench) {
    QTRY_VERIFY_WITH_TIMEOUT(!bench.window->runs().running(), patience_ms);
    bench.settle();
}

void edit(Bench& bench, Project project) {
    bench.window->document().edit(std::move(project), {"Edit", "Change"});
    waitForRun(bench);
}

void varyTwoInputs(Bench& bench) {
    Project project = bench.window->document().project();
    project.sweep =
        Sweep{{{"/wheel/dullness", 0.01, 0.05, 17},
               {"/cycle/stages/1/axial_feed_mm_min", 150, 900, 11, SweepSpacing::logarithmic}}};
    edit(bench, std::move(project));
    press(bench, "sweepRun");
}

void keepAndChange(Bench& bench) {
    bench.action("keepRun")->trigger();
    Project project = bench.window->document().project();
    project.cycle->stages[0].axial_feed_mm_min = 1400;
    edit(bench, std::move(project));
}

std::vector<Scene> scenes() {
    const char* const factory = "shaft-30h6-factory";
    const char* const optimal = "shaft-30h6-optimal";
    const char* const slender = "slender-shaft";
    const auto atStroke45 = [](Bench& bench) { bench.window->cursor().toStroke(45); };
    const auto search = [](Bench& bench) { press(bench, "optimiseRun"); };
    return {
        {"overview-en", slender, "overview"},
        {"window-en", factory, "feeds"},
        {"window-ru", factory, "feeds", "ru"},
        {"profiles-en", "plunge-shaft-two-stage", "profiles", "en", Theme::dark},
        {"constraints-en", optimal, "constraints"},
        {"layers-en", factory, "layers", "en", Theme::light, atStroke45},
        {"compliance-en", slender, "compliance"},
        {"batch-en", factory, "batch"},
        {"measured-en", "shaft-30h6-measured", "measured"},
        {"sweep-en", optimal, "sweep", "en", Theme::dark, varyTwoInputs},
        {"optimise-en", factory, "optimise", "en", Theme::light, search},
        {"compare-en", optimal, "compare", "en", Theme::light, keepAndChange},
    };
}

const Scene& sceneOf(const QString& name) {
    static const std::vector<Scene> all = scenes();
    for (const Scene& scene : all) {
        if (name == QLatin1String(scene.name)) {
            return scene;
        }
    }
    qFatal("no scene %s", qPrintable(name));
}

class TestHelpPictures : public QObject {
    Q_OBJECT

private slots:
    void everyPictureCanBeDrawnAnew_data() {
        QTest::addColumn<QString>("name");
        const QDir shipped(QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/help/pictures"));
        const QStringList files = shipped.entryList({QStringLiteral("*.png")}, QDir::Files);
        QCOMPARE(files.size(), qsizetype(scenes().size()));
        for (const QString& file : files) {
            QTest::newRow(qPrintable(file)) << file.chopped(4);
        }
    }

    void everyPictureCanBeDrawnAnew() {
        QFETCH(QString, name);
        const Scene& scene = sceneOf(name);
        Bench bench(QString::fromLatin1(scene.language), scene.theme);
        const QString file = examplePath(scene.example);
        QVERIFY(bench.open(file));
        QVERIFY(bench.window->showView(QLatin1String(scene.view)));
        bench.settle();
        View& view = *bench.window->viewTabs().findChild<View*>(QLatin1String(scene.view));
        scene.prepare(bench);
        bench.settle();
        QTRY_VERIFY_WITH_TIMEOUT(!view.busy(), patience_ms);
        QTest::qWait(50); // what is found beside the work, as remedies are
        bench.settle();
        const QDir folder(QStringLiteral(SPARKOUT_BUILD_DIR "/help-pictures"));
        QVERIFY(folder.mkpath(QStringLiteral(".")));
        const QImage drawn = bench.window->grab().toImage().convertToFormat(QImage::Format_RGB32);
        QCOMPARE(drawn.size(), QSize(1366, 768));
        QVERIFY(drawn.save(folder.filePath(name + QStringLiteral(".png"))));
    }
};

} // namespace sparkout::test_help_pictures

SPARKOUT_TEST(test_help_pictures, TestHelpPictures)
#include "test_help_pictures.moc"
