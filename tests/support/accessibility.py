"""What keeps a reader out of a page: the rules of axe-core that matter to such pages, looked at in the browser itself.

Contrast (WCAG 2.2, 1.4.3), language and title, landmarks, order of headings, names of tables and their headings, of drawings and of
controls, and whether what scrolls can be reached with the keyboard. Debian 12 has no package of axe-core; where OVERTURN_AXE names
its axe.min.js, that runs too, and what it calls serious or critical is a fault."""

import json
import os
from pathlib import Path

RULES = r"""(() => {
    const found = [];
    const say = (what, e) => found.push(what + (e ? ': ' + (e.outerHTML || '').slice(0, 90).replace(/\s+/g, ' ') : ''));
    const all = selector => [...document.querySelectorAll(selector)];
    const seen = e => e.checkVisibility() && e.getClientRects().length > 0;
    const name = e => (e.getAttribute('aria-label') || e.textContent || e.getAttribute('title') || '').trim()
        || (e.labels && e.labels.length ? e.labels[0].textContent.trim() : '');

    if (!document.documentElement.lang) say('no language');
    if (!document.title.trim()) say('no title');
    if (all('main').length !== 1) say('not one main landmark');
    for (const e of document.body.children)
        if (seen(e) && !['HEADER', 'NAV', 'MAIN', 'FOOTER', 'SCRIPT', 'STYLE'].includes(e.tagName) && e.getAttribute('aria-hidden') !== 'true')
            say('outside of landmarks', e);

    let level = 0;
    for (const e of all('h1, h2, h3, h4, h5, h6')) {
        const own = Number(e.tagName[1]);
        if (own > level + 1) say('heading skips a level', e);
        level = own;
    }
    if (all('h1').length !== 1) say('not one h1');

    for (const e of all('table')) {
        if (!(e.caption && e.caption.textContent.trim()) && !e.getAttribute('aria-label')) say('table without a name', e);
        if (!e.querySelector('th')) say('table without headings', e);
    }
    for (const e of all('th')) {
        if (!name(e)) say('empty heading of a table', e);
        if (!e.getAttribute('scope')) say('heading of a table without scope', e);
    }
    for (const e of all('svg')) if (!e.parentElement.closest('svg') && !(e.getAttribute('role') === 'img' && e.getAttribute('aria-label')))
        say('drawing without a name', e);
    for (const e of all('img')) if (!e.hasAttribute('alt')) say('picture without a name', e);
    for (const e of all('a[href], button, input, select')) if (seen(e) && !name(e)) say('control without a name', e);
    for (const e of all('[tabindex]')) if (e.tabIndex > 0) say('order of the keyboard is forced', e);

    for (const e of all('body *')) {
        if (e.closest('svg') || !seen(e)) continue;
        const s = getComputedStyle(e);
        const across = ['auto', 'scroll'].includes(s.overflowX) && e.scrollWidth > e.clientWidth + 1;
        const down = ['auto', 'scroll'].includes(s.overflowY) && e.scrollHeight > e.clientHeight + 1;
        if ((across || down) && e.tabIndex < 0 && !e.querySelector('a[href], button, input, [tabindex="0"]')) say('scrolls without keyboard', e);
        if (e.tabIndex === 0 && !['A', 'BUTTON', 'INPUT', 'SELECT', 'SUMMARY'].includes(e.tagName) && !(e.getAttribute('role') && e.getAttribute('aria-label')))
            say('stop of the keyboard without role and name', e);
    }

    const colour = text => { const v = text.match(/[\d.]+/g).map(Number); return {rgb: v.slice(0, 3), alpha: v.length > 3 ? v[3] : 1}; };
    const over = (front, back) => front.rgb.map((v, k) => v * front.alpha + back[k] * (1 - front.alpha));
    const bright = rgb => { const [r, g, b] = rgb.map(v => { v /= 255; return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; });
        return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
    const ground = e => {
        const layers = [];
        for (let p = e; p; p = p.parentElement) layers.push(colour(getComputedStyle(p).backgroundColor));
        const dark = getComputedStyle(document.documentElement).colorScheme.includes('dark') && matchMedia('(prefers-color-scheme: dark)').matches;
        return layers.reverse().reduce((back, layer) => over(layer, back), dark ? [18, 18, 18] : [255, 255, 255]);
    };
    for (const e of all('body *')) {
        if (e.closest('svg, script, style') || !seen(e)) continue;
        if (![...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim())) continue;
        const s = getComputedStyle(e), back = ground(e), front = bright(over(colour(s.color), back)), behind = bright(back);
        const ratio = (Math.max(front, behind) + 0.05) / (Math.min(front, behind) + 0.05);
        const size = parseFloat(s.fontSize), large = size >= 24 || (size >= 18.66 && Number(s.fontWeight) >= 700);
        if (ratio < (large ? 3 : 4.5)) say('contrast ' + ratio.toFixed(2), e);
    }
    return [...new Set(found)];
})()"""

AXE = """axe.run(document).then(found => JSON.stringify(found.violations.filter(v => ['serious', 'critical'].includes(v.impact))
    .map(v => v.id + ': ' + v.nodes[0].html.slice(0, 90))))"""


def faults(browser):
    """One line each, as the page stands in the window now."""
    yield from browser.value(RULES)
    if os.environ.get("OVERTURN_AXE"):
        browser.value(Path(os.environ["OVERTURN_AXE"]).read_text(encoding="utf-8") + "; 0")
        for line in json.loads(browser.ask("Runtime.evaluate", expression=AXE, awaitPromise=True, returnByValue=True)["result"]["value"]):
            yield "axe: " + line
