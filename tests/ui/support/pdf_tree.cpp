// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/pdf_tree.h"

#define POINTERHOLDER_TRANSITION 4 // libqpdf with std::shared_ptr alone
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>

#include <QRegularExpression>

#include <exception>
#include <map>
#include <set>
#include <string>

namespace sparkout::reading {

namespace {

/// The characters of a font's codes, each of two bytes, as its map says: "<0001> <0066> [<0041>
/// …]", or a range without brackets that counts on.
class FontMap {
public:
    explicit FontMap(QPDFObjectHandle font) {
        const auto data = font.getKey("/ToUnicode").getStreamData();
        const QString map = QString::fromLatin1(reinterpret_cast<const char*>(data->getBuffer()),
                                                static_cast<qsizetype>(data->getSize()));
        static const QRegularExpression range(
            QStringLiteral("<([0-9A-F]{4})> <([0-9A-F]{4})> (?:\\[([^\\]]*)\\]|<([0-9A-F]{4})>)"));
        const auto hex = [](const QString& text) { return text.toInt(nullptr, 16); };
        for (auto it = range.globalMatch(map.mid(map.indexOf(QStringLiteral("beginbfrange"))));
             it.hasNext();) {
            const auto match = it.next();
            int code = hex(match.captured(1));
            if (match.capturedLength(4) > 0) {
                for (int c = hex(match.captured(4)); code <= hex(match.captured(2)); ++code, ++c) {
                    m_characters[code] = QChar(c);
                }
                continue;
            }
            for (const QString& one : match.captured(3).split(u' ', Qt::SkipEmptyParts)) {
                m_characters[code++] = wide(one.mid(1, one.size() - 2));
            }
        }
    }
    [[nodiscard]] QString text(const std::string& codes) const {
        QString text;
        for (std::size_t i = 0; i + 1 < codes.size(); i += 2) {
            const int code = static_cast<unsigned char>(codes[i]) * 256
                             + static_cast<unsigned char>(codes[i + 1]);
            const auto found = m_characters.find(code);
            text +=
                found == m_characters.end() ? QString(QChar::ReplacementCharacter) : found->second;
        }
        return text;
    }

private:
    static QString wide(const QString& hex) {
        QString text;
        for (qsizetype i = 0; i + 3 < hex.size(); i += 4) {
            text += QChar(hex.mid(i, 4).toUShort(nullptr, 16));
        }
        return text;
    }
    std::map<int, QString> m_characters;
};

/// What a page paints, held against the rules: all of it within marked content, which holds whole
/// levels of the graphics state, and the numbers of which are used once each.
class Content : public QPDFObjectHandle::ParserCallbacks {
public:
    explicit Content(QPDFObjectHandle fonts) : m_fonts(fonts) {}

    void handleObject(QPDFObjectHandle object) override {
        if (!object.isOperator()) {
            m_operands.push_back(object);
            return;
        }
        const std::string name = object.getOperatorValue();
        static const std::set<std::string> painting{"f", "F",  "f*", "B",  "B*", "b", "b*", "S",
                                                    "s", "sh", "Do", "Tj", "TJ", "'", "\"", "EI"};
        if (name == "BDC" || name == "BMC") {
            begin();
        } else if (name == "EMC" && m_isSpan) {
            m_isSpan = false;
        } else if (name == "EMC") {
            check(m_isOpen, "an end without a beginning");
            check(m_depth == m_depthAtBegin, "levels that are not whole");
            m_isOpen = false;
            m_number = -1;
        } else if (name == "q") {
            ++m_depth;
        } else if (name == "Q") {
            --m_depth;
            check(m_depth >= (m_isOpen ? m_depthAtBegin : 0), "a level closed too often");
        } else if (name == "Tf") {
            const std::string font = m_operands.front().getName();
            m_font = &m_maps.try_emplace(font, m_fonts.getKey(font)).first->second;
        } else if (painting.count(name) > 0) {
            check(m_isOpen, "painted outside of marked content: " + name);
        }
        if (name == "Tj" && !m_isSpan && m_number >= 0) {
            texts[m_number] += m_font->text(m_operands.front().getStringValue());
        }
        m_operands.clear();
    }
    void handleEOF() override {
        check(!m_isOpen && m_depth == 0, "the page ends within marked content or a level");
    }

    std::set<long long> numbers;
    std::map<long long, QString> texts; ///< by number
    QStringList faults;

private:
    void begin() {
        if (m_isOpen && !m_isSpan && m_operands.front().getName() == "/Span") {
            m_isSpan = true; // by Qt: the characters of a glyph that are several
            if (m_number >= 0) {
                texts[m_number] +=
                    QString::fromStdString(m_operands.back().getKey("/ActualText").getUTF8Value());
            }
            return;
        }
        check(!m_isOpen, "marked content within marked content");
        m_isOpen = true;
        m_depthAtBegin = m_depth;
        if (m_operands.size() == 2 && m_operands.back().isDictionary()
            && m_operands.back().hasKey("/MCID")) {
            m_number = m_operands.back().getKey("/MCID").getIntValue();
            check(numbers.insert(m_number).second, "a number twice");
        } else {
            check(!m_operands.empty() && m_operands.front().getName() == "/Artifact",
                  "neither of the tree nor an artifact");
        }
    }
    void check(bool holds, const std::string& fault) {
        if (!holds) {
            faults << QString::fromStdString(fault);
        }
    }

    QPDFObjectHandle m_fonts;
    std::map<std::string, FontMap> m_maps;
    const FontMap* m_font = nullptr;
    long long m_number = -1; ///< of the marked content, where it is of the tree
    std::vector<QPDFObjectHandle> m_operands;
    int m_depth = 0, m_depthAtBegin = 0;
    bool m_isOpen = false, m_isSpan = false;
};

class Reader {
public:
    explicit Reader(PdfTree& tree) : m_tree(tree) {}

    void read(QPDF& document) {
        const QPDFObjectHandle root = document.getRoot();
        QPDFObjectHandle catalogue = root;
        m_tree.language = QString::fromStdString(catalogue.getKey("/Lang").getUTF8Value());
        m_tree.isMarked = catalogue.hasKey("/MarkInfo")
                          && catalogue.getKey("/MarkInfo").getKey("/Marked").getBoolValue();
        m_tree.showsTitle =
            catalogue.getKey("/ViewerPreferences").getKey("/DisplayDocTitle").getBoolValue();
        QPDFObjectHandle top = catalogue.getKey("/StructTreeRoot");
        std::vector<QPDFPageObjectHelper> pages = QPDFPageDocumentHelper(document).getAllPages();
        m_tree.pages = static_cast<int>(pages.size());
        readParents(top);
        for (QPDFPageObjectHelper& page : pages) {
            Content content(page.getObjectHandle().getKey("/Resources").getKey("/Font"));
            page.parseContents(&content);
            m_tree.faults += content.faults;
            check(!content.numbers.empty(), "a page without content of the tree");
            QPDFObjectHandle object = page.getObjectHandle();
            m_left[object.getObjGen()] = content.numbers;
            m_texts[object.getObjGen()] = content.texts;
            const auto parents = m_parents.find(object.getKey("/StructParents").getIntValue());
            check(parents != m_parents.end() && parents->second.size() == content.numbers.size()
                      && (content.numbers.empty()
                          || *content.numbers.rbegin() + 1
                                 == static_cast<long long>(content.numbers.size())),
                  "a page whose content is not in the tree of parents");
            check(object.getKey("/Tabs").getName() == "/S", "a page not in the structure's order");
        }
        readElement(top.getKey("/K"), top, 0);
        for (const auto& [page, numbers] : m_left) {
            check(numbers.empty(), "content that no element has");
        }
    }

private:
    void readParents(QPDFObjectHandle& top) {
        QPDFObjectHandle numbers = top.getKey("/ParentTree").getKey("/Nums");
        for (int i = 0; i + 1 < numbers.getArrayNItems(); i += 2) {
            m_parents[numbers.getArrayItem(i).getIntValue()] =
                numbers.getArrayItem(i + 1).getArrayAsVector();
        }
    }

    void readContent(QPDFObjectHandle page, long long number, QPDFObjectHandle element,
                     QString& text) {
        text += m_texts[page.getObjGen()][number];
        check(m_left[page.getObjGen()].erase(number) == 1, "content of two elements, or of none");
        const auto& parents = m_parents[page.getKey("/StructParents").getIntValue()];
        check(number < static_cast<long long>(parents.size())
                  && parents[static_cast<std::size_t>(number)].getObjGen() == element.getObjGen(),
              "content whose parent is another element");
    }

    std::size_t readElement(QPDFObjectHandle object, QPDFObjectHandle parent, int depth) {
        const std::size_t place = m_tree.elements.size();
        m_tree.elements.emplace_back();
        check(object.getKey("/P").getObjGen() == parent.getObjGen(), "a kid of another parent");
        PdfElement element;
        element.type = QByteArray::fromStdString(object.getKey("/S").getName().substr(1));
        element.depth = depth;
        if (object.hasKey("/Alt")) {
            element.alt = QString::fromStdString(object.getKey("/Alt").getUTF8Value());
        }
        if (object.hasKey("/A")) {
            readAttributes(object.getKey("/A"), element);
        }
        QPDFObjectHandle kids = object.getKey("/K");
        for (int i = 0; kids.isArray() && i < kids.getArrayNItems(); ++i) {
            QPDFObjectHandle kid = kids.getArrayItem(i);
            if (kid.isInteger()) {
                readContent(object.getKey("/Pg"), kid.getIntValue(), object, element.text);
                element.hasContent = true;
            } else if (kid.hasKey("/MCID")) {
                readContent(kid.getKey("/Pg"), kid.getKey("/MCID").getIntValue(), object,
                            element.text);
                element.hasContent = true;
            } else {
                element.kids.push_back(readElement(kid, object, depth + 1));
            }
        }
        m_tree.elements[place] = element;
        return place;
    }

    static void readAttributes(QPDFObjectHandle attributes, PdfElement& element) {
        element.isColumnHead =
            attributes.hasKey("/Scope") && attributes.getKey("/Scope").getName() == "/Column";
        if (attributes.hasKey("/ColSpan")) {
            element.span = attributes.getKey("/ColSpan").getIntValueAsInt();
        }
        if (attributes.hasKey("/BBox")) {
            const auto box = attributes.getKey("/BBox").getArrayAsRectangle();
            element.box = QRectF(QPointF(box.llx, box.lly), QPointF(box.urx, box.ury));
        }
    }

    void check(bool holds, const char* fault) {
        if (!holds) {
            m_tree.faults << QString::fromUtf8(fault);
        }
    }

    PdfTree& m_tree;
    std::map<long long, std::vector<QPDFObjectHandle>> m_parents; ///< by the page's key
    std::map<QPDFObjGen, std::set<long long>> m_left; ///< of each page, what was not met yet
    std::map<QPDFObjGen, std::map<long long, QString>> m_texts;
};

} // namespace

PdfTree treeOf(const QByteArray& pdf) {
    PdfTree tree;
    try {
        QPDF document;
        document.setSuppressWarnings(true);
        document.setAttemptRecovery(false);
        document.processMemoryFile("read back", pdf.constData(),
                                   static_cast<std::size_t>(pdf.size()));
        Reader(tree).read(document);
    } catch (const std::exception& fault) {
        tree.faults << QString::fromUtf8(fault.what());
    }
    return tree;
}

} // namespace sparkout::reading
