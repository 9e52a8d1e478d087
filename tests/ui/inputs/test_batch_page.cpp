// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The page "Batch" of the inputs: factors, their forms and numbers, correlations, by keys and
// mouse.
#include "core/batch/batch_run.h"
#include "core/batch/scenario_source.h"
#include "core/study/new_project.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"
#include "tests/ui/support/window_bench.h"
#include "ui/form/mark.h"
#include "ui/form/number_field.h"
#include "ui/inputs/factor_box.h"
#include "ui/inputs/inputs_panel.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>

#include <algorithm>

namespace sparkout::test_batch_page {

constexpr int batchPage = 6;

/// A window with the page in sight.
struct Page {
    explicit Page(const Project& project) : bench(QStringLiteral("en")) {
        bench.window->document().startUntitled(project);
        bench.window->inputs().showPage(batchPage);
        bench.settle();
    }
    [[nodiscard]] const Project& project() const { return bench.window->document().project(); }
    [[nodiscard]] const Batch& batch() const { return *project().batch; }
    [[nodiscard]] FormPage& form() const {
        return *bench.window->inputs().pages()[static_cast<std::size_t>(batchPage)];
    }
    template <typename Widget>
    [[nodiscard]] Widget* find(const char* name) const {
        return form().findChild<Widget*>(QString::fromLatin1(name));
    }
    /// Types a number into the field at a path and leaves it.
    void type(const char* path, const char* text) const {
        auto* field = find<NumberField>(path);
        QVERIFY2(field, path);
        form().showPath(path, true);
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, QString::fromLatin1(text));
        QTest::keyClick(field, Qt::Key_Return);
        bench.settle();
    }
    void tick(const char* path) const {
        auto* box = find<FactorBox>(path);
        QVERIFY2(box, path);
        form().showPath(path, true);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Space);
        bench.settle();
    }
    void choose(const char* path, FactorForm form) const {
        auto* box = find<QComboBox>(path);
        QVERIFY2(box, path);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Home);
        for (int i = 0; i < static_cast<int>(form); ++i) {
            QTest::keyClick(box, Qt::Key_Down);
        }
        bench.settle();
        QCOMPARE(box->currentIndex(), static_cast<int>(form));
    }
    void undo() const {
        bench.window->document().undo();
        bench.settle();
    }
    Bench bench;
};

Project bare() {
    Project project = fixtures::shaftBatch(50);
    project.batch.reset();
    return project;
}

class TestBatchPage : public QObject {
    Q_OBJECT

private slots:
    void aProjectWithoutABatchIsOfferedAUsualOne() {
        Page page(bare());
        auto* add = page.find<QPushButton>("addBatch");
        QVERIFY(add && add->isVisible());
        QTest::mouseClick(add, Qt::LeftButton);
        page.bench.settle();
        QVERIFY(page.project().batch.has_value());
        QVERIFY(checkBatch(page.project()).empty());
        QVERIFY(!add->isVisible());
        page.undo();
        QVERIFY(!page.project().batch.has_value());
        QVERIFY(add->isVisible());
    }

    void partsAndSeedAreTyped() {
        Page page(fixtures::shaftBatch(50));
        page.type("/batch/parts", "120");
        page.type("/batch/seed", "9");
        QCOMPARE(page.batch().parts, 120);
        QCOMPARE(page.batch().seed, 9);
    }

    void aFactorIsTickedAndLetBeAndTheOthersKeepTheirCorrelation() {
        Project project = fixtures::shaftBatch(50);
        project.batch->correlation = {{{1, 0.5, 0}, {0.5, 1, 0}, {0, 0, 1}}};
        Page page(project);
        page.tick("/batch/factors/flow_stress_mpa");
        QVERIFY(page.batch().factors.flow_stress_mpa.has_value());
        QCOMPARE(page.batch().correlation->size(), std::size_t{4});
        QVERIFY(checkBatch(page.project()).empty());
        page.tick("/batch/factors/dullness");
        QVERIFY(!page.batch().factors.dullness.has_value());
        const std::vector<std::vector<double>> left{{1, 0.5, 0}, {0.5, 1, 0}, {0, 0, 1}};
        QCOMPARE(*page.batch().correlation, left);
        QVERIFY(checkBatch(page.project()).empty());
        page.undo();
        page.undo();
        QVERIFY(sameProject(page.project(), project));
    }

    void anEditOfTheStockMovesItsLawAndSaysSo() {
        using Ends = std::vector<double>;
        const Page page(fixtures::shaftBatch(50));
        Project project = page.project();
        project.part->stock_mm = 0.2;
        page.bench.window->document().edit(project, {"Input", "Stock per side"});
        page.bench.settle();
        QCOMPARE(*page.batch().factors.stock_mm->uniform, (Ends{0.18, 0.22}));
        const auto notice = [&page] {
            return page.bench.window->findChild<QWidget*>(QStringLiteral("notice laws"));
        };
        QVERIFY(notice());
        const auto labels = notice()->findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) {
            return label->text().contains(QStringLiteral("follow this edit: Stock per side"));
        }));
        page.undo();
        QCOMPARE(*page.batch().factors.stock_mm->uniform, (Ends{0.13, 0.17}));
        QTRY_VERIFY(!notice());
    }

    void everyFormIsChosenAndCanBeRun() {
        Page page(fixtures::shaftBatch(50));
        for (const FactorForm form :
             {FactorForm::normal, FactorForm::triangular, FactorForm::measured, FactorForm::grows,
              FactorForm::constant, FactorForm::uniform}) {
            page.choose("/batch/factors/stock_mm/form", form);
            QVERIFY(checkBatch(page.project()).empty());
            const ReadResult read = readProject(writeProject(page.project()));
            QVERIFY(read.project && sameProject(*read.project, page.project()));
        }
    }

    void theNumbersOfAFormAreTyped() {
        Page page(fixtures::shaftBatch(50));
        page.type("/batch/factors/stock_mm/uniform/1", "0.19");
        QCOMPARE((*page.batch().factors.stock_mm->uniform)[1], 0.19);
        page.choose("/batch/factors/stock_mm/form", FactorForm::normal);
        page.type("/batch/factors/stock_mm/normal/0", "0.155");
        page.type("/batch/factors/stock_mm/normal/1", "0.004");
        const std::vector<double> normal{0.155, 0.004};
        QCOMPARE(*page.batch().factors.stock_mm->normal, normal);
        auto* truncated = page.find<QCheckBox>("/batch/factors/stock_mm/truncated");
        QVERIFY(truncated->isChecked());
        QTest::keyClick(truncated, Qt::Key_Space);
        page.bench.settle();
        QVERIFY(!page.batch().factors.stock_mm->within.has_value());
        QVERIFY(!page.find<NumberField>("/batch/factors/stock_mm/within/0"));
        page.choose("/batch/factors/stock_mm/form", FactorForm::grows);
        page.type("/batch/factors/stock_mm/parts_between_dressings", "10");
        QCOMPARE(page.batch().factors.stock_mm->parts_between_dressings, std::optional(10));
    }

    void aConstantIsOneNumber() {
        Page page(fixtures::shaftBatch(50));
        page.choose("/batch/factors/dullness/form", FactorForm::constant);
        page.type("/batch/factors/dullness/uniform/0", "0.025");
        const std::vector<double> ends{0.025, 0.025};
        QCOMPARE(*page.batch().factors.dullness->uniform, ends);
        QVERIFY(!page.find<NumberField>("/batch/factors/dullness/uniform/1"));
    }

    /// Typing equal ends does not turn the form under the hands of who types.
    void equalEndsOfAUniformFactorStayTwoNumbers() {
        Page page(fixtures::shaftBatch(50));
        page.type("/batch/factors/stock_mm/uniform/1", "0.13"); // the lowest is 0.13
        const std::vector<double> ends{0.13, 0.13};
        QCOMPARE(*page.batch().factors.stock_mm->uniform, ends);
        QVERIFY(page.find<NumberField>("/batch/factors/stock_mm/uniform/1"));
    }

    void undoBringsTheConstantBack() {
        Page page(fixtures::shaftBatch(50));
        page.choose("/batch/factors/stock_mm/form", FactorForm::constant);
        page.choose("/batch/factors/stock_mm/form", FactorForm::uniform);
        page.undo();
        auto* form = page.find<QComboBox>("/batch/factors/stock_mm/form");
        QCOMPARE(form->currentIndex(), static_cast<int>(FactorForm::constant));
    }

    void theRangeOfAFactorIsThatOfTheOperation() {
        Project project = fixtures::shaftBatch(50);
        project.batch->factors.contact_width_mm = usualFactor(FactorKind::contactWidth, project);
        Page page(project);
        Project plunge = newProject(Operation::plunge);
        plunge.batch = project.batch;
        page.bench.window->document().startUntitled(plunge);
        page.bench.settle();
        page.type("/batch/factors/contact_width_mm/uniform/1", "1500"); // no wheel is that wide
        QCOMPARE((*page.batch().factors.contact_width_mm->uniform)[1], 1500.0);
    }

    void aRefusedNumberStaysInSightAndUndoTakesItAway() {
        Page page(fixtures::shaftBatch(50));
        page.type("/batch/factors/stock_mm/uniform/0", "-3");
        auto* field = page.find<NumberField>("/batch/factors/stock_mm/uniform/0");
        QCOMPARE(field->text(), QStringLiteral("-3"));
        QVERIFY(field->refused());
        QCOMPARE((*page.batch().factors.stock_mm->uniform)[0], 0.13);
        QCOMPARE(page.bench.window->inputs().refusals().size(), std::size_t{1});
        page.bench.action("undo")->trigger();
        QVERIFY(!field->refused());
        QCOMPARE(field->text(), QStringLiteral("0.13"));
    }

    void anOrderThatIsWrongIsMarkedWithItsReason() {
        Page page(fixtures::shaftBatch(50));
        page.type("/batch/factors/stock_mm/uniform/1", "0.1"); // below the lowest, 0.13
        auto* field = page.find<NumberField>("/batch/factors/stock_mm/uniform/1");
        QTRY_VERIFY(field->remark().mark != Mark::none);
        QVERIFY(!field->remark().reason.isEmpty());
    }

    void aCorrelationIsTypedForTwoFactors() {
        Page page(fixtures::shaftBatch(50));
        QVERIFY(!page.batch().correlation);
        page.type("/batch/correlation/1/0", "0.4");
        const std::vector<std::vector<double>> matrix{{1, 0.4, 0}, {0.4, 1, 0}, {0, 0, 1}};
        QCOMPARE(*page.batch().correlation, matrix);
        QVERIFY(checkBatch(page.project()).empty());
        page.type("/batch/correlation/1/0", "0");
        QVERIFY(!page.batch().correlation);
    }

    void aMatrixOfCorrelationsIsPastedWhole() {
        Page page(fixtures::shaftBatch(50));
        const auto paste = [&page](const char* path, const char* text) {
            QApplication::clipboard()->setText(QString::fromUtf8(text));
            page.form().showPath(path, true);
            QTest::keySequence(page.find<NumberField>(path), QKeySequence::Paste);
            page.bench.settle();
        };
        const auto reason = [&page] {
            for (const auto* label : page.form().findChildren<ReasonLabel*>()) {
                if (label->isVisible() && label->text().startsWith(QStringLiteral("Not pasted"))) {
                    return label->text();
                }
            }
            return QString();
        };
        paste("/batch/correlation/1/0", "1\t0,3\t-0,1\n0,3\t1\t0,2\n\u22120,1\t0,2\t1\n");
        const std::vector<std::vector<double>> matrix{
            {1, 0.3, -0.1}, {0.3, 1, 0.2}, {-0.1, 0.2, 1}};
        QCOMPARE(*page.batch().correlation, matrix);
        page.undo();
        QVERIFY(!page.batch().correlation);
        paste("/batch/correlation/1/0", "1\t0,3\t0\n0,4\t1\t0\n0\t0\t1\n");
        QVERIFY2(reason().contains(QStringLiteral("row 1, column 2")), qPrintable(reason()));
        paste("/batch/correlation/2/0", "0,3\n1,4\n"); // down from here
        QVERIFY2(reason().contains(QStringLiteral("1,4")), qPrintable(reason()));
        QVERIFY(!page.batch().correlation);
        const QTemporaryDir folder;
        QVERIFY(
            !page.bench.window->document().saveAs(folder.filePath(QStringLiteral("a.sparkout"))));
        QCOMPARE(reason(), QString());
        paste("/batch/correlation/2/0", "0,3\n0,4\n");
        const std::vector<std::vector<double>> lower{{1, 0, 0.3}, {0, 1, 0.4}, {0.3, 0.4, 1}};
        QCOMPARE(*page.batch().correlation, lower);
    }

    void aMatrixOfUnequalRowsDoesNoHarm() {
        Project project = fixtures::shaftBatch(50);
        project.batch->correlation = {{{1}, {0.5, 1}, {}}};
        const Page page(project);
        page.tick("/batch/factors/dullness");
        QVERIFY(!page.batch().factors.dullness.has_value());
        page.type("/batch/correlation/1/0", "0.4");
        const std::vector<std::vector<double>> matrix{{1, 0.4}, {0.4, 1}};
        QCOMPARE(*page.batch().correlation, matrix);
        QVERIFY(checkBatch(page.project()).empty());
    }

    void aLawOverTheBatchHasNoCorrelation() {
        Page page(fixtures::shaftBatch(50));
        page.type("/batch/correlation/2/0", "0.4");
        page.choose("/batch/factors/dullness/form", FactorForm::grows);
        QVERIFY(!page.batch().correlation);
        QVERIFY(!page.find<NumberField>("/batch/correlation/2/0"));
        QVERIFY(checkBatch(page.project()).empty());
    }

    void measuredValuesAreReadFromATable() {
        Page page(fixtures::shaftBatch(50));
        page.choose("/batch/factors/stock_mm/form", FactorForm::measured);
        QTemporaryDir folder;
        const auto write = [&folder](const char* name, const QByteArray& text) {
            QFile file(folder.filePath(QString::fromLatin1(name)));
            const bool written = file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
            return written ? file.fileName() : QString();
        };
        auto* box = page.find<FactorBox>("/batch/factors/stock_mm");
        box->readFrom(write("other.csv", "dullness\n0.02\n"));
        QCOMPARE(page.batch().factors.stock_mm->measured->size(), std::size_t{1});
        box->readFrom(write("blanks.csv", "stock_mm;dullness\n0,151;0,02\n0,148;0,03\n"));
        const std::vector<double> values{0.151, 0.148};
        QCOMPARE(*page.batch().factors.stock_mm->measured, values);
    }

    void everyKeyOfTheBatchIsOnThePage() {
        Page page(fixtures::shaftBatch(50));
        for (const Field& field : tableOf<Batch>().fields) {
            if (!field.nested) {
                QVERIFY2(page.form().holds(std::string("/batch/") + field.key), field.key);
            }
        }
        for (const Field& field : tableOf<Factors>().fields) {
            for (const Field& form : tableOf<Factor>().fields) {
                const std::string path =
                    std::string("/batch/factors/") + field.key + "/" + form.key;
                QVERIFY2(page.form().holds(path), path.c_str());
            }
        }
    }
};

} // namespace sparkout::test_batch_page

SPARKOUT_TEST(test_batch_page, TestBatchPage)
#include "test_batch_page.moc"
