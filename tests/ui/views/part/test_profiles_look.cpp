// SPDX-License-Identifier: GPL-3.0-or-later
// The view "Zone profiles" along the axis, and what every view owes: texts, colours, exports,
// speed.
#include "tests/registry.h"
#include "tests/ui/views/part/profiles_bench.h"
#include "ui/chart/plot_tools.h"
#include "ui/text/names.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>

namespace sparkout::test_profiles_look {

using namespace profiles_bench;

class TestProfilesLook : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(m_of.ran()); }

    // --- along the axis -------------------------------------------------------------------------

    void theFieldIsABandAlongTheAxis() {
        ShownProfiles view(m_of.traverse);
        const auto upper = view.along()->graph(LengthLine::upperLimit);
        const auto lower = view.along()->graph(LengthLine::lowerLimit);
        QCOMPARE(upper->channelFillGraph(), lower);
        QVERIFY(std::abs(upper->data()->at(0)->value - 4) < 1e-9);
        QVERIFY(std::abs(lower->data()->at(1)->value + 4) < 1e-9);
        QCOMPARE(lower->data()->at(1)->key, 92.0);
        // Everything drawn is in sight.
        const QCPRange y = view.along()->cell()->axis(QCPAxis::atLeft)->range();
        QVERIFY(y.contains(4) && y.contains(-4));
        QStringList names;
        for (const Band& band : view.along()->bands()->bands()) {
            names << band.name;
        }
        QCOMPARE(names, QStringList({QStringLiteral("RZ1 (entry)"), QStringLiteral("NZ"),
                                     QStringLiteral("RZ2 (exit)")}));
    }

    void theEntryAtTheTailstockIsDrawnAtTheRight() {
        Project p = traverseProject();
        p.machine->entry_side = EntrySide::tailstock;
        ShownProfiles view(run(p));
        const auto& bands = view.along()->bands()->bands();
        QCOMPARE(bands.back().name, QStringLiteral("RZ1 (entry)"));
        QCOMPARE(bands.back().to, 92.0);
        const auto mean = view.along()->graph(LengthLine::mean)->data();
        const double rz1 = view.along()->graph(LengthLine::mean)->data()->at(5)->value;
        const ProfileSeries& s = view.across()->series();
        QVERIFY(std::abs(rz1 - (s.profiles[0].mean_mm - s.target_mm) * 1000) < 1e-9);
        QVERIFY(mean->at(0)->key < mean->at(5)->key);
    }

    void diametersReplaceRadii() {
        ShownProfiles view(m_of.traverse);
        auto* quantity = part<QComboBox>(view, "quantity");
        quantity->setFocus();
        QTest::keyClick(quantity, Qt::Key_Down);
        settle();
        const auto lower = view.along()->graph(LengthLine::lowerLimit)->data();
        QVERIFY(std::abs(lower->at(0)->value + 16) < 1e-9);
        const QString label = view.along()->cell()->axis(QCPAxis::atLeft)->label();
        QVERIFY(label.startsWith(QStringLiteral("Diameter")));
    }

    void toScaleNothingIsExaggerated() {
        Project p = traverseProject();
        p.part->shaft.segments = {{25, 20}, {120, 30}, {25, 20}};
        p.part->shaft.ground_from_mm = 30;
        ShownProfiles view(run(p));
        auto* box = part<QCheckBox>(view, "toScale");
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
        for (const QSize size : {QSize(700, 620), QSize(1200, 500)}) {
            view.resize(size);
            settle();
            const QCPAxisRect* rect = view.along()->cell();
            const QCPAxis* x = rect->axis(QCPAxis::atBottom);
            const QCPAxis* y = rect->axis(QCPAxis::atLeft);
            QVERIFY(std::abs(pixelsPerUnit(x) / pixelsPerUnit(y) - 1) < 1e-9);
            QVERIFY(x->range().contains(-30) && x->range().contains(140));
            QVERIFY(y->range().contains(15) && y->range().contains(-15));
        }
        const auto upper = view.along()->graph(LengthLine::mean)->data();
        const auto mirrored = view.along()->graph(LengthLine::mean, true);
        QVERIFY(mirrored->visible());
        QCOMPARE(mirrored->data()->at(0)->value, -upper->at(0)->value);
        QVERIFY(std::abs(upper->at(0)->value - 15) < 0.02);
        QVERIFY(!view.along()->graph(LengthLine::max)->visible());
        QVERIFY(view.along()->scaleText().contains(QStringLiteral("one pixel")));
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
        settle();
        QVERIFY(!view.along()->graph(LengthLine::mean, true)->visible());
        QVERIFY(view.along()->cell()->axis(QCPAxis::atLeft)->range().upper < 20);
    }

    void toScaleInternalShowsTheBore() {
        Project p = plungeProject(4);
        p.part->surface = Surface::internal;
        p.wheel->diameter_mm = 20;
        ShownProfiles view(run(p));
        part<QCheckBox>(view, "toScale")->click();
        part<QCheckBox>(view, "blank")->click();
        settle();
        // The wall around the bore is in sight, and the blank's line lies inside it.
        QVERIFY(view.along()->cell()->axis(QCPAxis::atLeft)->range().contains(15 * 1.3));
        QVERIFY(view.along()->graph(LengthLine::blankMin)->visible());
        QVERIFY(!view.along()->graph(LengthLine::blankMax)->visible());
        QVERIFY(view.along()->graph(LengthLine::blankMin)->data()->at(0)->value
                < view.along()->graph(LengthLine::mean)->data()->at(0)->value);
    }

    // --- states ---------------------------------------------------------------------------------

    void refusedInputsKeepTheProfilesDimmed() {
        ShownProfiles view(m_of.traverse);
        const auto alpha = [&] {
            return view.across()->curve(0, ProfileLine::profile)->pen().color().alpha();
        };
        const int before = alpha();
        show(view, refused());
        QVERIFY(alpha() < before / 2);
        QCOMPARE(view.across()->axisRectCount(), 3);
        auto* notice = part<QLabel>(view, "profilesNotice");
        QVERIFY(notice->isVisible() && notice->text().contains(QStringLiteral("5000")));
        show(view, m_of.traverse);
        QCOMPARE(alpha(), before);
        QVERIFY(!notice->isVisible());
    }

    void withoutAResultTheViewSaysSo() {
        ProfilesView view;
        view.show();
        auto* notice = part<QLabel>(view, "profilesNotice");
        QCOMPARE(notice->text(), QStringLiteral("No result yet."));
        show(view, refused());
        QVERIFY(notice->text().startsWith(QStringLiteral("The inputs are refused:")));
        QVERIFY(!view.across()->isVisible());
        show(view, m_of.traverse);
        QVERIFY(view.across()->isVisible() && view.along()->isVisible());
    }

    void aHiddenViewDrawsWhenItIsShown() {
        ProfilesView view;
        QSignalSpy spy(&view, &ProfilesView::updated);
        view.setOutcome(m_of.traverse);
        settle();
        QCOMPARE(spy.count(), 0);
        view.show();
        QTRY_COMPARE(spy.count(), 1);
        QCOMPARE(view.across()->axisRectCount(), 3);
    }

    void anotherLanguageReachesWhatIsDrawnAlongTheAxis() {
        ShownProfiles view(m_of.traverse);
        fixtures::Marking marking;
        QApplication::installTranslator(&marking);
        QCoreApplication::processEvents();
        QVERIFY(view.along()->bands()->bands()[0].name.contains(QChar(0x00AB)));
        QVERIFY(view.along()->graph(LengthLine::mean)->name().contains(QChar(0x00AB)));
        QApplication::removeTranslator(&marking);
        QCoreApplication::processEvents();
    }

    void theDescriptionTellsWhatIsDrawn() {
        ShownProfiles view(m_of.traverse);
        const QString text = view.across()->accessibleDescription();
        for (const QString& piece :
             {QStringLiteral("After double stroke"), QStringLiteral("Entry reversal zone RZ1"),
              QStringLiteral("Exit reversal zone RZ2"), QStringLiteral("×2000"),
              Names::fixed(m_of.traverse->result.sections[2].diameterDeviationMax_mm * 1000, 3)}) {
            QVERIFY2(text.contains(piece), qPrintable(text));
        }
        QVERIFY(view.accessibleDescription().contains(QStringLiteral("in the field")));
        view.setStroke(10);
        QVERIFY(view.accessibleDescription().contains(QStringLiteral("After double stroke 10 of")));
        QVERIFY(view.accessibleDescription().contains(QStringLiteral("outside the field")));
    }

    void theDataCopiedAreTheProfiles() {
        ShownProfiles view(m_of.traverse);
        view.across()->setFocus();
        QTest::keyClick(view.across(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        const QStringList lines = QApplication::clipboard()->text().trimmed().split(u'\n');
        QCOMPARE(lines.size(), 37);
        const QStringList header = lines[0].trimmed().split(u'\t');
        QCOMPARE(header.size(), 8); // number, angle, and profile and circle of three zones
        QVERIFY(header[2].startsWith(QStringLiteral("RZ1")));
        const QStringList row = lines[10].trimmed().split(u'\t');
        QCOMPARE(row[1].toDouble(), 90.0);
        const ProfileSeries& s = view.across()->series();
        QVERIFY(std::abs(row[2].toDouble() - (s.profiles[0].radii_mm[9] - s.target_mm) * 1000)
                < 1e-9);
        clickLegend(view, QStringLiteral("least-squares circle"));
        view.across()->tools()->copyData->trigger();
        QCOMPARE(QApplication::clipboard()->text().split(u'\n')[0].split(u'\t').size(), 5);
    }

    void theDataAlongTheAxisNameTheZones() {
        ShownProfiles view(m_of.traverse);
        view.along()->tools()->copyData->trigger();
        const QStringList lines = QApplication::clipboard()->text().trimmed().split(u'\n');
        QCOMPARE(lines.size(), 4);
        QVERIFY(lines[2].startsWith(QStringLiteral("NZ\t38\t46\t54\t")));
        const QStringList header = lines[0].trimmed().split(u'\t');
        const qsizetype upper =
            header.indexOf(QStringLiteral("upper limit radius from target, µm"));
        QVERIFY(upper > 0);
        QVERIFY(std::abs(lines[1].trimmed().split(u'\t')[upper].toDouble() - 4) < 1e-9);
    }

private:
    Cycles m_of;
};

} // namespace sparkout::test_profiles_look

SPARKOUT_TEST(test_profiles_look, TestProfilesLook)
#include "test_profiles_look.moc"
