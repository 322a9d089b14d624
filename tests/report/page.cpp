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
body{margin:0 auto;padding:24px 20px 60px;max-width:1340px;background:var(--bg);color:var(--fg);
font:16px/1.55 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif}
h1{font-size:1.9rem;line-height:1.2;margin:.2em 0}
h2{font-size:1.35rem;margin:2.6em 0 .5em;padding-top:.6em;border-top:1px solid var(--grid)}
p{max-width:72ch;margin:.7em 0}
a{color:var(--link)}
.lead{font-size:1.1rem;color:var(--muted)}
.facts{list-style:none;padding:0;margin:1em 0;color:var(--muted);font-size:.86rem}
nav{font-size:.86rem;line-height:1.35;background:var(--bg)}
nav ul{list-style:none;padding:0;margin:.2em 0 .9em}nav li{padding:.16em 0}nav a{text-decoration:none}
.text{min-width:0}
@media (min-width:1000px){body{display:grid;grid-template-columns:200px minmax(0,1fr);gap:36px;align-items:start}
nav{position:sticky;top:0;max-height:100vh;overflow-y:auto;padding:24px 0}}
@media (max-width:999px){nav{position:sticky;top:0;z-index:1;display:flex;gap:.9em;overflow-x:auto;white-space:nowrap;
border-bottom:1px solid var(--grid);padding:.5em 0}nav ul,nav li{display:inline-flex;gap:.9em;margin:0}
section{scroll-margin-top:3em}}
.gallery{display:grid;grid-template-columns:repeat(auto-fill,minmax(130px,1fr));gap:10px 16px;margin:1.2em 0;padding:0;
--titles:hidden;list-style:none;font-size:.86rem}
.gallery svg{width:100%;aspect-ratio:4/3;display:block}.gallery a{text-decoration:none}
.heads{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,165px),1fr));gap:12px;
margin:1.4em 0;padding:0;list-style:none}
.heads li{background:var(--card);border-radius:10px;padding:14px 16px}
.heads b{display:block;font-size:1.55rem;line-height:1.25;font-weight:650}
.heads span{font-size:.9rem;color:var(--muted);display:block;line-height:1.4;margin-top:.2em}
figure{margin:1.6em 0}
.panels{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,var(--panel,400px)),1fr));gap:18px 24px;
align-items:start}
.panels svg{width:100%;height:auto;display:block}
figcaption,caption,summary{max-width:80ch;font-size:.93rem;color:var(--muted);margin:.7em 0 0}
figcaption b,caption b,summary b{color:var(--fg);font-weight:600}
caption{text-align:left;padding-bottom:.5em}
caption span{display:block;position:sticky;left:0;max-width:min(80ch,calc(100vw - 40px))}
details{margin:1.6em 0}summary{cursor:pointer}summary i{white-space:nowrap}
.legend{list-style:none;display:flex;flex-wrap:wrap;gap:.15em 1.3em;padding:0;margin:.6em 0;font-size:.87rem}
.legend li{display:flex;align-items:center;gap:.45em}
.legend svg{width:34px;height:14px;flex:none}
.scroll{overflow-x:auto}
table{border-collapse:collapse;min-width:min(100%,34rem);
font-size:.9rem;font-variant-numeric:tabular-nums;margin:.8em 0 0}
th,td{padding:.32em .9em .32em 0;text-align:right;vertical-align:top;border-bottom:1px solid var(--grid)}
thead th{font-weight:600;color:var(--muted);vertical-align:bottom}
tbody th{font-weight:400}
th.l,td.l{text-align:left}
tbody th{white-space:nowrap}
.wordy td,.wordy tbody th{white-space:normal;min-width:7em}
.wordy td.l:nth-child(n+3){min-width:15em}
.files{font-size:.85rem;color:var(--muted)}
text{font:12px system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif;fill:var(--fg)}
.title{font-weight:600;font-size:13px;visibility:var(--titles,visible)}
.axis{fill:var(--muted)}
.tick,.tick text{fill:var(--muted);font-size:11.5px}
.note{fill:var(--muted);font-size:11px}
.cell,.cell text{font-size:11px;pointer-events:none}
.hot text{fill:var(--hot)}
.grid{stroke:var(--grid);stroke-width:1}
.minor{stroke:var(--minor);stroke-width:1}
.frame{stroke:var(--muted);stroke-width:1}
.limit{fill:none;stroke:var(--fg);stroke-width:1.6;stroke-linejoin:round}
.odd{fill:none;stroke:var(--odd);stroke-width:1.6}
.s0{stroke:var(--c0)}.p0{fill:var(--c0)}.s1{stroke:var(--c1)}.p1{fill:var(--c1)}
.s2{stroke:var(--c2)}.p2{fill:var(--c2)}.s3{stroke:var(--c3)}.p3{fill:var(--c3)}
.s4{stroke:var(--c4)}.p4{fill:var(--c4)}.s5{stroke:var(--c5)}.p5{fill:var(--c5)}
.s6{stroke:var(--c6)}.p6{fill:var(--c6)}.s7{stroke:var(--c7)}.p7{fill:var(--c7)}
.s8{stroke:var(--c8)}.p8{fill:var(--c8)}
.f0{stroke:var(--f0)}.f1{stroke:var(--f1)}.f2{stroke:var(--f2)}.f3{stroke:var(--f3)}
.f0,.f1,.f2,.f3{shape-rendering:crispEdges}
.m{text-anchor:middle}.e{text-anchor:end}
.line{fill:none;stroke-linejoin:round}.round{stroke-linecap:round}
.dash{stroke-dasharray:6 4}.dots{stroke-dasharray:1.5 4}
.mark{stroke-width:1.5}.none{fill:none}.hollow{fill:var(--bg)}.heat{fill:var(--heat)}
.guide{stroke:var(--muted);stroke-width:1;stroke-dasharray:3 3}
@media (max-width:520px){body{padding:14px 14px 40px}h1{font-size:1.6rem}.heads{gap:8px}.heads li{padding:10px 14px}
th,td{padding-right:1em}td.l:nth-child(n+3){min-width:10.5em}
.title{font-size:15px}.axis{font-size:14px}.tick,.tick text{font-size:13px}
.note{font-size:12px}.cell,.cell text{font-size:12px}}
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

std::string Page::show(const std::string& picture, const std::string& words) {
    const std::string id = "shown" + std::to_string(++shown_);
    const std::size_t box = picture.find("viewBox=\""), inside = picture.find('>') + 1, end = picture.rfind("</svg>");
    const std::string view = picture.substr(box, picture.find('"', box + 9) + 1 - box);
    gallery_ += "<li><a href=\"#" + parts_.back().id + "\"><svg " + view + " aria-hidden=\"true\"><use href=\"#" + id +
                "\"/></svg><span>" + escape(words) + "</span></a></li>\n";
    return picture.substr(0, inside) + "<g id=\"" + id + "\">" + picture.substr(inside, end - inside) + "</g></svg>\n";
}

void Page::table(const Table& table, const std::string& caption) {
    auto kind = [&](std::size_t column) {
        bool left = column == 0 || std::find(table.left.begin(), table.left.end(), column) != table.left.end();
        return left ? " class=\"l\"" : "";
    };
    const std::string words = caption_html("Table " + std::to_string(++tables_) + ".", caption);
    const bool folded = table.rows.size() > kLongTable;
    std::string& body = parts_.back().body;
    const std::string rows = std::to_string(table.rows.size()) + " rows";
    body += folded ? "<details>\n<summary>" + words + " <i>" + rows + "</i></summary>\n" : "<figure>\n";
    body += std::string("<div class=\"scroll\" tabindex=\"0\"><table") + (table.wordy ? " class=\"wordy\"" : "") +
            ">\n<caption><span>" + (folded ? "Table " + std::to_string(tables_) : words) +
            "</span></caption>\n<thead><tr>";
    for (std::size_t c = 0; c < table.head.size(); ++c)
        body += "<th scope=\"col\"" + std::string(kind(c)) + ">" + escape(table.head[c]) + "</th>";
    body += "</tr></thead>\n<tbody>\n";
    for (const std::vector<std::string>& row : table.rows) {
        body += "<tr>";
        for (std::size_t c = 0; c < row.size(); ++c)
            body += (c == 0 ? "<th scope=\"row\"" : "<td") + std::string(kind(c)) + ">" + escape(row[c]) +
                    (c == 0 ? "</th>" : "</td>");
        body += "</tr>\n";
    }
    body += "</tbody></table></div>\n" + std::string(folded ? "</details>\n" : "</figure>\n");
}

void Page::headline(const std::string& value, const std::string& meaning) {
    headlines_ += "<li><b>" + escape(value) + "</b><span>" + escape(meaning) + "</span></li>\n";
}

void Page::file(const std::string& name) { parts_.back().files.push_back(name); }

std::string Page::contents() const {
    std::string list, group;
    for (const Part& part : parts_) {
        const std::size_t colon = part.title.find(": ");
        const std::string its = colon == std::string::npos ? "" : part.title.substr(0, colon);
        if (list.empty() || its != group)
            list += (list.empty() ? "" : "</ul>\n") + ("<b>" + escape(its) + "</b><ul>\n");
        group = its;
        list += "<li><a href=\"#" + part.id + "\">" +
                escape(colon == std::string::npos ? part.title : part.title.substr(colon + 2)) + "</a></li>\n";
    }
    return "<nav aria-label=\"Contents\">\n" + list + (list.empty() ? "" : "</ul>\n") + "</nav>\n";
}

std::string Page::html(const std::string& title, const std::string& lead, const std::vector<std::string>& facts) const {
    std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
                       escape(title) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n" + contents() +
                       "<div class=\"text\">\n<header>\n<h1>" + escape(title) + "</h1>\n<p class=\"lead\">" +
                       escape(lead) + "</p>\n";
    if (!gallery_.empty()) page += "<ul class=\"gallery\">\n" + gallery_ + "</ul>\n";
    if (!headlines_.empty()) page += "<ul class=\"heads\">\n" + headlines_ + "</ul>\n";
    page += "<ul class=\"facts\">\n";
    for (const std::string& fact : facts) page += "<li>" + escape(fact) + "</li>\n";
    page += "</ul>\n</header>\n<main>\n";
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
    return page + "</main>\n</div>\n</body>\n</html>\n";
}

}  // namespace report
