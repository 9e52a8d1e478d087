// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of the layers, painted and by OpenGL: one grid, one projection, one look. What needs
// a screen runs in this program started once more, with --screen, on a server of its own.
#include "tests/ui/likeness.h"
#include "tests/ui/view_fixtures.h"
#include "tests/ui/window_bench.h"
#include "ui/gl/surface_graph.h"
#include "ui/view_tabs.h"
#include "ui/views/layers_surface.h"
#include "ui/views/layers_view.h"
#include "ui/views/plot_tools.h"
#include "ui/views/surface_opengl.h"

#include <QtDataVisualization/QSurfaceDataProxy>

#include <QComboBox>
#include <QProcess>
#include <QSlider>
#include <QStandardPaths>
#include <QTest>

#include <algorithm>
#include <clocale>
#include <cmath>

using namespace sparkout;

namespace {

/// A surface alone, with a run.
struct Alone {
    explicit Alone(const Project& project) : outcome(fixtures::run(project)) {
        surface.resize(640, 420);
        surface.setSeries(outcome->layers);
    }
    OutcomePtr outcome;
    LayersSurface surface;
};

/// Draws nothing but one colour, and remembers what it was asked.
class Recorder : public SurfaceDrawer {
public:
    struct Asked {
        SurfaceGrid grid;
        SurfaceSight sight;
        QSize pixels;
        int times = 0;
    };
    Recorder(Asked& asked, bool works) : m_asked(asked), m_works(works) {}
    [[nodiscard]] QImage draw(const SurfaceGrid& grid, const SurfaceSight& sight,
                              const QSize& pixels) override {
        m_asked = {grid, sight, pixels, m_asked.times + 1};
        QImage picture(pixels, QImage::Format_RGB32);
        picture.fill(Qt::magenta);
        return m_works ? picture : QImage();
    }

private:
    Asked& m_asked;
    bool m_works;
};

bool has(const QImage& picture, const QColor& colour) {
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            if (picture.pixel(x, y) == colour.rgb()) {
                return true;
            }
        }
    }
    return false;
}

QImage painted(LayersSurface& surface) {
    return surface.toPixmap(surface.width(), surface.height()).toImage();
}

} // namespace

/// Without a screen.
class TestSurface : public QObject {
    Q_OBJECT

private slots:
    void init() { applyTheme(Theme::light); }

    /// Point by point, from the run's layers.
    void theGraphHasThePointsOfTheRun() {
        for (const Project& project : {fixtures::traverseProject(), fixtures::plungeProject(3)}) {
            const Alone alone(project);
            const LayerSeries& series = alone.outcome->layers;
            const SurfaceGrid grid = alone.surface.grid();
            std::size_t rows = 0;
            for (const SurfaceSheet& sheet : grid.sheets) {
                QSurface3DSeries graph;
                SurfaceGraph::fill(graph, sheet, grid.scales);
                const QSurfaceDataProxy& proxy = *graph.dataProxy();
                QCOMPARE(proxy.columnCount(), 2 * int(series.columns.size()));
                QCOMPARE(proxy.rowCount(), int(sheet.numbers.size()));
                for (int i = 0; i < proxy.rowCount(); ++i, ++rows) {
                    const float number = proxy.itemAt(i, 0)->z();
                    const auto span =
                        std::ranges::find(series.spans, int(number), &LayerSpan::last);
                    for (const LayerColumn& column : series.columns) {
                        const double sum =
                            span == series.spans.end()
                                ? 0
                                : column.sum_mm[std::size_t(span - series.spans.begin())];
                        int found = 0;
                        for (int j = 0; j < proxy.columnCount(); ++j) {
                            const QVector3D at = proxy.itemAt(i, j)->position();
                            const bool end = at.x() == float(column.stretch.from_mm)
                                             || at.x() == float(column.stretch.to_mm);
                            found += end && std::abs(at.y() - sum * 1e3) < 1e-3 ? 1 : 0;
                        }
                        QVERIFY(found >= 2);
                    }
                }
            }
            QVERIFY(rows > 20);
        }
    }

    void theScalesAreThoseOfTheRun() {
        const Alone alone(fixtures::traverseProject());
        const SurfaceGrid grid = alone.surface.grid();
        const char* titles[] = {"Length, mm", "Double stroke", "Accumulated actual feed, µm"};
        const LayerSeries& series = alone.outcome->layers;
        const double most[] = {series.length_mm, double(series.spans.back().last),
                               series.largestSum_mm() * 1e3};
        for (std::size_t i = 0; i < 3; ++i) {
            QValue3DAxis axis;
            SurfaceGraph::setScale(axis, grid.scales[i]);
            QCOMPARE(axis.title(), QString::fromUtf8(titles[i]));
            QCOMPARE(axis.min(), 0.0F);
            QCOMPARE(axis.max(), float(most[i]));
        }
        const Alone plunge(fixtures::plungeProject(2));
        QCOMPARE(plunge.surface.grid().scales[1].title, QStringLiteral("Revolution"));
    }

    /// In the middle of each facet, in every theme; and the painter uses them too.
    void theColoursAreThoseThatArePainted() {
        for (const Theme theme : {Theme::light, Theme::dark, Theme::contrast}) {
            applyTheme(theme);
            Alone alone(fixtures::traverseProject());
            const SurfaceGrid grid = alone.surface.grid();
            QCOMPARE(grid.background, alone.surface.palette().color(QPalette::Base));
            const QImage picture = painted(alone.surface);
            QVERIFY(has(picture, grid.background) && has(picture, grid.wall));
            for (const SurfaceSheet& sheet : grid.sheets) {
                const QImage texture = SurfaceGraph::texture(sheet);
                const auto pixel = [](double share, int size) { return int(share * size); };
                const double length = sheet.lengths_mm.back(), from = sheet.numbers.front();
                const double all = sheet.numbers.back() - from;
                for (std::size_t i = 0; i + 1 < sheet.numbers.size(); ++i) {
                    for (std::size_t j = 0; j + 1 < sheet.columns(); j += 2) {
                        const double x = (sheet.lengths_mm[j] + sheet.lengths_mm[j + 1]) / 2;
                        const double y = (sheet.numbers[i] + sheet.numbers[i + 1]) / 2;
                        QCOMPARE(texture
                                     .pixelColor(pixel(x / length, texture.width()),
                                                 pixel(1 - (y - from) / all, texture.height()))
                                     .rgb(),
                                 sheet.colour(i, j).rgb());
                    }
                }
            }
        }
    }

    /// The angles and the size go to what draws as they are painted; keys and mouse turn both.
    void whatDrawsFollowsTheAngles() {
        Alone alone(fixtures::traverseProject());
        Recorder::Asked asked;
        alone.surface.setDrawer(std::make_unique<Recorder>(asked, true));
        alone.surface.show();
        for (const double azimuth : {-52.0, 20.0, 140.0}) {
            const PlotHistory::State fit = alone.surface.sight();
            alone.surface.setSight({-azimuth - 45, -azimuth + 45, 10, 70});
            alone.surface.replot();
            QCOMPARE(asked.pixels, alone.surface.cell()->rect().size());
            QVERIFY(std::abs(asked.sight.azimuth - azimuth) < 1e-9);
            QVERIFY(std::abs(asked.sight.elevation - 40) < 1e-9);
            const QPointF along = alone.surface.project(1, 0, 0) - alone.surface.project(0, 0, 0);
            const double a = azimuth / 180 * M_PI, e = 40.0 / 180 * M_PI;
            const double seen = std::hypot(std::cos(a), std::sin(a) * std::sin(e));
            QVERIFY(std::abs(std::hypot(along.x(), along.y()) - asked.sight.edge * seen) < 1e-6);
            QCOMPARE(asked.grid, alone.surface.grid());
            alone.surface.setSight(fit);
        }
        QVERIFY(has(alone.surface.grab().toImage(), Qt::magenta));
    }

    void picturesArePainted() {
        Alone alone(fixtures::traverseProject());
        const QImage before = painted(alone.surface);
        Recorder::Asked asked;
        alone.surface.setDrawer(std::make_unique<Recorder>(asked, true));
        alone.surface.show();
        alone.surface.replot();
        QVERIFY(asked.times > 0);
        const int times = asked.times;
        QVERIFY(painted(alone.surface) == before);
        QCOMPARE(asked.times, times);
    }

    void whatCannotDrawAnyMoreIsLeftForThePainter() {
        Alone alone(fixtures::traverseProject());
        Recorder::Asked asked;
        alone.surface.show();
        alone.surface.replot();
        const QImage before = alone.surface.grab().toImage();
        alone.surface.setDrawer(std::make_unique<Recorder>(asked, false));
        alone.surface.replot();
        QCOMPARE(asked.times, 1);
        QVERIFY(!alone.surface.usesOpenGl());
        QVERIFY(alone.surface.grab().toImage() == before);
    }

    void withoutAScreenItIsPainted() {
        QVERIFY(!openGlWorks());
        Alone alone(fixtures::traverseProject());
        alone.surface.show();
        QTest::qWait(50);
        QVERIFY(!alone.surface.usesOpenGl());
    }

    void withAScreenOpenGlDrawsIt() {
        const QString server = QStandardPaths::findExecutable(QStringLiteral("Xvfb"));
        if (server.isEmpty()) {
            QSKIP("Xvfb is not there");
        }
        QProcess screen;
        screen.setProcessChannelMode(QProcess::SeparateChannels);
        screen.start(server,
                     {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"),
                      QStringLiteral("0"), QStringLiteral("1400x800x24"),
                      QStringLiteral("-nolisten"), QStringLiteral("tcp")});
        QVERIFY(screen.waitForReadyRead(30'000));
        QProcess test;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("DISPLAY"),
                           u':' + QString::fromLatin1(screen.readLine()).trimmed());
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb"));
        environment.insert(QStringLiteral("LIBGL_ALWAYS_SOFTWARE"), QStringLiteral("1"));
        environment.insert(QStringLiteral("SPARKOUT_SOFTWARE_OPENGL"), QStringLiteral("1"));
        environment.remove(QStringLiteral("SPARKOUT_NO_OPENGL"));
        test.setProcessEnvironment(environment);
        test.setProcessChannelMode(QProcess::MergedChannels);
        test.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--screen")});
        const bool ended = test.waitForFinished(120'000);
        const QByteArray said = test.readAll();
        screen.terminate();
        screen.waitForFinished(10'000);
        QVERIFY2(ended && test.exitStatus() == QProcess::NormalExit && test.exitCode() == 0,
                 said.constData());
        QVERIFY2(said.contains("0 failed, 0 skipped"), said.constData());
    }
};

namespace {

/// The window on a screen, with the surface in sight.
struct Seen {
    explicit Seen(Theme theme = Theme::light) : bench(QStringLiteral("en"), theme) {
        opened = bench.open(
            QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/examples/shaft-30h6-factory.sparkout"));
        tabs = bench.window->findChild<ViewTabs*>();
        view = bench.window->findChild<LayersView*>();
        surface = view->surface();
        tabs->setCurrentWidget(view);
        view->findChild<QComboBox*>(QStringLiteral("layersContent"))->setCurrentIndex(1);
    }
    /// As OpenGL draws it now.
    [[nodiscard]] QImage drawn() const {
        for (int tries = 0; tries < 200 && !surface->usesOpenGl(); ++tries) {
            QTest::qWait(20);
        }
        bench.settle();
        return surface->usesOpenGl() ? surface->grab().toImage()
                                     : QImage(1, 1, QImage::Format_RGB32);
    }
    [[nodiscard]] bool alike() const {
        const QImage picture = drawn();
        return picture.size() == surface->size() && saysAlike(compare(picture, painted(*surface)));
    }
    Bench bench;
    bool opened = false;
    ViewTabs* tabs;
    LayersView* view;
    LayersSurface* surface;
};

} // namespace

/// On a screen.
class TestScreen : public QObject {
    Q_OBJECT

private slots:
    void openGlWorksHere() { QVERIFY(openGlWorks()); }

    /// In every theme, in both languages, at the cycle's end and in its middle, torn off and back.
    /// The window is closed while the surface is in its own.
    void bothLookAlike() {
        Seen seen;
        QVERIFY(seen.opened);
        QVERIFY(seen.alike());
        for (const Theme theme : {Theme::dark, Theme::contrast, Theme::light}) {
            applyTheme(theme);
            QVERIFY(seen.alike());
            QCOMPARE(seen.drawn().pixelColor(3, 3), seen.surface->palette().color(QPalette::Base));
        }
        for (const char* language : {"ru", "en", "ru"}) {
            seen.bench.language.apply(QString::fromLatin1(language));
            QVERIFY(seen.alike());
        }
        auto* slider = seen.bench.window->findChild<QSlider*>(QStringLiteral("playSlider"));
        slider->triggerAction(QAbstractSlider::SliderPageStepSub);
        QVERIFY(seen.surface->grid().sheets.back().newest);
        QVERIFY(seen.alike());
        seen.tabs->detach(seen.view);
        QVERIFY(seen.view->window() != seen.bench.window.get());
        seen.view->window()->resize(900, 700);
        QVERIFY(seen.alike());
        seen.tabs->attach(seen.view);
        seen.tabs->setCurrentWidget(seen.view);
        QVERIFY(seen.alike());
        seen.tabs->detach(seen.view);
        QVERIFY(seen.alike());
    }

    /// In a second window, with a context of its own; closed while the surface is in it.
    void mouseWheelAndKeysTurnIt() {
        Seen seen;
        const QImage first = seen.drawn();
        QWindow* const window = seen.bench.window->windowHandle();
        const QPoint middle =
            seen.surface->mapTo(seen.bench.window.get(), seen.surface->rect().center());
        const double azimuth = seen.surface->azimuth();
        QTest::mousePress(window, Qt::LeftButton, {}, middle);
        QTest::mouseMove(window, middle + QPoint(40, 15));
        QTest::mouseMove(window, middle + QPoint(90, 30));
        QTest::mouseRelease(window, Qt::LeftButton, {}, middle + QPoint(90, 30));
        QVERIFY(std::abs(seen.surface->azimuth() - azimuth) > 10);
        QVERIFY(compare(seen.drawn(), first).differing > 0.1);
        QVERIFY(seen.alike());
        fixtures::wheel(seen.surface, seen.surface->rect().center(), 240);
        QVERIFY(seen.surface->zoom() > 1.2);
        QVERIFY(seen.alike());
        seen.surface->setFocus();
        const double turned = seen.surface->azimuth(), raised = seen.surface->elevation();
        for (int i = 0; i < 4; ++i) {
            QTest::keyClick(window, Qt::Key_Left);
        }
        QTest::keyClick(window, Qt::Key_Up);
        QVERIFY(std::abs(seen.surface->azimuth() - turned) > 10);
        QVERIFY(seen.surface->elevation() > raised);
        QVERIFY(seen.alike());
        seen.view->tools()->fit->trigger();
        QVERIFY(compare(seen.drawn(), first).differing < 1e-3);
    }
};

int main(int argc, char** argv) {
    const QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    applyTheme(Theme::light);
    if (argc > 1 && QByteArray(argv[1]) == "--screen") {
        TestScreen test;
        return QTest::qExec(&test, argc - 1, argv + 1);
    }
    TestSurface test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_surface.moc"
