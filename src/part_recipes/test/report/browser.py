# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""A Chromium without a screen that reports what it was asked to load and what its console says."""
import base64
import json
import re

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

TIMEOUT = 120  # [s] on a busy computer
A4 = {'paperWidth': 8.27, 'paperHeight': 11.69, 'printBackground': True, 'preferCSSPageSize': True}  # [inch]
SOFTWARE_GL = ('--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader')
NO_GL = ('--disable-gpu', '--disable-3d-apis')


class Browser:
    def __init__(self, flags=SOFTWARE_GL):
        options = Options()
        options.binary_location = '/usr/bin/chromium'
        for flag in ('--headless=new', '--no-sandbox', '--disable-dev-shm-usage', '--window-size=1300,1000',
                     '--hide-scrollbars', '--disable-background-networking', '--disable-component-update') + tuple(flags):
            options.add_argument(flag)
        options.set_capability('goog:loggingPrefs', {'browser': 'ALL', 'performance': 'ALL'})
        self.driver = webdriver.Chrome(service=Service('/usr/bin/chromedriver'), options=options)
        self.driver.set_script_timeout(TIMEOUT)
        self.driver.set_page_load_timeout(TIMEOUT)

    def close(self):
        self.driver.quit()

    def open(self, path):
        self.driver.get_log('browser')
        self.driver.get_log('performance')
        self.driver.get('file://' + path)

    def until(self, script):
        """Waits until a script returns true."""
        return WebDriverWait(self.driver, TIMEOUT, 0.05).until(lambda driver: driver.execute_script(script))

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def texts(self, selector):
        return self.run('return [...document.querySelectorAll(arguments[0])].map((e) => e.textContent)', selector)

    def press(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def drag(self, selector, right, down):
        ActionChains(self.driver).drag_and_drop_by_offset(self.find(selector), right, down).perform()

    def requests(self):
        """Addresses requested since open(), without those that a page contains itself."""
        asked = []
        for entry in self.driver.get_log('performance'):
            message = json.loads(entry['message'])['message']
            if message['method'] in ('Network.requestWillBeSent', 'Network.webSocketCreated'):
                asked.append(message['params'].get('request', message['params'])['url'])
        return [url for url in asked if not url.startswith('data:')]

    def errors(self):
        """Lines of the console that are errors or warnings since open()."""
        return [entry['message'] for entry in self.driver.get_log('browser') if entry['level'] in ('SEVERE', 'WARNING')]

    def pdf(self):
        return base64.b64decode(self.driver.execute_cdp_cmd('Page.printToPDF', A4)['data'])

    def emulate(self, **features):
        """Sets media features: prefers_color_scheme='dark'"""
        self.driver.execute_cdp_cmd('Emulation.setEmulatedMedia', {
            'features': [{'name': name.replace('_', '-'), 'value': value} for name, value in features.items()]})


def pages_of(pdf):
    return len(re.findall(rb'/Type\s*/Page\b(?!s)', pdf))


__all__ = ['Browser', 'Keys', 'NO_GL', 'pages_of']
