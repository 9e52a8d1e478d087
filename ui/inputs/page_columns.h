// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/inputs/number_lines.h"
#include "ui/table/pasted_cells.h"

#include <QGroupBox>
#include <QString>
#include <QVBoxLayout>

#include <functional>
#include <span>
#include <string>
#include <vector>

class QCheckBox;
class QLabel;

namespace sparkout {

class PageColumns;

/// A group of inputs under a bold title, without a frame, so that the fields of all groups of a
/// page are aligned.
class SectionBox : public QGroupBox {
    Q_OBJECT

public:
    /// `depth`: number of boxes around it; the page's own rows are at 0.
    explicit SectionBox(int depth, QWidget* parent = nullptr);

    [[nodiscard]] int depth() const { return m_depth; }
    [[nodiscard]] PageColumns& rows() const { return *m_rows; }
    /// The left and right margin that aligns rows at a depth with those of the deepest boxes.
    [[nodiscard]] static int inset(int depth);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int m_depth;
    PageColumns* m_rows;
};

/// Lays out the parts of a page or of a box below each other, with their height for the width; in
/// two columns if there is room, in their order and as equal in height as possible.
class PageColumns : public QVBoxLayout {
public:
    using QVBoxLayout::QVBoxLayout;

    void addWide(QWidget* part); ///< across both columns

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] int minimumHeightForWidth(int width) const override;
    [[nodiscard]] QSize minimumSize() const override;
    void setGeometry(const QRect& rect) override;

private:
    struct Part {
        QLayoutItem* item;
        int height;
    };
    using Items = std::vector<QLayoutItem*>;
    using Put = std::function<void(QLayoutItem&, const QRect&)>;
    /// Places every part, and returns the total height.
    int place(const QRect& room, const Put& put) const;
    int placeColumns(const Items& items, const QRect& room, const Put& put) const;
    int placeColumn(std::span<const Part> parts, QRect room, const Put& put) const;
    [[nodiscard]] bool hasTwo(int width) const;
    [[nodiscard]] bool isWide(const QLayoutItem& item) const;
    [[nodiscard]] int gap(const QLayoutItem& above, const QLayoutItem& below) const;
    [[nodiscard]] int heightOf(std::span<const Part> parts) const;
    [[nodiscard]] std::size_t split(std::span<const Part> parts) const;

    std::vector<const QWidget*> m_wide;
};

/// A box of a page for an input that is not a single row of a table: numbers below one another, and
/// the reason of a mark of them all.
class InputBox : public SectionBox {
    Q_OBJECT

public:
    InputBox(std::string path, const Field& field, int depth, Document& document, QWidget* parent);

    [[nodiscard]] const std::string& path() const { return m_path; }
    virtual void showProject(bool replaced) = 0; ///< replaced: drop refused texts
    virtual void setOutcome(const OutcomePtr& outcome) = 0;
    virtual void forgetResults() {} ///< removes results shown beside the inputs
    virtual void retranslate() = 0;
    [[nodiscard]] std::vector<Refusal> refusals() const { return m_numbers->refusals(); }
    /// Restores the document's value in a refused field; false if it is not here.
    bool dropRefusal(const std::string& path) { return m_numbers->dropRefusal(path); }
    [[nodiscard]] bool holds(const std::string& path) const;
    virtual void focusPath(const std::string& path) { m_numbers->focusPath(path); }

signals:
    void refusalsChanged();

protected:
    [[nodiscard]] const Field& field() const { return m_field; }
    [[nodiscard]] Document& document() const { return m_document; }
    [[nodiscard]] NumberLines& numbers() const { return *m_numbers; }
    [[nodiscard]] ReasonLabel& reason() const { return *m_reason; }

private:
    std::string m_path;
    const Field& m_field;
    Document& m_document;
    NumberLines* m_numbers;
    ReasonLabel* m_reason;
};

/// The compliance: a field with a slider for each zone (traverse) or section (plunge), or a tick to
/// compute it from stiffness and shaft, which sets missing ones of these to usual values.
class ComplianceBox : public InputBox {
    Q_OBJECT

public:
    ComplianceBox(std::string path, const Field& field, Document& document,
                  QWidget* parent = nullptr);

    void showProject(bool replaced) override;
    void forgetResults() override;
    void setOutcome(const OutcomePtr& outcome) override; ///< the computed γ, for display
    void retranslate() override;
    void focusPath(const std::string& path) override;

private:
    void setIssues(const Issues& issues);
    [[nodiscard]] NumberLines::Line lineOf(const std::string& key, std::size_t index) const;
    void showComputed();
    void showCalibration(const Project& project);

    QCheckBox* m_computed;
    QLabel* m_gammas;      ///< computed, greyed
    QLabel* m_calibration; ///< data from which the values were found
    Issues m_issues;
    OutcomePtr m_good; ///< outcome of the last accepted inputs
};

/// The correlations of the batch's factors: a number for every two random factors.
class CorrelationBox : public InputBox {
    Q_OBJECT

public:
    CorrelationBox(std::string path, const Field& field, int depth, Document& document,
                   QWidget* parent = nullptr);

    void showProject(bool replaced) override;
    void setOutcome(const OutcomePtr& outcome) override;
    void retranslate() override;

private:
    [[nodiscard]] std::vector<QString> orderOf(const PastedCells& cells, QString& fault) const;
};

} // namespace sparkout
