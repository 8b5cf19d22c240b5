"""Opens a page in headless Chromium and says what is wrong with it, one line each; nothing where all is well.

Arguments: the browser, the page, a stem for screenshots (none: none are taken). It must load nothing but itself, say nothing to the
console, show every figure, reach beyond neither a phone's nor a desk's window, keep no reader out (accessibility.py; light, dark and
on a phone), and have every table and text whole in print. Where it has a script, its tables must sort and filter and its figures
zoom and tell values. Talks to the browser over its debugging pipe, so that no port and no package is needed."""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import accessibility


class Browser:
    def __init__(self, program, folder):
        hear, say = os.pipe(), os.pipe()

        def wire():  # the browser reads its orders from 3 and answers on 4
            theirs = os.dup(hear[0]), os.dup(say[1])
            os.dup2(theirs[0], 3)
            os.dup2(theirs[1], 4)
        options = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--remote-debugging-pipe",
                   "--no-first-run", "--disable-extensions", "--disable-background-networking", f"--user-data-dir={folder}"]
        self.process = subprocess.Popen([program, *options, "about:blank"], preexec_fn=wire, close_fds=False,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(hear[0])
        os.close(say[1])
        self.orders, self.answers = os.fdopen(hear[1], "wb", 0), os.fdopen(say[0], "rb", 0)
        self.number, self.rest, self.events, self.session = 0, b"", [], None

    def read(self):
        while b"\0" not in self.rest:
            more = self.answers.read(1 << 16)
            if not more:
                sys.exit("the browser ended")
            self.rest += more
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def ask(self, method, **parameters):
        self.number += 1
        order = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            order["sessionId"] = self.session
        self.orders.write(json.dumps(order).encode() + b"\0")
        while True:
            message = self.read()
            if message.get("id") == self.number:
                if "error" in message:
                    sys.exit(f"{method}: {message['error']['message']}")
                return message["result"]
            self.events.append(message)

    def wait_for(self, event):
        while not any(message.get("method") == event for message in self.events):
            self.events.append(self.read())

    def value(self, script):
        return self.ask("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)["result"].get("value")

    def resize(self, width, height):
        """Until the page has heard of it: events of a new size come with the next frame."""
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))")


FIGURES = """[...document.querySelectorAll('svg')].filter(e => !e.parentElement.closest('svg')).map(e => {
    const r = e.getBoundingClientRect(); return [e.getAttribute('aria-label') || '', r.width, r.height] })"""

# What reaches beyond the window and lies in no box that scrolls.
BEYOND = """(() => { const wide = document.documentElement.clientWidth, found = [];
    for (const e of document.body.querySelectorAll('*')) {
        if (e.closest('svg') && e.tagName !== 'svg') continue;
        const r = e.getBoundingClientRect();
        let boxed = false;
        for (let p = e.parentElement; p && !boxed; p = p.parentElement)
            boxed = ['auto', 'scroll', 'hidden'].includes(getComputedStyle(p).overflowX) && p.getBoundingClientRect().right <= wide + 1;
        if (r.width && r.right > wide + 1 && !boxed) found.push(e.tagName + ' ' + (e.id || e.className || e.textContent.slice(0, 40)));
    }
    if (document.documentElement.scrollWidth > wide) found.push('the page itself');
    return found })()"""

# Tables and texts that print would cut: not shown, or clipped by a box.
CUT = """[...document.querySelectorAll('table, pre, svg')].filter(e => !e.parentElement.closest('svg')).filter(e => {
    const r = e.getBoundingClientRect();
    if (!r.width || !r.height || !e.checkVisibility()) return true;
    for (let p = e.parentElement; p; p = p.parentElement) {
        const q = p.getBoundingClientRect(), s = getComputedStyle(p);
        if (s.overflowX !== 'visible' && p !== document.body && (r.right > q.right + 1 || r.bottom > q.bottom + 1)) return true;
    }
    return r.right > document.documentElement.clientWidth + 1;
}).map(e => e.tagName + ' ' + e.textContent.trim().slice(0, 60))"""

# Boxes that scroll to the side and do not show it.
UNSEEN = """[...document.querySelectorAll('body *')].filter(e => e.scrollWidth > e.clientWidth + 1
    && ['auto', 'scroll'].includes(getComputedStyle(e).overflowX) && !e.closest('.fold')
    && !getComputedStyle(e).backgroundImage.includes('gradient')).map(e => e.outerHTML.slice(0, 60))"""

# Levels of the answer that a phone would show behind a scroll, or without saying which they are.
UNREAD = """[...document.querySelectorAll('.answer table.stacked td[data-head]')].filter(e => {
    const box = e.closest('.scroll').getBoundingClientRect(), r = e.getBoundingClientRect();
    return r.right > box.right + 1 || r.left < box.left - 1 || !getComputedStyle(e, '::before').content.includes(e.dataset.head)
}).map(e => e.dataset.head + ': ' + e.textContent)"""

# How far the text of each sheet of print reaches: columns of a sheet's size break where sheets do. Captions end figures.
SHEETS = """(() => {
    const wide = 688, high = 994, gap = 40;  // A4 between its margins [px]
    document.documentElement.style.margin = 0;
    Object.assign(document.body.style, {margin: 0, width: wide + 'px', height: high + 'px', columnWidth: wide + 'px',
                                        columnGap: gap + 'px', columnFill: 'auto'});
    const ends = [], page = document.body.getBoundingClientRect();
    const see = r => {
        const sheet = Math.floor((r.left - page.left + 1) / (wide + gap));
        if (r.width && r.height) ends[sheet] = Math.max(ends[sheet] || 0, r.bottom - page.top);
    };
    const words = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (words.nextNode()) {
        if (!words.currentNode.textContent.trim() || words.currentNode.parentElement.closest('svg, script')) continue;
        const range = document.createRange();
        range.selectNodeContents(words.currentNode);
        [...range.getClientRects()].forEach(see);
    }
    return [...ends].map(end => (end || 0) / high) })()"""

# What its script does: tables sort both ways and filter, figures zoom and tell the value of a marker under the pointer.
WORKS = """(() => { const found = [];
    for (const table of document.querySelectorAll('table.sortable')) {
        const rows = () => [...table.tBodies[0].rows].map(r => r.cells[0].textContent), before = rows().join();
        const button = table.tHead.rows[0].cells[0].querySelector('button');
        if (!button) { found.push('a table does not sort: ' + table.caption.textContent); continue; }
        button.click();
        const up = rows(); button.click();
        const down = rows(), sorted = [...up].sort((a, b) => a.localeCompare(b, undefined, {numeric: true}));
        if (up.join() !== sorted.join() || down.join() !== [...sorted].reverse().join()) found.push('wrong order: ' + table.caption.textContent);
    }
    for (const input of document.querySelectorAll('.filter input')) {
        const table = (input.closest('.filter').nextElementSibling || document).querySelector('table');
        const shown = () => [...table.tBodies[0].rows].filter(r => r.checkVisibility()).length, all = shown();
        const put = text => { input.value = text; input.dispatchEvent(new Event('input')); };
        put('no row holds these words');
        if (shown() !== 0) found.push('does not filter: ' + table.caption.textContent);
        put('');
        if (shown() !== all) found.push('keeps rows hidden: ' + table.caption.textContent);
    }
    for (const svg of document.querySelectorAll('figure svg[data-axes]')) {
        const named = svg.getAttribute('aria-label'), inner = svg.querySelector('g');
        const use = svg.querySelector('g[id^="axes_"] > g[id^="line2d_"] use');
        const axes = JSON.parse(svg.dataset.axes).filter(a => 'x' in a);
        if (!axes.length) continue;
        const box = axes[0].box, centre = new DOMPoint((box[0] + box[2]) / 2, (box[1] + box[3]) / 2).matrixTransform(inner.getScreenCTM());
        svg.dispatchEvent(new PointerEvent('pointermove', {clientX: centre.x, clientY: centre.y, bubbles: true}));
        const tip = document.querySelector('.tip');
        if (tip.style.display !== 'block' || !/: -?[0-9]/.test(tip.textContent)) found.push('no value: ' + named);
        svg.dispatchEvent(new PointerEvent('pointerleave'));
        const [closer, , reset] = svg.closest('figure').querySelectorAll('.zoom button');
        closer.click();
        if (!/scale\\(1.5\\)/.test(inner.getAttribute('transform'))) found.push('does not zoom: ' + named);
        reset.click();
    }
    return found })()"""

PRINT_WIDTH = 688  # of A4 between margins of 14 mm [px]
LEAST_FILLED = 0.6  # of a sheet, but the last


def faults(browser, page):
    for room in ("Page", "Network", "Log", "Runtime"):
        browser.ask(f"{room}.enable")
    browser.ask("Page.navigate", url=page.as_uri())
    browser.wait_for("Page.loadEventFired")
    for width in (400, 1400):
        browser.resize(width, 900)
        figures = browser.value(FIGURES)
        if not figures:
            yield f"at {width} px: no figure"
        for name, across, up in figures:
            if across < 100 or up < 50:
                yield f"at {width} px: figure {name!r} is {across:.0f} x {up:.0f} px"
        for what in browser.value(BEYOND):
            yield f"at {width} px: {what} reaches beyond the window"
        for what in browser.value(UNSEEN):
            yield f"at {width} px: scrolls and does not show it: {what}"
        for what in browser.value(UNREAD) if width == 400 else ():
            yield f"at {width} px: the answer does not show {what}"
        for scheme in ("dark", "light"):
            browser.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            if scheme == "light" or width > 400:
                for what in accessibility.faults(browser):
                    yield f"at {width} px, {scheme}: {what}"
        if len(sys.argv) > 3:
            shot = browser.ask("Page.captureScreenshot", captureBeyondViewport=True, clip={
                "x": 0, "y": 0, "width": width, "height": browser.value("document.documentElement.scrollHeight"), "scale": 1})
            import base64
            Path(f"{sys.argv[3]}-{width}.png").write_bytes(base64.b64decode(shot["data"]))
    if browser.value("document.scripts.length"):
        yield from browser.value(WORKS)
    tables = browser.value("document.querySelectorAll('table').length")
    browser.ask("Emulation.setEmulatedMedia", media="print")
    browser.resize(PRINT_WIDTH, 1000)
    if not tables:
        yield "no table"
    for what in browser.value(CUT):
        yield f"in print: {what} is cut"
    if not browser.ask("Page.printToPDF")["data"]:
        yield "it cannot be printed"
    sheets = browser.value(SHEETS)
    for number, filled in enumerate(sheets[:-1], 1):
        if filled < LEAST_FILLED:
            yield f"in print: sheet {number} of {len(sheets)} is filled to {filled:.0%}"
    for event in browser.events:
        parameters = event.get("params", {})
        url = parameters["request"]["url"] if event.get("method") == "Network.requestWillBeSent" else None
        if url and url != page.as_uri() and not url.startswith("data:"):  # what lies in the page itself
            yield f"loads {url[:100]}"
        if event.get("method") == "Log.entryAdded":
            yield f"console: {parameters['entry']['text']}"
        if event.get("method") in ("Runtime.consoleAPICalled", "Runtime.exceptionThrown"):
            yield f"console: {json.dumps(parameters)[:200]}"


def main():
    page = Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        browser = Browser(sys.argv[1], folder)
        try:
            target = browser.ask("Target.createTarget", url="about:blank")["targetId"]
            browser.session = browser.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
            for fault in faults(browser, page):
                print(fault)
        finally:
            browser.session = None
            browser.process.terminate()
            browser.process.wait()


main()
