"""How a report's page looks, on a screen and in print."""

CSS = """
:root { color-scheme: light; }
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; color: #1a1a1a; background: #fff; margin: 0 auto;
       max-width: 62rem; padding: 1.5rem 1.5rem 4rem; }
h1 { overflow-wrap: anywhere; font-size: 1.6rem; line-height: 1.25; margin: 0 0 .6rem; }
h2 { font-size: 1.2rem; margin: 0 0 .6rem; } h3 { font-size: 1rem; margin: 1.2rem 0 .3rem; }
p { margin: .3rem 0; } ul { margin: .1rem 0 .6rem; padding-left: 1.2rem; }
.answer { border-left: 4px solid #d55e00; background: #fdf3ec; padding: .6rem 1rem; margin: 0 0 .8rem; font-size: 1.05rem; }
.warning { border-left: 3px solid #e69f00; padding-left: .7rem; font-size: .92rem; }
.quiet { color: #666; font-size: .86rem; } .label { font-weight: 600; margin-top: .6rem; }
nav { font-size: .9rem; color: #888; } nav a { color: #0072b2; text-decoration: none; }
section { border-top: 1px solid #ddd; margin-top: 1.5rem; padding-top: 1rem; }
figure { margin: .6rem 0; overflow-x: auto; } svg { max-width: 100%; min-width: var(--least); height: auto; display: block; }
.scroll { overflow-x: auto; margin: .5rem 0; }
table { border-collapse: collapse; font-size: .84rem; font-variant-numeric: tabular-nums; }
th { font-weight: 600; color: #666; } th, td { text-align: right; padding: .16rem .6rem; vertical-align: top; }
th:first-child, td:first-child { text-align: left; padding-left: 0; white-space: nowrap; } tbody tr { border-top: 1px solid #eee; }
.answer :is(th, td) { text-align: left; } .answer table { font-size: .9rem; }
.short { white-space: nowrap; } #asked td, #provenance td { text-align: left; overflow-wrap: anywhere; } #asked thead, #provenance thead { display: none; }
#assumptions :is(th, td) { text-align: left; } #assumptions .short { white-space: normal; } #assumptions :is(th, td):nth-child(3) { white-space: nowrap; }
.fold { max-height: 26rem; overflow: auto; border: 1px solid #e4e4e4; padding: 0 .8rem; margin: .2rem 0 .6rem; }
pre { font-size: .78rem; background: #f6f6f6; padding: .8rem; margin: 0 -.8rem; white-space: pre-wrap; overflow-wrap: anywhere; }
@media (max-width: 40rem) { body { padding: 1rem .8rem 3rem; } h1 { font-size: 1.35rem; } }
@media print {
  body { font-size: 10pt; max-width: none; padding: 0; } nav { display: none; } h2, h3 { break-after: avoid; }
  figure, tr, .answer { break-inside: avoid; } figure { overflow: visible; } figure svg { min-width: 0; max-height: 215mm; }
  .scroll { overflow: visible; } #assumptions :is(th, td) { text-align: left; } #assumptions .short { white-space: normal; } #assumptions :is(th, td):nth-child(3) { white-space: nowrap; }
.fold { max-height: none; overflow: visible; border: 0; padding: 0; } pre { margin: 0; font-size: 7.5pt; }
  table { font-size: 7.5pt; } .short { white-space: normal; } th, td { padding: .1rem .32rem; overflow-wrap: anywhere; } th:first-child, td:first-child { white-space: normal; }
  @page { margin: 16mm 14mm; }
}
"""
