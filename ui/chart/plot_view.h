// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/plot_tools.h"
#include "ui/chart/view.h"
#include "ui/session/document.h"
#include "ui/session/studies.h"

#include <QComboBox>
#include <QWidget>

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <vector>

class QAbstractButton;
class QAbstractItemModel;
class QLabel;
class QLayout;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QSplitter;
class QStackedWidget;
class QVBoxLayout;

namespace sparkout {

class CopyTable;
class CursorStrip;
class Job;
class LegendStrip;
class PlotCursors;
class Settings;
class ValueModel;
class ViewPlot;
struct Project;

/// The bar of a view that runs many cycles: buttons to run and stop, a text on the results or on
/// the progress and remaining time, and the view's own parts.
class RunBar : public QWidget {
    Q_OBJECT
public:
    /// Text for a number of parts; left_s is negative while unknown.
    using Progress = QString (*)(qint64 done, qint64 parts, double left_s);

    /// `name` is the prefix of the names of its parts.
    RunBar(const QString& name, QWidget* parent, Progress text = nullptr);

    /// Call once: sets the widgets before and behind the text. The text takes a line of its own
    /// unless it has room for this many letters.
    void layOut(std::initializer_list<QWidget*> before, std::initializer_list<QWidget*> behind,
                int letters = 0);
    /// A count of finished parts with the remaining time, if known.
    [[nodiscard]] static QString withTimeLeft(const QString& count, double left_s);
    /// Whether this many runs with this many radii each take at most about two seconds of one
    /// processor, so that they may start automatically.
    [[nodiscard]] static bool areQuick(std::int64_t runs, std::int64_t radii);
    void takeTurns() { m_turns = true; } ///< shows one of the two buttons at a time
    /// Shows the progress of a job whose parts are counted, and stops it.
    void follow(Job& job);
    void showProgress(qint64 done, qint64 parts, double left_s = -1);
    void showProgress(double share, const QString& text);
    void showRunning(bool runs, bool mayRun);

    [[nodiscard]] QPushButton* run() const { return m_run; }
    [[nodiscard]] QPushButton* stop() const { return m_stop; }
    [[nodiscard]] QLabel* state() const { return m_state; } ///< text on the results
    [[nodiscard]] QProgressBar* progress() const { return m_progress; }

private:
    Progress m_text;
    QPushButton* m_run;
    QPushButton* m_stop;
    QLabel* m_state;
    QProgressBar* m_progress;
    bool m_turns = false;
};

/// A view with plots: it keeps the last outcome that could be drawn, faint while a newer one is
/// refused, and owns what surrounds its plots: notice, legend, cursor strip, the values under the
/// mouse and the tools of each plot. Subclasses draw and describe the outcome.
class PlotView : public View {
    Q_OBJECT
public:
    [[nodiscard]] PlotTools* tools() const;     ///< of the front plot
    [[nodiscard]] PlotCursors* cursors() const; ///< null if the view has none
    [[nodiscard]] LegendStrip* legend() const { return m_legend; }
    [[nodiscard]] double lastUpdate_ms() const { return m_lastUpdate_ms; } ///< processor time
    [[nodiscard]] QSize sizeHint() const override { return {700, 620}; }
    void retranslate() override;

protected:
    /// `name` is that of the view, and the prefix of the names of its parts.
    PlotView(const QString& name, QWidget* parent, Settings* settings);

    /// Adds a plot that is always visible; its legend is the view's.
    void addPlot(ViewPlot& plot, PlotSubject subject = {});
    void addCursors(ViewPlot& plot); ///< requires addPlot()
    /// Adds one of several plots, of which one is shown at a time, with buttons to fit and export
    /// it.
    void addPage(ViewPlot& plot, PlotSubject subject = {});
    void addPageButtons(QLayout& row) const;
    [[nodiscard]] QComboBox* content(); ///< the box to choose the page; call after adding all pages
    void showPage(std::size_t index);
    [[nodiscard]] QStackedWidget* pages() const { return m_pages; }
    /// Adds boxes that are as wide as their current entry.
    static void addBoxes(QLayout& row, std::initializer_list<QComboBox*> boxes);
    /// Puts one or several plots into a scroll area, used below their minimumSizeHint().
    QScrollArea* scrolled(QWidget& plots);
    /// Adds buttons for actions of the front plot, and the export button.
    void addButtons(QLayout& row, const QList<QAction*>& actions) const;
    /// A row of tools that fills a widget.
    template <typename Row>
    static Row* rowIn(QWidget* bar) {
        auto* row = new Row(bar);
        closeUp(*row);
        return row;
    }
    /// The first above the second, with their shares of the height.
    static void share(QSplitter& splitter, std::initializer_list<std::pair<QWidget*, int>> parts);
    /// Adds the view's column of parts with the usual margins; the main part takes the remaining
    /// height.
    QVBoxLayout* addColumn(std::initializer_list<QWidget*> parts, QWidget* main);
    /// Adds a row of tools for the pages: the box to choose one, the given boxes, the buttons of
    /// the page.
    template <typename Row>
    QWidget* pageTools(std::initializer_list<QComboBox*> boxes) {
        auto* bar = new QWidget(this);
        auto* row = rowIn<Row>(bar);
        addBoxes(*row, {content()});
        addBoxes(*row, boxes);
        setTabOrder((*boxes.begin())->previousInFocusChain(), content()); // it was created later
        row->addStretch(1);
        addPageButtons(*row);
        return bar;
    }
    /// Adds a table beside the plots, to copy and to save.
    /// @param text the copied text, with tabs [the table itself]
    CopyTable* addTable(QAbstractItemModel& model, std::function<CsvTable()> table,
                        std::function<QString()> text = {});
    /// Adds a table given as a value.
    /// @param saved the saved table, also copied as a whole [the table itself]
    CopyTable* addTable(ValueModel& model, std::function<CsvTable()> saved = {});
    /// Sets translated texts and keeps the current entry.
    static void fillChoice(QComboBox& box, const QStringList& texts);
    void hideUntilDrawn(std::initializer_list<QWidget*> parts);
    void disableUntilDrawn(std::initializer_list<QWidget*> parts);
    static void nameObjects(std::initializer_list<std::pair<QWidget*, const char*>> names);
    /// Sets the accessible name and the tool tip of a control.
    static void tell(QWidget& widget, const QString& text);
    /// Sets a short accessible name and a longer tool tip.
    static void tell(QWidget& widget, const QString& name, const QString& tip);
    static void tellButton(QAbstractButton& button, const QString& text, const QString& tip);

    [[nodiscard]] Settings* settings() const { return m_settings; }
    [[nodiscard]] QLabel* notice() const { return m_notice; }
    [[nodiscard]] QLabel* values() const { return m_values; }
    [[nodiscard]] CursorStrip* strip() const { return m_strip; }
    [[nodiscard]] const std::vector<ViewPlot*>& plots() const { return m_plots; }
    [[nodiscard]] ViewPlot& front() const { return *m_front; } ///< with the legend and the tools

    [[nodiscard]] const OutcomePtr& good() const { return m_good; } ///< the drawn outcome, or null
    [[nodiscard]] bool refused() const;                             ///< the newest one
    /// Whether good() is of another operation, or of other zones or sections, than that one.
    [[nodiscard]] bool hasOtherPlaces(const OutcomePtr& before) const;
    [[nodiscard]] virtual bool draws(const Outcome& outcome) const; ///< here: of zones or sections
    /// good() has changed; `before` is the previous outcome and may be null.
    virtual void takeOutcome(const OutcomePtr& before) = 0;
    virtual void dropOutcome() {} ///< good() became null: it belonged to another document
    [[nodiscard]] virtual bool drawn() const { return m_good != nullptr; } ///< there are curves
    [[nodiscard]] virtual bool faint() const; ///< whether the plots show an outdated outcome
    [[nodiscard]] virtual bool isFaint(const ViewPlot&) const { return faint(); }
    void showOutcome() override;
    void showPlots();         ///< redraws all plots within their ranges
    void replotAll();         ///< replots all plots soon
    void replotFront();       ///< replots the front plot soon
    virtual void showState(); ///< updates notice, hidden and disabled parts, faintness
    virtual void showLegend();
    virtual void toggleCurve(int key); ///< called by the legend
    virtual void showOnly(int key);

    // Words.
    virtual void nameParts() = 0; ///< sets translated texts, also in boxes
    void nameAround(const QString& legend, const QString& notice, const QString& values);
    [[nodiscard]] virtual QString noticeText() const;
    /// The notice while the inputs are refused and an earlier outcome is drawn.
    [[nodiscard]] virtual QString keptText() const;
    [[nodiscard]] QString refusedText() const;                  ///< the notice if none is drawn
    [[nodiscard]] virtual QString remark() const { return {}; } ///< a remark on the drawn outcome
    [[nodiscard]] virtual QStringList heading() const;          ///< heading of exported pictures
    [[nodiscard]] virtual const Project* shownProject() const;  ///< the outcome's project, or null
    [[nodiscard]] QString projectTitle() const;                 ///< its title
    [[nodiscard]] virtual QStringList subheading() const {
        return {};
    } ///< below the project's name
    void recolour() override { showLegend(); }

private:
    void setUpTable(CopyTable& table, std::function<CsvTable()> saved);
    QWidget* pageButtons(PlotTools& tools);
    [[nodiscard]] bool isShown(const ViewPlot& plot) const; ///< false behind the front page
    static void closeUp(QLayout& row);

    Settings* m_settings;
    QLabel* m_notice;
    LegendStrip* m_legend;
    QLabel* m_values;
    CursorStrip* m_strip = nullptr;
    QStackedWidget* m_pages = nullptr;
    QComboBox* m_content = nullptr;
    std::vector<ViewPlot*> m_plots;
    std::vector<QWidget*> m_buttons; ///< buttons of the pages
    ViewPlot* m_front = nullptr;
    std::vector<QWidget*> m_hidden, m_disabled; ///< hidden or disabled until there are curves
    OutcomePtr m_good;
    double m_lastUpdate_ms = 0;
};

/// A view of a study that is computed on demand and shown until the next one, faint when the inputs
/// have changed.
class StudyView : public PlotView {
    Q_OBJECT
public:
    /// The notice over outdated results; `button` computes new ones.
    [[nodiscard]] static QString staleText(bool isRunning, const QString& button) {
        return isRunning ? tr("These results are for the inputs before the last edit; those for "
                              "the current inputs are being computed.")
                         : tr("These results are for the inputs before the last edit. Press “%1” "
                              "to compute them for the current inputs.")
                               .arg(button);
    }

signals:
    /// An edit of the document is requested.
    void editWanted(const std::function<sparkout::Project(sparkout::Project)>& edit,
                    const sparkout::EditText& text);
    void ended(); ///< the result, or its refusal, has been drawn

protected:
    /// Without studies of the window it creates its own.
    StudyView(const QString& name, QWidget* parent, Settings* settings, Studies* studies)
        : PlotView(name, parent, settings)
        , m_own(studies ? nullptr : std::make_unique<Studies>())
        , m_studies(studies ? *studies : *m_own) {}

    [[nodiscard]] Studies& studies() const { return m_studies; }

private:
    std::unique_ptr<Studies> m_own;
    Studies& m_studies;
};

} // namespace sparkout
