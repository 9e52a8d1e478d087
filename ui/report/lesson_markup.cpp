// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/lesson_markup.h"

#include "ui/chart/view_plot.h"
#include "ui/report/run_figures.h"
#include "ui/text/goal_text.h"
#include "ui/text/names.h"

#include <QRegularExpression>
#include <QStringList>
#include <qcustomplot.h>

#include <algorithm>
#include <utility>

namespace sparkout::report {

namespace {

QString withoutEntities(QString text) {
    for (const auto& [entity, sign] : {std::pair("&lt;", u'<'), std::pair("&gt;", u'>'),
                                       std::pair("&quot;", u'"'), std::pair("&nbsp;", u'\u00a0'),
                                       std::pair("&#160;", u'\u00a0'), std::pair("&amp;", u'&')}) {
        text.replace(QLatin1StringView(entity), QString(QChar(sign)));
    }
    return text;
}

/// Raises "2"; a character without a superscript form follows a caret.
QString raised(const QString& text) {
    static const QString plain = QStringLiteral("0123456789+-−n()");
    static const QString above = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻ⁿ⁽⁾");
    QString signs;
    for (const QChar c : text) {
        const qsizetype at = plain.indexOf(c);
        if (at < 0) {
            return QStringLiteral("^(%1)").arg(text);
        }
        signs += above[at];
    }
    return signs;
}

class MarkupReader {
public:
    explicit MarkupReader(int* formulas) : m_formulas(formulas) {}

    std::vector<Block> read(const QString& markup) {
        static const QRegularExpression tag(QStringLiteral("<(/?)([a-z0-9]+)([^>]*)>"));
        qsizetype from = 0;
        for (auto it = tag.globalMatch(markup); it.hasNext();) {
            const auto match = it.next();
            text(markup.mid(from, match.capturedStart() - from));
            const QString name = match.captured(2);
            if (match.captured(1).isEmpty()) {
                open(name, match.captured(3));
            } else {
                close(name);
            }
            from = match.capturedEnd();
        }
        text(markup.mid(from));
        end();
        return std::move(m_blocks);
    }

private:
    void text(const QString& part) {
        static const QRegularExpression space(QStringLiteral("[ \\t\\r\\n]+"));
        static const QRegularExpression word(QStringLiteral("(\\w+)"),
                                             QRegularExpression::UseUnicodePropertiesOption);
        QString plain = withoutEntities(part);
        if (!m_isFormula) {
            plain.replace(space, QStringLiteral(" "));
        }
        if (m_script == u"sub") {
            m_hasIndices = true;
            m_text += plain.trimmed().replace(word, QStringLiteral("_\\1"));
            m_isAfterIndex = true;
            return;
        }
        if (m_script == u"sup") {
            m_text += raised(plain.trimmed());
            return;
        }
        if (m_isAfterIndex && !plain.isEmpty() && plain.front().isLetterOrNumber()) {
            plain.prepend(QChar(0x200a)); // otherwise it would join the index
        }
        m_isAfterIndex = m_isAfterIndex && plain.isEmpty();
        m_text += plain;
    }

    void open(const QString& name, const QString& attributes) {
        if (name == u"sub" || name == u"sup") {
            m_script = name;
        } else if (name == u"br") {
            m_text += u'\n';
        } else if (name == u"p") {
            end();
            m_isFormula = attributes.contains(QStringLiteral("formula"));
        } else if (name == u"h3") {
            end();
            m_isStrong = true;
        } else if (name == u"ul" || name == u"ol") {
            end();
            m_lists.push_back(name == u"ol" ? 1 : 0);
        } else if (name == u"li") {
            end();
            if (!m_lists.empty()) {
                int& number = m_lists.back();
                m_item = number > 0 ? QStringLiteral("%1) ").arg(number++) : QStringLiteral("– ");
            }
        } else if (name == u"table") {
            end();
            m_rows.clear();
        } else if (name == u"tr") {
            m_rows.emplace_back();
        } else if (name == u"td") {
            m_text.clear();
        }
    }

    void close(const QString& name) {
        if (name == u"sub" || name == u"sup") {
            m_script.clear();
        } else if (name == u"p" || name == u"h3" || name == u"li") {
            end();
        } else if (name == u"ul" || name == u"ol") {
            end();
            if (!m_lists.empty()) {
                m_lists.pop_back();
            }
        } else if (name == u"td" && !m_rows.empty()) {
            const QString cell = m_text.trimmed();
            m_rows.back() << (cell.isEmpty() ? QStringLiteral("–") : cell);
            m_text.clear();
        } else if (name == u"table") {
            endTable();
        }
    }

    /// Ends a paragraph, an item or a formula.
    void end() {
        const QString text = std::exchange(m_text, {}).trimmed();
        const bool isFormula = std::exchange(m_isFormula, false);
        const bool isStrong = std::exchange(m_isStrong, false);
        const bool symbols = std::exchange(m_hasIndices, false);
        const QString item = std::exchange(m_item, {});
        m_isAfterIndex = false;
        if (text.isEmpty()) {
            return;
        }
        if (isFormula) {
            Formula formula;
            formula.sides = {{FormulaNode::Kind::text, text, 2, 0, {}}};
            formula.label = m_formulas ? QStringLiteral("(%1)").arg(++*m_formulas) : QString();
            m_blocks.emplace_back(std::move(formula));
            return;
        }
        m_blocks.emplace_back(Paragraph{item + text, isStrong, symbols});
    }

    /// The first row is the head.
    void endTable() {
        std::vector<QStringList> rows = std::exchange(m_rows, {});
        m_hasIndices = false;
        qsizetype columns = 0;
        for (const QStringList& row : rows) {
            columns = std::max(columns, row.size());
        }
        if (rows.empty() || columns == 0) {
            return;
        }
        for (QStringList& row : rows) {
            while (row.size() < columns) {
                row << QStringLiteral("–");
            }
        }
        Table table;
        table.head = rows.front();
        table.rows.assign(rows.begin() + 1, rows.end());
        table.texts.assign(static_cast<std::size_t>(columns), true);
        table.symbols = true;
        m_blocks.emplace_back(std::move(table));
    }

    int* m_formulas;
    std::vector<Block> m_blocks;
    QString m_text, m_script, m_item;
    std::vector<int> m_lists; ///< number of the next item; 0: unnumbered
    std::vector<QStringList> m_rows;
    bool m_isFormula = false, m_isStrong = false, m_hasIndices = false, m_isAfterIndex = false;
};

} // namespace

std::vector<Block> LessonMarkup::blocks(const QString& markup, int* formulas) {
    return MarkupReader(formulas).read(markup);
}

QString LessonMarkup::inOneLine(const QString& markup) {
    static const QRegularExpression within(QStringLiteral("</?(?:i|b|sub|sup|code)>"));
    static const QRegularExpression tag(QStringLiteral("<[^>]*>"));
    static const QRegularExpression power(QStringLiteral("<sup>([^<]*)</sup>"));
    QString text = markup;
    for (auto found = power.match(text); found.hasMatch(); found = power.match(text)) {
        text.replace(found.capturedStart(), found.capturedLength(), raised(found.captured(1)));
    }
    return withoutEntities(text.remove(within).replace(tag, QStringLiteral(" "))).simplified();
}

void StepKey::write(PaperWriter& paper, const Lesson& lesson, std::size_t step) {
    const Goal& goal = lesson.steps[step].goal;
    const Project& project = projectOf(lesson, step);
    if (goal.choice) {
        for (const ChoiceOption& option : goal.choice->options) {
            if (option.right) {
                paper.say(
                    tr("Right: %1.").arg(LessonMarkup::inOneLine(PaperWriter::text(option.text))));
            }
        }
        return;
    }
    if (!isAnsweredByEngine(goal.kind())) {
        paper.say(GoalText::asked(goal, project));
        return;
    }
    const GoalResult result = checkStep(lesson, step, {});
    const sparkout::Figure& figure = *goal.asked();
    const QString name = GoalText::quantity(figure, project);
    if (goal.prediction && result.value) {
        paper.say(tr("%1: %2; ± %3 is accepted.")
                      .arg(GoalText::quantityAndUnit(figure, project),
                           GoalText::number(figure, *result.value),
                           Names::fixed(result.tolerance, rowOf(figure.name).digits + 1)));
    } else if (goal.order && !result.order.empty()) {
        paper.say(
            tr("%1, the largest first: %2.").arg(name, GoalText::order(project, result.order)));
    } else if (goal.curve && !result.curve.empty()) {
        Table table;
        table.head = {GoalText::along(*goal.curve, project),
                      GoalText::quantityAndUnit(figure, project)};
        table.texts = {true};
        for (const ComparedPoint& point : result.curve) {
            table.rows.push_back({GoalText::alongAt(*goal.curve, point.at, project),
                                  GoalText::number(figure, point.value)});
        }
        paper.table(std::move(table), tr("By the engine"));
    } else {
        paper.say(GoalText::finding(result.finding));
    }
}

namespace {

constexpr int curveHeight = 340, blankHeight = 420, gridLines = 10;
constexpr double lineWidth = 2, roomAbove = 0.1;
constexpr QColor saidColour(0xd5, 0x5e, 0x00), engineColour(0x00, 0x72, 0xb2),
    gridColour(0x96, 0x96, 0x96);

/// Axes with their names, for a curve prediction.
void setUpAxes(QCustomPlot& plot, const CurvePrediction& goal, const Project& project) {
    sparkout::Figure figure = goal.figure;
    plot.xAxis->setLabel(GoalText::along(goal, project));
    plot.yAxis->setLabel(GoalText::quantityAndUnit(figure, project));
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
        style::setUpAxis(*axis);
    }
    if (goal.along == CurveAlong::place) {
        const QSharedPointer<QCPAxisTickerText> names(new QCPAxisTickerText);
        for (const double at : goal.at) {
            names->addTick(at, GoalText::alongAt(goal, at, project));
        }
        plot.xAxis->setTicker(names);
    }
    style::applyPalette(plot, plot.palette());
}

QCPGraph* addGraph(QCustomPlot& plot, const QColor& colour, Qt::PenStyle pen) {
    QCPGraph* graph = plot.addGraph();
    graph->setPen(QPen(colour, lineWidth, pen));
    graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, 7));
    return graph;
}

} // namespace

Figure CurveFigure::compared(const CurvePrediction& goal, const Project& project,
                             const GoalResult& result, const NumberRows& said) {
    QCustomPlot plot;
    setUpForPaper(plot, curveHeight);
    setUpAxes(plot, goal, project);
    QCPGraph* const engine = addGraph(plot, engineColour, Qt::SolidLine);
    QCPGraph* const predicted = addGraph(plot, saidColour, Qt::DashLine);
    double left = goal.at.empty() ? 0 : goal.at.front(), right = left, top = 0, bottom = 0;
    const auto add = [&](QCPGraph* graph, double x, double y) {
        graph->addData(x, y);
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::max(top, y);
        bottom = std::min(bottom, y);
    };
    for (const ComparedPoint& point : result.curve) {
        add(engine, point.at, point.value);
    }
    for (const auto& point : said.value_or(std::vector<std::vector<double>>())) {
        if (point.size() == 2) {
            add(predicted, point[0], point[1]);
        }
    }
    style::setSafeRange(*plot.xAxis, left, right);
    const double room = roomAbove * (top - bottom);
    style::setSafeRange(*plot.yAxis, bottom < 0 ? bottom - room : 0, top + room);
    const LegendEntries legend{{.colour = saidColour, .pen = Qt::DashLine, .text = tr("Predicted")},
                               {.colour = engineColour, .text = tr("By the engine")}};
    const QString caption = GoalText::quantity(goal.figure, project);
    return plotFigure(plot, legend, caption,
                      tr("%1: the prediction beside the engine's result").arg(caption));
}

Figure CurveFigure::blank(const CurvePrediction& goal, const Project& project) {
    QCustomPlot plot;
    setUpForPaper(plot, blankHeight);
    setUpAxes(plot, goal, project);
    const auto [least, most] = std::ranges::minmax_element(goal.at);
    if (least != goal.at.end()) {
        style::setSafeRange(*plot.xAxis, *least, *most);
    }
    // The student scales the values: a scale would reveal their size.
    plot.yAxis->setTickLabels(false);
    style::setSafeRange(*plot.yAxis, 0, gridLines);
    const QSharedPointer<QCPAxisTickerFixed> lines(new QCPAxisTickerFixed);
    lines->setTickStep(1);
    plot.yAxis->setTicker(lines);
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
        axis->grid()->setPen(QPen(gridColour, 1));
        axis->grid()->setSubGridVisible(axis == plot.xAxis);
        axis->grid()->setSubGridPen(QPen(gridColour, 0.5, Qt::DotLine));
    }
    const QString caption = GoalText::quantity(goal.figure, project);
    return plotFigure(plot, {}, caption, tr("A grid to draw on: %1").arg(caption));
}

} // namespace sparkout::report
