# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: browser.py HTML [PICTURES]

The playground in a headless Chromium, opened as a file and without a network. Every case of tests/corpus gets the
certified answer that it expects, from `filtered` and from `exact`, by the functions that the page calls. Then the page is
used: the ball dragged, moved by keys, the window zoomed until the doubles are dots, the failure map painted by the worker,
a polygon drawn and one pasted, the address opened again, on a desk, in a phone-sized window, and dark. Screenshots go to
the folder PICTURES. Exit status 1 at the first thing that is not as it should be.
"""

import json
import pathlib
import sys

from selenium.webdriver.common.actions.action_builder import ActionBuilder
from selenium.webdriver.common.actions.mouse_button import MouseButton
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

TESTS = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(TESTS / "system"))
from chromium import Chromium  # noqa: E402
from running import expect  # noqa: E402

CORPUS = TESTS / "corpus"
# What the page's reader of cases does not know: JSON.parse keeps the last of two equal keys and does not count levels, and
# a page has no use for tags.
NOT_THE_PAGES = {"radius-twice", "tags-is-text"}
DARK = {"prefers-color-scheme": "dark"}

# A case as the page answers it: by both exact ways.
VERDICT = """
const verdict = (text) => {
  try {
    const {loops, ball, to} = readCase(text), refusal = engine.take({loops, ball, to});
    if (refusal) return [{error: refusal.split(":")[0]}];
    return [false, true].map((exact) => {
      const {stage, ...answer} = engine.answer(exact ? "exact" : "filtered", ball);
      return to ? {...engine.firstContact(ball, to, exact), off_plane: answer.off_plane} : answer;
    });
  } catch (error) {
    if (error instanceof Malformed) return [{error: "malformed-case"}];
    throw error;
  }
};
return JSON.stringify(arguments[0].map(verdict));
"""


class Page(Chromium):
    LEVELS, EXCUSED = ("SEVERE", "WARNING"), ("willReadFrequently",)  # of the test's own reading of pixels

    def __init__(self, html, pictures, width=1280, height=900, phone=False, media=None):
        super().__init__(pictures, ("--disable-gpu", "--host-resolver-rules=MAP * ~NOTFOUND"), width, height, phone, media)
        self.html = pathlib.Path(html).resolve()
        if phone:
            self.cdp("Emulation.setTouchEmulationEnabled", enabled=True)

    def find(self, name):
        return self.driver.find_element(By.ID, name)

    def open(self, hash_=""):
        self.driver.get("about:blank")
        self.driver.get(self.html.as_uri() + hash_)
        self.wait("the library", lambda: not self.script("return document.body.hasAttribute('aria-busy')"))

    def painted(self):
        self.wait("the failure map", lambda: self.script("return map.done && document.body.hasAttribute('data-painted')"))

    def state(self):
        return self.script("return {center: state.ball.center, radius: state.ball.radius, scale: view.scale, loops: state.loops}")

    def shown(self, method, key):
        return self.script("return document.querySelector(`[data-method=${arguments[0]}][data-key=${arguments[1]}]`).textContent",
                           method, key)

    def place(self, a, b):
        """Where in the page the window shows a point."""
        return self.script("const box = at('window').getBoundingClientRect();"
                           "return [box.left + view.x(arguments[0]), box.top + view.y(arguments[1])]", a, b)

    def drag(self, start, end):
        action = ActionBuilder(self.driver)
        pointer = action.pointer_action
        pointer.move_to_location(*map(round, start)).pointer_down(MouseButton.LEFT)
        pointer.move_to_location(*(round((p + q) / 2) for p, q in zip(start, end))).move_to_location(*map(round, end))
        pointer.pointer_up(MouseButton.LEFT)
        action.perform()

    def click_at(self, place):
        self.drag(place, place)

    def put(self, name, value):
        self.script("const e = at(arguments[0]); e.value = arguments[1]; e.dispatchEvent(new Event('change'));", name, value)

    def paste(self, text):
        self.find("pasted").clear()
        self.find("pasted").send_keys(text)
        self.find("take").click()

    def fits(self):
        return self.script("return document.documentElement.scrollWidth <= innerWidth")


def corpus(page):
    asked = 0
    for file in sorted(CORPUS.glob("*.jsonl")):
        lines = [line for line in file.read_text().splitlines() if line and json.loads(line)["id"] not in NOT_THE_PAGES]
        for start in range(0, len(lines), 100):
            some = lines[start:start + 100]
            for line, answers in zip(some, json.loads(page.script(VERDICT, some), parse_int=float)):
                case = json.loads(line, parse_int=float)
                asked += 1
                for way, answer in zip(("filtered", "exact"), answers):
                    expected = case["expected"]
                    wrong = {key: (answer.get(key), value) for key, value in expected.items() if answer.get(key) != value}
                    expect(not wrong, f"{file.name}, {case['id']}, {way}: (the page's, expected) {wrong}")
    print(f"{asked} cases of the corpus have their certified answers from filtered and exact", flush=True)
    expect(asked > 2000, f"the corpus has {asked} cases only")


def ball_is_dragged(page):
    page.open()
    before = page.state()
    expect(page.shown("filtered", "relation") == "touching", "the gripper is not touched at first")
    start = page.place(*before["center"][:2])
    end = page.place(0.5, 2.5)
    page.drag(start, end)
    after = page.state()
    expect(abs(after["center"][0] - 0.5) < 0.02 and abs(after["center"][1] - 2.5) < 0.02 and after["center"][2] == 0,
           f"the ball was dragged to {after['center']}")
    expect(page.shown("filtered", "foot") == "inside", "the foot does not follow")
    page.find("window").send_keys(Keys.SHIFT + Keys.ARROW_RIGHT)
    moved = page.state()["center"][0]
    expect(moved == page.script("return neighbour(arguments[0])", after["center"][0]), f"Shift and an arrow moved it to {moved}")
    page.put("radius", "0.25")
    expect(page.state()["radius"] == 0.25, "the field of the radius does nothing")
    page.put("radius", "-1")
    expect("negative-radius" in page.find("refusal").text and page.state()["radius"] == 0.25, "a negative radius is not refused")
    page.find("touch").click()
    expect(page.shown("filtered", "relation") in ("touching", "overlapping", "separate"), "no relation")


def doubles_are_dots(page):
    page.open()
    page.script("take(structuredClone(SAMPLES['triangle of tenths']))")
    page.find("touch").click()
    page.painted()
    page.picture("map")
    expect(page.script("return view.dots()") is None, "there are dots in the whole polygon")
    for _ in range(60):  # the wheel over a corner, each notch about 4 times
        corner = page.place(1.3, 0.2)
        page.cdp("Input.dispatchMouseEvent", type="mouseWheel", x=corner[0], y=corner[1], deltaX=0, deltaY=-420)
        if page.script("return view.dots() !== null && view.scale * spacing(view.a) > 30"):
            break
    dots = page.script("return view.dots().map((list) => list.length)")
    expect(all(2 < count < 200 for count in dots), f"{dots} doubles are shown")
    across = page.script("const [xs] = view.dots(); return xs.every((x, i) => !i || x === neighbour(xs[i - 1]))")
    expect(across, "the dots are not neighbouring doubles")
    page.painted()
    page.picture("dots")
    counts = page.script("return map.counts")
    expect(counts["thesis"] > 0 and counts["pixels"] > 10000, f"near a corner nobody differs: {counts}")

    # The line between doubles that lie beyond the window, through one that is half-way between them.
    off = page.script("""
      const m = [1.1, 0.7], far = new View({a: neighbour(m[0], 2), b: neighbour(m[1], -1), scale: 80 * 2 ** 52});
      [far.width, far.height] = [600, 400];
      const [[x, y], [u, v]] = segmentOf(far, [m[0] - 0.5, m[1] - 0.25], [m[0] + 0.5, m[1] + 0.25]);
      const [dx, dy] = [u - x, v - y], [mx, my] = [far.x(m[0]), far.y(m[1])];
      return [Math.abs((mx - x) * dy - (my - y) * dx) / Math.hypot(dx, dy), dx / dy];""")
    expect(off[0] < 0.01 and abs(off[1] + 2) < 1e-9, f"the line passes {off[0]} pixels from its middle, in the direction {off[1]}")

    # Each painted pixel is what the methods answer there.
    same = page.script("""
      const pencil = map.canvas.getContext("2d"), colours = {}, style = getComputedStyle(document.documentElement);
      for (const name of ["in", "on", "out", "fast", "thesis", "both"]) {
        const probe = document.createElement("canvas").getContext("2d");
        probe.fillStyle = style.getPropertyValue("--" + name), probe.fillRect(0, 0, 1, 1);
        colours[name] = probe.getImageData(0, 0, 1, 1).data.slice(0, 3).join();
      }
      engine.takePolygon(state.loops);
      const {lift} = state, wrong = [];
      for (let i = 0; i < 400; ++i) {
        const x = 2 * Math.floor((i * 7919) % view.width / 2), y = 2 * Math.floor((i * 104729) % view.height / 2);
        const a = view.at(x + 1.5, 0)[0], b = view.at(0, y + 1.5)[1];
        const ball = {center: plane.point(a, b, lift), radius: state.ball.radius};
        const [certified, fast, thesis] = ["filtered", "fast", "thesis"].map((method) => engine.answer(method, ball).contact);
        const name = fast !== certified ? (thesis !== certified ? "both" : "fast") : thesis !== certified ? "thesis" : certified ? "in" : "out";
        if (pencil.getImageData(x, y, 1, 1).data.slice(0, 3).join() !== colours[name]) wrong.push([x, y, name]);
      }
      return wrong;""")
    expect(not same, f"the map is wrong at {same[:5]} and {len(same)} pixels in all")

    # The address brings back the same numbers, of many digits, too.
    page.script("take({loops: [[[1 / 3, 0, 0.1], [5, 1 / 7, 0.1], [2 / 3, 4, 0.1]], [[1, 1 / 0.7, 0.1], [1.1, 1, 0.1], [1.3, 4 / 3, 0.1]]],"
                "ball: {center: [4 / 3, 1 / 9, 5e-324], radius: 1e-17 / 3}})")
    link, state = page.script("return location.hash"), page.state()
    page.open(link)
    expect(page.state() == state, f"the address gives {page.state()}, not {state}")
    page.put("question", "foot")
    page.painted()
    page.picture("foot")
    expect("question=foot" in page.script("return location.hash"), "the question is not in the address")


def polygons_are_drawn_and_pasted(page):
    page.open()
    page.find("draw").click()
    corners = [(0.2, 0.2), (2.5, 0.4), (1.2, 2.6)]
    for corner in (*corners, corners[0]):
        page.click_at(page.place(*corner))
    loops = page.state()["loops"]
    expect(len(loops) == 1 and len(loops[0]) == 3 and all(abs(p[i] - c[i]) < 0.02 for p, c in zip(loops[0], corners) for i in (0, 1)),
           f"drawn was {loops}")
    page.paste("0 0\n4 0\n4 4\n0 4\n\n1 1\n1 2\n2 2")
    expect([len(loop) for loop in page.state()["loops"]] == [4, 3], "pasted points are not taken")
    page.paste("0 0\n4 4\n4 0\n0 4")
    expect(page.find("refusal").text.startswith(("loop-meets-itself", "zero-normal")), "a bow tie is taken")
    expect([len(loop) for loop in page.state()["loops"]] == [4, 3], "the polygon is gone")
    page.paste('{"ball": {"center": [2, 2, 5], "radius": 1}, "motion": {"to": [2, 2, -5]}, '
               '"polygon": {"outer": [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]]}}')
    expect("way at time 0.4, face" in page.find("first").text, f"the motion is answered by {page.find('first').text!r}")
    link = page.script("return location.hash")
    page.open(link)
    expect("way at time 0.4" in page.find("first").text, "the motion is not in the address")


def whole_page(html, pictures, name, **arguments):
    with Page(html, pictures, **arguments) as page:
        page.open()
        page.painted()
        expect(page.fits(), f"{name}: the page is wider than the screen")
        page.picture(name)
        if arguments.get("phone"):
            small = page.script("return [...document.querySelectorAll('button, select')].filter((e) => e.getBoundingClientRect().height < 32).length")
            expect(small == 0, f"{small} buttons are too small for a finger")
            page.script("scrollTo(0, document.querySelector('table').getBoundingClientRect().top + scrollY - 60)")
            page.picture(name + "-answers")
            expect(page.script("const e = document.querySelector('.scroll'); return e.scrollWidth <= e.clientWidth"), "a column is cut off")
            page.script("scrollTo(0, 0)")
            x, y = page.place(*page.state()["center"][:2])
            for kind, dx in (("touchStart", 0), ("touchMove", -20), ("touchMove", -60), ("touchEnd", None)):
                page.cdp("Input.dispatchTouchEvent", type=kind, touchPoints=[] if dx is None else [{"x": x + dx, "y": y}])
            moved = page.state()["center"][0]
            expect(moved < 1.2, f"a finger dragged the ball to {moved}")


def main(html, pictures=None):
    with Page(html, pictures) as page:
        page.open()
        corpus(page)
        ball_is_dragged(page)
        print("the ball is dragged", flush=True)
        doubles_are_dots(page)
        print("the doubles are dots, the map is right, the address holds everything", flush=True)
        polygons_are_drawn_and_pasted(page)
        print("polygons are drawn and pasted", flush=True)
    whole_page(html, pictures, "desk")
    whole_page(html, pictures, "dark", media=DARK)
    whole_page(html, pictures, "phone", width=390, height=844, phone=True)
    whole_page(html, pictures, "phone-dark", width=390, height=844, phone=True, media=DARK)
    print("desk, dark, phone")


main(*sys.argv[1:])
