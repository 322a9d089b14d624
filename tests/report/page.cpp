#include "page.hpp"

#include <algorithm>

#include "format.hpp"

namespace report {
namespace {

const char* const kStyle = R"css(
:root{color-scheme:light dark;
--bg:#fcfcfa;--card:#f3f2ee;--fg:#1c1b1a;--muted:#5d5b57;--grid:#dcdad4;--minor:#efede8;
--heat:#d9601a;--hot:#1c1b1a;--link:#0a62a8;
--c0:#6b6965;--c1:#0a6fb5;--c2:#d1520a;--c3:#0b8a63;--c4:#a8468c;--c5:#b88400;--c6:#2b9ac4;--c7:#24221f;--c8:#8a5a2b;
--f0:#b9d8ee;--f1:#e4ecd9;--f2:#f0a04b;--f3:#8c2f1f;--odd:#c4007a}
@media (prefers-color-scheme:dark){:root{--bg:#151617;--card:#1f2123;--fg:#e9e7e2;--muted:#a5a39d;--grid:#383a3d;
--minor:#242628;--heat:#c2571a;--hot:#fff;--link:#7cc0f5;
--c0:#a9a69f;--c1:#58b1f2;--c2:#ff8f52;--c3:#3ecb9c;--c4:#e290cc;--c5:#edc244;--c6:#8ad6f5;--c7:#f4f1ea;--c8:#c99b6d;
--f0:#27506e;--f1:#2f3f35;--f2:#c27a26;--f3:#f0b7a4;--odd:#ff6ec7}}
*{box-sizing:border-box}
body{margin:0 auto;padding:24px 20px 60px;max-width:1120px;background:var(--bg);color:var(--fg);
font:16px/1.55 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif}
h1{font-size:1.9rem;line-height:1.2;margin:.2em 0}
h2{font-size:1.35rem;margin:2.6em 0 .5em;padding-top:.6em;border-top:1px solid var(--grid)}
p{max-width:72ch;margin:.7em 0}
a{color:var(--link)}
.lead{font-size:1.1rem;color:var(--muted)}
.facts{list-style:none;padding:0;margin:1em 0;color:var(--muted);font-size:.86rem}
nav ul{list-style:none;padding:0;margin:1em 0;display:flex;flex-wrap:wrap;gap:.3em 1.2em}
.heads{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,200px),1fr));gap:12px;
margin:1.4em 0;padding:0;list-style:none}
.heads li{background:var(--card);border-radius:10px;padding:14px 16px}
.heads b{display:block;font-size:1.55rem;line-height:1.25;font-weight:650}
.heads span{font-size:.9rem;color:var(--muted);display:block;line-height:1.4;margin-top:.2em}
figure{margin:1.6em 0}
.panels{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,var(--panel,400px)),1fr));gap:18px 24px;
align-items:start}
.panels svg{width:100%;height:auto;display:block}
figcaption,.caption{max-width:80ch;font-size:.93rem;color:var(--muted);margin:.7em 0 0}
figcaption b,.caption b{color:var(--fg);font-weight:600}
.legend{list-style:none;display:flex;flex-wrap:wrap;gap:.15em 1.3em;padding:0;margin:.6em 0;font-size:.87rem}
.legend li{display:flex;align-items:center;gap:.45em}
.legend svg{width:34px;height:14px;flex:none}
.scroll{overflow-x:auto}
table{border-collapse:collapse;font-size:.9rem;font-variant-numeric:tabular-nums;margin:.8em 0 0}
th,td{padding:.32em .9em .32em 0;text-align:right;vertical-align:top;border-bottom:1px solid var(--grid)}
th{font-weight:600;color:var(--muted);vertical-align:bottom}
th.l,td.l{text-align:left}
td:first-child{white-space:nowrap}
.wordy td{white-space:normal;min-width:7em}
.wordy td.l:nth-child(n+3){min-width:15em}
.files{font-size:.85rem;color:var(--muted)}
svg text{font:12px system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif;fill:var(--fg)}
svg .title{font-weight:600;font-size:13px}
svg .axis{fill:var(--muted)}
svg .tick{fill:var(--muted);font-size:11.5px}
svg .note{fill:var(--muted);font-size:11px}
svg .cell{font-size:11px}
svg .hot{fill:var(--hot)}
svg .grid{stroke:var(--grid);stroke-width:1}
svg .minor{stroke:var(--minor);stroke-width:1}
svg .frame{stroke:var(--muted);stroke-width:1}
svg .limit{fill:none;stroke:var(--fg);stroke-width:1.6;stroke-linejoin:round}
svg .odd{fill:none;stroke:var(--odd);stroke-width:1.6}
svg .guide{stroke:var(--muted);stroke-width:1;stroke-dasharray:3 3}
@media (max-width:520px){body{padding:14px 14px 40px}h1{font-size:1.6rem}.heads{gap:8px}.heads li{padding:10px 14px}
th,td{padding-right:1em}td.l:nth-child(n+3){min-width:10.5em}
svg .title{font-size:15px}svg .axis{font-size:14px}svg .tick{font-size:13px}
svg .note{font-size:12px}svg .cell{font-size:12px}}
@media print{body{max-width:none}h2{break-after:avoid}figure{break-inside:avoid}}
)css";

// The first sentence carries the finding: it is set strong.
std::string caption_html(const std::string& label, const std::string& caption) {
    std::size_t end = caption.find(". ");
    if (end == std::string::npos) return label + " <b>" + escape(caption) + "</b>";
    return label + " <b>" + escape(caption.substr(0, end + 1)) + "</b>" + escape(caption.substr(end + 1));
}

}  // namespace

void Page::section(const std::string& id, const std::string& title) { parts_.push_back({id, title, "", {}}); }

void Page::paragraph(const std::string& text) { parts_.back().body += "<p>" + escape(text) + "</p>\n"; }

void Page::figure(const std::vector<std::string>& panels, const std::string& legend_html, const std::string& caption,
                  int panel_width) {
    std::string& body = parts_.back().body;
    body += "<figure>\n<div class=\"panels\" style=\"--panel:" + std::to_string(panel_width) + "px\">\n";
    for (const std::string& panel : panels) body += "<div>" + panel + "</div>\n";
    body += "</div>\n" + legend_html + "<figcaption>" +
            caption_html("Figure " + std::to_string(++figures_) + ".", caption) + "</figcaption>\n</figure>\n";
}

void Page::table(const Table& table, const std::string& caption) {
    auto kind = [&](std::size_t column) {
        bool left = column == 0 || std::find(table.left.begin(), table.left.end(), column) != table.left.end();
        return left ? " class=\"l\"" : "";
    };
    std::string& body = parts_.back().body;
    body += std::string("<figure>\n<div class=\"scroll\"><table") + (table.wordy ? " class=\"wordy\"" : "") +
            ">\n<thead><tr>";
    for (std::size_t c = 0; c < table.head.size(); ++c)
        body += std::string("<th") + kind(c) + ">" + escape(table.head[c]) + "</th>";
    body += "</tr></thead>\n<tbody>\n";
    for (const std::vector<std::string>& row : table.rows) {
        body += "<tr>";
        for (std::size_t c = 0; c < row.size(); ++c)
            body += std::string("<td") + kind(c) + ">" + escape(row[c]) + "</td>";
        body += "</tr>\n";
    }
    body += "</tbody></table></div>\n<p class=\"caption\">" +
            caption_html("Table " + std::to_string(++tables_) + ".", caption) + "</p>\n</figure>\n";
}

void Page::headline(const std::string& value, const std::string& meaning) {
    headlines_ += "<li><b>" + escape(value) + "</b><span>" + escape(meaning) + "</span></li>\n";
}

void Page::file(const std::string& name) { parts_.back().files.push_back(name); }

std::string Page::html(const std::string& title, const std::string& lead, const std::vector<std::string>& facts) const {
    std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
                       escape(title) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<header>\n<h1>" +
                       escape(title) + "</h1>\n<p class=\"lead\">" + escape(lead) + "</p>\n";
    if (!headlines_.empty()) page += "<ul class=\"heads\">\n" + headlines_ + "</ul>\n";
    page += "<ul class=\"facts\">\n";
    for (const std::string& fact : facts) page += "<li>" + escape(fact) + "</li>\n";
    page += "</ul>\n<nav><ul>\n";
    for (const Part& part : parts_)
        page += "<li><a href=\"#" + part.id + "\">" + escape(part.title) + "</a></li>\n";
    page += "</ul></nav>\n</header>\n<main>\n";
    for (const Part& part : parts_) {
        page += "<section id=\"" + part.id + "\">\n<h2>" + escape(part.title) + "</h2>\n" + part.body;
        if (!part.files.empty()) {
            page += "<p class=\"files\">Numbers: ";
            for (std::size_t i = 0; i < part.files.size(); ++i)
                page += (i ? ", " : "") + ("<a href=\"" + part.files[i] + "\">" + escape(part.files[i]) + "</a>");
            page += "</p>\n";
        }
        page += "</section>\n";
    }
    return page + "</main>\n</body>\n</html>\n";
}

}  // namespace report
