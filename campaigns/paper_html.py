"""The paper's page as a file: items, each with its verdict, in one document that needs no network."""

import html
import io
import json

import matplotlib

from paper_words import DIFFERS, MISSING, REPRODUCED, UNKNOWN

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


class Page:
    def __init__(self, folder, quick, program=""):
        self.folder, self.quick, self.program, self.items = folder, quick, program, []

    def save(self, figure, name):
        """Equal data give equal bytes."""
        matplotlib.rcParams["svg.hashsalt"] = "overturn"
        figure.savefig(self.folder / name, metadata={"Date": None, "Creator": None}, dpi=150)
        plt.close(figure)

    def json(self, name):
        return json.loads((self.folder / f"{name}.json").read_text(encoding="utf-8"))

    def item(self, what, ours, verdict, why, figures=(), rows=None):
        self.items.append({"paper": what, "ours": ours, "verdict": verdict, "why": why, "figures": list(figures), "rows": rows})

    def has(self, name):
        return (self.folder / name).exists()

    def text(self):
        out = io.StringIO()
        out.write("<!doctype html><meta charset=utf-8><title>The paper, table by table</title><style>body{font:15px/1.45 system-ui,sans-serif;"
                  "max-width:56em;margin:2em auto;padding:0 1em;color:#1a1a1a}section{border-top:1px solid #ddd;padding:.6em 0}h2{font-size:1.05em;"
                  "margin:.2em 0}table{border-collapse:collapse;font-size:.9em}td,th{padding:.1em .8em .1em 0;text-align:left}.v{font-weight:700}"
                  "svg{max-width:100%;height:auto}</style>\n<h1>The paper, table by table and figure by figure</h1>\n")
        count = {v: sum(i["verdict"] == v for i in self.items) for v in (REPRODUCED, DIFFERS, UNKNOWN, MISSING)}
        out.write(f"<p>PATRAM 2013, \"Stability evaluation methodology of the dual purpose metal cask attached to a transfer air pallet during "
                  f"long-period seismic motions\": {', '.join(f'{n} {v}' for v, n in count.items() if n)}. Verdicts are chosen by the numbers "
                  "beside them; intervals are of 95 %.</p>\n")
        if self.quick:
            out.write("<p><b>A quick run of few waves: its numbers mean nothing.</b></p>\n")
        for item in self.items:
            out.write(f"<section><h2>{html.escape(item['paper'])}</h2><p><span class=v>{item['verdict']}</span>"
                      + (f": {html.escape(item['ours'])}" if item["ours"] else "") + f"<br>{html.escape(item['why'])}.</p>\n")
            if item["rows"]:
                head, *body = item["rows"]
                out.write("<table><tr>" + "".join(f"<th>{html.escape(str(c))}" for c in head) + "".join(
                    "<tr>" + "".join(f"<td>{html.escape(str(c))}" for c in row) for row in body) + "</table>\n")
            for name in item["figures"]:
                svg = (self.folder / name).read_text(encoding="utf-8")
                out.write(svg[svg.index("<svg"):] + "\n")
            out.write("</section>\n")
        out.write(f"<p>Made by {html.escape(self.program)}.</p>\n" if self.program else "")
        return out.getvalue()
