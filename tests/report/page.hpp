// The report's page: one HTML file that needs no other file, no script and no network.
#ifndef REPORT_PAGE_HPP
#define REPORT_PAGE_HPP

#include <string>
#include <vector>

namespace report {

const std::size_t kPageBudget = 1000000;  // bytes
const std::size_t kLongTable = 12;        // rows; more are folded

struct Table {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;  // plain text; the first column is set left, the others right
    std::vector<std::size_t> left;               // further columns to set left
    bool wordy = false;                          // cells hold sentences, which may be broken
};

class Page {
public:
    // A part of the page, with an entry in its contents. Everything added later belongs to it. Parts one after the
    // other whose titles begin alike, up to a colon, stand together there.
    void section(const std::string& id, const std::string& title);

    // Plain text; one paragraph.
    void paragraph(const std::string& text);

    // Panels (SVG), each at least so wide, side by side where there is room; the legend (HTML) below them; the caption
    // says what is seen.
    void figure(const std::vector<std::string>& panels, const std::string& legend_html, const std::string& caption,
                int panel_width = 400);

    // Shows a picture (SVG) of the present part at the head of the page, too. Returns what goes into its figure.
    std::string show(const std::string& picture, const std::string& words);

    // Long ones are folded.
    void table(const Table& table, const std::string& caption);

    // One of the few figures at the head of the page.
    void headline(const std::string& value, const std::string& meaning);

    // A file beside the page; listed at the end of its section.
    void file(const std::string& name);

    std::string html(const std::string& title, const std::string& lead, const std::vector<std::string>& facts) const;

private:
    struct Part {
        std::string id, title, body;
        std::vector<std::string> files;
    };
    std::string contents() const;

    std::vector<Part> parts_;
    std::string headlines_, gallery_;
    int figures_ = 0, tables_ = 0, shown_ = 0;
};

}  // namespace report

#endif
