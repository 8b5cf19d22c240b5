#include "output/record_page.hpp"

#include <iterator>

#include <fmt/format.h>

#include "core/escaped_html.hpp"
#include "core/scroll_hint.hpp"

namespace overturn::output {
std::string html_of(RecordPage const& page) {
    std::string facts;
    for (auto const& [name, value] : page.facts) {
        fmt::format_to(std::back_inserter(facts), "<dt>{}</dt><dd>{}</dd>\n", escaped_html(name), escaped_html(value));
    }
    std::string head;
    for (auto const& cell : page.head) {
        head += fmt::format("<th scope=\"col\">{}</th>", escaped_html(cell));
    }
    std::string rows;
    for (auto const& row : page.rows) {
        rows += row.passed ? "<tr class=\"pass\">" : "<tr class=\"fail\">";
        for (auto const& cell : row.cells) {
            rows += fmt::format("<td>{}</td>", escaped_html(cell));
        }
        rows += "</tr>\n";
    }
    return fmt::format(R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>overturn: {}</title>
<style>
:root {{ color-scheme: light dark; --ink: #222; --paper: #fff; --quiet: #595959; --pass: #17633a; --fail: #a02020; }}
@media screen and (prefers-color-scheme: dark) {{
  :root {{ --ink: #e4e4e4; --paper: #121212; --quiet: #b0b0b0; --pass: #7fd3a5; --fail: #ff9b93; }} }}
body {{ font: 15px/1.5 sans-serif; color: var(--ink); background: var(--paper); max-width: 90rem; margin: 2rem auto; padding: 0 1rem;
       overflow-wrap: anywhere; }}
div {{ overflow-x: auto; {} }} table {{ border-collapse: collapse; }}
th, td {{ text-align: left; vertical-align: top; padding: .25rem .75rem .25rem 0; border-bottom: 1px solid #8886; }}
td {{ overflow-wrap: break-word; }} td:nth-child(-n+2), th {{ white-space: nowrap; }}
.pass td:first-child {{ color: var(--pass); }} .fail td {{ color: var(--fail); font-weight: bold; }}
dt {{ color: var(--quiet); }} dd {{ margin: 0 0 .4rem; }}
@page {{ size: landscape; }}
@media print {{ body {{ font-size: 8pt; margin: 0; max-width: none; }} td:nth-child(3), td:nth-child(4), td:last-child {{ overflow-wrap: anywhere; }}
  div {{ overflow: visible; background: none; }} tr {{ break-inside: avoid; }} }}
</style></head><body><main>
<h1>{}</h1>
<dl>
{}</dl>
<div role="group" aria-label="results" tabindex="0"><table aria-label="results"><thead><tr>{}</tr></thead><tbody>
{}</tbody></table></div>
</main></body></html>
)",
                       escaped_html(page.title), scroll_hint, escaped_html(page.title), facts, head, rows);
}

}  // namespace overturn::output
