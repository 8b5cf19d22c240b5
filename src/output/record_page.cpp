#include "output/record_page.hpp"

#include <iterator>

#include <fmt/format.h>

#include "core/escaped_html.hpp"

namespace overturn::output {
std::string html_of(RecordPage const& page) {
    std::string facts;
    for (auto const& [name, value] : page.facts) {
        fmt::format_to(std::back_inserter(facts), "<dt>{}</dt><dd>{}</dd>\n", escaped_html(name), escaped_html(value));
    }
    std::string head;
    for (auto const& cell : page.head) {
        head += fmt::format("<th>{}</th>", escaped_html(cell));
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
body {{ font: 15px/1.5 sans-serif; color: #222; background: #fff; max-width: 70rem; margin: 2rem auto; padding: 0 1rem;
       overflow-wrap: anywhere; }}
div {{ overflow-x: auto; }} table {{ border-collapse: collapse; }}
th, td {{ text-align: left; vertical-align: top; padding: .25rem .75rem .25rem 0; border-bottom: 1px solid #ddd; }}
.pass td:first-child {{ color: #17633a; }} .fail td {{ color: #a02020; font-weight: bold; }}
dt {{ color: #595959; }} dd {{ margin: 0 0 .4rem; }}
@media print {{ body {{ font-size: 10pt; margin: 0; }} tr {{ break-inside: avoid; }} }}
</style></head><body>
<h1>{}</h1>
<dl>
{}</dl>
<div><table><thead><tr>{}</tr></thead><tbody>
{}</tbody></table></div>
</body></html>
)",
                       escaped_html(page.title), escaped_html(page.title), facts, head, rows);
}

}  // namespace overturn::output
