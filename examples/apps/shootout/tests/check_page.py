#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Opens a report in headless Chromium: no error on the console, the table sorts, the wipe moves, taps are drawn.

    check_page.py REPORT.html [--screenshots FOLDER]

The page is served from this machine with a script at its end, which acts as a reader and posts what it finds. Exits 77,
the code of a skipped test, where Chromium is missing.
"""
import argparse
import http.server
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading

HEAD = """<script>
const faults = [];
window.addEventListener('error', (event) => faults.push(String(event.message)));
window.addEventListener('unhandledrejection', (event) => faults.push(String(event.reason)));
for (const name of ['error', 'warn']) console[name] = (...values) => faults.push(values.join(' '));
</script>"""

TAIL = """<script>
async function act() {
  const wait = (ready) => new Promise((resolve) => { const t = setInterval(() => { if (ready()) { clearInterval(t); resolve(); } }, 30); });
  await wait(() => document.body.dataset.ready === 'yes');
  const found = {};
  const column = (i) => [...document.querySelectorAll('#rows tbody tr')].map((tr) => parseFloat(tr.cells[i].textContent));
  const heads = () => document.querySelectorAll('#rows th');
  found.first = column(1);
  heads()[1].click();
  found.reversed = column(1);
  heads()[4].click();
  found.mean = column(4);
  found.sorted = heads()[4].getAttribute('aria-sort');
  document.querySelector('#table-filter').value = 'ewa';
  document.querySelector('#table-filter').dispatchEvent(new Event('input'));
  found.filtered = [...document.querySelectorAll('#rows tbody tr')].map((tr) => tr.cells[0].textContent);
  const canvas = document.querySelector('#stage-canvas'), box = document.querySelector('#stage');
  const shot = () => canvas.toDataURL();
  const at = (share, type) => {
    const r = box.getBoundingClientRect();
    box.dispatchEvent(new PointerEvent(type, { clientX: r.left + share * r.width, clientY: r.top + r.height / 2, pointerId: 1, bubbles: true }));
  };
  box.setPointerCapture = () => {};
  const before = shot();
  at(0.45, 'pointerdown'); at(0.7, 'pointermove'); at(0.7, 'pointerup');
  found.wipe_moves = shot() !== before && Math.abs(stage.wipe - 0.7) < 0.01;
  const views = {};
  for (const view of ['difference', 'flip', 'flicker', 'wipe']) {
    document.querySelector('#compare-view').value = view;
    document.querySelector('#compare-view').dispatchEvent(new Event('change'));
    views[view] = shot();
  }
  found.views = new Set(Object.values(views)).size;
  const zoom = shot();
  document.querySelector('#compare-zoom').value = 8;
  document.querySelector('#compare-zoom').dispatchEvent(new Event('input'));
  found.zooms = shot() !== zoom || stage.zoom === 8;
  document.querySelectorAll('#taps-frame circle')[5].dispatchEvent(new MouseEvent('click', { bubbles: true }));
  found.taps = document.querySelectorAll('#taps-view rect').length;
  found.weights = document.querySelector('#taps-caption').textContent;
  found.plots = document.querySelectorAll('#plot-grid svg circle').length;
  document.querySelector('#plot-across').value = 'whole_ns';
  document.querySelector('#plot-across').dispatchEvent(new Event('change'));
  found.timed = document.querySelectorAll('#plot-grid svg circle').length;
  found.images = [...document.images].filter((image) => !image.complete || !image.naturalWidth).length;
  found.requests = performance.getEntriesByType('resource').filter((entry) => entry.name.startsWith('http')).map((entry) => entry.name);
  found.faults = faults;
  return found;
}
act().catch((error) => ({ failed: String(error), faults })).then((found) => fetch('/found', { method: 'POST', body: JSON.stringify(found) }));
</script>"""


def find_browser():
    return shutil.which("chromium-headless-shell") or shutil.which("chromium")


def run_browser(browser, arguments, timeout, done=None):
    """Runs a browser until it ends or `done` is set; its process group ends in any case."""
    with tempfile.TemporaryDirectory() as profile:
        process = subprocess.Popen([browser, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}", *arguments],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        try:
            if done:
                return done.wait(timeout)
            return process.wait(timeout) == 0
        except subprocess.TimeoutExpired:
            return False
        finally:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            process.wait()


def visit(browser, page):
    """Serves the page with the script, and returns what the script found."""
    text = page.read_text(encoding="utf-8").replace("<head>", "<head>" + HEAD, 1)
    body = text.replace("</body>", TAIL + "</body>", 1).encode()
    found, done = {}, threading.Event()

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            self.send_response(200)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.end_headers()
            self.wfile.write(body)

        def do_POST(self):
            found.update(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
            self.send_response(204)
            self.end_headers()
            done.set()

        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    ended = run_browser(browser, ["--remote-debugging-port=0", "--window-size=1280,900", f"http://127.0.0.1:{server.server_port}/"], 240, done)
    server.shutdown()
    server.server_close()
    if not ended:
        sys.exit("the page did not answer within 240 s")
    return found


def problems(found):
    """Yields what is wrong."""
    if "failed" in found:
        yield found["failed"]
        return
    def falls(values):
        return all(a >= b for a, b in zip(values, values[1:]))
    if found["faults"]:
        yield f"console: {found['faults']}"
    if len(found["first"]) < 20 or not falls(found["first"]):
        yield f"PSNR does not fall at first: {found['first']}"
    if not falls(found["reversed"][::-1]) or found["reversed"] == found["first"]:
        yield f"a click on PSNR does not reverse it: {found['reversed']}"
    if not falls(found["mean"][::-1]) or found["sorted"] != "ascending":
        yield f"a click on the mean does not sort it: {found['mean']}"
    if not found["filtered"] or not all("EWA" in name for name in found["filtered"]):
        yield f"the search for ewa shows {found['filtered']}"
    for key in ("wipe_moves", "zooms"):
        if not found[key]:
            yield f"{key} is false"
    if found["views"] < 4:
        yield f"only {found['views']} of 4 views differ"
    if found["taps"] < 1 or "sum to 1.000" not in found["weights"]:
        yield f"taps: {found['taps']}, {found['weights']}"
    if found["plots"] < 100 or found["timed"] < 100:
        yield f"plots have {found['plots']} and {found['timed']} points"
    if found["images"]:
        yield f"{found['images']} pictures are not shown"
    if found["requests"]:
        yield f"the page loads {found['requests']}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("report", type=pathlib.Path)
    parser.add_argument("--screenshots", type=pathlib.Path)
    options = parser.parse_args()
    browser = find_browser()
    if not browser:
        print("skipped: no chromium (Debian package chromium-headless-shell or chromium)")
        return 77
    found = visit(browser, options.report)
    wrong = list(problems(found))
    for text in wrong:
        print(text)
    if options.screenshots:
        options.screenshots.mkdir(parents=True, exist_ok=True)
        run_browser(browser, ["--hide-scrollbars", "--window-size=1360,9000", "--virtual-time-budget=10000",
                              f"--screenshot={options.screenshots / 'page.png'}", options.report.resolve().as_uri()], 240)
    if not wrong:
        print(f"page: {found['plots']} points, {len(found['first'])} rows, {found['taps']} texels; all checks passed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
