# SPDX-License-Identifier: GPL-3.0-or-later
"""A page in a headless Chromium, for the tests of pages: how they use it."""
import pathlib

from running import expect
from selenium import webdriver
from selenium.webdriver.support.ui import WebDriverWait

PATIENCE = 60  # seconds, for what takes one


class Chromium:
    """Within `with`: its end fails if the console has said anything of the LEVELS, but what is EXCUSED."""
    LEVELS, EXCUSED = ("SEVERE",), ()

    def __init__(self, pictures, arguments, width, height, phone=False, media=None):
        options = webdriver.ChromeOptions()
        for argument in (*arguments, "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=webdriver.chrome.service.Service("/usr/bin/chromedriver"))
        self.pictures = pictures and pathlib.Path(pictures)
        if pictures:
            self.pictures.mkdir(parents=True, exist_ok=True)
        self.cdp("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=2 if phone else 1, mobile=phone)
        self.cdp("Emulation.setEmulatedMedia", features=[{"name": name, "value": value} for name, value in (media or {}).items()])

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        try:
            if kind is None:
                worst = [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] in self.LEVELS]
                worst = [text for text in worst if not any(excused in text for excused in self.EXCUSED)]
                expect(not worst, f"the console says {worst}")
            elif self.pictures:
                self.picture("failed")
        finally:
            self.driver.quit()

    def cdp(self, command, **arguments):
        return self.driver.execute_cdp_cmd(command, arguments)

    def script(self, text, *arguments):
        return self.driver.execute_script(text, *arguments)

    def wait(self, what, holds):
        WebDriverWait(self.driver, PATIENCE, 0.05).until(lambda _: holds(), what)

    def picture(self, name):
        if self.pictures:
            self.driver.save_screenshot(str(self.pictures / f"{name}.png"))
