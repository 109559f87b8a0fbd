# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: browser.py TOUCHSTONE [PICTURES]

The page of `touchstone cell serve` and `export` in a headless Chromium: run, pause, step, scrub, keys, sliders, the
storage dragged, a cell that cannot be; on a desk, in a phone-sized window, dark, without motion, offline. What it says
and colours is compared with what the program answers. Screenshots go to the folder PICTURES. Exit status 1 at the first
thing that is not as it should be.
"""

import base64
import contextlib
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import urllib.parse
import urllib.request

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

ROOT = pathlib.Path(__file__).resolve().parents[5]
sys.path.append(str(ROOT / "tests/system"))
from chromium import PATIENCE, Chromium  # noqa: E402
from running import expect  # noqa: E402

CELL = ROOT / "experiments/thesis/cell/cells/aristo.json"


@contextlib.contextmanager
def server(touchstone):
    """The address of a server, which an interrupt ends."""
    signal.signal(signal.SIGINT, signal.default_int_handler)  # in the background of a shell it is ignored, also by children
    process = subprocess.Popen([touchstone, "cell", "serve", str(CELL), "--port", "0"], stdout=subprocess.PIPE, text=True)
    try:
        yield re.search(r"http://\S+/", process.stdout.readline()).group()
        process.send_signal(signal.SIGINT)
        expect(process.wait(PATIENCE) == -signal.SIGINT, f"interrupted, the server ends with status {process.returncode}")
    finally:
        process.kill()


def ask(address, setting):
    request = urllib.request.Request(address + "api/run", json.dumps(setting).encode(),
                                     {"Content-Type": "application/json"})
    with urllib.request.urlopen(request, timeout=PATIENCE) as reply:
        return json.load(reply)


class Page(Chromium):
    EXCUSED = ("422", "400")  # Chromium's own note on a refusal

    def __init__(self, pictures, width=1280, height=800, phone=False, arguments=(), **media):
        super().__init__(pictures, (*arguments, "--use-angle=swiftshader", "--enable-unsafe-swiftshader"), width, height, phone,
                         {name.replace("_", "-"): value for name, value in media.items()})

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def text(self, name):
        return self.script("return document.getElementById(arguments[0]).textContent", name)

    def open(self, address):
        self.driver.get(address)
        self.settled()
        self.wait("the first stop", lambda: self.text("status").startswith("Stop 0 of"))

    def settled(self):
        self.wait("an answer", lambda: not self.script("return document.body.hasAttribute('aria-busy')"))

    def stop(self):
        found = re.match(r"Stop (\d+) of (\d+):", self.text("status"))
        return (int(found[1]), int(found[2])) if found else None

    def value(self, name):
        return self.find(f"#{name}").get_property("value")

    def put(self, selector, value, *events):
        self.script("const [e, value, ...kinds] = arguments; e.value = value;"
                    "for (const kind of kinds) e.dispatchEvent(new Event(kind, {bubbles: true}))", self.find(selector), value, *events)

    def go(self, number):
        self.put("#stop", number, "input")

    def slide(self, name, value):
        self.put(f"#{name}", value, "input", "change")
        self.settled()

    def reset(self):
        self.find("#reset").click()
        self.settled()

    def runs(self, run):
        """Whether the page shows a run of so many stops, at its first one."""
        self.back()
        return self.stop() == (0, len(run["stops"]) - 1)

    def back(self):
        """From where a process fails, or a jogged arm, to the run."""
        self.script("const b = document.getElementById('unjog'); if (!b.hidden) b.click()")

    def choose(self, name, value):
        self.put(f"#{name}", value, "change")
        self.settled()

    def keys(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def blur(self):
        self.script("document.activeElement && document.activeElement.blur()")

    def seen(self, count):
        """What a function of the bytes of the perspective view gives, once it is drawn."""
        return self.script("""
          return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => {
            const canvas = document.getElementById('scene'), gl = canvas.getContext('webgl');
            const bytes = new Uint8Array(4 * canvas.width * canvas.height);
            gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
            done((""" + count + """)(bytes));
          })))""")

    def pixels(self, holds):
        return self.seen("bytes => { let count = 0; for (let i = 0; i < bytes.length; i += 4) {"
                         f"const [r, g, b] = [bytes[i], bytes[i + 1], bytes[i + 2]]; if ({holds}) ++count; }} return count; }}")

    def orange(self):
        """Pixels of the perspective view in the colour of touching."""
        return self.pixels("r > 140 && g > 0.25 * r && g < 0.65 * r && b < 0.4 * r")

    def magenta(self):
        return self.pixels("r > 140 && g < 0.65 * r && b > 0.7 * r && b > 1.2 * g")

    def red(self):
        """Pixels in the colour of parts that touch."""
        return self.pixels("r > 140 && g < 0.3 * r && b < 0.45 * r")

    def kinds_of_pixels(self):
        return self.seen("bytes => new Set(new Uint32Array(bytes.buffer)).size")

    def look(self, name):
        self.script("document.querySelector(`[data-look=${arguments[0]}]`).click()", name)

    def picture(self, name):
        if self.pictures:
            size = self.script("return [document.documentElement.scrollWidth, document.documentElement.scrollHeight]")
            super().picture(name)
            shot = self.cdp("Page.captureScreenshot", captureBeyondViewport=True,
                            clip={"x": 0, "y": 0, "width": size[0], "height": size[1], "scale": 1})
            (self.pictures / f"{name}-whole.png").write_bytes(base64.b64decode(shot["data"]))


def check_words(page, run):
    """At the stops where something happens the page says what the program has answered."""
    page.look("near")
    number = len(run["stops"])
    events = [i for i in range(number) if run["stops"][i]["touched"] is not None]
    expect(events, "the run touches nothing")
    for i in [0, number // 3, number - 1] + events:
        page.go(i)
        stop, status = run["stops"][i], page.text("status")
        expect(page.stop() == (i, number - 1), f"at stop {i} it says {status!r}")
        if stop["touched"] is None:
            expect("touches nothing" in status, f"at stop {i}: {status!r}")
            expect(page.orange() == 0, f"at stop {i} something is orange that is not touched")
        else:
            expect(f"touches face {stop['touched']} (" in status, f"at stop {i}: {status!r}")
            expect(page.orange() > 100, f"at stop {i} nothing is orange")
        expect(("gripper holds" in status or "gripper takes" in status) == (stop["place"] is None),
               f"at stop {i}: {status!r}")
        angles = page.script("return [...document.querySelectorAll('#joints tbody tr')].map(r => r.cells[1].textContent)")
        for said, angle in zip(angles, stop["commanded"]):
            expect(abs(float(said.replace("−", "-").rstrip("°")) - angle) < 0.006, f"at stop {i}: {angles}")


def check_transport(page):
    page.go(0)
    page.find("#forward").click()
    expect(page.stop()[0] == 1, "a step does not go one stop on")
    page.find("#back").click()
    expect(page.stop()[0] == 0, "a step back does not go one stop back")
    page.find("#run").click()
    expect(page.text("run") == "Pause", "running, the button does not say Pause")
    page.wait("the run to run", lambda: page.stop()[0] > 10)
    page.find("#run").click()
    expect(page.text("run") == "Run", "pausing, the button does not say Run")
    here = page.stop()[0]
    page.kinds_of_pixels()
    expect(page.stop()[0] == here, "it runs on while it pauses")
    page.find("#last").click()
    expect(page.stop()[0] == page.stop()[1], "the end is not the end")


def check_keys(page):
    page.blur()
    page.keys(Keys.HOME)
    expect(page.stop()[0] == 0, "Home does not go home")
    page.keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_LEFT)
    expect(page.stop()[0] == 1, "arrows do not step")
    before = page.text("speed-says")
    page.keys("+")
    expect(page.text("speed-says") != before, "+ does not change the speed")
    page.keys("-")
    expect(page.text("speed-says") == before, "- does not change it back")
    page.keys(Keys.SPACE)
    page.wait("space to run", lambda: page.stop()[0] > 5)
    page.keys(Keys.SPACE)
    expect(page.text("run") == "Run", "space does not pause")
    expect(page.text("live") == page.text("status"), "a pause is not announced")
    page.keys(Keys.END)
    expect(page.stop()[0] == page.stop()[1], "End does not go to the end")
    # Everything that can be clicked can be reached by the tabulator.
    page.script("document.body.tabIndex = -1; document.body.focus(); document.body.removeAttribute('tabindex')")
    reached = set()
    for _ in range(90):
        page.keys(Keys.TAB)
        reached.add(page.script("const e = document.activeElement; return e.id || e.getAttribute('class') || e.dataset.look"))
    for name in ("scene", "top", "run", "forward", "speed", "stop", "handle", "angle", "radius", "height", "slot", "step", "reset"):
        expect(name in reached, f"{name} cannot be reached by the tabulator, but {sorted(map(str, reached))}")


def check_configuration(page, address):
    before = page.value("angle")
    page.script("document.getElementById('plan').scrollIntoView({block: 'center'})")
    handle = page.find("#plan .handle .grip")
    ActionChains(page.driver).click_and_hold(handle).move_by_offset(-12, -60).perform()
    expect("being moved" in page.text("status"), "while it is dragged an old run is shown")
    expect(page.find("#run").get_property("disabled"), "while it is dragged an old run can be run")
    ActionChains(page.driver).release().perform()
    page.settled()
    setting = {"storage": {name: float(page.value(name)) for name in ("angle", "radius", "height")}}
    expect(str(setting["storage"]["angle"]) != before, "dragging does not turn the storage")
    run = ask(address, setting)
    expect(page.runs(run), f"dragged: {page.text('status')!r}, not {len(run['stops'])} stops")
    expect(page.script("return document.querySelector('[data-label=\"storage.angle\"]').textContent") == "C",
           "a dragged angle is not labelled as chosen")
    page.picture("dragged")

    page.script("document.querySelector('#plan .handle').focus()")
    angle = float(page.value("angle"))
    page.keys(Keys.ARROW_LEFT, Keys.ARROW_LEFT, Keys.ARROW_LEFT)
    page.settled()
    expect(float(page.value("angle")) == angle + 3, "arrow keys do not turn the storage")
    run = ask(address, {"storage": dict(setting["storage"], angle=angle + 3)})
    expect(page.runs(run), "of several questions, the last is not the one answered")

    page.reset()
    page.slide("angle", -33)
    page.slide("radius", 609.2)
    expect("−183" in page.text("moves"), "at -33 degrees the base does not turn by 183")
    page.slide("height", 262)
    run = ask(address, {"storage": {"angle": -33, "radius": 609.2, "height": 262}})
    expect(page.runs(run) or page.stop() is None, page.text("status"))
    page.slide("angle", 67)
    expect(page.text("failure").startswith("The process does not begin: at home storage/") and "stands in machine/" in page.text("failure"),
           f"in the machine: {page.text('failure')!r}")
    page.reset()
    page.slide("height", 610)
    expect("does not come out" in page.text("failure"), "a process that fails says nothing")
    expect(page.text("status").startswith("Where it fails: "), "the arm is not shown where it fails")
    expect(page.red() > 100, "what touches is not coloured")
    expect(page.script("return !document.querySelector('#failure details').open"), "all that was tried is not folded")
    page.picture("failing")
    page.back()
    expect(page.find("#failure").is_displayed() and page.stop(), "a process that fails is not shown")
    expect(page.red() == 0, "something is red at a stop")
    page.find("#where").click()
    expect(page.red() > 100, "the button does not show where it fails")
    page.reset()
    page.slide("radius", 150)
    expect(page.text("failure").startswith("The process does not begin: at home "), f"in the robot: {page.text('failure')!r}")
    expect(page.text("status").startswith("Where it fails: at home "), f"without a stop it says {page.text('status')!r}")
    expect(page.find("#run").get_property("disabled"), "a run without stops can be run")
    page.picture("no-stop")
    page.reset()
    page.slide("radius", 800)
    expect("storage.radius: " in page.text("failure"), f"too far: {page.text('failure')!r}")
    expect(page.find("#failure").is_displayed(), "the reason is hidden")
    expect(page.find("#run").get_property("disabled"), "what cannot be can be run")
    page.picture("too-far")
    furthest = float(re.search(r"at radii from \S+ to ([\d.]+)", page.text("failure"))[1])
    page.slide("radius", furthest - 1)
    page.back()
    expect(page.stop() and "out of reach" not in page.text("failure"), f"the advised radius: {page.text('failure')!r}")
    page.reset()
    expect(page.stop() and not page.find("#failure").is_displayed(), "it does not recover from a cell that cannot be")
    page.slide("step", 2)
    page.back()
    expect(page.stop()[1] < 400, "a step of 2 degrees does not halve the stops")
    page.slide("slot", "C")
    page.reset()


def check_typed(page, address):
    """Numbers can be typed that no slider reaches."""
    page.choose("radius-number", 487.35)
    run = ask(address, {"storage": {"radius": 487.35}})
    expect(page.runs(run), "a typed radius is not run")
    expect(run["setting"]["storage"]["radius"] == 487.35, "the program takes another radius")
    page.reset()
    expect(page.value("radius-number") == "480.2", "reset leaves what was typed")


def check_distances(page, run):
    """The curve, the distances at a stop, and the table say what the program has measured."""
    nearest = run["separation"]["nearest"]
    number = next(i for i, d in enumerate(nearest["held material"]["here"]) if d is not None and d > 1)
    page.go(number)
    for mover, words in (("arm", "arm and gripper"), ("held material", "held material"), ("sphere", "sphere")):
        said = re.search(words + r" ([\d.]+) mm from ([^;]+)", page.text("answer"))
        expect(said and abs(float(said[1]) - nearest[mover]["here"][number]) < 0.06, f"{mover}: {page.text('answer')!r}")
    rows = page.script("return document.querySelectorAll('#least tbody tr').length")
    expect(rows == len(run["separation"]["least"]), "the table lacks distances")
    expect(run["cycle"][1:] in page.text("curve-says"), f"no cycle time: {page.text('curve-says')!r}")
    expect(page.script("return document.querySelectorAll('#curve .line').length") >= 4, "a curve is missing")
    page.script("document.getElementById('curve').scrollIntoView({block: 'center'})")
    page.find("#curve").click()
    expect(abs(page.stop()[0] - len(run["stops"]) / 2) < len(run["stops"]) / 4, "a click into the curve does not go there")


def check_views(page):
    """Both views from the start; the sphere can be switched."""
    page.look("near")
    page.go(0)
    blue = "b > 120 && r < 0.3 * b && g < 0.75 * b && g > 0.4 * b"
    expect(page.pixels(blue) > 100, "the sphere is not to be seen")
    page.find("#with-sphere").click()
    expect(page.pixels(blue) == 0, "the sphere cannot be switched off")
    page.find("#with-sphere").click()
    page.look("split")


def check_hand(page, run):
    """The path of the hand is drawn through all stops, and the hand stays in the middle of the view that follows it."""
    blue = "b > 120 && r < 0.3 * b && g < 0.75 * b && g > 0.4 * b"
    for look in ("near", "front"):  # the whole alone
        page.look(look)
    page.go(0)
    page.find("#with-sphere").click()
    expect(page.pixels(blue) == 0, "there is a path before it is asked for")
    page.seen("bytes => (window.without = bytes, 0)")
    page.find("#with-path").click()
    page.go(0)
    seen = page.pixels(blue)
    expect(seen > 200, "the path of the hand is not to be seen")
    page.go(0)
    changed = page.seen("bytes => bytes.filter((byte, i) => i % 4 === 0 && Math.abs(byte - without[i]) > 20).length")
    expect(changed < 5 * seen, f"the path changes {changed} pixels, of which {seen} are its own")
    points = page.script("return document.querySelector('#plan .path').getAttribute('points')").split()
    expect([[float(x) for x in point.split(",")] for point in points]
           == [[round(stop["sphere"][0], 4), round(-stop["sphere"][1], 4)] for stop in run["stops"]], "the plan has another path")
    page.picture("path")
    page.find("#with-path").click()
    expect(page.pixels(blue) == 0 and not page.script("return document.querySelector('#plan .path').getAttribute('points')"),
           "the path cannot be switched off")
    without = page.find("#with-sphere")
    without.click()

    def seen():
        """Where the sphere is in the view, at home and where it holds the material: what it makes bluer."""
        places = []
        for stop in (0, next(i for i, stop in enumerate(run["stops"]) if stop["place"] is None) + 20):
            page.go(stop)
            without.click()
            page.seen("bytes => (window.without = bytes, 0)")
            without.click()
            places.append(page.seen("""bytes => {
              const canvas = document.getElementById('scene');
              let x = 0, y = 0, count = 0;
              for (let i = 0; i < bytes.length; i += 4)
                if (bytes[i + 2] - bytes[i] - without[i + 2] + without[i] > 20)
                  x += i / 4 % canvas.width, y += Math.floor(i / 4 / canvas.width), ++count;
              return [x / count / canvas.width, y / count / canvas.height];
            }"""))
        return places
    expect(max(abs(a - b) for a, b in zip(*seen())) > 0.05, "the view follows the hand before it is asked to")
    page.find("#follow").click()
    for place in seen():
        expect(all(abs(x - 0.5) < 0.02 for x in place), f"the hand is at {place} of the view that follows it")
    page.picture("follow")
    page.find("#follow").click()
    page.look("split")


def check_slots(page):
    """Wherever the storage stands, the names of slots and storage can be read, and none lies on another."""
    boxes = page.script("""
      const plan = document.getElementById('plan').plan, all = [];
      for (let angle = -180; angle < 180; angle += 15)
        for (const share of [0.3, 0.6, 0.95]) {
          plan.configure(angle, share * plan.far, '', false);
          all.push([...plan.svg.querySelectorAll('.slot, .name')].map(text => {
            const {left, right, top, bottom} = text.getBoundingClientRect();
            return [text.textContent, left, right, top, bottom, text.getCTM().b];
          }));
        }
      return all;""")
    for texts in boxes:
        expect([text[0] for text in texts] == ["A", "B", "C", "storage"], f"the plan names {texts}")
        for i, (name, left, right, top, bottom, turned) in enumerate(texts):
            expect(turned == 0 and bottom - top >= 12, f"{name} cannot be read")
            for other in texts[:i]:
                expect(left >= other[2] or right <= other[1] or top >= other[4] or bottom <= other[3], f"{name} lies on {other[0]}")
    page.reset()


def check_jog(page):
    page.go(0)
    page.put("#joints tbody tr:nth-child(3) input[type=range]", -115, "input")
    page.wait("an answer about the pose", lambda: page.text("status").startswith("Jogged: "))
    expect("nothing is touched" not in page.text("status") and page.red() > 50, f"jogged down: {page.text('status')!r}")
    page.picture("jogged")
    page.back()
    expect(page.stop() is not None, "from a jogged arm there is no way back")


def check_area(page):
    page.wait("the area", lambda: page.script("return document.querySelectorAll('#plan .area.completed').length") > 5)
    expect("directions" in page.text("area-says"), "the area is not explained")


def check_wrong_stop(page, address):
    """The robot that the thesis's method stops, with a U-shaped part: before it touches anything."""
    names = json.load(urllib.request.urlopen(address + "api/presets", timeout=PATIENCE))
    page.open(f"{address}?preset={names.index('U-part') + 1}")
    expect("wrong stop" not in page.text("moves").lower(), "a wrong stop by the exact answer")
    page.choose("drive", "thesis")
    page.back()
    expect("Wrong stop: 3° early, 5.92 mm from the material" in page.text("moves"), f"moves: {page.text('moves')!r}")
    page.look("near")
    row = page.script("return [...document.querySelectorAll('#moves tbody tr')].findIndex(r => r.textContent.includes('Wrong stop'))")
    page.script("document.querySelectorAll('#moves tbody tr')[arguments[0]].querySelector('button').click()", row)
    page.picture("wrong-stop")
    expect("Wrong stop: 3° early" in page.text("status") and page.magenta() > 20, f"a wrong stop is not marked: {page.text('status')!r}")


CONTRAST = """
  const style = getComputedStyle(document.documentElement);
  const light = name => {
    const hex = style.getPropertyValue('--' + name).trim();
    return [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16) / 255)
      .map(c => c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
      .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  };
  const [a, b] = arguments.map ? arguments.map(light) : [light(arguments[0]), light(arguments[1])];
  return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
"""


def check_contrast(page):
    """Text is told from what is behind it: 4.5 to 1 by the Web Content Accessibility Guidelines."""
    for ink, ground in (("ink", "ground"), ("ink", "card"), ("quiet", "ground"), ("quiet", "card"), ("quiet", "view"),
                        ("accent", "card"), ("on-accent", "accent"), ("free-ink", "card"), ("touching-ink", "card"),
                        ("wrong", "card"), ("bad", "bad-ground")):
        ratio = page.script(CONTRAST, ink, ground)
        expect(ratio >= 4.5, f"{ink} on {ground}: {ratio:.2f} to 1")


def check_phone(page):
    width = page.script("return document.documentElement.scrollWidth")
    expect(width <= 390, f"in a window of 390 pixels the page is {width} wide")
    for selector in ("#run", "#forward", "#angle", "#height", "#plan", "#scene"):
        box = page.find(selector).rect
        expect(box["x"] >= 0 and box["x"] + box["width"] <= 390, f"{selector} is out of the window: {box}")
        expect(box["height"] >= 24, f"{selector} is too low for a finger: {box}")


def check_touch(page):
    """A finger drags the storage, and the page stays where it is."""
    page.script("document.getElementById('plan').scrollIntoView({block: 'center'})")
    box = page.script("const b = document.querySelector('#plan .handle .grip').getBoundingClientRect();"
                      "return [b.x + b.width / 2, b.y + b.height / 2]")
    angle = "return document.getElementById('angle').value"
    place = "return document.getElementById('plan').getBoundingClientRect().y"
    before, places = page.script(angle), []
    page.cdp("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": box[0], "y": box[1]}])
    for i in range(1, 9):
        page.cdp("Input.dispatchTouchEvent", type="touchMove", touchPoints=[{"x": box[0] - i, "y": box[1] - 4 * i}])
        places.append(page.script(place))
    page.cdp("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
    page.settled()
    expect(page.script(angle) != before, "a finger does not drag the storage")
    expect(places[-1] == places[1], f"dragging the storage scrolls the page: {places}")
    page.reset()


def check_calm(page):
    page.find("#run").click()
    page.wait("the end of a move", lambda: page.stop()[0] > 0)
    (here, ends), (there, now) = page.script("""
      const seen = () => [+document.getElementById('stop').value,
                          [...document.querySelectorAll('#moves tbody tr')].findIndex(row => row.className === 'now')];
      const before = seen();
      document.getElementById('forward').click();
      return [before, seen()];""")
    expect(there == here + 1 and now == ends + 1, "without motion, it does not go by whole moves")


RECORDED = re.compile(r'(id="recorded">)(.*?)(</script>)', re.S)


def recorded(file):
    return json.loads(RECORDED.search(file.read_text())[2])


def check_disagreements(page, file):
    """A recording in which a method has erred at one stop."""
    answers = recorded(file)
    answers["run"]["disagreements"] = [{"stop": 40, "owner": "machine/vice", "face": 3, "methods": ["thesis"]}]
    wrong = file.with_name("wrong.html")
    wrong.write_text(RECORDED.sub(lambda found: found[1] + json.dumps(answers) + found[3], file.read_text()))
    page.open(wrong.as_uri())
    page.look("near")
    expect(page.magenta() == 0, "magenta where no method errs")
    page.find("#next-wrong").click()
    expect(page.stop()[0] == 40, "the next stop where a method errs is not gone to")
    expect("Wrong here: thesis." in page.text("status"), page.text("status"))
    expect("Wrong here: thesis, on face 3 of machine/vice." in page.text("disagreements"), page.text("disagreements"))
    expect(page.magenta() > 20, "a stop where a method errs is not marked")
    page.picture("disagreement")


def check_play(page, file):
    """The run is played in its own time, also between the stops, and waits where the arm waits."""
    answers = recorded(file)
    run = answers["run"]
    for stop in range(8, len(run["stops"])):
        run["times"][stop] += 2
    run["waits"][7] = 2
    waiting = file.with_name("waiting.html")
    waiting.write_text(RECORDED.sub(lambda found: found[1] + json.dumps(answers) + found[3], file.read_text()))
    page.open(waiting.as_uri())
    page.go(5)
    page.script("return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")  # the page has drawn
    page.script("window.frames = []; window.requestAnimationFrame = act => frames.push(act); performance.now = () => 0")
    hand = """for (let i = 0; i < 3; ++i) frames.splice(0).forEach(act => act(arguments[0]));
              const ball = document.querySelector('#plan .ball');
              return [+ball.getAttribute('cx'), -ball.getAttribute('cy')];"""

    def expect_hand(moment, stop, share):
        a, b = (run["stops"][number]["sphere"] for number in (stop, min(stop + 1, len(run["stops"]) - 1)))
        here = page.script(hand, 1000 * (moment - run["times"][5]))
        expect(all(abs(here[i] - a[i] - share * (b[i] - a[i])) < 1e-3 for i in (0, 1)), f"after {moment} s the hand is at {here}")
        expect(page.stop()[0] == stop, f"after {moment} s it says {page.text('status')!r}")

    times = run["times"]
    page.find("#run").click()
    expect_hand(0.75 * times[5] + 0.25 * times[6], 5, 0.25)
    expect_hand(0.5 * times[6] + 0.5 * times[7], 6, 0.5)
    expect_hand(times[7] + 1.9, 7, 0)
    expect("2 s" in page.text("answer"), "it is not said that the arm waits")
    expect_hand(times[7] + 2 + 0.5 * (times[8] - times[7] - 2), 7, 0.5)
    held = next(i for i, stop in enumerate(run["stops"]) if stop["place"] is None) + 20
    expect_hand(0.5 * times[held] + 0.5 * times[held + 1], held, 0.5)
    page.find("#run").click()
    expect_hand(0, held, 0)  # it pauses at a stop
    page.find("#run").click()
    page.script(hand, 1e6)
    expect(page.stop()[0] == page.stop()[1] and page.text("run") == "Run", "it does not end at the end")


def elements(page):
    return page.script("return [...document.querySelectorAll('#elements tbody tr')].map(row => row.dataset.key)")


def reloaded(page, act):
    """What the page shows once it has been loaded again by something that is done to it."""
    page.script("window.before = true")
    act()
    page.wait("the page again", lambda: page.script("return document.readyState === 'complete' && !window.before"))
    page.wait("an answer", lambda: page.text("status") not in ("", "The program is asked for the cell …")
              or page.find("#failure").is_displayed())
    page.settled()


def add(page, kind):
    def act():
        page.script("document.getElementById('kind').value = arguments[0]", kind)
        page.find("#add").click()
    reloaded(page, act)


def change(page, label, value):
    reloaded(page, lambda: page.put(f"#elements [aria-label='{label}']", value, "change"))


def move(page, name, place):
    for axis, value in zip("xyz", place):
        change(page, f"{name}: move {axis}", value)


def check_elements(page, address):
    """Things are added, moved and removed; each change is one of the cell's file."""
    page.open(address)
    own = elements(page)
    expect(own == ["robot", "storage", "machine", "material"], f"the cell consists of {own}")
    moves = page.text("moves")
    add(page, "zone-box")
    expect(elements(page) == own + ["zones[0]"], elements(page))
    expect("change=" in page.driver.current_url, "the address does not say what was changed")
    move(page, "box-2", (420, -240, 220))
    expect(page.text("moves") == moves, "a virtual object is in the way")
    setting = {"changes": ['zones[0]={"name": "box-2", "box": ' + page.script(
        "return JSON.stringify(JSON.parse(new URLSearchParams(location.search).getAll('change')[0].slice('zones[0]='.length)).box)")
        + '}', "zones[0].move=[420, -240, 220]"]}
    run = ask(address, setting)
    expect(run["triggers"], "nothing comes into a virtual object on the way")
    rows = page.script("return [...document.querySelectorAll('#triggers tbody tr')].map(r => r.cells[0].textContent + r.cells[2].textContent)")
    expect(rows == [f"{t['zone']}{t['after']}" for t in run["triggers"]], f"the page lists {rows}")
    inside = run["triggers"][0]["after"] + 1
    page.go(inside)
    page.picture("virtual-box")
    stops = page.find("#elements [aria-label='box-2: stops the robot']")
    reloaded(page, stops.click)
    expect("comes into the zone box-2, which stops the robot" in page.text("failure"), page.text("failure"))
    page.picture("virtual-box-stops")
    reloaded(page, page.find("#undo").click)
    expect(page.text("moves") == moves, "the last change is not taken back")
    reloaded(page, page.find("#elements [aria-label='Remove box-2']").click)
    expect(elements(page) == own, "what is removed is there")

    page.open(address)
    add(page, "box")
    expect(page.text("moves") == moves or page.find("#failure").is_displayed(), "an obstacle changes the run")
    move(page, "box-2", (-420, -240, 320))
    expect("box-2" in page.text("failure"), f"an obstacle above the material: {page.text('failure')!r}")
    expect(page.red() > 50, "the obstacle is not coloured")
    page.picture("obstacle")

    page.open(address)
    add(page, "storage")
    expect(elements(page)[2] == "storages[0]", elements(page))
    change(page, "storage-2: angle", 5)
    expect("stands in storage-2/" in page.text("failure"), page.text("failure"))
    change(page, "storage-2: angle", 200)
    expect(page.text("moves") == moves, page.text("failure"))
    page.picture("two-storages")

    page.open(address)
    add(page, "robot")
    expect(elements(page)[1] == "robots[0]", elements(page))
    change(page, "robot-2: place x", -1900)
    expect(page.text("moves") == moves, page.text("failure"))
    page.picture("two-robots")

    query = "?change=" + "&change=".join(urllib.parse.quote(text) for text in (
        "storages[0]=@storage", "storages[0].name=rack", "storages[0].angle=200",
        "materials[0]=@material", "materials[0].name=second", "materials[0].storage=rack"))
    page.open(address + query)
    expect(page.find("#piece").is_displayed(), "there is no choice of pieces")
    reloaded(page, lambda: page.choose("piece", "second"))
    expect("piece=second" in page.driver.current_url and page.find("#piece").get_attribute("value") == "second", page.driver.current_url)
    page.driver.get(address + "?change=" + urllib.parse.quote("storage.radius=5000"))
    page.wait("a refusal", lambda: "storage.radius: too far" in page.text("failure"))
    expect(page.find("#failure a").is_displayed(), "there is no way back from a cell that cannot be")
    page.driver.get(address + "?change=" + urllib.parse.quote("robot.urdf=/etc/passwd"))
    page.wait("a refusal", lambda: "the page does not set \"urdf\"" in page.text("failure"))


def check_without_webgl(page, address):
    page.open(address)
    expect(page.find("#no-scene").is_displayed() and not page.find("#scene").is_displayed(), "no word of what is missing")
    page.find("#forward").click()
    expect(page.stop()[0] == 1, "without WebGL the run does not step")


def check_offline(page, file):
    page.cdp("Network.enable")
    page.cdp("Network.emulateNetworkConditions", offline=True, latency=0, downloadThroughput=0, uploadThroughput=0)
    page.open(file.as_uri())
    check_words(page, recorded(file)["run"])
    check_transport(page)
    expect(page.find("#angle").get_property("disabled"), "a recorded storage can be moved")
    asked = page.script("return performance.getEntriesByType('resource').map(e => e.name).filter(n => !n.startsWith('data:'))")
    expect(not asked, f"the exported page asks for {asked}")


def main(touchstone, pictures=None):
    done = []
    with server(touchstone) as address:
        run = ask(address, {})
        with Page(pictures) as page:
            page.open(address)
            expect(page.kinds_of_pixels() > 50, "the perspective view is empty")
            page.picture("desktop")
            expect(page.script("return document.querySelector('[data-look=split]').getAttribute('aria-pressed')") == "true",
                   "there is one view from the start")
            check_words(page, run)
            page.look("near")
            page.go(next(i for i, stop in enumerate(run["stops"]) if stop["touched"] is not None and stop["target"] == "machine"))
            page.picture("touching")
            page.look("front")
            check_contrast(page)
            check_transport(page)
            check_keys(page)
            check_distances(page, run)
            check_views(page)
            check_hand(page, run)
            check_slots(page)
            check_jog(page)
            check_typed(page, address)
            check_area(page)
            check_configuration(page, address)
            check_wrong_stop(page, address)
            done.append("desktop")
        with Page(pictures) as page:
            check_elements(page, address)
            done.append("more than one")
        with Page(pictures, 390, 844, phone=True) as page:
            page.open(address)
            check_phone(page)
            page.go(300)
            page.picture("phone")
            check_phone(page)
            check_touch(page)
            done.append("phone")
        with Page(pictures, prefers_color_scheme="dark") as page:
            page.open(address)
            check_contrast(page)
            check_words(page, run)
            page.look("front")
            page.go(300)
            page.picture("dark")
            done.append("dark")
        with Page(pictures, prefers_reduced_motion="reduce") as page:
            page.open(address)
            check_calm(page)
            done.append("without motion")
        with Page(pictures, arguments=["--disable-3d-apis"]) as page:
            check_without_webgl(page, address)
            done.append("without WebGL")
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "run.html"
        subprocess.run([touchstone, "cell", "export", CELL, file], check=True, capture_output=True, timeout=PATIENCE)
        with Page(pictures) as page:
            check_offline(page, file)
            page.picture("exported")
            check_disagreements(page, file)
            check_play(page, file)
            done.append("exported, offline")
    print(f"The page is as it should be: {', '.join(done)}.")


if __name__ == "__main__":
    main(*sys.argv[1:])
