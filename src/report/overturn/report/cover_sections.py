"""The first sheet of a report: what was asked, the answer, by which program from which file, and who signs."""

from .limit_sections import answer_table
from .page_parts import escape, paragraphs, table


def identity(report):
    """What the package is of: {what, which}, without what was not stated."""
    about, cover = report.results.about, report.data["cover"]
    rows = [("revision", cover["revision"]), ("date", cover["date"]),
            ("program", f"overturn {about['program_version']} ({about['git_revision']})"),
            ("campaign", f"{about['campaign_name']}, input_sha256 {about['input_sha256']}"),
            ("results", f"content_sha256 {about['content_sha256']}" if about.get("content_sha256") else "")]
    return "".join(f"<div><dt>{escape(what)}</dt><dd>{escape(which)}</dd></div>" for what, which in rows if which)


def signatures(report):
    """A line for each who signs: the name where it was stated, room to sign and to date."""
    rows = "".join(f"<tr><th scope=row>{escape(what)}</th><td>{escape(name)}</td><td></td><td></td></tr>"
                   for what, name in report.data["cover"]["signatures"])
    return ("<table class=signatures aria-label=signatures><thead><tr><th scope=col>step</th><th scope=col>name</th><th scope=col>signature</th>"
            f"<th scope=col>date</th></tr></thead><tbody>{rows}</tbody></table>")


def cover(report):
    answer = answer_table(report.data["answer"]) or paragraphs(report.data["headlines"])  # of a grid: no probabilities
    answer += paragraphs([f"{line}." for line in report.fit["cautions"]], " class=warning")
    records = report.data["records"]
    if records["rows"]:
        answer += table("each recorded motion", records["head"], records["rows"], records["note"])
    failed = paragraphs([report.notes["check_failed"].format(**check) for check in report.data["checks"] if check["failed"]],
                        " class=warning")
    changed = failed + (paragraphs([report.data["changed"]], " class=warning") if report.data["changed"] else "")
    return (f"<p class=kind>Calculation package</p>\n<h1>{escape(report.results.title)}</h1>\n"
            f"<p class=question>{escape(report.data['cover']['question'])}</p>\n<div class=answer>{changed}{answer}</div>\n"
            f"<dl class=identity>{identity(report)}</dl>\n{signatures(report)}")
