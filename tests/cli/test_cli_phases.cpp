// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// `phases` as a user meets it: what it prints is what the engine decides, and its exit status.
#include "core/phases/phase_decision.h"
#include "core/project/gauge.h"
#include "core/project/part.h"
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"

#include <vector>

namespace test_cli_phases {

using namespace sparkout;
using namespace cli;

const QString example = examplePath("plunge-shaft-two-stage");

class TestCliPhases : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void jsonStatesWhatTheEngineDecides() {
        const Project project = projectOf(example);
        const PhaseDecision decision = decidePhases(project, usualPhases(project));
        const json answer = answerTo({"phases", example, "--json"});
        QVERIFY(answer.at("decided").get<bool>());
        QCOMPARE(answer.at("holds").get<bool>(), decision.holds());
        QCOMPARE(answer.at("pieces").size(), decision.pieces.size());
        QVERIFY(decision.pieces.size() > 2);
        for (std::size_t i = 0; i < decision.pieces.size(); ++i) {
            const json& piece = answer.at("pieces")[i];
            QCOMPARE(piece.at("steps_by_stage").get<std::vector<int>>(),
                     decision.pieces[i].piece.counts);
            QCOMPARE(piece.at("stock_mm")[0].get<double>(), decision.pieces[i].piece.from_mm);
        }
        QCOMPARE(answer.at("failing").size(), decision.failing.size());
    }

    void aNarrowFieldFailsForSomeStocks() {
        json file = json::parse(samples::readText(example.toStdString()));
        file.erase("runs");
        file["part"]["lower_deviation_um"] = file["part"]["upper_deviation_um"].get<double>() - 0.3;
        const QString narrow = save(QStringLiteral("narrow.sparkout"), file.dump());
        const ProcessOutcome outcome = run({"phases", narrow, "--check"});
        QCOMPARE(outcome.status, 4);
        QVERIFY(QByteArray::fromStdString(outcome.out).contains("unfit for stocks of "));
        QVERIFY(!QByteArray::fromStdString(outcome.out).contains("fit for every stock"));
        QCOMPARE(run({"phases", narrow}).status, 0);
    }

    void oneStockIsARangeToo() {
        const Project project = projectOf(example);
        const QString stock = QString::number(project.part->stock_mm, 'g', 17);
        const ProcessOutcome outcome =
            run({"phases", example, "--from", stock, "--to", stock, "--json"});
        QCOMPARE(outcome.status, 0);
        QCOMPARE(json::parse(outcome.out).at("pieces").size(), std::size_t{1});
    }

    void whatCannotBeDecidedIsRefused() {
        json file = json::parse(samples::readText(example.toStdString()));
        file.erase("runs");
        file["gauge"]["control"] = "position";
        const QString position = save(QStringLiteral("position.sparkout"), file.dump());
        const ProcessOutcome outcome = run({"phases", position});
        QCOMPARE(outcome.status, 1);
        QVERIFY(QByteArray::fromStdString(outcome.err).contains("/gauge/control"));
        QCOMPARE(run({"phases", example, "--from", "2", "--to", "1"}).status, 2);
        QCOMPARE(run({"phases", example, "--from", "0"}).status, 2);
        QCOMPARE(run({"phases"}).status, 2);
    }
};

} // namespace test_cli_phases

SPARKOUT_TEST(test_cli_phases, TestCliPhases)
#include "test_cli_phases.moc"
