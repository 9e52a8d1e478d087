// SPDX-License-Identifier: GPL-3.0-or-later
// A call-out of a plot stands beside the curves where there is room for it.
#include "tests/registry.h"
#include "ui/chart/free_place.h"

#include <cmath>

namespace sparkout::test_free_place {

const QRectF plot(100, 50, 400, 200);
const QSizeF text(90, 24);

/// Whether a line comes into a rectangle, tried at every half pixel.
bool crosses(const QPolygonF& line, const QRectF& place) {
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QPointF whole = line[i] - line[i - 1];
        const int steps = static_cast<int>(2 * std::hypot(whole.x(), whole.y())) + 1;
        for (int step = 0; step <= steps; ++step) {
            if (place.contains(line[i - 1] + whole * (double(step) / steps))) {
                return true;
            }
        }
    }
    return false;
}

class TestFreePlace : public QObject {
    Q_OBJECT

private slots:
    void whatAPlaceCoversIsCounted() {
        FreePlace places(QRectF(10, 10, 200, 100));
        places.addCurve(QPolygonF({{10, 52}, {210, 52}}));
        const int wide = places.coveredIn({20, 40, 40, 20});
        QVERIFY(wide >= 10 && wide <= 11); // squares of 4 px
        QCOMPARE(places.coveredIn({20, 60, 40, 20}), 0);
        QCOMPARE(places.coveredIn({10, 10, 200, 100}), 50);
    }

    void withoutCurvesItStandsAtTheMark() {
        const FreePlace places(plot);
        const FreePlace::Found found = places.nearest(text, {300, 150});
        QCOMPARE(found.covered, 0);
        QVERIFY(found.away == 0 && plot.contains(found.place) && found.place.size() == text);
    }

    /// A plot that was not laid out yet has a room of less than nothing.
    void aRoomTurnedAboutIsTheSameRoom() {
        const QPolygonF curve{{110, 60}, {200, 150}, {490, 240}};
        FreePlace places(plot), turned(QRectF(plot.bottomRight(), plot.topLeft()));
        places.addCurve(curve);
        turned.addCurve(curve);
        const FreePlace::Found a = places.nearest(text, {300, 150});
        const FreePlace::Found b = turned.nearest(text, {300, 150});
        QVERIFY(a.place == b.place && a.covered == b.covered);
        FreePlace none(QRectF(10, 10, -14, -30));
        none.addCurve({{-100, -100}, {100, 100}});
        QVERIFY(none.nearest(text, {0, 0}).place.size() == text);
    }

    void itCoversNeitherTheCurvesNorTheMark() {
        const QPointF mark(300, 150);
        for (const QPolygonF& curve :
             {QPolygonF{{100, 60}, {500, 240}}, QPolygonF{{100, 240}, {500, 60}},
              QPolygonF{{100, 150}, {500, 150}}, QPolygonF{{300, 50}, {300, 250}},
              QPolygonF{{0, -4000}, {300, 150}, {600, 9000}}}) {
            FreePlace places(plot);
            places.addCurve(curve);
            places.addSpot({mark - QPointF(7, 7), QSizeF(14, 14)});
            const FreePlace::Found found = places.nearest(text, mark);
            QCOMPARE(found.covered, 0);
            QVERIFY(plot.contains(found.place));
            QVERIFY(!crosses(curve, found.place) && !found.place.contains(mark));
            QVERIFY2(found.away < 40, qPrintable(QString::number(found.away)));
        }
    }

    /// Curves on both sides leave a lane that is too narrow near the mark, and wide far from it.
    void itGoesAsFarAsItMust() {
        const QPolygonF upper{{100, 50}, {500, 148}}, lower{{100, 250}, {500, 152}};
        FreePlace places(plot);
        for (int y = 0; y < 50; y += 3) { // above and below all is taken
            places.addCurve(upper.translated(0, -y));
            places.addCurve(lower.translated(0, y));
        }
        const QPointF mark(490, 150);
        const FreePlace::Found found = places.nearest(text, mark);
        QCOMPARE(found.covered, 0);
        QVERIFY(found.place.top() > 50 && found.place.bottom() < 250);
        QVERIFY(!crosses(upper, found.place) && !crosses(lower, found.place));
        QVERIFY2(std::abs(found.place.center().y() - 150) < 30, "it is in the lane");
    }

    void whereNoPlaceIsFreeItCoversTheLeast() {
        FreePlace places(plot);
        for (int y = 50; y < 250; y += 4) {
            if (y != 150) { // a row is free
                places.addCurve({{100, y + 1.0}, {500, y + 1.0}});
            }
        }
        const FreePlace::Found found = places.nearest(text, {110, 60});
        QVERIFY(found.covered > 0 && plot.contains(found.place));
        QVERIFY(found.place.top() <= 151 && found.place.bottom() >= 146); // with its margin
    }

    void aTextLargerThanThePlotHasAPlaceAtItsCorner() {
        const FreePlace places(QRectF(0, 0, 50, 20));
        QCOMPARE(places.nearest({90, 24}, {10, 10}).place.topLeft(), QPointF(0, 0));
    }
};

} // namespace sparkout::test_free_place

SPARKOUT_TEST(test_free_place, TestFreePlace)
#include "test_free_place.moc"
