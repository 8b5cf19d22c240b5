"""How a report's page looks: on a screen, light and dark, on a phone and in print."""

CSS = """
:root { color-scheme: light dark; --ink: #1a1a1a; --paper: #fff; --quiet: #595959; --rule: #ddd; --faint: #eee; --link: #00609a;
        --answer: #fdf3ec; --accent: #d55e00; --warn: #e69f00; --code: #f6f6f6; --under: var(--paper); --shade: #0004; --blend: darken; }
@media screen and (prefers-color-scheme: dark) {
  :root { --ink: #e4e4e4; --paper: #121212; --quiet: #b0b0b0; --rule: #3a3a3a; --faint: #2a2a2a; --link: #7cc4f2; --answer: #26190f;
          --code: #1d1d1d; --shade: #fff5; --blend: lighten; }
  figure svg { filter: invert(.93) hue-rotate(180deg); }  /* white to the paper's black, ink to light, hues kept */
}
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; color: var(--ink); background: var(--paper); margin: 0 auto;
       max-width: 62rem; padding: 1.5rem 1.5rem 4rem; }
h1, h2, h3, h4, caption, figcaption, dd { overflow-wrap: anywhere; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: 0 0 .4rem; }
h2 { font-size: 1.4rem; margin: 2.2rem 0 .6rem; padding-top: .6rem; border-top: 2px solid var(--ink); }
h3 { font-size: 1.12rem; margin: 0 0 .5rem; } h4 { font-size: 1rem; margin: 1.2rem 0 .3rem; }
p { margin: .3rem 0; } ul { margin: .1rem 0 .6rem; padding-left: 1.2rem; }
.kind { color: var(--quiet); font-size: .9rem; letter-spacing: .02em; } .question { font-size: 1.1rem; margin: 0 0 .8rem; }
.answer { --under: var(--answer); border-left: 4px solid var(--accent); background: var(--answer); padding: .6rem 1rem; margin: 0 0 .8rem; }
.warning { border-left: 3px solid var(--warn); padding-left: .7rem; font-size: .92rem; }
.quiet { color: var(--quiet); font-size: .86rem; } .label { font-weight: 600; margin-top: .6rem; }
.identity { margin: .8rem 0; font-size: .88rem; } .identity div { display: flex; gap: .8rem; }
.identity dt { flex: 0 0 5.5rem; color: var(--quiet); } .identity dd { margin: 0; min-width: 0; }
nav { font-size: .9rem; } nav ol { list-style: none; padding: 0; margin: 1rem 0 0; } nav li { margin: .25rem 0; }
nav span { font-weight: 600; margin-right: .4rem; } a { color: var(--link); text-decoration: none; } a:hover, a:focus { text-decoration: underline; }
section { border-top: 1px solid var(--rule); margin-top: 1.2rem; padding-top: .9rem; } h2 + section { border-top: 0; margin-top: 0; padding-top: 0; }
figure { margin: .8rem 0 1rem; } svg { max-width: 100%; min-width: var(--least); height: auto; display: block; }
caption, figcaption { text-align: left; font-size: .84rem; font-weight: 600; padding: 0 0 .2rem; } figcaption { padding-top: .2rem; }
/* A shadow at the side where more is to be seen: covers move with the content, shadows stay. */
.scroll { overflow-x: auto; margin: .5rem 0; background: linear-gradient(to right, var(--under) 40%, transparent) left / 2.5rem 100% no-repeat local,
  linear-gradient(to left, var(--under) 40%, transparent) right / 2.5rem 100% no-repeat local,
  linear-gradient(to right, var(--shade), transparent) left / 1rem 100% no-repeat, linear-gradient(to left, var(--shade), transparent) right / 1rem 100% no-repeat; }
.scroll svg { mix-blend-mode: var(--blend); } :focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
table { border-collapse: collapse; font-size: .84rem; font-variant-numeric: tabular-nums; }
th { font-weight: 600; color: var(--quiet); } thead th { vertical-align: bottom; } th, td { text-align: right; padding: .16rem .6rem; vertical-align: top; }
th:first-child, td:first-child { text-align: left; padding-left: 0; white-space: nowrap; } tbody tr { border-top: 1px solid var(--faint); }
:is(.answer, .words, .facts, .signatures) :is(th, td), th.text, td.text { text-align: left; } .answer table { font-size: .92rem; } .short { white-space: nowrap; }
.answer :is(th, td):nth-child(-n+2) { padding-right: .8rem; } .facts td { overflow-wrap: anywhere; } .facts th { white-space: nowrap; }
.words .short { white-space: normal; } .words td { min-width: 6rem; overflow-wrap: anywhere; } .words .short { overflow-wrap: break-word; } .words td:first-child { white-space: normal; min-width: 8rem; }
.signatures { width: 100%; margin: .6rem 0; } .signatures :is(th, td) { border-bottom: 1px solid var(--rule); padding: .5rem .6rem .5rem 0; }
.signatures thead th { padding-bottom: .1rem; } .signatures tbody th { width: 6rem; } .signatures :is(th, td):nth-child(n+3) { width: 26%; }
.fold { max-height: 26rem; overflow: auto; border: 1px solid var(--rule); padding: 0 .8rem; margin: .2rem 0 .6rem; } .fold .scroll { overflow: visible; }
pre { font-size: .78rem; background: var(--code); padding: .8rem; margin: 0 -.8rem; white-space: pre-wrap; overflow-wrap: anywhere; }
th button { font: inherit; color: inherit; background: none; border: 0; padding: 0; cursor: pointer; text-align: inherit; }
th button::after { content: " \\2195"; opacity: .6; } th[aria-sort=ascending] button::after { content: " \\2191"; } th[aria-sort=descending] button::after { content: " \\2193"; }
.filter, .zoom { font-size: .84rem; color: var(--quiet); } .filter input { font: inherit; color: inherit; background: var(--paper); border: 1px solid var(--quiet); padding: .1rem .3rem; }
.zoom { margin: 0; } .zoom button { font: inherit; color: var(--ink); background: var(--faint); border: 1px solid var(--quiet); border-radius: 3px; min-width: 1.7rem; margin-right: .3rem; cursor: pointer; }
.tip { display: none; position: absolute; pointer-events: none; white-space: pre; background: var(--paper); color: var(--ink); border: 1px solid var(--quiet); padding: .2rem .5rem; font-size: .8rem; max-width: 190px; overflow: hidden; }
.tip.on { border-color: var(--accent); border-width: 2px; }
@media (max-width: 40rem) { body { padding: 1rem .8rem 3rem; } h1 { font-size: 1.35rem; } .answer { padding: .5rem .6rem; } caption { position: sticky; left: 0; max-width: calc(100vw - 3.4rem); }
  .answer table { font-size: .8rem; min-width: 33rem; } .answer td { padding: .16rem .4rem; } .answer .short { white-space: normal; } .answer td:first-child { white-space: nowrap; } .words { min-width: 44rem; } .identity div { display: block; margin-bottom: .3rem; } }
@media screen and (max-width: 40rem) {  /* the answer, one line for each level */
  .answer .stacked { display: block; min-width: 0; } .stacked thead { display: none; } .stacked :is(caption, tbody, tr, td) { display: block; }
  .answer .stacked td { padding: .05rem 0; } .stacked tbody tr { padding: .2rem 0; } .stacked td:empty { display: none; }
  .stacked td:is(:first-child, :nth-child(2)) { font-weight: 600; } .stacked td:nth-child(2) { color: var(--quiet); }
  .answer .stacked td[data-head] { display: flex; justify-content: space-between; gap: .8rem; text-align: right; }
  .stacked td[data-head]::before { content: attr(data-head); text-align: left; color: var(--quiet); } }
@media print {
  @page { size: A4; margin: 16mm 14mm 18mm; @bottom-left { content: "overturn"; font: 7.5pt sans-serif; color: #595959; }
          @bottom-right { content: counter(page) " / " counter(pages); font: 7.5pt sans-serif; color: #595959; } }
  :root { color-scheme: light; font-size: 9.5pt; } body { font-size: 1rem; max-width: none; padding: 0; } nav, .filter, .zoom, .tip { display: none !important; }
  th button { display: contents; } th button::after { content: "" !important; }  /* a box would be blank where a heading is repeated */
  h1, h2, h3, h4, caption { break-after: avoid; } h2 { margin-top: 1.2rem; } p, li { orphans: 3; widows: 3; }
  figure, tr, .identity, .signatures, table:not(:has(tbody tr:nth-child(13))) { break-inside: avoid; }  /* a short table stays whole */
  .answer { font-size: 9pt; } .answer table { font-size: 8.5pt; } figure svg { min-width: 0; mix-blend-mode: normal; max-height: 100mm; margin: 0 auto; } #bodies figure svg { max-height: 50mm; }
  thead, tbody tr:first-child { break-inside: avoid; break-after: avoid; }
  .scroll, .fold { overflow: visible; background: none; } .fold { max-height: none; border: 0; padding: 0; } pre { margin: 0; font-size: 7.5pt; }
  table { font-size: 7.5pt; } .short { white-space: normal; } th, td { padding: .1rem .3rem; overflow-wrap: break-word; }
  th:first-child, td:first-child { white-space: normal; } .words td, .words td:first-child { min-width: 0; } .signatures :is(th, td) { padding: 3mm 1mm 3mm 0; }
}
"""
