#include "report/detail/study_page.hpp"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/escaped_html.hpp"
#include "core/scroll_hint.hpp"
#include "report/cost_page.hpp"
#include "report/figure.hpp"

namespace overturn::report {

namespace {

constexpr char const* study_style = R"css(
:root { color-scheme: light dark; --ink: #1a1a1a; --paper: #fff; --quiet: #595959; --answer: #fdf3ec; }
@media screen and (prefers-color-scheme: dark) {
  :root { --ink: #e4e4e4; --paper: #121212; --quiet: #b0b0b0; --answer: #26190f; }
  figure svg { filter: invert(.93) hue-rotate(180deg); }  /* white to the paper's black, ink to light, hues kept */
}
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; color: var(--ink); background: var(--paper); margin: 0 auto;
       overflow-wrap: anywhere;
       max-width: 76rem; padding: 1.5rem 1.5rem 4rem; }
h1 { font-size: 1.5rem; margin: 0 0 .2rem; } h2 { font-size: 1.1rem; margin: 0; }
p { margin: .3rem 0; } .quiet { color: var(--quiet); font-size: .88rem; }
.answer { border-left: 4px solid #d55e00; background: var(--answer); padding: .7rem 1rem; margin: 1.1rem 0 .5rem;
          font-size: 1.05rem; }
section { border-top: 1px solid #8886; margin-top: 1.6rem; padding-top: 1.1rem; display: grid; gap: .4rem 1.6rem;
          grid-template-columns: minmax(20rem, 1fr) minmax(26rem, 1.15fr); align-items: start; }
section > header { grid-column: 1 / -1; } figure { margin: 0; }
svg { width: 100%; min-width: 29rem; height: auto; display: block; }  /* letters of 8 pixels at least */
table { border-collapse: collapse; font-size: .82rem; font-variant-numeric: tabular-nums; width: 100%; }
th { font-weight: 600; color: var(--quiet); } th, td { text-align: right; padding: .16rem .45rem; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; } tbody tr { border-top: 1px solid #8883; }
tr.here td { background: var(--answer); font-weight: 600; } tr.front td:first-child::before { content: "\25cf\00a0"; color: #0072b2; }
tr.here td:first-child::before { content: "\25c6\00a0"; color: #d55e00; }
tr.plain td:first-child::before { content: "\25cb\00a0"; color: #888; }
.scroll { overflow-x: auto; } :focus-visible { outline: 2px solid #0072b2; } code { font-size: .92em; }
@media (max-width: 60rem) { section { grid-template-columns: minmax(0, 1fr); } }
@media (max-width: 40rem) { body { padding: 1rem .8rem 3rem; } }
@media print {
  @page { size: A4; margin: 16mm 14mm; }
  :root { color-scheme: light; } body { font-size: 10pt; max-width: none; padding: 0; } p { orphans: 3; widows: 3; }
  section { display: block; margin-top: 1.2rem; padding-top: .8rem; } h1, h2, header { break-after: avoid; }
  .scroll { overflow: visible; background: none; } figure svg { min-width: 0; max-height: 68mm; margin: .4rem auto; }
  figure, tr, header, .answer, table:not(:has(tbody tr:nth-child(13))) { break-inside: avoid; }  /* a short table stays whole */
  thead, tbody tr:first-child { break-after: avoid; } tr:last-child { break-before: avoid; }
  table { font-size: 8pt; margin-top: .4rem; } th, td { white-space: normal; }
}
)css";

using StudyJson = nlohmann::ordered_json;

}  // namespace

std::string study_head(std::string const& heading, StudyJson const& study, std::string const& style) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{0}: {1}</title>\n"
        "<style>.scroll {{ {4} }}\n{2}{3}</style></head><body><main>\n<h1>{0}</h1>\n<p>{1}</p>\n",
        heading, text_at(study, "title"), study_style, style, scroll_hint);
}

std::string study_figure(char const* script, StudyJson const& data, std::string const& label) {
    auto const svg = figure_text(script, data);
    auto const begin = svg.find("<svg");
    if (begin == std::string::npos) {
        throw SystemError("no figure (Python drew something else than svg). Look at $OVERTURN_PYTHON");
    }
    return fmt::format(
        "<figure><div class=\"scroll\" role=\"group\" aria-label=\"{0}\" tabindex=\"0\"><svg role=\"img\" "
        "aria-label=\"{0}\"{1}</div></figure>\n",
        label, svg.substr(begin + std::string_view("<svg").size()));
}

std::string text_at(StudyJson const& row, char const* key) {
    auto const& text = row.at(key);
    return text.is_null() ? std::string() : escaped_html(text.get<std::string>());
}

std::int64_t count_at(StudyJson const& row, char const* key) { return row.at(key).get<std::int64_t>(); }

std::string number_at(StudyJson const& row, char const* key, char const* format) {
    auto const& value = row.at(key);
    return value.is_null() ? "&ndash;" : fmt::format(fmt::runtime(format), value.get<double>());
}

std::string table_row(std::vector<std::string> const& cells, std::string const& kind, std::string const& tip) {
    return fmt::format("<tr class=\"{}\"{}><td>{}</td></tr>\n", kind,
                       tip.empty() ? "" : fmt::format(" title=\"{}\"", tip), fmt::join(cells, "</td><td>"));
}

std::string last_table(std::string const& name, std::vector<std::string> const& headings, std::string const& rows,
                       std::string const& note) {
    return fmt::format(
        "<div class=\"scroll\" role=\"group\" aria-label=\"{0}\" tabindex=\"0\"><table "
        "aria-label=\"{0}\"><thead><tr><th "
        "scope=\"col\">{1}</th></tr></thead><tbody>\n{2}</tbody></table>{3}</div></section>\n",
        name, fmt::join(headings, "</th><th scope=\"col\">"), rows,
        note.empty() ? "" : "<p class=\"quiet\">" + note + "</p>");
}

}  // namespace overturn::report
